"""The word finder on texts where the answer is known."""
import unittest

import words


def listed(text):
    return [word for _, word in words.found(text)]


class Words(unittest.TestCase):
    def test_identifiers_are_whole_words(self):
        self.assertEqual(listed("Backdrop b; int MyBackdropX; remover(); int mover;"), ["Backdrop", "mover"])

    def test_phrases_go_across_lines_of_a_comment_and_of_a_string(self):
        self.assertEqual(words.found("int x;\n/// as the paper says to the\n/// letter.\n"), [(2, "to the /// letter")])
        self.assertEqual(len(listed('"a shadow "\n    "answer"')), 1)

    def test_case_of_phrases_does_not_matter(self):
        self.assertEqual(listed("Hard cases"), ["Hard cases"])

    def test_ordinary_uses_are_fine(self):
        self.assertEqual(listed("figure 9; this is ruled out; std::visit(x); the middle of the screen; it moves"), [])

    def test_aliases_are_by_file_and_word(self):
        words.ALIASES["a.cpp"] = ("--no-keep",)
        try:
            self.assertEqual(words.forbidden("a.cpp", "--no-keep --no-plan"), [(1, "--no-plan")])
        finally:
            del words.ALIASES["a.cpp"]


if __name__ == "__main__":
    unittest.main()

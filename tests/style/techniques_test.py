"""The scan for names of techniques on texts where the answer is known, and on the project's own folders."""
import os
import re
import unittest

import techniques

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PATTERNS = [("ranges", re.compile(techniques.pattern_of("ranges", ["RangesShadow"])))]


def names(path, text):
    return [name for _, name in techniques.named(path, text, PATTERNS)]


class Names(unittest.TestCase):
    def test_ids_in_quotes(self):
        self.assertEqual(len(names("app/a.cpp", 'f("ranges"); g("ranges.bias=2"); h("ranges:bias=2");')), 3)
        self.assertEqual(len(names("tests/cli/a.py", "['ranges', \"tsm\"]")), 1)
        self.assertEqual(names("app/a.cpp", 'f("its ranges"); g("ranges of depth"); ranges(1); std::ranges::sort(x);'),
                         [])

    def test_classes_and_include_paths(self):
        self.assertEqual(len(names("app/a.cpp", '#include "techniques/ranges/ranges_shadow.h"\nRangesShadow s;')), 2)
        self.assertEqual(names("app/a.cpp", "MyRangesShadowX s;"), [])

    def test_comments_may_give_examples(self):
        self.assertEqual(names("app/a.cpp", '/// "ranges"\nint x;  // "ranges:bias=2"\n'), [])
        self.assertEqual(names("a.py", '# "ranges"\n'), [])

    def test_lines(self):
        self.assertEqual(techniques.named("app/a.cpp", 'int x;\n/* a\n b */\nf("ranges");', PATTERNS), [(4, '"ranges')])

    def test_a_technique_names_itself_and_so_do_its_tests(self):
        for path in ("renderer/techniques/ranges/a.cpp", "shaders/techniques/ranges/a.frag",
                     "tests/technique/ranges_test.cpp", "renderer/techniques/registry.cpp"):
            self.assertEqual(names(path, 'f("ranges")'), [], path)
        self.assertEqual(len(names("renderer/techniques/other/a.cpp", 'f("ranges")')), 1)

    def test_every_folder_of_techniques_is_known(self):
        self.assertIn("ranges", techniques.ids(ROOT))
        for name in techniques.ids(ROOT):
            self.assertTrue(techniques.classes(ROOT, name), name)


if __name__ == "__main__":
    unittest.main()

"""Snippets whose functions and lengths are known."""
import unittest

import function_lengths


def lengths(text, kind="c++"):
    return {function.name: function.length for function in function_lengths.functions(text, kind)}


class Braces(unittest.TestCase):
    def test_a_function_is_as_long_as_its_lines(self):
        self.assertEqual(lengths("int one() { return 1; }\n"), {"one": 1})
        self.assertEqual(lengths("// above\nint three() {\n    return 3;\n}\n\nint x = 4;\n"), {"three": 3})

    def test_a_long_signature_counts(self):
        self.assertEqual(lengths("static void f(int a,\n              int b)\n{\n}\n"), {"f": 4})

    def test_names_and_lines(self):
        text = "namespace a {\nint x;\n\nvoid B::c() const {\n}\n}  // namespace a\n"
        found = function_lengths.functions(text, "c++")
        self.assertEqual(found, [function_lengths.Function("B::c", 4, 2)])

    def test_braces_in_strings_and_comments_are_no_braces(self):
        self.assertEqual(lengths('void f() {\n  // }\n  g("}", \'}\', R"(}})");\n  /* }\n  */\n}\n'), {"f": 6})
        self.assertEqual(lengths("int g() {\n  return 1'000'000;\n}\n"), {"g": 3})
        self.assertEqual(lengths("#define F(x) { \\\n  x\nvoid h() {\n}\n"), {"h": 2})

    def test_members_of_a_class(self):
        text = ("class A final : public B {\n public:\n  A(int x) : x_{x}, y_(2) {\n    go();\n  }\n"
                "  int x() const override { return x_; }\n private:\n  int x_{0};\n  std::vector<int> v_ = {1, 2};\n"
                "  void z() {\n  }\n};\n")
        self.assertEqual(lengths(text), {"A": 3, "x": 1, "z": 2})

    def test_blocks_and_lambdas_belong_to_their_function(self):
        text = "void f() {\n  auto g = [](int x) {\n    return x;\n  };\n  for (;;) {\n  }\n}\n"
        self.assertEqual(lengths(text), {"f": 7})

    def test_templates_and_structs(self):
        text = "template <class T>\nT f(T x) {\n  return x;\n}\nstruct S {\n  int a = 1;\n};\nenum class E { A, B };\n"
        self.assertEqual(lengths(text), {"f": 4})

    def test_a_value_of_several_lines_is_no_function(self):
        self.assertEqual(lengths("const std::array x = {\n  f(1),\n  f(2),\n};\nint g() {\n}\n"), {"g": 2})

    def test_tests_are_named_with_their_arguments(self):
        self.assertEqual(lengths("TEST(Suite, Name) {\n}\n"), {"TEST(Suite,Name)": 2})

    def test_glsl(self):
        text = ("#version 450 core\nlayout(std140, binding = 0) uniform Block {\n  vec4 a;\n};\nout vec4 color;\n\n"
                "void main() {\n  color = a;\n}\n")
        self.assertEqual(lengths(text, "glsl"), {"main": 3})

    def test_open_braces_are_reported(self):
        with self.assertRaises(ValueError):
            lengths("void f() {\n")
        with self.assertRaises(ValueError):
            lengths("}\n")


class Python(unittest.TestCase):
    def test_functions_and_methods(self):
        text = ("class A:\n    def f(self):\n        return 1\n\n\n"
                "def g(a,\n      b):\n    def h():\n        pass\n    return h\n")
        self.assertEqual(lengths(text, "python"), {"f": 2, "g": 5, "h": 2})


if __name__ == "__main__":
    unittest.main()

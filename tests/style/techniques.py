"""Names of techniques outside their folders.

A technique is its folders in renderer/techniques and shaders/techniques and one line of the registry. Elsewhere no
quoted id, class or include path of one may stand, but for the one default, the tour's script and tests about that very
technique: those whose name begins with its id, and those listed here.
"""
import os
import re

import tree

FOLDER = "renderer/techniques"
CLASS = re.compile(r"^(?:class|struct) (\w+)[^;()]*\{", re.MULTILINE)
REGISTRY = "renderer/techniques/registry.cpp"
THE_DEFAULT = ("app/options/technique_options.h", '"tsm')  # the technique that is drawn where none is named

# Ids that are ordinary words too, where they mean just that.
ORDINARY = {
    "app/cases.cpp": ("exact",),  # the exact value of a case
    "renderer/measure/case_picture.cpp": ("exact",),
    "tests/cli/reports_test.py": ("exact",),
}

# Tests about techniques that their names do not name.
ABOUT = {
    "tests/parity/range_lists_test.cpp": ("ranges",),
}


def ids(root):
    folder = os.path.join(root, FOLDER)
    return sorted(name for name in os.listdir(folder) if os.path.isdir(os.path.join(folder, name)))


def classes(root, technique):
    """Types that the headers of a technique's folder declare."""
    headers = tree.files(os.path.join(root, FOLDER, technique), ("c++",))
    return sorted({name for path in headers if path.endswith(".h")
                   for name in CLASS.findall(tree.read(root, os.path.join(FOLDER, technique, path)))})


def is_about(path, technique):
    stem = os.path.basename(path).split(".")[0]
    own = path.startswith((f"{FOLDER}/{technique}/", f"shaders/techniques/{technique}/"))
    return own or (path.startswith("tests/") and (stem.split("_")[0] == technique or technique in ABOUT.get(path, ())))


def pattern_of(technique, types):
    names = [rf"""["']{technique}(?=["'.:=,])""", f"techniques/{technique}/", *(rf"\b{name}\b" for name in types)]
    return "|".join(names)


def patterns(root):
    """(id, pattern) of all that names a technique."""
    return [(name, re.compile(pattern_of(name, classes(root, name)))) for name in ids(root)]


def without_comments(path, text):
    """Text without comments, which may give examples; strings stay."""
    if tree.kind_of(path) in ("c++", "glsl"):
        keep = re.compile(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', re.DOTALL)
        return keep.sub(lambda match: match.group(1) or "\n" * match.group(0).count("\n"), text)
    return re.sub(r'(?m)^\s*#.*$', "", text)


def named(path, text, of_techniques):
    """(line, name) for each place of a text that names a technique which the file is not about."""
    if path == REGISTRY or path.startswith("tests/style/"):
        return []
    code = without_comments(path, text)
    return [(code.count("\n", 0, match.start()) + 1, match.group(0))
            for technique, pattern in of_techniques if not is_about(path, technique)
            for match in pattern.finditer(code)
            if match.group(0).strip("\"'") not in ORDINARY.get(path, ()) and (path, match.group(0)) != THE_DEFAULT]

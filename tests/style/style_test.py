"""Checks how the tree is written: style_test.py CHECK ROOT. Exits 77 where the check cannot run here.

What a check may still find is listed in pending.txt, `path: check` a line; an entry that is no longer needed fails.
"""
import os
import re
import shutil
import subprocess
import sys

import function_lengths
import techniques
import tree
import words

MAX_COLUMNS, MAX_FILE_LINES, MAX_FUNCTION_LINES = 120, 400, 60
SKIPPED = 77
FORMAT_VERSION = "14."


class Skip(Exception):
    """The check cannot run here, and why."""


def check_format(root):
    program = next((found for found in map(shutil.which, ("clang-format-14", "clang-format")) if found), None)
    if not program:
        raise Skip("there is no clang-format")
    version = subprocess.check_output([program, "--version"], text=True).split("version ")[-1].split()[0]
    if not version.startswith(FORMAT_VERSION):
        raise Skip(f"clang-format is {version}, the tree follows {FORMAT_VERSION}x")
    done = subprocess.run([program, "--dry-run", "--Werror", "--style=file", *tree.files(root, ("c++",))], cwd=root,
                          text=True, capture_output=True)
    for path, line in re.findall(r"^([^:\n]+):(\d+):\d+: error: ", done.stderr, re.MULTILINE):
        yield path, line, "is not as clang-format writes it"
    if done.returncode and "error: " not in done.stderr:
        yield ".clang-format", 1, done.stderr.strip()


def check_columns(root):
    for path in tree.files(root, tree.SOURCE + ("markdown", "workflow")):
        for number, line in enumerate(tree.read(root, path).split("\n"), 1):
            table = tree.kind_of(path) == "markdown" and line.startswith(("|", "!["))
            if len(line) > MAX_COLUMNS and "://" not in line and not table:
                yield path, number, f"{len(line)} columns"


def check_file_lengths(root):
    for path in tree.files(root, tree.SOURCE):
        lines = len(tree.read(root, path).splitlines())
        if lines > MAX_FILE_LINES:
            yield path, lines, f"{lines} lines"


def check_function_lengths(root):
    for path in tree.files(root, ("c++", "glsl", "python")):
        try:
            found = function_lengths.functions(tree.read(root, path), tree.kind_of(path))
        except (SyntaxError, ValueError) as error:
            yield path, 1, f"functions cannot be found: {error}"
            continue
        for function in found:
            if function.length > MAX_FUNCTION_LINES:
                yield path, function.line, f"{function.name} has {function.length} lines"


def check_words(root):
    for path in tree.files(root, tree.SOURCE + ("markdown", "workflow")):
        for line, word in words.forbidden(path, tree.read(root, path)):
            yield path, line, f"'{word}'"


def check_techniques(root):
    of_techniques = techniques.patterns(root)
    for path in tree.files(root, tree.SOURCE):
        for line, name in techniques.named(path, tree.read(root, path), of_techniques):
            yield path, line, f"names a technique: {name}"


CHECKS = {
    "format": check_format,
    "columns": check_columns,
    "file_lengths": check_file_lengths,
    "function_lengths": check_function_lengths,
    "words": check_words,
    "techniques": check_techniques,
}


def pending(check):
    """Paths that pending.txt still allows to fail this check."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "pending.txt"), encoding="utf-8") as file:
        entries = [line.split(": ") for line in file.read().split("\n") if line and not line.startswith("#")]
    return {path for path, name in entries if name == check}


def main(check, root):
    try:
        found = list(CHECKS[check](root))
    except Skip as reason:
        print(f"skipped: {reason}")
        return SKIPPED
    known = pending(check)
    failures = [f"{path}:{line}: {what}" for path, line, what in found if path not in known]
    failures += [f"{path}: no longer fails; remove it from pending.txt" for path in
                 sorted(known - {path for path, _, _ in found})]
    print("\n".join(failures) or f"{check}: as it should be, {len(known)} files pending")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], os.path.abspath(sys.argv[2])))

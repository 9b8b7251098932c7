"""Finds functions and their lengths: in C++ and GLSL by their braces, in Python by its syntax tree.

A length is the number of lines from the first line of the signature to the closing brace, both included. Comments above
a function do not count, those inside do. A lambda inside a function is part of that function.
"""
import ast
import re
from collections import namedtuple

Function = namedtuple("Function", "name line length")

# Comments, raw strings, strings, characters (not the separators of 1'000) and preprocessor lines.
NOT_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^\s()\\]*)\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\''
    r'|^[ \t]*#(?:\\\n|[^\n])*', re.DOTALL | re.MULTILINE)
NAMESPACE = re.compile(r'\b(namespace|extern)\b')
TYPE = re.compile(r'^(?:template\b.*>\s*)?(?:typedef\s+)?(?:class|struct|union|enum)\b')
BLOCK = re.compile(r'\b(?:uniform|buffer|in|out)\s+\w+\s*$')  # GLSL interface blocks
INITIALIZERS = re.compile(r'\)\s*(?:noexcept(?:\([^)]*\))?\s*)?:(?!:)')  # of a constructor's members
LABEL = re.compile(r'\s*(?:public|protected|private)\s*:(?!:)')


def blanked(text):
    """The text without comments, strings and preprocessor lines, every line in its place."""
    def blank(match):
        found = match.group(0)
        filler = '""' if found[0] in '"R' else "0" if found[0] == "'" else ""
        return filler + "\n" * found.count("\n")
    return NOT_CODE.sub(blank, text)


def name_in(header):
    """The name in a signature: what stands before the first parenthesis that is none of a template or attribute."""
    match = re.search(r'(operator\s*(?:\(\)|[^\s(]+)|~?[A-Za-z_][\w:~]*)\s*\(', header)
    name = match.group(1) if match else "(lambda)"
    if name.startswith(("TEST", "RC_GTEST")):
        return re.sub(r'\s+', "", header[match.start():].split(")")[0]) + ")"
    return name


def opens(header):
    """What the brace after this text opens: a scope that holds functions, a function, or something else."""
    if NAMESPACE.search(header) and "(" not in header:
        return "scope"
    if TYPE.search(header) and not re.search(r'\)\s*(?:const|noexcept|override|final)?\s*$', header):
        return "scope"
    if BLOCK.search(header):
        return "other"
    if INITIALIZERS.search(header) and re.search(r'[\w>]\s*$', header):
        return "other"  # member_{value}: the signature goes on
    if "(" in header and not re.search(r'=\s*$', header):
        return "function"
    return "other"


def of_braces(text):
    """Functions of C++ and GLSL text, in the order of their closing braces."""
    code = blanked(text)
    functions, stack, start = [], [], 0  # stack of (kind, start of the signature)
    for match in re.finditer(r'[{};]', code):
        at, sign = match.start(), match.group(0)
        inside = bool(stack) and stack[-1][0] != "scope"
        if sign == "{":
            label = LABEL.match(code, start)
            start = label.end() if label and not inside else start
            header = code[start:at]
            stack.append(("other" if inside else opens(header.strip()), start))
        elif sign == "}":
            if not stack:
                raise ValueError(f"line {code.count(chr(10), 0, at) + 1}: a brace closes what none opened")
            kind, begun = stack.pop()
            if kind == "function":
                begun += len(code[begun:at]) - len(code[begun:at].lstrip())
                line = code.count("\n", 0, begun) + 1
                functions.append(Function(name_in(code[begun:at]), line, code.count("\n", begun, at) + 1))
        # Braces of a member's value leave the signature they stand in open.
        if sign == "{" and stack[-1][0] == "scope" or sign == "}" and (not stack or kind_ends(stack, kind)):
            start = match.end()
        elif sign == ";" and not inside:
            start = match.end()
    if stack:
        raise ValueError("braces are left open")
    return functions


def kind_ends(stack, kind):
    """Whether a closed brace ends a declaration of the scope around it."""
    return stack[-1][0] == "scope" and kind != "other"


def of_python(text):
    return [Function(node.name, node.lineno, node.end_lineno - node.lineno + 1) for node in ast.walk(ast.parse(text))
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]


def functions(text, kind):
    return of_python(text) if kind == "python" else of_braces(text)

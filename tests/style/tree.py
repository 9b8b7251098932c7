"""The text files of the project, by kind."""
import os

SKIPPED_FOLDERS = {"build", "out", ".git", ".cache", "__pycache__", "third_party"}
SUFFIXES = {
    "c++": (".cpp", ".h"),
    "glsl": (".glsl", ".vert", ".frag", ".comp", ".geom"),
    "python": (".py",),
    "shell": (".sh",),
    "cmake": (".cmake", "CMakeLists.txt"),
    "markdown": (".md",),
    "workflow": (".yml",),
}
SHELL_FILES = ("run", "test", ".ci/run")
SOURCE = ("c++", "glsl", "python", "shell", "cmake")


def kind_of(path):
    """The kind of a file by its path relative to the root; None for what is not text of ours."""
    if path in SHELL_FILES:
        return "shell"
    for kind, suffixes in SUFFIXES.items():
        if path.endswith(suffixes):
            return kind
    return None


def files(root, kinds):
    """Sorted paths, relative to the root, of the files of these kinds, committed or not."""
    found = []
    for folder, subfolders, names in os.walk(root):
        subfolders[:] = sorted(name for name in subfolders if name not in SKIPPED_FOLDERS)
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), root)
            if kind_of(path) in kinds:
                found.append(path)
    return sorted(found)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()

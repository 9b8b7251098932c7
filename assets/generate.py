#!/usr/bin/python3
"""Writes Timeshade's three scenes, chess.glb, octopus.glb and pillars.glb. Standard library only.

The same text gives the same bytes everywhere, so --check can tell whether the files beside it are stale.
"""

import argparse
import importlib
import os
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = ("chess", "octopus", "pillars")


def write_scenes(folder):
    os.makedirs(folder, exist_ok=True)
    for name in SCENES:
        content = importlib.import_module(f"generator.{name}").build()
        path = os.path.join(folder, name + ".glb")
        # Rename when whole: an interrupted run leaves no half-written scene behind.
        with open(path + ".part", "wb") as file:
            file.write(content)
        os.replace(path + ".part", path)


def first_difference(ours, theirs):
    for offset, (a, b) in enumerate(zip(ours, theirs)):
        if a != b:
            return offset
    return min(len(ours), len(theirs))


def check(folder):
    """None where the files in `folder` are what this program writes, else a line that names the difference."""
    with tempfile.TemporaryDirectory() as fresh:
        write_scenes(fresh)
        for name in SCENES:
            path = os.path.join(folder, name + ".glb")
            with open(os.path.join(fresh, name + ".glb"), "rb") as file:
                expected = file.read()
            try:
                with open(path, "rb") as file:
                    found = file.read()
            except OSError as error:
                return f"{path}: {error.strerror}"
            if found != expected:
                return (f"{path}: {len(found)} bytes, the generator writes {len(expected)}; "
                        f"the first difference is at byte {first_difference(found, expected)}")
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", metavar="DIR", default=os.path.join(HERE, "scenes"), help="default: %(default)s")
    parser.add_argument("--check", action="store_true", help="write nothing, compare with the files in the folder")
    arguments = parser.parse_args()
    if arguments.check:
        difference = check(arguments.output)
        if difference:
            print(f"generate.py: error: {difference}", file=sys.stderr)
            return 1
        return 0
    write_scenes(arguments.output)
    return 0


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    sys.exit(main())

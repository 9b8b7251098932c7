"""The README's tables of disagreement, cell by cell: each is what `verify` says today.

usage: readme_test.py PROGRAM SOURCE_FOLDER
"""

import json
import pathlib
import subprocess
import sys
import unittest

PROGRAM = sys.argv[1]
README = (pathlib.Path(sys.argv[2]) / "README.md").read_text()
# Other processors round otherwise: a few samples on edges, and a share of many.
SAMPLES, SHARE = 5.0, 0.01


def rows_of(header):
    """The cells of the table that begins so, one list a row."""
    lines = README[README.index(header):].split("\n\n")[0].splitlines()
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def disagreement(scene, *options):
    done = subprocess.run([PROGRAM, "verify", scene, "--size", "320x240", "--spp", "8", "--map", "512", *options, "--json", "-"], capture_output=True,
                          text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class Tables(unittest.TestCase):
    def check(self, text, scene, *options):
        written = float(text.replace(",", "").replace("ppm", ""))
        report = disagreement(scene, *options)
        self.assertLessEqual(abs(report["ppm"] - written), SHARE * written + SAMPLES * 1e6 / report["tested"], f"{scene} {' '.join(options)}: {report['ppm']} ppm")

    def test_ordinary_techniques(self):
        rows = rows_of("| scene | technique | tested | disagree |")
        self.assertEqual(len(rows), 9)
        for scene, technique, _, ppm, *_ in rows:
            with self.subTest(scene=scene, technique=technique):
                self.check(ppm, scene, "--technique", technique, "--set", "accumulation.renders=16")

    def test_techniques_with_lists(self):
        header = "| scene | tsm | temporal | as published | ranges | as published | exact |"
        rows = rows_of(header)
        self.assertEqual(len(rows), 7)
        for scene, *cells in rows:
            technique = ""
            for name, text in zip([cell.strip() for cell in header.strip("|").split("|")][1:], cells):
                published = name == "as published"
                technique = technique if published else name
                if text:
                    with self.subTest(scene=scene, technique=technique, published=published):
                        self.check(text, scene, "--technique", technique, *(["--set", f"{technique}.as_published=on"] if published else []))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

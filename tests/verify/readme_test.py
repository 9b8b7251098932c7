"""The README's tables of wrong samples and of both errors, cell by cell: each is what `verify` says today.

usage: readme_test.py PROGRAM SOURCE_FOLDER
"""

import functools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from thorough import ALL, THOROUGH  # noqa: E402

PROGRAM = sys.argv[1]
README = (pathlib.Path(sys.argv[2]) / "README.md").read_text()
# Other processors round otherwise: a few samples on edges, and a share of many.
SAMPLES, SHARE = 5.0, 0.01
# Fewer than the README's 1,024: the debiased error is the same but for the standard error that comes with it.
RAYS = {"chess": 128, "octopus": 128, "pillars": 128, "cubes": 128, "ball": 128}
# Of many triangles, which take long: every second row with TIMESHADE_TESTS=thorough, each with TIMESHADE_TESTS=all.
HEAVY = {"octopus-fine": 64, "tree": 64, "leg": 64, "runner": 64}
CACHE = tempfile.TemporaryDirectory()


def rows_of(header):
    """The cells of the table that begins so, one list a row."""
    lines = README[README.index(header):].split("\n\n")[0].splitlines()
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def drawn_anew(rows, of_each_scene=1):
    """Those that are checked: every eighth, of each scene others."""
    return [row for number, row in enumerate(rows)
            if THOROUGH or (number % of_each_scene + number // of_each_scene) % 8 == 0]


@functools.lru_cache(maxsize=None)
def report_of(scene, technique, published=False):
    rays = {**RAYS, **HEAVY}.get(scene, 0)
    command = [PROGRAM, "verify", scene, "--size", "320x240", "--spp", "8", "--map", "512", "--technique", technique,
               "--set", "accumulation.renders=16", "--reference-rays", str(rays), "--json", "-"]
    if published:
        command += ["--set", f"{technique}.as_published=on"]
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          env=dict(os.environ, XDG_CACHE_HOME=CACHE.name))
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class Tables(unittest.TestCase):
    def check(self, text, report):
        written = float(text.replace(",", "").replace("ppm", ""))
        slack = SHARE * written + SAMPLES * 1e6 / report["tested"]
        self.assertLessEqual(abs(report["ppm"] - written), slack, f"{report['ppm']} ppm")

    def test_both_errors(self):
        rows = rows_of("| scene | technique | shadow error | footprint error | wrong samples |")
        names = [t["name"] for t in json.loads(subprocess.check_output([PROGRAM, "list", "--json"]))["techniques"]]
        self.assertEqual(sorted((scene, technique) for scene, technique, *_ in rows),
                         sorted((scene, name) for scene in (*RAYS, *HEAVY) for name in names))
        heavy = [row for row in rows if row[0] in HEAVY]
        left_out = [] if ALL else heavy[1::2] if THOROUGH else heavy
        for scene, technique, shadow, footprint, ppm in drawn_anew(rows, len(names)):
            if [scene, technique, shadow, footprint, ppm] in left_out:
                continue
            with self.subTest(scene=scene, technique=technique):
                report = report_of(scene, technique)
                error = report["shadow_error"]
                self.assertLessEqual(abs(error["rms"] - float(shadow)), 3 * error["standard_error"] + 5e-5)
                square = float(footprint) ** 2
                slack = 2 * SHARE * square + SAMPLES / report["footprint_samples"]
                self.assertLessEqual(abs(report["footprint_error"]["rms"] ** 2 - square), slack)
                if report["ppm"] is None:
                    self.assertEqual(ppm, "")
                else:
                    self.check(ppm, report)

    def test_ordinary_techniques(self):
        rows = rows_of("| scene | technique | tested | disagree |")
        self.assertEqual(len(rows), 9)
        for scene, technique, _, ppm, *_ in drawn_anew(rows, 3):
            with self.subTest(scene=scene, technique=technique):
                self.check(ppm, report_of(scene, technique))

    def test_techniques_with_lists(self):
        header = "| scene | tsm | temporal | as published | ranges | as published | exact |"
        rows = rows_of(header)
        self.assertEqual(len(rows), 7)
        for scene, *cells in drawn_anew(rows):
            technique = ""
            for name, text in zip([cell.strip() for cell in header.strip("|").split("|")][1:], cells):
                published = name == "as published"
                technique = technique if published else name
                if text:
                    with self.subTest(scene=scene, technique=technique, published=published):
                        self.check(text, report_of(scene, technique, published))

    def test_shadow_errors_of_published_forms(self):
        header = "| scene | shadow error: temporal | as published | ranges | as published |"
        rows = rows_of(header)
        self.assertEqual(len(rows), 6)
        names = [cell.split()[-1] for cell in header.strip("|").split("|")[1:]]
        forms = [(names[0], False), (names[0], True), (names[2], False), (names[2], True)]
        for scene, *cells in drawn_anew(rows):
            if scene not in RAYS:  # its reference would take long
                continue
            for (name, published), text in zip(forms, cells):
                with self.subTest(scene=scene, technique=name, published=published):
                    error = report_of(scene, name, published)["shadow_error"]
                    self.assertLessEqual(abs(error["rms"] - float(text)), 3 * error["standard_error"] + 5e-5)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

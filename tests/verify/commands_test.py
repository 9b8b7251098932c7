"""`verify` and `measure` as a user runs them: gates, reports, same numbers every time, resumed sweeps.

usage: commands_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from thorough import THOROUGH  # noqa: E402

PROGRAM = sys.argv[1]
SMALL = ["--size", "160x120", "--spp", "2", "--map", "256"]
VERIFY = [*SMALL, "--reference-rays", "64"]
SAMPLES_ALONE = [*SMALL, "--reference-rays", "0"]


def run(*arguments, cache=None):
    environment = dict(os.environ)
    if cache:
        environment["XDG_CACHE_HOME"] = cache
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False, env=environment)


class Verify(unittest.TestCase):
    def test_same_numbers_every_time(self):
        first, second = (run("verify", "octopus", *VERIFY, "--json", "-") for _ in range(2))
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual(first.stdout, second.stdout)

    def test_report_has_what_is_promised(self):
        report = json.loads(run("verify", "chess", "--technique", "static", *VERIFY, "--json", "-").stdout)
        for key in ("scene", "technique", "settings", "spp", "size", "map", "seed", "frame", "samples",
                    "tested", "shadowed", "disagree",
                    "false_shadow", "false_lit", "ppm", "primary_tested", "primary_disagree", "primary_ppm", "gl",
                    "footprint", "pixels", "shadow_error", "footprint_error", "reference_rays", "resolved_exactly",
                    "corrected"):
            self.assertIn(key, report)
        for key in ("mean", "rms", "p999", "standard_error"):
            self.assertIn(key, report["shadow_error"])
            self.assertIn(key, report["footprint_error"])
        self.assertEqual(report["disagree"], report["false_shadow"] + report["false_lit"])
        self.assertEqual(report["samples"], 160 * 120 * 2)

    def test_both_errors_of_every_technique(self):
        techniques = [t["name"] for t in json.loads(run("list", "--json").stdout)["techniques"]]
        self.assertGreater(len(techniques), 5)
        with tempfile.TemporaryDirectory() as cache:
            scenes = ("chess", "octopus", "pillars", "cubes")
            for index, scene in enumerate(scenes):
                # As a rule each technique in one scene; in all with TIMESHADE_TESTS=thorough, as .ci/run has it.
                for technique in techniques if THOROUGH else techniques[index::len(scenes)]:
                    with self.subTest(scene=scene, technique=technique):
                        result = run("verify", scene, "--technique", technique, "--size", "48x36", "--spp", "2",
                                     "--map", "128", "--reference-rays", "64", "--set", "accumulation.renders=4",
                                     "--json", "-", cache=cache)
                        self.assertEqual(result.returncode, 0, result.stderr)
                        report = json.loads(result.stdout)
                        self.assertEqual(report["reference_rays"], 64)
                        self.assertGreater(report["pixels"], 1000)
                        for error in (report["shadow_error"], report["footprint_error"]):
                            self.assertTrue(0 <= error["rms"] <= 1 and 0 <= error["mean"] <= error["p999"] <= 1, error)
                            self.assertGreaterEqual(error["standard_error"], 0)
                        # Two samples a pixel are noisy whatever the technique: between a technique that is right and
                        # one that is never.
                        self.assertTrue(0.02 < report["shadow_error"]["rms"] < 0.5, report["shadow_error"])
                        footprint = report["footprint"]
                        binary = (footprint == {"time": "instant", "space": "point", "filter_texels": 0})
                        self.assertEqual(report["ppm"] is not None, binary)
                        if binary:
                            self.assertEqual(report["footprint_samples"], report["tested"])
                            self.assertAlmostEqual(report["footprint_error"]["mean"], report["ppm"] * 1e-6)

    def test_reference_is_kept_and_can_be_left_out(self):
        with tempfile.TemporaryDirectory() as cache:
            arguments = ["verify", "chess", *SMALL, "--reference-rays", "32", "--json", "-"]
            first, second = run(*arguments, cache=cache), run(*arguments, cache=cache)
            self.assertEqual(first.stdout, second.stdout)
            self.assertEqual(len(os.listdir(os.path.join(cache, "timeshade"))), 1)
        report = json.loads(run("verify", "chess", *SMALL, "--reference-rays", "0", "--json", "-").stdout)
        self.assertNotIn("shadow_error", report)
        self.assertIn("footprint_error", report)

    def test_sample_pass_sees_what_the_oracle_sees(self):
        for scene in ("chess", "octopus", "pillars"):
            report = json.loads(run("verify", scene, "--technique", "static", *SAMPLES_ALONE, "--json", "-").stdout)
            self.assertLessEqual(report["primary_ppm"], 20, scene)

    def test_tsm_is_worst_on_pillars(self):
        ppm = {scene: json.loads(run("verify", scene, *SAMPLES_ALONE, "--json", "-").stdout)["ppm"]
               for scene in ("chess", "octopus", "pillars")}
        self.assertEqual(max(ppm, key=ppm.get), "pillars", ppm)

    def test_gate(self):
        self.assertEqual(run("verify", "chess", *SAMPLES_ALONE, "--max-ppm", "0").returncode, 3)
        self.assertEqual(run("verify", "chess", *SAMPLES_ALONE, "--max-ppm", "1000000").returncode, 0)

    def test_gate_is_for_techniques_that_are_right_or_wrong(self):
        result = run("verify", "chess", *SAMPLES_ALONE, "--technique", "history", "--max-ppm", "1000")
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn("the whole shutter", result.stderr)
        result = run("verify", "chess", *SAMPLES_ALONE, "--technique", "static", "--set", "static.pcf_radius=2",
                     "--max-ppm", "1000")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("texels", result.stderr)


class Measure(unittest.TestCase):
    def test_tables_and_resuming(self):
        with tempfile.TemporaryDirectory() as folder:
            out, cache = os.path.join(folder, "out"), os.path.join(folder, "cache")
            arguments = ["measure", "chess", "-o", out, "--techniques", "static,tsm,embree", "--spps", "1,2",
                         "--rounds", "2", "--reference", "32", "--size", "80x60", "--map", "128"]
            first = run(*arguments, cache=cache)
            self.assertEqual(first.returncode, 0, first.stderr)
            with open(os.path.join(out, "accuracy.csv"), newline="", encoding="utf-8") as stream:
                rows = list(csv.DictReader(stream))
            # Embree caches nothing.
            self.assertEqual([(r["technique"], r["spp"], r["state"]) for r in rows],
                             [(t, s, state) for t in ("static", "tsm") for s in ("1", "2")
                              for state in ("cold", "steady")] +
                             [("embree", s, "cold") for s in ("1", "2")])
            for row in rows:
                self.assertGreater(float(row["total_ms"]), 0)
                self.assertGreater(float(row["rmse"]), 0)
            self.assertEqual([float(r["disagree"]) for r in rows if r["technique"] == "embree"], [0, 0])
            with open(os.path.join(out, "accuracy.json"), encoding="utf-8") as stream:
                manifest = json.load(stream)["manifest"]
            self.assertIn("renderer", manifest["gl"])
            self.assertIn("triangles move", " ".join(manifest["plans"]["chess"]))
            # Interrupted after the first row: the row is kept to the last digit, the others are measured anew, and
            # errors and counts come out the same.
            journal = os.path.join(out, "rows.jsonl")
            with open(journal, encoding="utf-8") as stream:
                lines = stream.readlines()
            with open(journal, "w", encoding="utf-8") as stream:
                stream.writelines(lines[:2])
            self.assertEqual(run(*arguments, cache=cache).returncode, 0)
            with open(journal, encoding="utf-8") as stream:
                again = stream.readlines()
            self.assertEqual(again[:2], lines[:2])
            for before, after in zip(map(json.loads, lines[1:]), map(json.loads, again[1:])):
                self.assertEqual(before["error"], after["error"])
                self.assertEqual(before["verify"], after["verify"])

    def test_varied_settings_and_variants(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("measure", "-o", folder, "--vary", "cubes.count=20,60", "--techniques", "tsm,tsm:bias=4",
                         "--spp", "2", "--rounds", "2", "--reference", "16", "--size", "64x48", "--map", "64",
                         cache=os.path.join(folder, "cache"))
            self.assertEqual(result.returncode, 0, result.stderr)
            with open(os.path.join(folder, "accuracy.csv"), newline="", encoding="utf-8") as stream:
                rows = list(csv.DictReader(stream))
            self.assertEqual([(r["scene"], r["varied"], r["value"], r["technique"], r["spp"]) for r in rows],
                             [("cubes", "cubes.count", v, t, "2") for v in ("20", "60")
                              for t in ("tsm", "tsm:bias=4") for _ in ("cold", "steady")])
            self.assertEqual(rows[0]["rmse"], rows[1]["rmse"], "a state decides the times alone")
            self.assertNotEqual(rows[0]["rmse"], rows[2]["rmse"])
            for name in ("cubes-time.png", "cubes-memory.png", "cubes-disagreement.png"):
                self.assertTrue(os.path.exists(os.path.join(folder, name)), name)
            with open(os.path.join(folder, "accuracy.json"), encoding="utf-8") as stream:
                report = json.load(stream)
            self.assertIn("240 of 368 triangles move", " ".join(report["manifest"]["plans"]["cubes cubes.count=20"]))
            self.assertEqual(report["rows"][4]["varied"], {"key": "cubes.count", "value": 60})
            self.assertEqual(report["rows"][0]["figures"], [])
            self.assertIn("tsm:bias=4.bias = 4", report["manifest"]["settings"])

    def test_wrong_variations(self):
        with tempfile.TemporaryDirectory() as folder:
            for arguments, words in ((("--vary", "cubes.count=0,5"), ("cubes.count=0", "expected")),
                                     (("--vary", "cubes.count="), ("expected",)),
                                     (("--vary", "chess.count=5"), ("chess", "expected")),
                                     (("--vary", "cubes.nonsense=5"), ("nonsense", "expected")),
                                     (("chess", "--vary", "cubes.count=5"), ("cubes",)),
                                     (("--techniques", "tsm:bias"), ("tsm:bias", "expected")),
                                     (("--techniques", "tsm:nonsense=5"), ("nonsense", "expected")),
                                     (("--techniques", "tsm:bias=-5"), ("bias", "expected"))):
                result = run("measure", *arguments, "-o", folder)
                self.assertEqual(result.returncode, 2, arguments)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                for word in words:
                    self.assertIn(word, result.stderr)

    def test_unknown_technique(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run("measure", "chess", "-o", folder, "--techniques", "tsm,magic")
            self.assertEqual(result.returncode, 2)
            self.assertIn("magic", result.stderr)


class Diagnostics(unittest.TestCase):
    def test_views(self):
        with tempfile.TemporaryDirectory() as folder:
            sizes = []
            for view in ("final", "error", "disagreement"):
                path = os.path.join(folder, view + ".png")
                result = run("shot", "chess", *SMALL, "--view", view, "-o", path, cache=folder)
                self.assertEqual(result.returncode, 0, result.stderr)
                sizes.append(os.path.getsize(path))
            self.assertEqual(len(set(sizes)), 3)

    def test_only_for_png_shots(self):
        self.assertEqual(run("shot", "chess", "--view", "error", "-o", "x.exr").returncode, 2)
        self.assertEqual(run("verify", "chess", "--view", "error").returncode, 2)


unittest.main(argv=[sys.argv[0]])

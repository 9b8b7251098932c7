"""Equal time and equal error: what is asked for, what is written, and that a report does not contradict itself. What
takes how long is no matter here."""

import csv
import fcntl
import json
import os
import unittest

from program import Picture, ProgramTest, environment, in_thorough_tests

SMALL = ("--size", "64x48", "--map", "64", "--spp", "2", "--rounds", "2", "--sequence", "1", "--reference", "2",
         "--reference-rays", "64")


class Equal(ProgramTest):
    def measure(self, *arguments):
        """The rows of equal.csv, and equal.json. Both say the same."""
        said = self.succeed("measure", *arguments, "-o", "E", env=environment(XDG_CACHE_HOME=self.folder / "cache"))
        self.assertTrue(said.endswith("/E/report.md\n"), said)
        with open(self.folder / "E/equal.csv", newline="", encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        report = json.loads((self.folder / "E/equal.json").read_text(encoding="utf-8"))
        listed = [(scene["scene"], row) for scene in report["scenes"] for row in scene["techniques"]]
        self.assertEqual([(r["scene"], r["technique"]) for r in rows], [(s, r["technique"]) for s, r in listed])
        for row, (_, other) in zip(rows, listed):
            self.assertEqual(float(row["steady_ms"]), other["milliseconds"]["median"])
            self.assertEqual(float(row["shadow_error_rms"]), other["shadow_error"]["rms"])
            self.assertEqual(row["verdict"], other.get("verdict", ""))
            self.assertIn(row["technique"], said)
        return rows, report

    def check_time(self, row):
        """What the row says follows from its own times."""
        ratio = float(row["ratio"])
        self.assertAlmostEqual(ratio, float(row["steady_ms"]) / float(row["first_ms"]), places=12)
        self.assertEqual(row["found"], "yes" if abs(ratio - 1.0) <= 0.05 else "no")
        self.assertTrue(row["verdict"].startswith("equal: " if row["found"] == "yes" else "could not: "), row)
        self.assertLessEqual(float(row["steady_ms_low"]), float(row["steady_ms"]))
        self.assertLessEqual(float(row["steady_ms"]), float(row["steady_ms_high"]))

    def verified(self, scene, technique, spp):
        return json.loads(self.succeed("verify", scene, "--technique", technique, "--size", "64x48", "--map", "64",
                                       "--spp", spp, "--reference-rays", "64", "--json", "-"))

    def test_equal_time(self):
        rows, report = self.measure("rising", "--equal-time", "static,tsm:bias=2,accumulation", *SMALL)
        self.assertEqual(sorted(name for name in self.files() if name.startswith("E/")),
                         ["E/equal.csv", "E/equal.json", "E/report.md", "E/rising-equal.png"])
        self.assertEqual([(r["scene"], r["technique"]) for r in rows],
                         [("rising", t) for t in ("static", "tsm:bias=2", "accumulation")])
        first, other, brute = rows
        self.assertEqual((first["spp"], first["map"], first["found"], first["verdict"]), ("2", "64", "", ""))
        self.check_time(other)
        self.check_time(brute)
        self.assertIn(int(other["spp"]), range(1, 33))
        self.assertEqual(brute["spp"], "")
        self.assertIn(int(brute["renders"]), range(1, 513))
        self.assertEqual((report["equal"], report["tolerance"]), ("time", 0.05))
        self.assertIn("renderer", report["manifest"]["gl"])
        self.assertIn("tsm:bias=2.bias = 2", report["manifest"]["settings"])
        self.assertIn("triangles move", " ".join(report["manifest"]["plans"]["rising"]))
        text = (self.folder / "E/report.md").read_text(encoding="utf-8")
        self.assertEqual(len([line for line in text.splitlines() if line.startswith("|")]), 2 + 3)
        self.assertIn("(rising-equal.png)", text)
        self.assertEqual(report["manifest"]["gl"]["software"], "**Software renderer**" in text)
        for row in (other, brute):
            self.assertIn(row["verdict"], text)
        # The first is what verify and shot say of it.
        truth = self.verified("rising", "static", 2)
        self.assertEqual(float(first["shadow_error_rms"]), truth["shadow_error"]["rms"])
        self.assertEqual(float(first["ppm"]), truth["ppm"])
        picture = Picture((self.folder / "E/rising-equal.png").read_bytes())
        shot = Picture(self.shot("rising", "F.png", "--technique", "static", "--size", "64x48", "--map", "64",
                                 "--spp", "2"))
        self.assertEqual(picture.width, 4 * 256 + 3 * 6)
        same = sum(picture.rgb[3 * (4 * y * picture.width + 4 * x):][:3] == shot.rgb[3 * (64 * y + x):][:3]
                   for y in range(48) for x in range(64))
        self.assertGreater(same, 64 * 48 - 70, "all but the outline of the detail")

    @in_thorough_tests
    def test_several_maps_and_scenes(self):
        rows, report = self.measure("rising", "frusta", "--equal-time", "static,static", *SMALL, "--maps", "32,128")
        self.assertEqual([(r["scene"], r["map"]) for r in rows[::2]], [("rising", "64"), ("frusta", "64")])
        for row in rows[1::2]:
            self.assertIn(row["map"], ("32", "128"))
            self.check_time(row)
        self.assertEqual([scene["picture"] for scene in report["scenes"]], ["rising-equal.png", "frusta-equal.png"])

    def test_equal_error(self):
        arguments = ("rising", "--equal-error", "tsm,tsm,exact", *SMALL, "--spp", "8")
        rows, report = self.measure(*arguments)
        self.assertEqual(report["equal"], "error")
        first, same, better = rows
        error = float(first["shadow_error_rms"])
        self.assertLessEqual(int(same["spp"]), 8, "the same technique needs no more")
        for row in (same, better):
            self.assertEqual(row["found"], "yes")
            ratio = float(row["ratio"])
            self.assertAlmostEqual(ratio, float(row["shadow_error_rms"]) / error, places=9)
            self.assertLessEqual(ratio, 1.05)
            self.assertTrue(row["verdict"].startswith("equal: " if ratio >= 0.95 else "less: "), row)
            self.assertGreater(float(row["steady_ms"]), 0.0)
            # One sample fewer is not enough.
            before = self.verified("rising", row["technique"], int(row["spp"]) - 1)["shadow_error"]["rms"]
            self.assertGreater(before, 1.05 * error)
        # What does not depend on time is the same again.
        again, _ = self.measure(*arguments)
        keys = ("technique", "spp", "map", "shadow_error_rms", "ppm", "ratio", "found", "verdict")
        self.assertEqual([[r[k] for k in keys] for r in rows], [[r[k] for k in keys] for r in again])

    def test_an_error_that_cannot_be_reached(self):
        rows, _ = self.measure("pillars", "--equal-error", "exact,static", *SMALL, "--spp", "16")
        self.assertEqual(rows[1]["found"], "no")
        self.assertTrue(rows[1]["verdict"].startswith("could not: "), rows[1])

    def test_what_is_refused(self):
        nowhere = environment(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        for arguments, mentions in (
                (("--equal-time", "static,tsm", "--equal-error", "static,tsm"), ("--equal-time", "--equal-error")),
                (("--equal-time", "static"), ("--equal-time static", "expected two")),
                (("--equal-error", "static,magic"), ("magic", "expected")),
                (("--equal-time", "static,"), ("--equal-time static", "expected two")),
                (("--equal-time", "static,embree"), ("embree", "expected")),
                (("--equal-time", "static,tsm:bias"), ("tsm:bias", "expected")),
                (("--equal-time", "static,tsm:bias=-5"), ("bias", "expected")),
                (("--equal-time", "static,tsm", "--vary", "cubes.count=20,60"), ("--equal-time", "--vary")),
                (("--equal-error", "static,tsm", "--effects"), ("--equal-error", "--effects")),
                (("--equal-time", "static,tsm", "--convergence", "1,2"), ("--equal-time", "--convergence")),
                (("--equal-time", "static,tsm", "--techniques", "tsm"), ("--equal-time", "--techniques")),
                (("--equal-time", "static,tsm", "--spps", "1,2"), ("--equal-time", "--spps")),
                (("--equal-time", "static,tsm", "--reference-rays", "0"), ("--reference-rays 0", "expected"))):
            with self.subTest(arguments=arguments):
                self.refuse(2, mentions, "measure", "-o", "E", *arguments, env=nowhere, timeout=60)

    def test_a_folder_has_one_writer(self):
        (self.folder / "E").mkdir()
        descriptor = os.open(self.folder / "E", os.O_RDONLY)
        self.addCleanup(os.close, descriptor)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        self.refuse(1, ("E", "another timeshade"), "measure", "rising", "--equal-time", "static,tsm", *SMALL,
                    "-o", "E", leaves=("E",))

    def test_a_run_that_fails_leaves_nothing(self):
        done = self.run_program("measure", "rising", "missing.gltf", "--equal-time", "static,tsm", *SMALL, "-o", "E")
        self.assertEqual(done.returncode, 1)
        self.assertIn("missing.gltf", done.stderr)
        self.assertEqual([name for name in self.files() if name.startswith("E/")], [])

    def test_help(self):
        text = self.succeed("measure", "--help")
        for word in ("--equal-time", "--equal-error"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()

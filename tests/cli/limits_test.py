"""Nothing that a driver refuses ends in a picture: work groups beyond its limit, errors in any pass, long lists."""

import json
import unittest

from program import QUICK, TECHNIQUES, ProgramTest, environment, in_thorough_tests


class WorkGroups(ProgramTest):
    def forms(self):
        """Every technique, and its published form where it has one."""
        for technique in json.loads(self.succeed("list", "--json"))["techniques"]:
            yield (technique["name"],)
            if any(setting["key"] == "as_published" for setting in technique["settings"]):
                yield (technique["name"], "--set", technique["name"] + ".as_published=on")

    def test_any_arrangement_of_work_groups_draws_the_same(self):
        """A device may take no more than 65,535 work groups in a row; here 7, and 1."""
        for form in self.forms():
            arguments = (*QUICK, "--map", "128", "--technique", *form)
            usual = self.shot("cubes", "usual.png", *arguments, "--set", "cubes.count=40")
            for groups in (7, 1):
                with self.subTest(form=form, groups=groups):
                    self.assertEqual(usual, self.shot("cubes", "few.png", *arguments, "--set", "cubes.count=40",
                                                      env=environment(TIMESHADE_TEST_WORK_GROUPS=groups)))

    def wrong_ppm(self, *arguments):
        report = json.loads(self.succeed("verify", "cubes", "--size", "48x36", "--spp", "2", "--reference-rays", "0",
                                         "--json", "-", *arguments))
        self.assertGreater(report["tested"], 1000)
        return report["ppm"]

    @in_thorough_tests
    def test_large_maps_and_long_lists_are_right_or_refused(self):
        """65,536 work groups and more: a map of 2048 texels a side, and 240,000 triangles in 32 buckets of time."""
        small = self.wrong_ppm("--technique", "ranges", "--map", "1024")
        self.assertLessEqual(self.wrong_ppm("--technique", "ranges", "--map", "2048"), small + 1500)
        self.assertEqual(self.wrong_ppm("--technique", "exact", "--set", "cubes.count=20000", "--set",
                                        "exact.buckets=32"), 0)
        self.refuse(1, ("lower --map",), "shot", "cubes", "-o", "F.png", "--technique", "ranges", "--size", "48x36",
                    "--map", "8192")


class DriverErrors(ProgramTest):
    def test_an_error_in_any_pass_ends_every_command(self):
        passes = ("sample", "build", "lookup", "shade", "display")
        commands = {"shot": ("shot", "pillars", "-o", "F.png", *QUICK),
                    "verify": ("verify", "pillars", *QUICK, "--reference-rays", "0"),
                    "record": ("record", "pillars", "-o", "V.mp4", "--frames", "2", *QUICK)}
        for step in passes:
            for name, command in commands.items():
                if name == "verify" and step in ("display", "shade"):
                    continue  # it draws neither for its answers
                with self.subTest(step=step, command=name):
                    self.refuse(1, ("the driver reports GL_INVALID_ENUM",), *command,
                                env=environment(TIMESHADE_TEST_GL_ERROR=step))
        done = self.run_program("measure", "pillars", "-o", "M", "--techniques", TECHNIQUES[0], "--spps", "1", *QUICK,
                                env=environment(TIMESHADE_TEST_GL_ERROR="lookup"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("the driver reports", done.stderr)
        self.assertEqual([name for name in self.files() if name.startswith("M/accuracy")], [])

    def test_the_call_is_named_where_the_driver_says_it(self):
        line = self.refuse(1, ("the driver reports GL_INVALID_ENUM", "glEnable"), "shot", "pillars", "-o", "F.png",
                           *QUICK, "--gl-debug", env=environment(TIMESHADE_TEST_GL_ERROR="lookup"))
        self.assertNotIn("--gl-debug", line)


if __name__ == "__main__":
    unittest.main()

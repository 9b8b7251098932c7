"""scripts/gpu_check.sh: what it runs, what it reports, and that it goes on where it was. The program is a stand-in;
what the real one prints is tested elsewhere."""

import os
import pathlib
import subprocess
import unittest

from program import PROGRAM, ProgramTest, environment

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts" / "gpu_check.sh"
STAND_IN = r"""#!/usr/bin/env bash
echo "$*" >>"$CALLS"
while (($# > 0)); do
    case $1 in
    -o) out=$2 ;;
    --json) json=$2 ;;
    esac
    command+=" $1"
    shift
done
case $command in
" shot"*) [[ $SOFTWARE == none ]] && echo "timeshade: error: no OpenGL here" && exit 1
    printf '{\n "renderer": "A card",\n "version": "4.6",\n "software": %s\n}\n' "$SOFTWARE" >"$json" ;;
" list --json"*) printf '  "techniques": [\n    {\n      "name": "tsm",\n    },\n    {\n      "name": "exact",\n' ;;
" verify"*exact*) [[ $BROKEN == yes ]] && echo "timeshade: 12 ppm, expected 10" && exit 3
    echo "  disagree    3 (1.1 ppm): 2 false shadow" ;;
" verify"*) echo "  footprint error    0.001048 RMS (+- 0.000268), 0.000001 in the mean" ;;
" cases"*) echo "283 right, 94 predicted, 0 wrong" ;;
" measure"*) mkdir -p "$out" && cat >"$out/times.csv" <<'END' ;;
scene,technique,spp,map,state,clock,step,median_ms,low_ms,high_ms
chess,tsm,4,96,cold,wall,whole,9.5,9,10
chess,tsm,4,96,steady,device,lookup,1.5,1,2
chess,tsm,4,96,steady,wall,whole,3.456,3,4
cubes,tsm,8,96,steady,wall,whole,5.25,5,6
cubes,layers:as_published=on,8,96,steady,wall,whole,7,6,8
END
esac
"""


class GpuCheck(ProgramTest):
    def setUp(self):
        super().setUp()
        self.program = self.folder / "stand-in"
        self.program.write_text(STAND_IN)
        self.program.chmod(0o755)
        self.calls = self.folder / "calls"

    def check(self, *arguments, **variables):
        env = {**os.environ, "CALLS": str(self.calls), "SOFTWARE": "false", "BROKEN": "no", **variables}
        return subprocess.run([SCRIPT, "--program", self.program, "-o", self.folder / "results", *arguments],
                              check=False, capture_output=True, text=True, env=env, cwd=self.folder)

    def test_a_page_of_results(self):
        done = self.check("--scenes", "chess,cubes", "--device", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        report = (self.folder / "results/report.md").read_text()
        for text in ("# A card", "0 wrong", "every step ran", "| | chess | cubes |", "| tsm | RMS 0.001048 |",
                     "| exact | 1.1 ppm | 1.1 ppm |", "| | chess, 4 | cubes, 8 |", "| tsm | 3.46 | 5.25 |",
                     "| layers:as_published=on |  | 7.00 |", "(times/times.md)", "(ranges/times.md)"):
            self.assertIn(text, report)
        calls = self.calls.read_text().splitlines()
        self.assertEqual(len([c for c in calls if c.startswith("verify")]), 4)
        self.assertTrue(all("--device 1" in c for c in calls if c.startswith(("verify", "measure", "cases"))))

    def test_what_fails_is_said_and_tried_again(self):
        done = self.check("--scenes", "chess", BROKEN="yes")
        self.assertEqual(done.returncode, 1)
        report = (self.folder / "results/report.md").read_text()
        self.assertIn("FAILED: verify-chess-exact: timeshade: 12 ppm, expected 10", report)
        self.assertIn("| exact | failed |", report)
        self.calls.unlink()
        done = self.check("--scenes", "chess")
        self.assertEqual(done.returncode, 0, done.stderr)
        steps = [c for c in self.calls.read_text().splitlines() if not c.startswith(("list --json", "--version"))]
        self.assertEqual(len(steps), 1, "all else is there already")
        self.assertIn("every step ran", (self.folder / "results/report.md").read_text())

    def test_a_software_renderer_is_refused(self):
        for arguments, program in (((), self.program), (("--program", PROGRAM), PROGRAM)):
            done = subprocess.run([SCRIPT, "--program", program, "-o", self.folder / "none", *arguments], check=False,
                                  capture_output=True, text=True, cwd=self.folder,
                                  env={**environment(), "CALLS": str(self.calls), "SOFTWARE": "true", "BROKEN": "no"})
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"\A[^\n]*expected a GPU, or --allow-software\n\Z")
        self.assertEqual(self.check("--allow-software", "--scenes", "chess", SOFTWARE="true").returncode, 0)

    def test_without_opengl_there_is_one_line(self):
        done = self.check("--allow-software", SOFTWARE="none")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\A[^\n]*no picture could be drawn: [^\n]*no OpenGL here\n\Z")
        self.assertEqual(len(self.calls.read_text().splitlines()), 1)
        self.assertEqual(self.check("--scenes", "chess").returncode, 0, "tried again")

    def test_what_was_interrupted_goes_on(self):
        """Steps that have ended are not run again; one that had only begun is."""
        done = self.check("--scenes", "chess")
        self.assertEqual(done.returncode, 0, done.stderr)
        before = (self.folder / "results/report.md").read_text()
        (self.folder / "results/cases.done").unlink()
        (self.folder / "results/report.md").unlink()
        self.calls.unlink()
        self.assertEqual(self.check("--scenes", "chess").returncode, 0)
        steps = [c.split()[0] for c in self.calls.read_text().splitlines() if not c.startswith(("list", "--version"))]
        self.assertEqual(steps, ["cases"])
        self.assertEqual((self.folder / "results/report.md").read_text(), before)

    def test_bad_arguments(self):
        self.assertIn("--what: unknown", self.check("--what").stderr)
        done = subprocess.run([SCRIPT, "--program", "/nonexistent"], check=False, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nonexistent: can't be run", done.stderr)


if __name__ == "__main__":
    unittest.main()

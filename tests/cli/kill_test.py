"""Runs that are killed at any moment: the same command afterwards gives what it gives without, and leaves nothing else.

As a rule six kills, twelve in thorough tests; as many as TIMESHADE_KILLS says, of the seed TIMESHADE_KILL_SEED, by
hand.
"""

import csv
import os
import random
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import PROGRAM, QUICK, THOROUGH, ProgramTest, environment

KILLS = int(os.environ.get("TIMESHADE_KILLS", "12" if THOROUGH else "6"))
SEED = int(os.environ.get("TIMESHADE_KILL_SEED", "1"))
COMMANDS = {
    "shot": ("shot", "chess", "-o", "F.png", *QUICK, "--json", "F.json"),
    "record": ("record", "chess", "-o", "V.mp4", "--frames", "12", *QUICK),
    "verify": ("verify", "cubes", *QUICK, "--reference-rays", "32", "--json", "r.json"),
    "measure": ("measure", "cubes", "-o", "M", "--techniques", "static,tsm", "--spps", "1,2", "--rounds", "2",
                "--reference", "16", "--size", "48x36", "--map", "64"),
}


class Killed(ProgramTest):
    def setUp(self):
        super().setUp()
        # What the driver keeps of compiled shaders is its own, and is no part of what a run leaves.
        shaders = os.environ.get("MESA_SHADER_CACHE_DIR") or tempfile.mkdtemp(prefix="timeshade-shaders-")
        if shaders != os.environ.get("MESA_SHADER_CACHE_DIR"):
            self.addCleanup(shutil.rmtree, shaders, ignore_errors=True)
        self.environment = environment(XDG_CACHE_HOME=self.folder / "cache", MESA_SHADER_CACHE_DIR=shaders)

    def whole(self, command):
        self.succeed(*command, env=self.environment)

    def killed_after(self, command, seconds):
        """Whether it was still at work."""
        with subprocess.Popen([PROGRAM, *command], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
                              env=self.environment) as process:
            time.sleep(seconds)
            os.killpg(process.pid, signal.SIGKILL)  # the encoder too, as when a machine goes down
            process.wait()
            return process.returncode < 0

    def outcome(self, name):
        """Pictures, answers, and errors without their times: what an interruption must not change."""
        if name == "shot":
            return (self.folder / "F.png").read_bytes()
        if name == "record":
            return (self.folder / "V.mp4").read_bytes()
        if name == "verify":
            return (self.folder / "r.json").read_bytes()
        with open(self.folder / "M/accuracy.csv", newline="", encoding="utf-8") as stream:
            return [[row[key] for key in ("technique", "spp", "state", "rmse", "disagree")]
                    for row in csv.DictReader(stream)]

    def test_the_next_run_is_right_and_leaves_nothing_else(self):
        numbers = random.Random(SEED)
        wanted, files, seconds = {}, {}, {}
        for name, command in COMMANDS.items():
            self.whole(command)  # compiles what every later run finds compiled
            self.empty()
            begin = time.monotonic()
            self.whole(command)
            seconds[name] = time.monotonic() - begin
            wanted[name], files[name] = self.outcome(name), self.files()
            self.empty()
        interrupted = 0
        for kill in range(KILLS):
            name = list(COMMANDS)[kill % len(COMMANDS)]
            after = numbers.uniform(0.0, 0.8 * seconds[name])
            with self.subTest(kill=kill, command=name, after=f"{after:.3f} s"):
                interrupted += self.killed_after(COMMANDS[name], after)
                self.whole(COMMANDS[name])
                self.assertTrue(self.outcome(name) == wanted[name], "another outcome")
                self.assertEqual(self.files(), files[name])
            self.empty()
        self.assertGreater(interrupted, KILLS // 3, "most came too late to interrupt anything")

    def empty(self):
        for path in self.folder.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()


if __name__ == "__main__":
    unittest.main()

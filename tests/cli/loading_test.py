"""A scene that takes long to load: it says so on a terminal, and a signal ends it at once."""

import os
import pty
import signal
import subprocess
import time
import unittest

from program import PROGRAM, QUICK, ProgramTest, environment
from slow_model import slow_model


class Loading(ProgramTest):
    COMMANDS = {"shot": ("shot", "m.gltf", "-o", "F.png", "--json", "F.json", *QUICK),
                "record": ("record", "m.gltf", "-o", "V.mp4", "--frames", "1", *QUICK),
                "measure": ("measure", "m.gltf", "-o", "M")}

    @classmethod
    def setUpClass(cls):
        cls.slow_model = slow_model()

    def setUp(self):
        super().setUp()
        (self.folder / "m.gltf").write_text(self.slow_model)

    def start(self, command, stderr):
        return subprocess.Popen([PROGRAM, *command], cwd=self.folder, env=environment(), stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=stderr)

    def seen_on_terminal(self, command, until):
        """The process, and what it has written to a terminal so far; ends with `until`, or with the program."""
        main, terminal = pty.openpty()
        self.addCleanup(os.close, main)
        process = self.start(command, terminal)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        os.close(terminal)
        seen = b""
        try:
            while until not in seen:
                seen += os.read(main, 65536)
        except OSError:
            pass  # it has ended
        return process, seen.decode()

    def test_it_is_said_after_a_second(self):
        begin = time.monotonic()
        _, seen = self.seen_on_terminal(self.COMMANDS["shot"], b"loading")
        self.assertRegex(seen, r"timeshade: loading m\.gltf: [a-z ]+( \d+ of \d+)?, \d+ s")
        self.assertGreater(time.monotonic() - begin, 1.0)

    def test_nothing_is_said_of_what_is_quick_or_elsewhere(self):
        for scene in ("chess", "cubes"):
            _, seen = self.seen_on_terminal(("shot", scene, "-o", "F.png", *QUICK), b"loading")
            self.assertNotIn("loading", seen)
        process = self.start(self.COMMANDS["shot"], subprocess.PIPE)
        time.sleep(2.0)
        process.kill()
        self.assertEqual(process.communicate()[1], b"")

    def test_what_failed_to_decode_counts(self):
        """A hundred images of 64 MiB each, of 1 GiB in all: fifteen are tried."""
        done = self.run_program(*self.COMMANDS["shot"])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 42)  # 40 of the file's notes, how many more, and the ground's
        self.assertEqual(done.stderr.count("is used up"), 25)

    def test_a_signal_ends_it_at_once(self):
        for name, command in self.COMMANDS.items():
            with self.subTest(command=name):
                process, seen = self.seen_on_terminal(command, b"loading")
                self.assertIn("loading", seen)
                begin = time.monotonic()
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(timeout=60), -signal.SIGINT)
                self.assertLess(time.monotonic() - begin, 5.0)
                self.assertEqual(self.files(), ["m.gltf"])


if __name__ == "__main__":
    unittest.main()

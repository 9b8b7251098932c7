"""Help, the manual and completion say what the commands take; pictures go to a pipe."""

import re
import subprocess
import unittest

from program import PROGRAM, QUICK, SCENES, TECHNIQUES, Picture, ProgramTest, environment

COMMANDS = ("view", "shot", "record", "pictures", "verify", "measure", "epipolar", "reproduce", "cases", "list")


class Help(ProgramTest):
    def options_of(self, command):
        """Long names that its help lists."""
        return re.findall(r"(?m)^  (?:-\w, )?(--[\w-]+)", self.succeed(command, "--help"))

    def test_help_is_help(self):
        self.assertEqual(self.succeed("help"), self.succeed("--help"))
        for command in COMMANDS:
            with self.subTest(command=command):
                text = self.succeed("help", command)
                self.assertEqual(text, self.succeed(command, "--help"))
                self.assertRegex(text, r"Usage: ")
                self.assertRegex(text, rf"(?m)^  timeshade .*\b{command if command != 'view' else 'my_model'}",
                                 "an example")
                self.assertEqual([line for line in text.splitlines() if len(line) > 100], [])

    def test_groups_and_defaults(self):
        text = self.succeed("help", "shot")
        for group in ("Sampling", "Time", "Shutter", "Camera", "Light, ground and display", "Technique and view",
                      "Comparison", "Running"):
            self.assertIn(f"\n{group}:\n", text)
        words = " ".join(text.split())
        for said in ("default: 640x480", "(1 to 32; default: 8)", "default: tsm", "default: filmic", "default: 1024"):
            self.assertIn(said, words)
        self.assertIn("default: 320x240", " ".join(self.succeed("help", "measure").split()))

    def test_the_manual_has_every_option(self):
        manual = self.succeed("help", "--man").replace("\\-", "-")
        self.assertTrue(manual.startswith(".TH TIMESHADE 1 "))
        for command in COMMANDS:
            section = manual.split(f".SH OPTIONS OF {command}\n")[1].split("\n.SH ")[0]
            for option in self.options_of(command):
                self.assertIn(f"\\fB{option}\\fR", section, command)

    def test_completion_has_every_option_and_value(self):
        for shell in ("bash", "zsh", "fish"):
            text = self.succeed("help", "--completion", shell)
            for command in COMMANDS:
                for option in self.options_of(command):
                    self.assertIn(option if shell != "fish" else f"-l {option[2:]}", text, shell)
            for word in (*SCENES, *TECHNIQUES, "reinhard", "gaussian"):
                self.assertIn(word, text, shell)

    def completed(self, *words):
        (self.folder / "timeshade.bash").write_text(self.succeed("help", "--completion", "bash"))
        script = (f"source timeshade.bash; COMP_WORDS=({' '.join(words)}); COMP_CWORD={len(words) - 1}; _timeshade; "
                  "echo ${COMPREPLY[@]}")
        return subprocess.run(["bash", "-c", script], check=True, capture_output=True, text=True,
                              cwd=self.folder).stdout.split()

    def test_bash_completes(self):
        self.assertEqual(self.completed("timeshade", "sh"), ["shot"])
        self.assertEqual(self.completed("timeshade", "chess", "--tone-map", "f"), ["filmic"])
        self.assertEqual(self.completed("timeshade", "shot", "pil"), ["pillars"])
        self.assertEqual(self.completed("timeshade", "shot", "--technique", "ex"), ["exact"])
        self.assertIn("--light-move", self.completed("timeshade", "shot", "--light-"))
        self.assertEqual(self.completed("timeshade", "list", "--light-"), [])


class Pipe(ProgramTest):
    def piped(self, *arguments):
        return subprocess.run([PROGRAM, "shot", "chess", "-o", "-", *QUICK, *arguments], cwd=self.folder,
                              capture_output=True, check=False, env=environment())

    def test_a_picture_and_nothing_else(self):
        done = self.piped("--explain")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, self.shot("chess", "F.png", *QUICK))
        Picture(done.stdout)
        self.assertIn(b"technique", done.stderr)
        self.assertEqual(self.files(), ["F.png"])

    def test_what_a_pipe_does_not_take(self):
        self.refuse(2, ("--frames 2", "expected"), "shot", "chess", "-o", "-", *QUICK, "--frames", "2")
        with open("/dev/full", "wb") as full:
            done = subprocess.run([PROGRAM, "shot", "chess", "-o", "-", *QUICK], stdout=full, stderr=subprocess.PIPE,
                                  check=False, env=environment())
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"cannot write to standard output", done.stderr)


if __name__ == "__main__":
    unittest.main()

"""timeshade epipolar: a picture of what lies along a line of the shadow map, and what it refuses."""

import re
import unittest

from program import QUICK, TECHNIQUES, Picture, ProgramTest, environment

NO_GL = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}


class Epipolar(ProgramTest):
    def test_every_technique_gives_a_picture_and_a_line(self):
        for technique in TECHNIQUES:
            with self.subTest(technique=technique):
                drawn = []
                for name in ("A.png", "B.png"):
                    said = self.succeed("epipolar", "crossing", "--technique", technique, "--pixel", "36,33", *QUICK,
                                        "-o", name, "--gl-debug")
                    self.assertEqual(said.count("\n"), 1, said)
                    self.assertRegex(said, r"line [\d.,]+, [\d.]+ texels: 3 objects in truth, \d+ marks? stored, "
                                           r"\d+ samples of the pixel")
                    drawn.append((self.folder / name).read_bytes())
                self.assertEqual(*drawn, "the same command gave two pictures")

    def test_lines(self):
        """A row is a line, and where neither is given it is the middle one."""
        pictures = []
        for line in ((), ("--row", "0.5"), ("--line", "0,0.5,1,0.5"), ("--line", "1,0.5,0,0.5")):
            said = self.succeed("epipolar", "crossing", *QUICK, "-o", "F.png", *line)
            self.assertIsNone(re.search("samples", said), said)
            pictures.append((self.folder / "F.png").read_bytes())
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])
        self.assertGreater(Picture(pictures[0]).share_of_pixels_off(Picture(pictures[3]), 8), 0.01)

    def test_what_is_refused(self):
        command = ("epipolar", "crossing", *QUICK, "-o", "F.png")
        wrong = [("--line", value) for value in ("0,0.5", "0,0.5,1,0.5,1", "0,0.5,1,x", "0,0.5,1.1,0.5", "-1,0,1,1",
                                                 "0,nan,1,1", "0,0.5,0,0.5", "0;1;0;1", " 0,0,1,1", "0,0,1,1,")]
        wrong += [("--pixel", value) for value in ("64,0", "0,48", "-1,0", "3", "3,4,5", "a,b", "1.5,2", "nan,0")]
        wrong += [("--row", value) for value in ("1.5", "-0.1", "nan", "x")]
        for option, value in wrong:
            with self.subTest(option=option, value=value):
                self.refuse(2, (option, value, "expected"), *command, f"{option}={value}", env=environment(**NO_GL))
        self.refuse(2, ("--row", "--line"), *command, "--row", "0.2", "--line", "0,0,1,1", env=environment(**NO_GL))
        self.refuse(2, ("F.exr", ".png"), "epipolar", "crossing", *QUICK, "-o", "F.exr", env=environment(**NO_GL))
        self.refuse(1, ("--pixel 0,0", "shadow map"), *command, "--pixel", "0,0")


if __name__ == "__main__":
    unittest.main()

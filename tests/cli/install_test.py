"""The program as it is installed: data and libraries are found beside it, wherever it is moved to."""

import os
import pathlib
import shutil
import subprocess
import unittest

from program import PROGRAM, QUICK, ProgramTest, environment

BUILD = pathlib.Path(PROGRAM).parent


class Installed(ProgramTest):
    def setUp(self):
        super().setUp()
        self.first = self.folder / "first"
        for component in ("program", "libraries"):
            subprocess.run(["cmake", "--install", BUILD, "--prefix", self.first, "--component", component],
                           check=True, capture_output=True)

    def test_it_may_be_moved(self):
        elsewhere = self.folder / "else where"
        shutil.move(self.first, elsewhere)
        program = elsewhere / "bin" / "timeshade"
        subprocess.run([program, "shot", "pillars", "-o", "F.png", *QUICK], check=True, cwd=self.folder,
                       capture_output=True, env=environment())
        self.assertEqual((self.folder / "F.png").read_bytes(), self.shot("pillars", "G.png", *QUICK))
        # It reads what lies beside it, and nothing of the sources.
        (elsewhere / "share/timeshade/shaders/passes/shade.frag").unlink()
        done = subprocess.run([program, "shot", "pillars", "-o", "H.png", *QUICK], check=False, cwd=self.folder,
                              capture_output=True, text=True, env=environment())
        self.assertEqual(done.returncode, 1)
        self.assertIn(str(elsewhere / "share/timeshade/shaders"), done.stderr)

    def test_its_libraries_are_its_own(self):
        found = subprocess.run(["ldd", self.first / "bin/timeshade"], check=True, capture_output=True, text=True).stdout
        own = [line for line in found.splitlines() if "/bin/../lib/timeshade/" in line]
        self.assertGreater(len(own), 8, found)
        for line in found.splitlines():
            if line not in own and "=>" in line:
                self.assertRegex(line, r"lib(c|m|dl|pthread|stdc\+\+|gcc_s|z|EGL|GLdispatch)\.so", "not in the archive")

    def test_what_a_distribution_expects(self):
        for path in ("share/man/man1/timeshade.1", "share/applications/timeshade.desktop",
                     "share/bash-completion/completions/timeshade", "share/zsh/site-functions/_timeshade",
                     "share/fish/vendor_completions.d/timeshade.fish", "share/doc/timeshade/README.md",
                     "share/timeshade/assets/papers/palmer.json", "share/timeshade/assets/papers/page.js"):
            self.assertTrue((self.first / path).is_file(), path)
        self.assertTrue(os.access(self.first / "bin/timeshade", os.X_OK))
        script = (f"source '{self.first}/share/bash-completion/completions/timeshade'; PATH='{self.first}/bin':$PATH; "
                  "COMP_WORDS=(timeshade shot --shutter-); COMP_CWORD=2; _timeshade; echo ${COMPREPLY[@]}")
        words = subprocess.run(["bash", "-c", script], check=True, capture_output=True, text=True).stdout.split()
        self.assertIn("--shutter-position", words)


if __name__ == "__main__":
    unittest.main()

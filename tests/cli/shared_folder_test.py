"""A sticky folder that two users write to: one plants links at every name that the other's commands write to."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from program import PROGRAM, QUICK, ProgramTest, environment

ATTACKER, VICTIM = 1, 65534  # daemon and nobody, as on every system
MEASURE = ("--techniques", "static", "--spps", "1", "--rounds", "2", "--reference", "1", "--reference-rays", "0",
           "--map", "32", "--size", "24x16")
COMMANDS = {
    "shot": ("shot", "cubes", "-o", "F.png", "--json", "F.json", *QUICK),
    "frames": ("shot", "cubes", "-o", "F.exr", "--frames", "2", *QUICK),
    "video": ("record", "cubes", "-o", "V.mp4", "--frames", "1", "--json", "V.json", *QUICK),
    "pictures": ("record", "cubes", "-o", "P/", "--frames", "2", *QUICK),
    "verify": ("verify", "cubes", "--reference-rays", "0", "--json", "r.json", "--dump", "D", *QUICK),
    "epipolar": ("epipolar", "crossing", "--technique", "static", "--row", "0.5", "-o", "E.png", "--map", "32"),
    "measure": ("measure", "cubes", "-o", "M", *MEASURE),
}


@unittest.skipUnless(os.geteuid() == 0, "needs root to act as two users")
class SharedFolder(ProgramTest):
    def setUp(self):
        super().setUp()
        self.shared = self.folder / "shared"
        for folder in (self.folder, self.shared):
            folder.mkdir(exist_ok=True)
            folder.chmod(0o1777)
        self.precious = self.folder / "precious"
        self.private = self.folder / "private"
        self.private.mkdir()
        self.options = self.as_victim()

    def as_victim(self):
        """How the program is run: by a user who is not root, where one can."""
        elsewhere = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-user-"))
        self.addCleanup(shutil.rmtree, elsewhere, ignore_errors=True)
        os.chmod(elsewhere, 0o755)
        (elsewhere / "cache").mkdir()
        os.chown(elsewhere / "cache", VICTIM, VICTIM)
        options = {"executable": shutil.copy(PROGRAM, elsewhere), "user": VICTIM, "group": VICTIM,
                   "env": environment(HOME=elsewhere / "cache", XDG_CACHE_HOME=elsewhere / "cache",
                                      MESA_SHADER_CACHE_DIR=elsewhere / "cache")}
        done = subprocess.run([PROGRAM, *COMMANDS["shot"]], cwd=self.shared, capture_output=True, check=False,
                              **options)
        self.empty()
        if done.returncode == 0:
            self.user = VICTIM
            return options
        print("(run as root: no other user can read the checkout)", end=" ", flush=True)
        self.user = 0
        return {"env": environment()}

    def empty(self):
        for path in self.shared.iterdir():
            shutil.rmtree(path) if path.is_dir() and not path.is_symlink() else path.unlink()

    def run_here(self, command):
        return subprocess.run([PROGRAM, *command], cwd=self.shared, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=300, check=False, **self.options)

    def names_of(self, command):
        """Every file and folder that the command makes, relative to the shared folder."""
        self.empty()
        done = self.run_here(command)
        self.assertEqual(done.returncode, 0, done.stderr)
        return sorted(path.relative_to(self.shared) for path in self.shared.rglob("*"))

    def plant(self, name, target):
        self.empty()
        for parent in reversed(name.parents[:-1]):
            (self.shared / parent).mkdir(exist_ok=True)
            (self.shared / parent).chmod(0o1777)
        subprocess.run(["ln", "-s", target, self.shared / name], check=True, user=ATTACKER, group=ATTACKER)

    def test_planted_links(self):
        for command, arguments in COMMANDS.items():
            for name in self.names_of(arguments):
                with self.subTest(command=command, name=str(name)):
                    self.expect_untouched(arguments, name, self.private if name.suffix == "" else self.precious)

    def expect_untouched(self, arguments, name, target):
        self.precious.write_text("precious")
        shutil.rmtree(self.private)
        self.private.mkdir()
        for path in (self.precious, self.private):
            os.chown(path, self.user, self.user)
        self.plant(name, target)
        done = self.run_here(arguments)
        self.assertEqual(self.precious.read_text(), "precious")
        self.assertEqual(list(self.private.iterdir()), [])
        if done.returncode != 0:
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(str(name.parts[0]), done.stderr)
        else:
            self.assertTrue((self.shared / name).exists())
            self.assertFalse((self.shared / name).is_symlink(), "the link is still there")
        self.assertEqual([path for path in self.shared.rglob("*.part")], [])


if __name__ == "__main__":
    unittest.main()

"""Files that cannot be written, and runs that are stopped: what is there stays, nothing half-written is left."""

import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import PROGRAM, QUICK, Picture, ProgramTest, environment

SHOT = ("shot", "chess", *QUICK)
# Bytes that no part of these pictures fits into.
TINY = 4096


def mounted(kind):
    """Mounts a file system for a test, or says that this user may not."""
    folder = tempfile.mkdtemp(prefix="timeshade-mount-")
    done = subprocess.run(["mount", "-t", "tmpfs", "-o", kind, "tmpfs", folder], capture_output=True)
    if done.returncode != 0:
        os.rmdir(folder)
        raise unittest.SkipTest("this user may not mount file systems")
    return folder


def unmounted(folder):
    subprocess.run(["umount", folder], check=True)
    os.rmdir(folder)


class Unwritable(ProgramTest):
    def refuse_outputs(self, output, mentions, leaves=()):
        """As a picture, as an EXR and as a report, before there is a context."""
        env = environment(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        for ending in ("png", "exr"):
            self.refuse(1, mentions, *SHOT, "-o", f"{output}.{ending}", env=env, leaves=leaves)
        self.refuse(1, mentions, *SHOT, "-o", "F.png", "--json", f"{output}.png", env=env, leaves=leaves)

    def test_a_folder_that_is_not_there(self):
        self.refuse_outputs("missing/F", ("missing/F", "No such file or directory", "expected"))

    def test_a_file_in_place_of_the_folder(self):
        (self.folder / "file").write_text("kept")
        self.refuse_outputs("file/F", ("file/F", "Not a directory"), leaves=("file",))
        self.assertEqual((self.folder / "file").read_text(), "kept")

    def test_a_folder_in_its_place(self):
        for ending in ("png", "exr"):
            (self.folder / f"F.{ending}").mkdir()
        for ending in ("png", "exr"):
            self.refuse(1, (f"F.{ending}", "Is a directory"), *SHOT, "-o", f"F.{ending}", leaves=("F.exr", "F.png"))
        self.refuse(1, ("F.png", "Is a directory"), *SHOT, "-o", "G.png", "--json", "F.png", leaves=("F.exr", "F.png"))

    def test_no_permission(self):
        # Not even root can make a file here.
        self.refuse_outputs("/proc/F", ("/proc/F",))

    def test_a_folder_that_is_read_only(self):
        options = {}
        if os.geteuid() == 0:  # permissions do not bind root
            # A copy, since the checkout may lie where no other user can look (in /root, say).
            elsewhere = tempfile.mkdtemp()
            self.addCleanup(shutil.rmtree, elsewhere)
            os.chmod(elsewhere, 0o755)
            options = {"user": 65534, "group": 65534, "executable": shutil.copy(PROGRAM, elsewhere)}
            if subprocess.run([PROGRAM, "--version"], capture_output=True, check=False, **options).returncode != 0:
                self.skipTest("no other user can run the program here")
        os.chmod(self.folder, 0o555)
        self.addCleanup(os.chmod, self.folder, 0o755)
        self.refuse(1, ("F.png", "Permission denied"), *SHOT, "-o", "F.png", **options)

    def test_a_file_system_that_is_read_only(self):
        folder = mounted("ro")
        self.addCleanup(unmounted, folder)
        self.refuse_outputs(f"{folder}/F", (f"{folder}/F", "Read-only file system"))

    def test_every_file_of_a_sequence_is_tried_first(self):
        (self.folder / "F.0002.png").mkdir()
        self.refuse(1, ("F.0002.png", "Is a directory"), *SHOT, "-o", "F.png", "--frames", "3", leaves=("F.0002.png",))


class FullDisk(ProgramTest):
    def test_a_device_that_is_full(self):
        for ending in ("png", "exr"):
            (self.folder / f"F.{ending}").symlink_to("/dev/full")
        for ending in ("png", "exr"):
            self.refuse(1, (f"F.{ending}", "No space left on device"), *SHOT, "-o", f"F.{ending}",
                        leaves=("F.exr", "F.png"))

    def test_a_file_that_may_not_grow(self):
        """The limit of the process stands for a full disk: writing fails half-way through the picture."""
        old = b"the picture of yesterday"
        (self.folder / "F.png").write_bytes(old)
        limited = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (TINY, TINY)),
                   "restore_signals": False}
        for ending in ("png", "exr"):
            self.refuse(1, (f"F.{ending}", "File too large"), *SHOT, "-o", f"F.{ending}", leaves=("F.png",), **limited)
        self.assertEqual((self.folder / "F.png").read_bytes(), old)

    def test_a_file_system_that_is_full(self):
        folder = mounted(f"size={TINY}")
        self.addCleanup(unmounted, folder)
        for ending in ("png", "exr"):
            self.refuse(1, (f"{folder}/F.{ending}", "No space left on device"), *SHOT, "-o", f"{folder}/F.{ending}")
            self.assertEqual(os.listdir(folder), [])

    def test_standard_output_that_is_full(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([PROGRAM, "list"], stdout=full, stderr=subprocess.PIPE, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, "timeshade: error: cannot write to standard output: No space left on device\n")


class Stopped(ProgramTest):
    LONG = ("shot", "chess", "-o", "F.png", "--json", "F.json", "--technique", "accumulation", "--size", "320x240",
            "--set", "accumulation.renders=4096")

    def stop(self, name, leaves):
        program = subprocess.Popen([PROGRAM, *self.LONG], cwd=self.folder, env=environment(), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(program.stdout.close)
        self.addCleanup(program.stderr.close)
        self.addCleanup(program.wait)
        self.addCleanup(program.kill)
        # A quarter of a second of processor time is past the start and far from the end.
        deadline = time.monotonic() + 60
        while self.processor_seconds(program.pid) < 0.25 and program.poll() is None and time.monotonic() < deadline:
            time.sleep(0.02)
        self.assertIsNone(program.poll(), "ended before it could be stopped")
        self.assertEqual(self.files(), leaves, "written before it is whole")
        program.send_signal(getattr(signal, name))
        self.assertEqual(program.wait(timeout=60), -getattr(signal, name))
        self.assertEqual(self.files(), leaves)

    @staticmethod
    def processor_seconds(pid):
        try:
            fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:
            return 0.0
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def test_signals_leave_nothing(self):
        for name in ("SIGTERM", "SIGINT", "SIGHUP", "SIGKILL"):
            with self.subTest(signal=name):
                self.stop(name, [])

    def test_signals_leave_what_was_there(self):
        (self.folder / "F.png").write_bytes(b"old")
        self.stop("SIGTERM", ["F.png"])
        self.assertEqual((self.folder / "F.png").read_bytes(), b"old")


class Whole(ProgramTest):
    def test_existing_files_are_replaced(self):
        (self.folder / "F.png").write_bytes(b"old")
        Picture(self.shot("chess", "F.png", *QUICK))
        self.assertEqual(self.files(), ["F.png"])

    def test_links_are_followed(self):
        (self.folder / "F.png").symlink_to("G.png")
        self.shot("chess", "F.png", *QUICK)
        self.assertTrue((self.folder / "F.png").is_symlink())
        Picture((self.folder / "G.png").read_bytes())

    def test_exr(self):
        """Its frame: magic, version, three float channels, the size. --gl-debug refuses a NaN or an infinity in it."""
        data = self.shot("chess", "F.exr", *QUICK, "--gl-debug")
        self.assertEqual(data[:8], b"\x76\x2f\x31\x01\x02\0\0\0")
        self.assertIn(b"channels\0chlist\0", data)
        window = data.index(b"dataWindow\0box2i\0") + len(b"dataWindow\0box2i\0") + 4
        self.assertEqual([int.from_bytes(data[window + 4 * i:window + 4 * i + 4], "little") for i in range(4)],
                         [0, 0, 63, 47])
        self.assertEqual(data, self.shot("chess", "G.exr", *QUICK))


if __name__ == "__main__":
    unittest.main()

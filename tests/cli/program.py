"""What the suites of this folder share: the program under test, run without a display in a folder of its own."""

import ctypes
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from thorough import THOROUGH, drawn, in_thorough_tests  # noqa: E402

PROGRAM = os.environ.get("TIMESHADE", "")
SCENES = ("chess", "octopus", "pillars")  # those that are files
COMPUTED = ("cubes", "rising", "frusta", "sphere", "crossing", "depths", "cube", "foliage", "ball",
            "octopus-fine", "tree", "leg", "runner")


def listed_techniques():
    """Names of the techniques that the program has, in its order."""
    if not PROGRAM:
        return ()
    listed = subprocess.run([PROGRAM, "list", "--json"], capture_output=True, text=True, check=True)
    return tuple(technique["name"] for technique in json.loads(listed.stdout)["techniques"])


TECHNIQUES = listed_techniques()
# Small and quick: what these suites test does not depend on the number of pixels.
QUICK = ("--size", "64x48", "--map", "64", "--spp", "2", "--set", "accumulation.renders=2",
         "--set", "history.warm_up=2")


def environment(**changes):
    """The caller's environment without a display; None removes a variable."""
    names = dict(os.environ)
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "TIMESHADE_DATA", "TIMESHADE_SCENES", "TIMESHADE_SHADERS"):
        names.pop(name, None)
    for name, value in changes.items():
        if value is None:
            names.pop(name, None)
        else:
            names[name] = str(value)
    return names


def has_osmesa():
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
        try:
            ctypes.CDLL(name)
            return True
        except OSError:
            pass
    return False


# Newer Mesa releases have no OSMesa, and the program must do without.
CONTEXTS = ("egl", "osmesa") if has_osmesa() else ("egl",)


class FileBytes(bytes):
    """Bytes that do not spill into a test's report."""

    def __repr__(self):
        return f"<{len(self)} bytes, crc {zlib.crc32(self):08x}>"


class ProgramTest(unittest.TestCase):
    """Every test has an empty folder, which is the program's working directory."""

    def setUp(self):
        self.assertTrue(os.access(PROGRAM, os.X_OK), f"TIMESHADE={PROGRAM!r}: expected the program's path")
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_program(self, *arguments, env=None, timeout=300, **options):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, env=env or environment(),
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=timeout, encoding="utf-8", errors="replace", **options)

    def succeed(self, *arguments, **options):
        """Standard output of a run that must not fail nor complain."""
        done = self.run_program(*arguments, **options)
        self.assertEqual((done.returncode, done.stderr), (0, ""), f"timeshade {' '.join(map(str, arguments))}")
        return done.stdout

    def shot(self, scene, output, *arguments, **options):
        """The bytes of the picture drawn."""
        self.succeed("shot", scene, "-o", output, *arguments, **options)
        return FileBytes((self.folder / output).read_bytes())

    def refuse(self, code, mentions, *arguments, env=None, leaves=(), **options):
        """The run fails with the code and says why in one line that holds every one of `mentions`, prints nothing
        else, and leaves no file but `leaves`. Returns the line."""
        done = self.run_program(*arguments, env=env, **options)
        said = f"timeshade {' '.join(map(str, arguments))}\nexit code {done.returncode}\nstderr: {done.stderr!r}\n"
        self.assertEqual(done.returncode, code, said)
        lines = done.stderr.split("\n")
        self.assertEqual((len(lines), lines[-1]), (2, ""), said + "expected one whole line on stderr")
        self.assertTrue(lines[0].startswith("timeshade: error: "), said)
        for text in mentions:
            self.assertIn(text, lines[0], said)
        self.assertEqual(done.stdout, "", said)
        self.assertEqual(self.files(), sorted(leaves), said)
        return lines[0]

    def files(self):
        """Everything in the test's folder, part files included."""
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))


class Picture:
    """An eight-bit RGB or RGBA PNG, not interlaced: width, height, and its rows as bytes of RGB."""

    def __init__(self, data):
        if data[:8] != b"\x89PNG\r\n\x1a\n":
            raise ValueError("not a PNG")
        compressed, header, at = b"", None, 8
        while at < len(data):
            (length,) = struct.unpack_from(">I", data, at)
            kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
            (checksum,) = struct.unpack_from(">I", data, at + 8 + length)
            if zlib.crc32(kind + body) != checksum:
                raise ValueError(f"chunk {kind} is damaged")
            if kind == b"IHDR":
                header = struct.unpack(">IIBBBBB", body)
            elif kind == b"IDAT":
                compressed += body
            at += 12 + length
        if kind != b"IEND":
            raise ValueError("the file ends early")
        self.width, self.height, depth, colour, _, _, interlaced = header
        if depth != 8 or colour not in (2, 6) or interlaced:
            raise ValueError(f"bit depth {depth}, colour type {colour}, interlaced {interlaced}")
        channels = 3 if colour == 2 else 4
        rows = _unfiltered(zlib.decompress(compressed), self.width * channels, self.height, channels)
        if channels == 4:
            rows = [bytes(value for i, value in enumerate(row) if i % 4 != 3) for row in rows]
        self.rgb = b"".join(rows)

    def mean(self):
        return sum(self.rgb) / len(self.rgb)

    def share_of_pixels_off(self, other, tolerance):
        """Share of the pixels where some channel differs by more than the tolerance."""
        if (self.width, self.height) != (other.width, other.height):
            raise ValueError("pictures of different sizes")
        if self.rgb == other.rgb:
            return 0.0
        off = {i // 3 for i, (a, b) in enumerate(zip(self.rgb, other.rgb)) if abs(a - b) > tolerance}
        return len(off) / (self.width * self.height)


def _unfiltered(data, stride, height, channels):
    """PNG specification, section 9."""
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        if len(row) != stride:
            raise ValueError("the picture ends early")
        for x in range(stride if kind else 0):
            left = row[x - channels] if x >= channels else 0
            if kind == 1:
                predicted = left
            elif kind == 2:
                predicted = above[x]
            elif kind == 3:
                predicted = (left + above[x]) // 2
            else:
                corner = above[x - channels] if x >= channels else 0
                p = left + above[x] - corner
                a, b, c = abs(p - left), abs(p - above[x]), abs(p - corner)
                predicted = left if a <= b and a <= c else above[x] if b <= c else corner
            row[x] = (row[x] + predicted) & 255
        rows.append(bytes(row))
        above = row
    return rows

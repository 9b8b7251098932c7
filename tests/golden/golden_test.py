"""Pictures of the program against pictures that people have looked at.

    golden_test.py                    compares them all
    golden_test.py --update NAME...   draws the expected ones anew; all of them without a name

What differs is left in GOLDEN_OUT (build/golden) as NAME-actual.png, NAME-expected.png and NAME-difference.png."""

import os
import pathlib
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from program import PROGRAM, TECHNIQUES, Picture, environment  # noqa: E402

EXPECTED = pathlib.Path(__file__).resolve().parent / "expected"
OUT = pathlib.Path(os.environ.get("GOLDEN_OUT", "build/golden"))
COMMON = ("--size", "160x120", "--spp", "4", "--map", "256", "--seed", "1")

# Software renderers compile for the processor at hand: another order of sums, or a fused multiplication, changes a
# value by a level or two, and moves a sample across an edge. One of four samples is up to 64 levels in one pixel.
ROUNDING = {"levels": 6, "share": 0.004}
# Every sample is tested in a map whose texels were drawn with such values: more edges, more samples at them.
EDGES_OF_MAPS = {"levels": 6, "share": 0.012}
# Sixteen frames one after the other: what differed in one stays in the next.
HISTORY = {"levels": 8, "share": 0.02}

# Every technique that the program lists draws one picture; a new one's is skipped, by name, until it has been drawn.
OF_TECHNIQUES = {"exact": ROUNDING, "history": HISTORY}
FEWER_RENDERS = {"accumulation": ("--set", "accumulation.renders=8")}


CASES = {f"pillars-{name}": (("pillars", "--technique", name, *FEWER_RENDERS.get(name, ())),
                             OF_TECHNIQUES.get(name, EDGES_OF_MAPS)) for name in TECHNIQUES}
CASES |= {
    "octopus-static": (("octopus", "--technique", "static"), EDGES_OF_MAPS),
    "octopus-tsm": (("octopus", "--technique", "tsm"), EDGES_OF_MAPS),
    "octopus-ranges": (("octopus", "--technique", "ranges"), EDGES_OF_MAPS),
    "octopus-exact": (("octopus", "--technique", "exact"), ROUNDING),
    "chess-exact": (("chess", "--technique", "exact", "--camera", "knight"), ROUNDING),
    "chess-visibility": (("chess", "--technique", "exact", "--view", "visibility"), ROUNDING),
    "cubes-exact": (("cubes", "--technique", "exact", "--set", "cubes.count=100"), ROUNDING),
    "cubes-candidates": (("cubes", "--technique", "exact", "--set", "cubes.count=100", "--view", "candidates"),
                         EDGES_OF_MAPS),
    "octopus-instant": (("octopus", "--technique", "exact", "--instant", "0.25"), ROUNDING),
    "pillars-wipe": (("pillars", "--compare", "tsm,exact", "--seam", "0.4"), EDGES_OF_MAPS),
}


def draw(arguments, path):
    done = subprocess.run([PROGRAM, "shot", *arguments, *COMMON, "-o", str(path)], env=environment(),
                          stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise AssertionError(done.stderr)


def write_png(path, width, height, rgb):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) +
                     chunk(b"IEND", b""))


class Golden(unittest.TestCase):
    maxDiff = None


def compare(name, arguments, levels, share):
    def test(self):
        if not (EXPECTED / f"{name}.png").exists():
            self.skipTest(f"there is no expected picture {name} yet: look at it and ./test --update-golden {name}")
        OUT.mkdir(parents=True, exist_ok=True)
        kept = [OUT / f"{name}-{what}.png" for what in ("actual", "expected", "difference")]
        for path in kept:
            path.unlink(missing_ok=True)
        draw(arguments, kept[0])
        actual, expected = Picture(kept[0].read_bytes()), Picture((EXPECTED / f"{name}.png").read_bytes())
        same_size = (actual.width, actual.height) == (expected.width, expected.height)
        off = actual.share_of_pixels_off(expected, levels) if same_size else 1.0
        if off <= share:
            kept[0].unlink()
            return
        shutil.copy(EXPECTED / f"{name}.png", kept[1])
        if same_size:
            write_png(kept[2], actual.width, actual.height,
                      bytes(min(255, 4 * abs(a - b)) for a, b in zip(actual.rgb, expected.rgb)))
        self.fail(f"{name}: {100 * off:.2f} % of the pixels differ by more than {levels} levels, "
                  f"expected at most {100 * share:.2f} %; "
                  f"see {kept[0]}, and if it is right: ./test --update-golden {name}")
    return test


for case, (words, tolerance) in CASES.items():
    setattr(Golden, "test_" + case.replace("-", "_"), compare(case, words, **tolerance))


class Complete(unittest.TestCase):
    def test_no_picture_without_a_case(self):
        self.assertLessEqual({path.stem for path in EXPECTED.glob("*")}, set(CASES))

    def test_a_difference_is_seen(self):
        """Two techniques are further apart than any tolerance."""
        one, other = (Picture((EXPECTED / f"pillars-{name}.png").read_bytes()) for name in ("tsm", "exact"))
        self.assertGreater(one.share_of_pixels_off(other, 8), 0.1)


def update(names):
    unknown = sorted(set(names) - set(CASES))
    if unknown:
        sys.exit(f"no such picture: {', '.join(unknown)}; expected some of {', '.join(CASES)}")
    EXPECTED.mkdir(exist_ok=True)
    for name in names or CASES:
        draw(CASES[name][0], EXPECTED / f"{name}.png")
        print(EXPECTED / f"{name}.png")


if __name__ == "__main__":
    if "--update" in sys.argv:
        update(sys.argv[sys.argv.index("--update") + 1:])
    else:
        unittest.main()

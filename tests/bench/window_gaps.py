#!/usr/bin/env python3
"""The longest time without a frame of the window, while a full frame, a magnifier and a reference are computed.

    TIMESHADE=build/release/timeshade tests/bench/window_gaps.py [TECHNIQUE...]

By the window's own log (TIMESHADE_FRAME_LOG), on a display of its own. Where the window has announced what it does
(loading, a shader's first link), or there was nothing to do, that counts not.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "window"))

from desk import PROGRAM, Display, Window  # noqa: E402

LARGE = ("--size", "1160x864", "--spp", "32", "--map", "1024")


def gaps(lines):
    """(milliseconds, work) of every two frames after each other."""
    frames = [line.split(maxsplit=3) for line in lines]
    for before, after in zip(frames, frames[1:]):
        if len(before) == 3 and len(after) == 3 and after[1] != "rest":
            yield float(after[0]) - float(before[0]), after[1]


def measure(display, technique, folder):
    log = folder / f"{technique}.txt"
    window = Window(display, "chess", "--technique", technique, *LARGE, TIMESHADE_FRAME_LOG=str(log),
                    XDG_CACHE_HOME=str(folder / technique))
    parts, begin = [], 0

    def part(name):
        nonlocal begin
        lines = log.read_text().splitlines()
        parts.append((name, max(gaps(lines[begin:]), default=(0.0, ""))))
        begin = len(lines)

    try:
        window.wait(lambda d: d["state"]["settled"] and not d["state"]["shown_preview"], "a full picture", 600)
        part("frame")
        state = window.state()
        (width, height), (whole, _) = state["drawn"], state["window"]
        window.point(whole - width / 2, height * 0.6)
        window.key("m")
        window.wait(lambda d: d["state"]["probe"] == [True, True], "the magnifier", 600)
        part("magnifier")
        window.key("m")
        window.open_tab("compare")
        window.choose("compare", "truth")
        window.wait(lambda d: d["state"].get("compare.second", "").startswith("Ground truth, 8 spp"), "rays", 600)
        part("reference")
    finally:
        window.close()
    return parts


def main():
    listed = json.loads(subprocess.run([PROGRAM, "list", "--json"], check=True, capture_output=True).stdout)
    techniques = sys.argv[1:] or [each["name"] for each in listed["techniques"]]
    display = Display()
    with tempfile.TemporaryDirectory(prefix="timeshade-gaps-") as folder:
        for technique in techniques:
            for name, (milliseconds, work) in measure(display, technique, pathlib.Path(folder)):
                print(f"{technique:14} {name:10} {milliseconds:7.0f} ms  {work}", flush=True)
    display.close()


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Draws the README's tour: a newcomer's first steps in the real window, on a display of its own (Xvfb).

    TIMESHADE=build/release/timeshade docs/pictures/tour.py [FOLDER]     # default: docs/pictures
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TESTS = HERE.parents[1] / "tests"
sys.path[:0] = [str(TESTS / "window"), str(TESTS / "cli")]
from box_model import box_model  # noqa: E402  pylint: disable=wrong-import-position
from desk import Display, Window, shown  # noqa: E402  pylint: disable=wrong-import-position



class Tour:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.display = Display()
        self.window = None

    def save(self, name):
        window = self.window
        window.frames(3)
        seen = window.look()
        subprocess.run(["convert", "-size", f"{seen.width}x{seen.height}", "-depth", "8", "rgb:-", "-quality", "86",
                        str(self.folder / f"tour-{name}.jpg")], input=seen.data, check=True)

    def place(self, x, y):
        """A place of the picture, by its shares of width and height."""
        (width, height), (whole, _) = self.window.state()["drawn"], self.window.state()["window"]
        return whole - width + x * width, y * height

    def compared(self):
        self.window.wait(lambda d: d["state"]["compared"], "both pictures", 500)

    def start(self):
        self.window = Window(self.display)
        self.window.resize(860, 560)
        self.compared()
        self.save("1-start")

    def seam(self):
        seam = self.window.state()["seam"]
        self.window.drag(*self.place(seam, 0.4), *self.place(0.3, 0.4))
        self.window.click("story.close")
        self.compared()
        self.save("2-seam")

    def magnifier(self):
        # The soft edge of the shadow of what moves.
        self.window.point(*self.place(0.365, 0.93))
        self.window.key("m")
        self.window.wait(lambda d: d["state"]["probe"] == [True, True], "all values", 400)
        self.save("3-magnifier")
        self.window.key("Escape")

    def own_model(self):
        window = self.window
        (window.folder / "box.gltf").write_text(box_model())
        window.choose("compare", "none")
        window.click("scene.path")
        window.type("box.gltf")
        window.key("Return")
        window.settle(scene="box.gltf", loading="")
        for section in ("camera", "time"):
            if shown(window.dump(), f"section.{section}"):
                window.click(f"section.{section}")
                window.frames(3)  # what is below has moved
        window.click("section.light")
        window.wait(lambda d: shown(d, "section.light"), "the section")
        window.hand("keydown", "ctrl")
        window.drag(*self.place(0.5, 0.5), *self.place(0.62, 0.62))
        window.hand("keyup", "ctrl")
        window.settle()
        self.save("4-own-model")

    def record(self):
        window = self.window
        window.key("ctrl+r")
        window.wait(lambda d: d["state"]["recording"][1] >= 12, "twelve frames", 240)
        self.save("5-recording")
        window.key("ctrl+r")
        window.wait(lambda d: d["state"]["recorded"], "the file", 60)

    def settings(self):
        window = self.window
        window.open_tab("technique")
        window.key("ctrl+s")
        window.wait(lambda d: "Saved" in shown(d, "notice"), "the file")
        window.settle()
        self.save("6-saved")

    def run(self):
        try:
            for step in (self.start, self.seam, self.magnifier, self.own_model, self.record, self.settings):
                print(step.__name__, flush=True)
                step()
            assert self.window.quit() == 0, self.window.standard_error()
        finally:
            if self.window is not None:
                self.window.close()
            self.display.close()


if __name__ == "__main__":
    Tour(sys.argv[1] if len(sys.argv) > 1 else HERE).run()

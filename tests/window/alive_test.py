"""The real window while something takes long: it stays alive, says what it shows, and takes back what was done."""

import json
import pathlib
import random
import re

from desk import QUICK, WindowTest, run_tests, shown

# A full frame of some seconds on a software renderer.
SLOW = ("--size", "860x600", "--spp", "32", "--map", "1024", "--gl-debug")


class Alive(WindowTest):
    def slow_frame(self, window):
        """The dump of a moment within a full frame, after some slices of it."""
        dump = window.wait(lambda d: "rendering" in d["state"].get("chips", []), "a full frame at work")
        begun, slices = dump["state"]["begun"], dump["state"]["slices"][0]
        return window.wait(lambda d: d["state"]["begun"] == begun and d["state"]["slices"][0] > slices + 2,
                           "slices of one frame")

    def test_the_window_draws_within_a_frame_and_a_key_ends_it(self):
        log = pathlib.Path(self.enterContext(self.folder())) / "frames.txt"
        window = self.open("chess", "--technique", "tsm", *SLOW, TIMESHADE_FRAME_LOG=str(log))
        before = self.slow_frame(window)["state"]
        self.assertEqual(before["picture"], "drawing")
        self.assertEqual(before["slices"][1], 0, "nothing was cancelled")
        window.key("Right")  # another moment: the frame is of no use any more
        after = window.wait(lambda d: d["state"]["slices"][1] > before["slices"][1], "the end of the frame")["state"]
        self.assertGreater(after["frames"], before["frames"])
        window.wait(lambda d: d["state"]["begun"] > before["begun"], "the next picture")
        # What does not change the picture does not end it.
        dump = self.slow_frame(window)["state"]
        window.key("F1")
        window.wait(lambda d: "keys.close" in d["widgets"], "the list of keys")
        self.assertEqual(window.state()["slices"][1], dump["slices"][1])
        window.key("Escape")
        window.wait(lambda d: "keys.close" not in d["widgets"], "no list of keys")
        # Escape leaves the state, too: what has been drawn stays, and goes on where that is wished. A frame may have
        # been whole just before.
        for _ in range(5):
            self.slow_frame(window)
            window.key("Escape")
            window.frames(3)
            if "stopped" in window.state()["chips"]:
                break
            window.key("Right")
        state = window.state()
        self.assertIn("stopped", state["chips"])
        self.assertEqual((state["picture"], state["shown_preview"]), ("cancelled", True))
        window.click("chip.stopped")
        window.wait(lambda d: d["state"]["settled"] and not d["state"]["shown_preview"], "the full picture")
        work = [line for line in log.read_text().splitlines() if line.split()[1] == "first"]
        self.assertGreater(len(work), 10, "frames of the window within frames of the picture")
        self.close(window)

    def folder(self):
        import tempfile
        return tempfile.TemporaryDirectory(prefix="timeshade-alive-")

    def enterContext(self, context):
        """As unittest has it since Python 3.11."""
        value = context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        return value


class Honest(WindowTest):
    STATUS = re.compile(r"^(Preview )?(\d+) x (\d+), (\d+) (?:spp|renders), map (\d+)(?:, [0-9.]+ m?s)?")
    LABEL = re.compile(r"^.*, (\d+) spp, map (\d+)(, preview)?(, shadow error [0-9.e-]+)?(?:, [0-9.e+]+ m?s)?$")

    def check(self, dump):
        state = dump["state"]
        status = self.STATUS.match(shown(dump, "status"))
        if not status or not state.get("manifest"):
            return 0
        made = state["manifest"]
        self.assertEqual([int(status[2]), int(status[3])], made["size"], dump)
        self.assertEqual((int(status[4]), status[5]), (made["spp"], made["map"]), dump)
        self.assertEqual(bool(status[1]), state["shown_preview"])
        self.assertEqual("preview" in state["chips"], state["shown_preview"])
        label = self.LABEL.match(state.get("compare.first", ""))
        if label:
            self.assertEqual((int(label[1]), label[2]), (made["spp"], made["map"]), dump)
            self.assertEqual(bool(label[3]), state["shown_preview"], dump)
            self.assertFalse(label[3] and label[4], "a preview has no error")
        return 2 if state["shown_preview"] else 1

    def test_figures_are_those_of_the_picture_that_is_shown(self):
        """As they stand on the screen; 200 random states are those of a session without a window."""
        window = self.open("pillars", *QUICK, "--compare", "tsm,static", "--spp", "8")
        rng = random.Random(5)
        seen = {0: 0, 1: 0, 2: 0}
        keys = ("Right", "Left", "x", "period", "v", "1", "2", "space", "r")
        for _ in range(8):
            key = rng.choice(keys)
            window.key(key)
            if key == "space":
                window.frames(3)
                window.key("space")
            for _ in range(4):
                seen[self.check(window.dump())] += 1
                window.frames(1)
            seen[self.check(window.settle())] += 1
        self.assertGreater(seen[1], 4, seen)
        self.assertGreater(seen[2], 3, seen)
        self.close(window)


class Kept(WindowTest):
    def test_undo_redo_and_names(self):
        window = self.open("pillars", "--technique", "tsm", *QUICK)
        window.settle()
        spp = window.widget("spp")["value"]
        changed = window.drag_slider("spp", 0.4)
        self.assertNotEqual(changed, spp)
        window.key("2")
        window.settle()
        other = window.state()["technique"]
        window.key("ctrl+z")
        window.settle(technique="tsm")
        window.key("ctrl+z")
        window.wait(lambda d: d["widgets"]["spp"]["value"] == spp, "the samples of before")
        window.key("ctrl+y")
        window.wait(lambda d: d["widgets"]["spp"]["value"] == changed, "the samples again")
        window.key("ctrl+shift+z")
        window.settle(technique=other)
        window.key("p")
        first = window.wait(lambda d: d["state"]["saved"] == 1, "a file")["state"]["screenshot"]
        data = pathlib.Path(first).read_bytes()
        window.key("p")
        second = window.wait(lambda d: d["state"]["saved"] == 2, "another file")["state"]["screenshot"]
        self.assertEqual(pathlib.Path(second).name, pathlib.Path(first).stem + "-2.png")
        self.assertEqual(pathlib.Path(first).read_bytes(), data)
        self.close(window)

    def test_the_story_is_told_once(self):
        window = self.open()
        state = window.wait(lambda d: "story" in d["widgets"], "the card")["state"]
        self.assertEqual((state["scene"], len(state["compare"])), ("chess", 2))
        window.click("story.close")
        window.wait(lambda d: "story" not in d["widgets"], "no card")
        config = pathlib.Path(window.environment["XDG_CONFIG_HOME"])
        self.assertEqual(window.quit(), 0, window.standard_error())
        self.assertTrue(json.loads((config / "timeshade" / "window.json").read_text())["story_closed"])

    def test_a_small_window_and_a_wide_panel(self):
        window = self.open("pillars", "--technique", "static", *QUICK)
        window.settle()
        window.resize(500, 400)
        self.assertGreaterEqual(window.settle()["state"]["drawn"][0], 200)
        window.resize(1200, 700)
        before = window.settle()["state"]["drawn"][0]
        x0, y0, x1, y1 = window.widget("panel.edge")["rect"]
        window.drag((x0 + x1) / 2, 300, (x0 + x1) / 2 + 100, 300)
        self.assertAlmostEqual(window.settle()["state"]["drawn"][0], before - 100, delta=3)
        self.close(window)


if __name__ == "__main__":
    run_tests()

"""The real window: techniques beside each other, and what is found out about them."""

import pathlib
import re
import shutil
import tempfile
import time

from desk import PANEL_WIDTH, QUICK, THOROUGH, WindowTest, headless, in_thorough_tests, pixels, run_tests, shown

SCENES = ("chess", "octopus", "pillars")
# A history learns from many frames before the first: what is looked at here does not depend on how many.
SHORT_HISTORY = ("--set", "history.warm_up=2")


class Techniques(WindowTest):
    def test_every_technique_and_scene(self):
        window = self.open("chess", "--technique", "tsm", *QUICK, "--size", "640x480", *SHORT_HISTORY)
        window.settle(technique="tsm", scene="chess")
        self.assert_readable(window)
        titles = self.technique_titles(window)
        self.assertGreaterEqual(len(titles), 3)
        seen = {}
        for title in titles:
            window.choose("technique", title)
            window.wait(lambda dump: dump["widgets"].get("technique", {}).get("value") == title, title)
            state = window.settle()["state"]
            if state["picture"] == "failed":
                self.assertTrue(state["failure"])
                continue
            seen[title] = window.look_at_picture()
            self.assert_picture(seen[title])
        for i, one in enumerate(seen):
            for other in list(seen)[:i]:
                self.assertGreater(seen[one].share_different(seen[other]), 0.0005, f"{one} and {other} draw the same")
        # The same by key; the first of the list is the first key.
        window.key("2", "1")
        window.settle(technique="static")
        pictures = {}
        for scene in SCENES:
            window.choose("scene", scene)
            window.settle(scene=scene)
            pictures[scene] = window.look_at_picture()
            self.assert_picture(pictures[scene])
        self.assertGreater(pictures["chess"].share_different(pictures["octopus"]), 0.3)
        self.assertGreater(pictures["chess"].share_different(pictures["pillars"]), 0.3)
        self.close(window)

    def technique_titles(self, window):
        window.click("technique")
        dump = window.wait(lambda d: any(name.startswith("technique/") for name in d["widgets"]),
                           "the list of techniques")
        window.key("Escape")
        window.press_at(*self.middle_of_picture(window))
        window.wait(lambda d: not any(name.startswith("technique/") for name in d["widgets"]), "the list to close")
        return [name.split("/", 1)[1] for name in dump["widgets"] if name.startswith("technique/")]

    @staticmethod
    def middle_of_picture(window):
        width, height = window.state()["window"]
        return (PANEL_WIDTH + width) / 2, height / 3

    def assert_readable(self, window):
        """Light letters on a dark panel: both there, and far apart."""
        width, height = window.state()["window"]
        levels = sorted(window.look().crop(0, 0, PANEL_WIDTH, height).grey())
        self.assertLess(levels[len(levels) // 2], 60)
        light = sum(1 for level in levels if level > 160) / len(levels)
        self.assertGreater(light, 0.01)
        self.assertLess(light, 0.3)

    def assert_picture(self, picture):
        levels = sorted(picture.grey())
        self.assertGreater(levels[-len(levels) // 50] - levels[len(levels) // 50], 40, "the picture is of one colour")


class Compared(WindowTest):
    def test_wipe_with_a_seam_to_drag(self):
        window = self.open("pillars", "--technique", "tsm", *QUICK)
        window.settle()
        alone = window.look_at_picture()
        window.choose("compare", "exact")
        window.wait_state(compare=["tsm", "exact"], compared=True)
        dump = window.wait(lambda d: "error" in d["state"].get("compare.first", "")
                           and "error" in d["state"].get("compare.second", ""), "both errors", 90)
        self.assertRegex(dump["state"]["compare.first"],
                         r"^TSM, 2 spp, map 256, shadow error [0-9.e-]+, [0-9.e+]+ ms$")
        error = [float(dump["state"][f"compare.{name}"].split("error ")[1].split(",")[0])
                 for name in ("first", "second")]
        self.assertGreater(error[0], 1.5 * error[1], "what is wrong with tsm here")
        (width, height), (whole, _) = dump["state"]["drawn"], dump["state"]["window"]
        left = whole - width
        window.drag(left + width / 2, height / 2, left + 3 * width / 4, height / 2)
        state = window.wait(lambda d: abs(d["state"]["seam"] - 0.75) < 0.01, "the seam")["state"]
        self.assertFalse(state["hand_camera"], "the seam was dragged, not the camera")
        wiped = window.look_at_picture()
        seam = round(0.75 * width)
        below = (0, 90)
        same = wiped.crop(below[0], below[1], seam - 8,
                          height).share_different(alone.crop(below[0], below[1], seam - 8, height), 0)
        self.assertEqual(same, 0, "left of the seam is the first's")
        self.assertGreater(wiped.crop(seam + 8, 90, width,
                                      height).share_different(alone.crop(seam + 8, 90, width, height)), 0.05)
        # Saved as one, and as the command line draws it.
        window.key("p")
        path = window.wait(lambda d: d["state"]["saved"] == 1, "the file")["state"]["screenshot"]
        data = pathlib.Path(path).read_bytes()
        self.assertIn(b"iTXttimeshade", data)
        self.assertIn(b'"technique": "exact"', data)
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        saved = pixels(path)
        headless(command, window.folder)
        self.assertEqual(saved == pixels(path), True, command)
        self.assertNotIn(b"iTXt", pathlib.Path(path).read_bytes(), "drawn anew")
        # Exchanged, the sliders are the other's; a held key shows the second alone.
        window.key("x")
        window.wait_state(compare=["exact", "tsm"], technique="exact", compared=True)
        window.hand("keydown", "f")
        window.wait(lambda d: "compare.first" not in d["state"] and "compare.second" in d["state"], "the second alone")
        held = window.look_at_picture()
        window.hand("keyup", "f")
        # Below there are notices of what was saved.
        self.assertEqual(held.crop(0, 60, width, height // 2).share_different(alone.crop(0, 60, width, height // 2), 0),
                         0)
        window.click("compare.mode/difference")
        window.wait(lambda d: d["state"].get("compare.second", "").startswith("- "), "the difference")
        levels = sorted(window.look_at_picture().crop(0, 60, width, height // 2).grey())
        self.assertLess(levels[len(levels) // 4], 8, "where they agree it is dark")
        window.key("shift+p")
        path = window.wait(lambda d: d["state"]["screenshot"].endswith(".exr"), "the EXR")["state"]["screenshot"]
        self.assertEqual(pathlib.Path(path).read_bytes()[:4], b"\x76\x2f\x31\x01")
        window.choose("compare", "none")
        window.settle(compare=[])
        self.close(window)


class Pages(WindowTest):
    def test_the_technique_s_page_and_files_opened_before(self):
        window = self.open("chess", "--technique", "tsm", *QUICK)
        window.settle()
        window.click("technique.page")
        window.wait(lambda d: d["widgets"].get("page", {}).get("value") == "tsm", "the page")
        x0, y0, x1, y1 = window.wait(lambda d: "page.picture" in d["widgets"],
                                     "its picture")["widgets"]["page.picture"]["rect"]
        levels = window.look().crop(x0, y0, x1, y1).grey()
        self.assertGreater(max(levels) - min(levels), 60, "nothing is drawn there")
        window.key("i")
        window.wait(lambda d: "page" not in d["widgets"], "no page")
        shutil.copy(pathlib.Path(__file__).parents[2] / "assets/scenes/octopus.glb", window.folder)
        window.click("scene.path")
        window.type("octopus.glb")
        window.click("scene.open")
        window.wait(lambda d: d["state"]["scene"].endswith("octopus.glb"), "the file")
        window.choose("scene", "pillars")
        window.settle(scene="pillars")
        window.frames(3)  # the list stands lower than before
        window.choose("scene.recent", "octopus.glb")
        window.settle(scene=str(window.folder / "octopus.glb"))
        self.close(window)


class Magnifier(WindowTest):
    def magnified(self, window, x, y):
        """The magnifier's rows at a place of the picture, and how they look. Of each sample [from, to, lit, truth]."""
        state = window.settle()["state"]
        (width, height), (whole, _) = state["drawn"], state["window"]
        window.point(whole - width + width * x, height * y)
        window.key("m")
        dump = window.wait(lambda d: d["state"]["probe"] == [True, True], "all values")
        last = None
        while dump["widgets"] != last:  # it takes its size and place a frame after its contents
            last = dump["widgets"]
            window.frames(2)
            dump = window.dump()
        rows = {name.split(".", 1)[1]: widget for name, widget in dump["widgets"].items() if name.startswith("probe.")}
        self.assertGreaterEqual(len(rows), 6)
        seen = window.look()
        for name, row in rows.items():
            with self.subTest(name):
                self.assert_drawn(seen, row["rect"], row["value"])
        return {name: row["value"] for name, row in rows.items()}

    def assert_drawn(self, seen, rect, values):
        """Marks at instants and bars over intervals, each as grey as its value, above those of the truth."""
        values = [value for value in values if value[2] >= 0]
        x0, y0, x1, _ = rect
        for which, top, height in ((2, y0, 11), (3, y0 + 12, 5)):
            for value in values:
                of_interval = sorted((v for v in values if v[:2] == value[:2]), key=lambda v: (-v[2], -v[3]))
                begin, end = (x0 + share * (x1 - x0) for share in value[:2])
                if begin == end:
                    others = [x0 + v[0] * (x1 - x0) for v in values if v is not value]
                    if any(abs(other - begin) < 8 for other in others):
                        continue  # one mark hides a part of the other
                    begin, end = max(begin - 2, x0), min(begin + 2, x1)
                for row in range(height):
                    # A row's middle may lie just between two.
                    place = (row + 0.5) * len(of_interval) / height
                    shown = {of_interval[int(place + side)][which] for side in (-1e-4, 1e-4)}
                    line = seen.crop(int(begin), top + row, max(int(end) - 1, int(begin) + 1), top + row + 1).grey()
                    self.assertLessEqual(min(max(abs(grey - 255 * one) for grey in line) for one in shown), 1,
                                         (value, row, line))

    def test_the_samples_of_pixels(self):
        """In one window: every technique's programs are compiled once."""
        window = self.open("pillars", "--technique", "tsm", "--set", "static.pcf_radius=2", *QUICK, "--spp", "8",
                           "--frame", "12", "--size", "640x430", *SHORT_HISTORY)
        self.check_samples(window)
        self.check_values_between(window)
        if THOROUGH:
            window.choose("scene", "foliage")
            window.settle(scene="foliage")
            self.check_cut_out(window)
        self.close(window)

    def check_samples(self, window):
        rows = self.magnified(window, 0.4, 0.75)
        self.assertLessEqual({"tsm", "exact", "static"}, set(rows))
        self.assertEqual({len(values) for values in rows.values()}, {8})
        truth = [value[3] for value in rows["exact"]]
        self.assertEqual([value[2] for value in rows["exact"]], truth, "exact is the ray tracer's equal")
        self.assertTrue(any(value >= 0 for value in truth), rows)
        # At their own times, one in each stratum; the truth is a property of the samples alone.
        for name in ("tsm", "exact", "static"):
            self.assertEqual([int(8 * value[0]) for value in rows[name]], list(range(8)))
            self.assertEqual([value[0] for value in rows[name]], [value[1] for value in rows[name]])
            self.assertEqual([value[3] for value in rows[name]], truth)
        segments = window.dump()["widgets"]["seen.segments"]["value"]
        self.assertEqual([segments[0][1], segments[-1][2]], [0, 1])
        self.assertTrue(all(a[2] == b[1] and a[0] != b[0] for a, b in zip(segments, segments[1:])), segments)
        lit = sum((end - begin) * lit for _, begin, end, lit in segments)
        self.assertLess(abs(lit - sum(truth) / len(truth)), 0.35, "a pixel's centre against eight of its samples")
        window.key("m")
        window.wait_state(probe=[False, False])

    def check_values_between(self, window):
        """Blurred over the map, and averaged over the whole shutter."""
        rows = self.magnified(window, 0.52, 0.62)
        blurred = rows["static"]
        self.assertTrue(any(0.1 < lit < 0.9 for _, _, lit, _ in blurred), blurred)
        self.assertLessEqual({truth for _, _, _, truth in blurred}, {0, 1}, "a blur is no part of the truth")
        averaging = [values for values in rows.values() if values[0][:2] == [0, 1]]
        self.assertTrue(averaging, rows)
        for values in averaging:
            self.assertEqual({tuple(value[:2]) for value in values}, {(0, 1)})
            self.assertTrue(any(0.1 < truth < 0.9 for _, _, _, truth in values), values)
        window.key("m")
        window.wait_state(probe=[False, False])

    def check_cut_out(self, window):
        """What alpha cuts out has values but no segments."""
        rows = self.magnified(window, 0.5, 0.6)
        self.assertEqual({len(values) for values in rows.values()}, {8})
        self.assertNotIn("seen.segments", window.dump()["widgets"])


class Shaders(WindowTest):
    def test_broken_and_mended(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-shaders-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        shutil.copytree(pathlib.Path(__file__).parents[2] / "shaders", folder / "shaders")
        file = folder / "shaders/passes/display.frag"
        good = file.read_text()
        # Without --gl-debug: the driver complains of the broken shader, as it should.
        window = self.open("chess", "--technique", "static", *QUICK[:-1], TIMESHADE_SHADERS=str(folder / "shaders"))
        window.settle()
        before = window.look_at_picture()
        file.write_text(good.replace("void main()", "void main( oops"))
        state = window.wait(lambda d: d["state"]["shader_log"], "the driver's complaint")["state"]
        self.assertIn("display.frag", state["shader_log"][0])
        state = window.settle()["state"]
        self.assertEqual(state["picture"], "complete")
        width, height = state["drawn"]
        self.assertEqual(window.look_at_picture().crop(0, height * 2 // 3, width,
                                                       height).share_different(before.crop(0, height * 2 // 3, width,
                                                                                           height), 0), 0,
                         "the last good program stays")
        # Mended, and changed: what it draws is dark.
        end = good.rindex("}")
        name = re.search(r"out vec4 (\w+);", good).group(1)
        file.write_text(good[:end] + f"    {name} *= 0.25;\n" + good[end:])
        window.wait(lambda d: d["state"]["shader_log"] == [], "the mended shader")
        window.settle()
        after = window.look_at_picture()
        self.assertLess(sum(after.grey()), 0.6 * sum(before.grey()))
        number = window.state()["shaders"]
        window.key("F5")
        window.wait(lambda d: d["state"]["shaders"] == number + 1, "the reloaded shaders")
        file.write_text(good)
        window.wait(lambda d: d["state"]["shaders"] > number + 1, "the first shader")
        window.settle()
        self.close(window)


class Accuracy(WindowTest):
    @in_thorough_tests
    def test_live_point_and_equal_time(self):
        cache = tempfile.mkdtemp(prefix="timeshade-cache-")
        self.addCleanup(shutil.rmtree, cache, ignore_errors=True)
        # Low and wide: the reference is made for few pixels.
        window = self.open("pillars", "--technique", "tsm", *QUICK, "--size", "900x330", XDG_CACHE_HOME=cache)
        window.settle()
        begun = window.state()["begun"]
        self.assertNotIn("accuracy", window.state())
        window.click("section.accuracy")
        dump = window.wait(lambda d: d["state"].get("accuracy", {}).get("points") == 1
                           and d["state"]["accuracy"]["state"] == "idle", "the live point", seconds=180)
        self.assertGreater(float(shown(dump, "accuracy.shadow")), 0.0)
        self.assertGreater(float(shown(dump, "accuracy.rmse")), 0.0)
        self.assertRegex(shown(dump, "accuracy.ms"), r"^[0-9.]+ ms$")
        self.assertEqual(window.state()["begun"], begun, "the picture is left alone")
        window.click("accuracy.time")
        dump = window.wait(lambda d: d["state"]["accuracy"]["said"] and d["state"]["accuracy"]["state"] == "idle",
                           "an equal")
        self.assertGreater(dump["state"]["accuracy"]["points"], 1)
        # How long things take is the machine's affair: a busy one may find that no sample count takes as long.
        said = dump["state"]["accuracy"]["said"]
        self.assertIn("Static map at", said)
        spp = window.value("spp")
        window.open_tab("measure")
        if not said.startswith("Out of range"):
            samples = int(said.split("Static map at ")[1].split(" spp")[0])
            compared = window.wait(lambda d: len(d["state"]["compare"]) == 2, "what was found as B")["state"]["compare"]
            self.assertEqual(compared[1], "static" if samples == spp else f"static:spp={samples}")
            self.assertEqual((compared[0], window.settle(technique="tsm")["state"]["technique"]), ("tsm", "tsm"))
            self.assertEqual(window.value("spp"), spp, "A is left as it was")
            window.choose("compare", "none")
            window.settle(compare=[])
        # The two views that compare, each with its legend.
        window.click("view/error")
        window.wait_state(diagnostic=["error", True])
        window.click("view/disagreement")
        window.wait_state(diagnostic=["disagreement", True])
        window.key("v")
        window.wait_state(diagnostic=["none", False])
        # Another frame has another reference.
        window.open_tab("measure")
        window.key("Right")
        window.wait(lambda d: d["state"]["accuracy"]["points"] <= 1 and d["state"]["frame"] != 0, "an empty trail")
        window.wait(lambda d: d["state"]["accuracy"]["points"] == 1 and d["state"]["accuracy"]["state"] == "idle",
                    "its first point")
        self.close(window)


if __name__ == "__main__":
    run_tests()

"""The real window: settings, scenes, and what is remembered of them."""

import json
import pathlib
import shutil
import struct
import sys
import tempfile

from desk import PANEL_WIDTH, QUICK, WindowTest, headless, in_thorough_tests, pixels, run_tests, shown

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from slow_model import slow_model  # noqa: E402  pylint: disable=wrong-import-position


class Layout(WindowTest):
    @in_thorough_tests
    def test_it_survives_from_run_to_run(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-config-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        quick = ("--technique", "static", *QUICK[2:])
        file = folder / "timeshade/window.json"
        window = self.open("chess", *quick, XDG_CONFIG_HOME=str(folder))
        window.settle(window=[1280, 720])
        shutil.copy(pathlib.Path(__file__).parents[2] / "assets/scenes/pillars.glb", folder / "my pillars.glb")
        window.resize(1100, 640)
        self.assertFalse(window.value("section.plan"))
        window.click("section.plan")
        window.wait(lambda d: shown(d, "section.plan"), "the plan")
        window.click("section.camera")
        window.wait(lambda d: shown(d, "section.camera") is False, "no cameras")
        window.choose("text.size", "125 %")
        window.wait(lambda d: d["state"]["scale"] == 1.25, "larger text")
        self.close(window)
        again = self.open(str(folder / "my pillars.glb"), *quick, XDG_CONFIG_HOME=str(folder))
        again.settle(window=[1100, 640], scale=1.25)
        self.assertTrue(again.value("section.plan"))
        self.assertFalse(again.value("section.camera"))
        # Kept while it runs, too.
        again.wait(lambda d: "my pillars.glb" in file.read_text(), "the file")
        again.process.kill()
        again.process.wait()
        # Obeyed, though it is what pictures have without a window.
        last = self.open("chess", *quick, "--size", "640x480", XDG_CONFIG_HOME=str(folder))
        last.settle(window=[640, 480])
        last.choose("scene.recent", "my pillars.glb")
        last.settle(scene=str(folder / "my pillars.glb"))
        self.close(last)

    def test_a_file_that_is_no_good_is_one_notice(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-config-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        (folder / "timeshade").mkdir()
        (folder / "timeshade/window.json").write_text('{"size": [1000, "wide"]}')
        window = self.open("chess", "--technique", "static", *QUICK[2:], XDG_CONFIG_HOME=str(folder))
        window.wait(lambda d: "wide" in str(d["widgets"].get("notice", {}).get("value")), "a notice")
        window.settle(window=[1280, 720])
        self.close(window)
        # No folder can be where a file is.
        (folder / "occupied").write_text("")
        window = self.open("chess", "--technique", "static", *QUICK[2:], XDG_CONFIG_HOME=str(folder / "occupied"))
        window.wait(lambda d: "occupied" in str(d["widgets"].get("notice", {}).get("value")), "a notice")
        window.resize(900, 600)
        window.settle(window=[900, 600])
        self.close(window)


def with_clips(source, target, clips):
    """A .glb file again, with clips of given names, each with the channels of the first clip for which a function of
    node names holds."""
    data = source.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    whole = document["animations"][0]
    names = [node.get("name", "") for node in document["nodes"]]
    document["animations"] = [{**whole, "name": name,
                               "channels": [c for c in whole["channels"] if wanted(names[c["target"]["node"]])]}
                              for name, wanted in clips.items()]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    target.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text),
                                   0x4e4f534a) + text + rest)


class Clips(WindowTest):
    def test_the_clips_of_a_file(self):
        window = self.open("pillars", "--technique", "static", *QUICK, "--size", "900x800")
        with_clips(pathlib.Path(__file__).parents[2] / "assets/scenes/chess.glb", window.folder / "game.glb",
                   {"all": lambda node: True, "the knight": lambda node: "knight" in node})
        window.settle(clip="motion")
        self.assertNotIn("scene.clip", window.dump()["widgets"])
        window.click("scene.path")
        window.type("game.glb")
        window.key("Return")
        window.settle(scene="game.glb", clip="all")
        window.drag(700, 300, 730, 310)
        frame = window.settle(hand_camera=True)["state"]["frame"]
        whole = window.look_at_picture()
        window.choose("scene.clip", "the knight")
        state = window.settle(clip="the knight", scene="game.glb")["state"]
        self.assertTrue(state["hand_camera"], "seen from where it was")
        other = window.look_at_picture()
        self.assertGreater(other.share_different(whole), 0.001, "the queen stands still")
        self.assertLess(other.share_different(whole), 0.2, "the board stays where it is")
        window.choose("scene.clip", "all")
        window.settle(clip="all", frame=frame)
        self.assertEqual(window.look_at_picture().share_different(whole, 0), 0)
        window.choose("scene.clip", "the knight")
        window.settle(clip="the knight")
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        self.assertIn("the knight", command)
        self.close(window)


class SettingsFiles(WindowTest):
    def copied(self, window):
        window.key("ctrl+c")
        return window.wait(lambda dump: dump["state"]["command"], "the command line")["state"]["command"]

    def picture(self, window):
        window.key("p")
        path = window.wait(lambda dump: dump["state"]["screenshot"] and dump["state"]["saved"] > self.saved,
                           "a saved picture")
        self.saved = path["state"]["saved"]
        return pixels(path["state"]["screenshot"])

    def test_pictures_come_back_by_command_and_by_file(self):
        self.saved = 0
        window = self.open("pillars", "--technique", "tsm", *QUICK)
        window.settle()
        width, height = window.state()["window"]
        window.drag((PANEL_WIDTH + width) / 2, height / 3, (PANEL_WIDTH + width) / 2 + 60, height / 3 + 20)
        window.drag_slider("tsm.bias", 0.8)
        window.drag_slider("shutter", 0.7)
        window.choose("shutter.response", "gaussian")
        window.drag_slider("shutter.width", 0.3)
        window.key("Right", "Right")
        window.settle(hand_camera=True)
        first = self.picture(window)
        command = self.copied(window)
        for word in ("pillars", "tsm.bias", "--pose", "--shutter", "--shutter-response=gaussian", "--shutter-width"):
            self.assertIn(word, command)
        headless(command, window.folder)
        name = command.split(" -o ")[1]
        self.assertEqual(first == pixels(window.folder / name), True, "the command draws the very picture")

        window.key("ctrl+s")
        path = window.folder / "timeshade-settings.json"
        window.wait(lambda dump: path.exists(), "the file")
        # Elsewhere altogether, and back.
        window.key("4")
        window.choose("scene", "octopus")
        window.settle(scene="octopus", hand_camera=False)
        window.key("ctrl+o")
        window.settle(scene="pillars", technique="tsm", hand_camera=True)
        self.assertEqual(self.picture(window) == first, True, "loaded in the same window")
        size = window.state()["drawn"]
        # A file that is wrong is named with its line, and nothing changes.
        broken = path.read_text().replace('"pillars"', '"nowhere"')
        path.write_text(broken)
        window.key("ctrl+o")
        window.wait(lambda dump: "nowhere" in str(dump["widgets"].get("notice", {}).get("value")), "a notice")
        self.assertEqual(window.state()["scene"], "pillars")
        path.write_text(broken.replace('"nowhere"', '"pillars"'))
        file = path.read_text()
        self.close(window)
        again = self.open("chess", *QUICK)
        (again.folder / "timeshade-settings.json").write_text(file)
        again.key("ctrl+o")
        again.settle(scene="pillars", drawn=size)
        self.assertEqual(self.picture_of_new(again) == first, True, "loaded after a restart")
        self.close(again)

    def picture_of_new(self, window):
        self.saved = 0
        return self.picture(window)


class Settings(WindowTest):
    def test_sliders_change_the_picture_and_reset_brings_it_back(self):
        window = self.open("chess", "--technique", "tsm", *QUICK)
        window.settle()
        before = window.look_at_picture()
        bias = window.widget("tsm.bias")["value"]
        self.assertGreater(window.drag_slider("tsm.bias", 0.97), bias)
        self.assertGreater(window.look_at_picture().share_different(before), 0.005)
        window.click("tsm.bias.reset")
        window.wait(lambda dump: shown(dump, "tsm.bias") == bias, "the default")
        window.settle()
        self.assertEqual(window.look_at_picture().share_different(before, 0), 0,
                         "the same settings give the same picture")

        self.assertGreater(window.drag_slider("spp", 0.2), 2)
        self.assertGreater(window.look_at_picture().share_different(before), 0.005)
        shutter = window.widget("shutter")["value"]
        self.assertNotEqual(window.drag_slider("shutter", 0.9), shutter)
        plain = window.look_at_picture()
        window.choose("shutter.response", "tent")
        window.settle()
        self.assertGreater(window.look_at_picture().share_different(plain), 0.005)
        self.assertNotIn("shutter.width", window.wait(lambda dump: True, "a dump")["widgets"], "a tent has none")
        window.choose("map", "128 × 128")
        window.wait(lambda dump: "map 128" in shown(dump, "status"), "the other map")
        window.choose("tsm.dynamic_bias", "both_times")
        window.wait(lambda dump: shown(dump, "tsm.dynamic_bias") == "Both times", "the choice")
        self.assertEqual(window.settle()["state"]["picture"], "complete")
        self.close(window)

    def test_a_computed_scene_is_built_anew(self):
        window = self.open("cubes", "--technique", "exact", *QUICK, "--set", "cubes.count=40")
        window.settle(scene="cubes")
        before = window.look_at_picture()
        self.assertEqual(window.value("cubes.count"), 40)
        self.assertGreater(window.drag_slider("cubes.count", 0.75), 400)
        self.assertGreater(window.look_at_picture().share_different(before), 0.02)
        # Another scene and back: the settings are as they were left.
        count = window.value("cubes.count")
        window.choose("scene", "sphere")
        window.settle(scene="sphere")
        window.choose("scene", "cubes")
        window.settle(scene="cubes")
        self.assertEqual(window.value("cubes.count"), count)
        self.close(window)

    def test_a_view_of_the_technique(self):
        window = self.open("cubes", "--technique", "exact", *QUICK, "--set", "cubes.count=40")
        window.settle(view="final")
        before = window.look_at_picture()
        self.assertNotIn("view.scale", window.dump()["widgets"])
        window.click("view.own/candidates")
        window.settle(view="candidates")
        window.reveal("view.scale")
        window.reveal("view.scale")
        self.assertGreater(window.look_at_picture().share_different(before), 0.2)
        window.click("section.statistics")
        window.wait(lambda d: "figure.dynamic triangles" in d["widgets"], "the statistics")
        self.assertIn("480", window.widget("figure.dynamic triangles")["value"].replace(",", ""))
        # A technique without it shows the picture.
        window.key("1")
        window.settle(technique="static", view="final")
        self.close(window)

    def test_command_line(self):
        window = self.open("octopus", "--technique", "accumulation", "--frame", "12", "--view", "visibility", *QUICK)
        state = window.settle()["state"]
        self.assertEqual((state["scene"], state["technique"], state["frame"], state["renders"]),
                         ("octopus", "accumulation", 12, [4, 4]))
        picture = window.look_at_picture()
        colourful = sum(1 for i in range(0, len(picture.data), 3) if len(set(picture.data[i:i + 3])) > 1)
        self.assertLess(colourful / (picture.width * picture.height), 0.01, "visibility is grey")
        window.key("v")
        window.settle()
        self.assertGreater(window.look_at_picture().share_different(picture), 0.3)
        self.close(window)

    @in_thorough_tests
    def test_more_than_the_device_has(self):
        """16 GiB of maps. Where that fails it is said, and everything goes on from there."""
        window = self.open("pillars", "--technique", "tsm", *QUICK, "--map", "8192", "--spp", "32", "--set",
                           "tsm.dynamic_bias=both_times")
        state = window.settle()["state"]
        if state["picture"] == "failed":
            window.wait(lambda dump: "failure" in dump["widgets"], "the reason")
        window.choose("map", "256 × 256")
        window.wait(lambda dump: dump["widgets"].get("map", {}).get("value") == "256 × 256", "the smaller map")
        self.assertEqual(window.settle()["state"]["picture"], "complete")
        self.assertGreater(window.state()["begun"], state["begun"])
        self.assertEqual(window.quit(), 1 if state["picture"] == "failed" else 0,
                         "the driver's complaints are heard by --gl-debug")

    def test_a_scene_that_fails_to_load(self):
        window = self.open("chess", "--technique", "static", *QUICK)
        window.settle()
        (window.folder / "broken.glb").write_bytes(b"no model")
        window.click("scene.path")
        window.type("./broken.glb")
        window.key("Return")
        dump = window.wait(lambda d: "scene.error" in d["widgets"], "the reason")
        self.assertIn("broken.glb", shown(dump, "scene.error"))
        self.assertEqual(window.settle()["state"]["scene"], "chess")
        self.close(window)

    def test_a_scene_that_takes_long_to_load(self):
        window = self.open("chess", "--technique", "static", *QUICK)
        window.settle()
        (window.folder / "slow.gltf").write_text(slow_model())
        window.click("scene.path")
        window.type("./slow.gltf")
        window.key("Return")
        window.wait(lambda d: "loading slow.gltf" in shown(d, "loading"), "that it is loading")
        begun = window.state()["begun"]
        window.key("Right")  # the scene before is shown, and moves
        window.wait(lambda d: d["state"]["begun"] > begun, "another frame of it")
        window.key("Escape")
        state = window.wait(lambda d: not d["state"]["loading"], "the end of loading", 2)["state"]
        self.assertEqual(state["scene"], "chess")
        window.settle(scene="chess")
        window.click("scene.open")
        window.wait(lambda d: d["state"]["loading"], "that it is loading again")
        window.settle(scene="./slow.gltf", loading="")
        self.close(window)


if __name__ == "__main__":
    run_tests()

"""The real window, used as a person uses it."""

import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from desk import PROGRAM, Window, WindowTest, missing_tools

SCENES = ("chess", "octopus", "pillars")
# A small picture: a software renderer draws it in well under a second. The driver's complaints end in exit code 1.
QUICK = ("--size", "900x600", "--spp", "2", "--map", "256", "--set", "accumulation.renders=4", "--gl-debug")
PANEL_WIDTH = 340


class Techniques(WindowTest):
    def test_every_technique_and_scene(self):
        window = self.open("chess", "--technique", "tsm", *QUICK)
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
        dump = window.wait(lambda d: any(name.startswith("technique/") for name in d["widgets"]), "the list of techniques")
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


def headless(command, folder):
    """Runs a command line that the window has copied, in a shell and without a display."""
    names = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    script = f"timeshade() {{ {PROGRAM!r} \"$@\"; }}\n{command}"
    done = subprocess.run(["bash", "-c", script], cwd=folder, env=names, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, f"{command}\n{done.stderr}"


def pixels(path):
    """A picture file without what is written beside its pixels."""
    return subprocess.run(["convert", path, "-depth", "8", "ppm:-"], check=True, capture_output=True).stdout


class Compared(WindowTest):
    def test_wipe_with_a_seam_to_drag(self):
        window = self.open("pillars", "--technique", "tsm", *QUICK)
        window.settle()
        alone = window.look_at_picture()
        window.choose("compare", "exact")
        window.wait_state(compare=["tsm", "exact"], compared=True)
        dump = window.wait(lambda d: "error" in d["state"].get("compare.first", "") and "error" in d["state"].get("compare.second", ""), "both errors", 90)
        self.assertRegex(dump["state"]["compare.first"], r"^tsm, 2 spp, [0-9.e+]+ ms, error [0-9.e-]+$")
        error = [float(dump["state"][f"compare.{name}"].split("error ")[1]) for name in ("first", "second")]
        self.assertGreater(error[0], 1.5 * error[1], "what is wrong with tsm here")
        (width, height), (whole, _) = dump["state"]["drawn"], dump["state"]["window"]
        left = whole - width
        window.drag(left + width / 2, height / 2, left + 3 * width / 4, height / 2)
        state = window.wait(lambda d: abs(d["state"]["seam"] - 0.75) < 0.01, "the seam")["state"]
        self.assertFalse(state["hand_camera"], "the seam was dragged, not the camera")
        wiped = window.look_at_picture()
        seam = round(0.75 * width)
        below = (0, 60)
        same = wiped.crop(below[0], below[1], seam - 8, height).share_different(alone.crop(below[0], below[1], seam - 8, height), 0)
        self.assertEqual(same, 0, "left of the seam is the first's")
        self.assertGreater(wiped.crop(seam + 8, 60, width, height).share_different(alone.crop(seam + 8, 60, width, height)), 0.05)
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
        self.assertEqual(held.crop(0, 60, width, height // 2).share_different(alone.crop(0, 60, width, height // 2), 0), 0)
        window.click("compare.mode/difference")
        window.wait(lambda d: d["state"].get("compare.second", "").startswith("- "), "the difference")
        levels = sorted(window.look_at_picture().crop(0, 60, width, height // 2).grey())
        self.assertLess(levels[len(levels) // 4], 8, "where they agree it is dark")
        window.key("shift+p")
        path = window.wait(lambda d: d["state"]["screenshot"].endswith(".exr"), "the EXR")["state"]["screenshot"]
        self.assertEqual(pathlib.Path(path).read_bytes()[:4], b"\x76\x2f\x31\x01")
        window.choose("compare", "nothing")
        window.settle(compare=[])
        self.close(window)


class Time(WindowTest):
    def test_scrub_within_the_shutter_and_loop_a_part(self):
        window = self.open("octopus", "--technique", "tsm", *QUICK, "--size", "700x450")
        window.settle(instant=-1)
        blurred = window.look_at_picture()
        window.key("period")
        window.settle(instant=0)
        first = window.look_at_picture()
        window.key("period", "period")
        window.settle(instant=0.125)
        self.assertGreater(first.share_different(blurred), 0.02)
        self.assertGreater(first.share_different(window.look_at_picture()), 0.01)
        window.drag_slider("instant", 1.0)
        window.settle(instant=1)
        window.click("instant.on")
        window.settle(instant=-1)
        self.assertEqual(blurred.share_different(window.look_at_picture(), 0), 0)
        # Of a loop of some frames nothing else is played.
        self.assertGreater(window.drag_slider("loop.first", 0.6), 20)
        part = (window.widget("loop.first")["value"], window.widget("loop.first")["value"] + 30)
        window.key("space")
        frames = set()
        end = time.monotonic() + 2
        while time.monotonic() < end:
            frames.add(window.state()["frame"])
            time.sleep(0.02)
        window.key("space")
        self.assertGreater(len(frames), 3)
        self.assertGreaterEqual(min(sorted(frames)[1:]), part[0])
        self.close(window)

    def test_a_recording_is_what_shot_draws(self):
        window = self.open("octopus", "--technique", "tsm", "--frame", "12", *QUICK, "--size", "700x450")
        window.settle()
        window.key("ctrl+r")
        window.wait(lambda d: d["state"]["recording"][1] >= 6, "six frames", 60)
        window.key("ctrl+r")
        state = window.wait(lambda d: d["state"]["recorded"], "the file")["state"]
        (width, height), path = [side & ~1 for side in state["drawn"]], state["recorded"]
        found = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=width,height,r_frame_rate,nb_read_frames",
                                "-of", "csv=p=0", path], check=True, capture_output=True, text=True).stdout.strip().split(",")
        self.assertEqual(found, [str(width), str(height), "24/1", str(state["recording"][1])])
        data = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-vf", "scale=flags=accurate_rnd+full_chroma_int", "-f", "rawvideo",
                               "-pix_fmt", "rgb24", "-"], check=True, capture_output=True).stdout
        size = 3 * width * height
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        now = int(window.state()["frame"])
        self.assertEqual(now, 12 + state["recording"][1])
        for number in (0, 5):
            headless(command.replace(f"--frame={now}", f"--frame={12 + number}").split(" -o ")[0] + f" -o {number}.png", window.folder)
            shot = subprocess.run(["convert", window.folder / f"{number}.png", "-crop", f"{width}x{height}+0+0", "-depth", "8", "rgb:-"],
                                  check=True, capture_output=True).stdout
            frame = data[number * size:(number + 1) * size]
            self.assertEqual(len(shot), len(frame))
            self.assertLess(sum(abs(a - b) for a, b in zip(shot, frame)) / size, 4, f"frame {number}")
        self.close(window)


    def test_a_recording_begins_as_record_does(self):
        """With what a history learns from the frames before the first, and not from standing still on it."""
        window = self.open("chess", "--technique", "history", "--frame", "14", "--set", "history.warm_up=3", *QUICK, "--size", "600x380", "--compare", "history,static")
        window.settle(compared=True)
        window.key("ctrl+r")
        window.wait(lambda d: d["state"]["recording"][1] >= 3, "three frames", 60)
        window.key("ctrl+r")
        state = window.wait(lambda d: d["state"]["recorded"], "the file")["state"]
        count = state["recording"][1]
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        command = command.replace(" shot ", " record ").replace(f"--frame={14 + count}", "--frame=14").split(" -o ")[0]
        headless(f"{command} --frames {count} -o again.mp4", window.folder)
        frames = [subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "framemd5", "-"], check=True, capture_output=True, text=True).stdout
                  for path in (state["recorded"], window.folder / "again.mp4")]
        self.assertEqual(frames[0], frames[1], command)
        self.close(window)


class Layout(WindowTest):
    def test_it_survives_from_run_to_run(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="timeshade-config-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        quick = ("--technique", "static", *QUICK[2:])
        file = folder / "timeshade/window.json"
        window = self.open("chess", *quick, XDG_CONFIG_HOME=str(folder))
        window.settle(window=[1280, 720])
        shutil.copy(pathlib.Path(__file__).parents[2] / "assets/scenes/pillars.glb", folder / "my pillars.glb")
        window.resize(1100, 640)
        self.assertFalse(window.widget("section.plan")["value"])
        window.click("section.plan")
        window.click("section.camera")
        window.wait(lambda d: d["widgets"]["section.plan"]["value"] and not d["widgets"]["section.camera"]["value"], "the sections")
        window.choose("text.size", "125 %")
        window.wait(lambda d: d["state"]["scale"] == 1.25, "larger text")
        self.close(window)
        again = self.open(str(folder / "my pillars.glb"), *quick, XDG_CONFIG_HOME=str(folder))
        again.settle(window=[1100, 640], scale=1.25)
        self.assertTrue(again.widget("section.plan")["value"])
        self.assertFalse(again.widget("section.camera")["value"])
        # Kept while it runs, too.
        again.wait(lambda d: "my pillars.glb" in file.read_text(), "the file")
        again.process.kill()
        again.process.wait()
        last = self.open("chess", *quick, "--size", "900x600", XDG_CONFIG_HOME=str(folder))
        last.settle(window=[900, 600])
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


class Pages(WindowTest):
    def test_the_technique_s_page_and_files_opened_before(self):
        window = self.open("chess", "--technique", "tsm", *QUICK)
        window.settle()
        window.click("technique.page")
        window.wait(lambda d: d["widgets"].get("page", {}).get("value") == "tsm", "the page")
        x0, y0, x1, y1 = window.wait(lambda d: "page.picture" in d["widgets"], "its picture")["widgets"]["page.picture"]["rect"]
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


def with_clips(source, target, clips):
    """A .glb file again, with clips of given names, each with the channels of the first clip for which a function of node names holds."""
    data = source.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    whole = document["animations"][0]
    names = [node.get("name", "") for node in document["nodes"]]
    document["animations"] = [{**whole, "name": name, "channels": [c for c in whole["channels"] if wanted(names[c["target"]["node"]])]}
                              for name, wanted in clips.items()]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    target.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4e4f534a) + text + rest)


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


class Magnifier(WindowTest):
    def test_the_samples_of_one_pixel(self):
        window = self.open("pillars", "--technique", "tsm", *QUICK, "--spp", "8", "--size", "700x450")
        state = window.settle()["state"]
        (width, height), (whole, _) = state["drawn"], state["window"]
        window.point(whole - width + width * 0.4, height * 0.75)
        window.key("m")
        dump = window.wait(lambda d: d["state"]["probe"] == [True, True] and "probe.truth" in d["widgets"], "all answers", 90)
        rows = {name.split(".", 1)[1]: widget["value"] for name, widget in dump["widgets"].items() if name.startswith("probe.")}
        self.assertLessEqual({"truth", "tsm", "exact", "ranges", "temporal", "static"}, set(rows))
        self.assertEqual({len(row) for row in rows.values()}, {8})
        self.assertEqual(rows["exact"], rows["truth"], "exact is the ray tracer's equal")
        self.assertTrue(any(value >= 0 for value in rows["truth"]), rows)
        window.key("m")
        window.wait_state(probe=[False, False])
        self.close(window)


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
        self.assertEqual(window.look_at_picture().crop(0, height * 2 // 3, width, height).share_different(before.crop(0, height * 2 // 3, width, height), 0), 0,
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
        window.wait(lambda d: d["state"]["shaders"] == number + 1, "all shaders anew")
        file.write_text(good)
        window.wait(lambda d: d["state"]["shaders"] > number + 1, "the first shader")
        window.settle()
        self.close(window)


class SettingsFiles(WindowTest):
    def copied(self, window):
        window.key("ctrl+c")
        return window.wait(lambda dump: dump["state"]["command"], "the command line")["state"]["command"]

    def picture(self, window):
        window.key("p")
        path = window.wait(lambda dump: dump["state"]["screenshot"] and dump["state"]["saved"] > self.saved, "a saved picture")
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
        window.key("Right", "Right")
        window.settle(hand_camera=True)
        first = self.picture(window)
        command = self.copied(window)
        for word in ("pillars", "tsm.bias", "--pose", "--shutter"):
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
        window.wait(lambda dump: dump["widgets"]["tsm.bias"]["value"] == bias, "the default")
        window.settle()
        self.assertEqual(window.look_at_picture().share_different(before, 0), 0, "the same settings give the same picture")

        self.assertGreater(window.drag_slider("spp", 0.2), 2)
        self.assertGreater(window.look_at_picture().share_different(before), 0.005)
        shutter = window.widget("shutter")["value"]
        self.assertNotEqual(window.drag_slider("shutter", 0.9), shutter)
        window.choose("map", "128 × 128")
        window.wait(lambda dump: "map 128" in dump["widgets"]["status"]["value"], "the other map")
        window.click("tsm.dynamic_bias")
        window.wait(lambda dump: dump["widgets"]["tsm.dynamic_bias"]["value"] is True, "the switch")
        self.assertEqual(window.settle()["state"]["picture"], "complete")
        self.close(window)

    def test_a_computed_scene_is_built_anew(self):
        window = self.open("cubes", "--technique", "exact", *QUICK, "--set", "cubes.count=40")
        window.settle(scene="cubes")
        before = window.look_at_picture()
        self.assertEqual(window.widget("cubes.count")["value"], 40)
        self.assertGreater(window.drag_slider("cubes.count", 0.75), 400)
        self.assertGreater(window.look_at_picture().share_different(before), 0.02)
        # Another scene and back: the settings are as they were left.
        count = window.widget("cubes.count")["value"]
        window.choose("scene", "sphere")
        window.settle(scene="sphere")
        window.choose("scene", "cubes")
        window.settle(scene="cubes")
        self.assertEqual(window.widget("cubes.count")["value"], count)
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
        self.assertIn("480", window.widget("figure.moving triangles")["value"].replace(",", ""))
        # A technique without it shows the picture.
        window.key("1")
        window.settle(technique="static", view="final")
        self.close(window)

    def test_command_line(self):
        window = self.open("octopus", "--technique", "accumulation", "--frame", "12", "--view", "visibility", *QUICK)
        state = window.settle()["state"]
        self.assertEqual((state["scene"], state["technique"], state["frame"], state["renders"]), ("octopus", "accumulation", 12, [4, 4]))
        picture = window.look_at_picture()
        colourful = sum(1 for i in range(0, len(picture.data), 3) if len(set(picture.data[i:i + 3])) > 1)
        self.assertLess(colourful / (picture.width * picture.height), 0.01, "visibility is grey")
        window.key("v")
        window.settle()
        self.assertGreater(window.look_at_picture().share_different(picture), 0.3)
        self.close(window)

    def test_more_than_the_device_has(self):
        """16 GiB of maps. Where that fails it is said, and everything goes on from there."""
        window = self.open("pillars", "--technique", "tsm", *QUICK, "--map", "8192", "--spp", "32", "--set", "tsm.dynamic_bias=on")
        state = window.settle()["state"]
        if state["picture"] == "failed":
            window.wait(lambda dump: "failure" in dump["widgets"], "the reason")
        window.choose("map", "256 × 256")
        window.wait(lambda dump: dump["widgets"].get("map", {}).get("value") == "256 × 256", "the smaller map")
        self.assertEqual(window.settle()["state"]["picture"], "complete")
        self.assertGreater(window.state()["begun"], state["begun"])
        self.assertEqual(window.quit(), 1 if state["picture"] == "failed" else 0, "the driver's complaints are heard by --gl-debug")

    def test_a_scene_that_fails_to_load(self):
        window = self.open("chess", "--technique", "static", *QUICK)
        window.settle()
        (window.folder / "broken.glb").write_bytes(b"no model")
        window.click("scene.path")
        window.type("./broken.glb")
        window.key("Return")
        dump = window.wait(lambda d: "scene.error" in d["widgets"], "the reason")
        self.assertIn("broken.glb", dump["widgets"]["scene.error"]["value"])
        self.assertEqual(window.settle()["state"]["scene"], "chess")
        self.close(window)


class Motion(WindowTest):
    def test_play_step_scrub(self):
        window = self.open("chess", "--technique", "static", "--frame", "20", *QUICK)
        window.settle()
        still = window.look_at_picture()
        window.key("Right")
        window.settle(frame=21)
        window.key("Left", "Left")
        window.settle(frame=19)
        window.click("step.forward")
        window.settle(frame=20)
        self.assertEqual(window.look_at_picture().share_different(still, 0), 0, "frame 20 is frame 20")
        window.key("space")
        window.wait(lambda dump: dump["state"]["playing"] and dump["state"]["frame"] not in (19, 20, 21), "it plays")
        window.key("space")
        state = window.settle(playing=False, preview=False)["state"]
        self.assertEqual(state["drawn"][0], 900 - PANEL_WIDTH)
        x0, y0, x1, y1 = window.reveal("scrub")
        window.press_at(x0 + 0.8 * (x1 - x0), (y0 + y1) / 2)
        self.assertGreater(window.settle(playing=False)["state"]["frame"], 50)
        # Nothing moves and nothing changes: nothing is drawn.
        begun = window.state()["begun"]
        time.sleep(1.0)
        self.assertEqual(window.state()["begun"], begun)
        self.close(window)

    def test_camera(self):
        window = self.open("pillars", "--technique", "static", *QUICK)
        window.settle()
        before = window.look_at_picture()
        window.drag(600, 300, 700, 260)
        window.settle(hand_camera=True)
        orbited = window.look_at_picture()
        self.assertGreater(orbited.share_different(before), 0.1)
        window.drag(600, 300, 640, 330, button="3")
        window.settle()
        panned = window.look_at_picture()
        self.assertGreater(panned.share_different(orbited), 0.1)
        window.click("camera.save")
        window.wait(lambda dump: "camera.view.1" in dump["widgets"], "the bookmark")
        window.point(600, 300)
        window.wheel(2)
        window.settle()
        self.assertGreater(window.look_at_picture().share_different(panned), 0.1)
        window.click("camera.view.1")
        window.settle()
        self.assertEqual(window.look_at_picture().share_different(panned, 0), 0)
        window.key("r")
        window.settle(hand_camera=False)
        self.assertEqual(window.look_at_picture().share_different(before, 0), 0)
        self.close(window)

    def test_brute_force_can_be_cancelled(self):
        window = self.open("chess", "--technique", "accumulation", *QUICK, "--set", "accumulation.renders=4096")
        window.wait(lambda dump: "cancel" in dump["widgets"] and not dump["state"]["preview"] and dump["state"]["renders"][0] > 1, "progress")
        window.click("cancel")
        done = window.settle(picture="cancelled")["state"]["renders"]
        self.assertLess(done[0], 4096)
        self.assertIn(f"{done[0]} of 4096", window.wait(lambda d: "stopped" in d["widgets"]["progress"]["value"], "the word")["widgets"]["progress"]["value"])
        window.click("continue")
        window.wait(lambda dump: dump["state"]["renders"][0] > done[0] and dump["state"]["picture"] == "drawing", "more renders")
        window.key("1")
        self.assertEqual(window.settle(technique="static")["state"]["picture"], "complete")
        self.close(window)


class Accuracy(WindowTest):
    def test_live_point_and_equal_time(self):
        cache = tempfile.mkdtemp(prefix="timeshade-cache-")
        self.addCleanup(shutil.rmtree, cache, ignore_errors=True)
        window = self.open("pillars", "--technique", "tsm", *QUICK, XDG_CACHE_HOME=cache)
        window.settle()
        begun = window.state()["begun"]
        self.assertNotIn("accuracy", window.state())
        window.click("section.accuracy")
        dump = window.wait(lambda d: d["state"].get("accuracy", {}).get("points") == 1 and d["state"]["accuracy"]["state"] == "idle", "the live point")
        self.assertGreater(float(dump["widgets"]["accuracy.rmse"]["value"]), 0.0)
        self.assertRegex(dump["widgets"]["accuracy.ms"]["value"], r"^[0-9.]+ ms$")
        self.assertEqual(window.state()["begun"], begun, "the picture is left alone")
        window.click("accuracy.time")
        dump = window.wait(lambda d: d["state"]["accuracy"]["said"] and d["state"]["accuracy"]["state"] == "idle", "an equal")
        self.assertGreater(dump["state"]["accuracy"]["points"], 1)
        # How long things take is the machine's affair: a busy one may find that no effort takes as long.
        said = dump["state"]["accuracy"]["said"]
        self.assertIn("static at", said)
        if not said.startswith("Out of range"):
            samples = int(said.split("static at ")[1].split(" spp")[0])
            window.settle(technique="static")
            self.assertEqual(window.widget("spp")["value"], samples)
        # The two views that compare, each with its legend.
        window.click("view/error")
        window.wait_state(diagnostic=["error", True])
        window.click("view/disagreement")
        window.wait_state(diagnostic=["disagreement", True])
        window.key("v")
        window.wait_state(diagnostic=["none", False])
        # Another frame has another reference.
        window.key("Right")
        window.wait(lambda d: d["state"]["accuracy"]["points"] <= 1 and d["state"]["frame"] != 0, "an empty trail")
        window.wait(lambda d: d["state"]["accuracy"]["points"] == 1 and d["state"]["accuracy"]["state"] == "idle", "its first point")
        self.close(window)


class Windows(WindowTest):
    def test_sizes(self):
        window = self.open("chess", "--technique", "static", *QUICK)
        window.settle()
        for size in ((1, 1), (40, 30), (300, 900), (1500, 200), (1600, 1000), (2, 700), (900, 600)):
            window.resize(*size)
            window.settle()
        self.assertEqual(window.state()["drawn"][0], 900 - PANEL_WIDTH)
        # While it plays, and while it is not to be seen.
        window.key("space")
        window.wait_state(playing=True)
        for size in ((40, 30), (1200, 800), (1, 1), (900, 600)):
            window.resize(*size)
        window.hand("windowunmap", "--sync", window.id)
        time.sleep(0.5)
        window.hand("windowmap", "--sync", window.id)
        window.focus()
        window.key("space")
        window.settle(playing=False)
        window.key("h")
        window.settle(panels=False, drawn=[900, 600])
        window.key("h")
        window.settle(panels=True)
        self.close(window)

    def test_screenshot(self):
        window = self.open("octopus", "--technique", "tsm", "--frame", "7", *QUICK)
        window.settle()
        seen = window.look_at_picture()
        window.key("p")
        path = window.folder / "timeshade-octopus-tsm-0007.png"
        window.wait_state(screenshot=str(path))
        data = path.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (seen.width, seen.height))
        (window.folder / "seen.ppm").write_bytes(f"P6 {seen.width} {seen.height} 255\n".encode() + seen.data)
        differing = subprocess.run(["compare", "-metric", "AE", path, window.folder / "seen.ppm", "null:"], capture_output=True, text=True)
        self.assertEqual(differing.stderr.split()[0], "0", "what is saved is what is seen")
        self.close(window)

    def test_dense_display(self):
        small = self.open("chess", "--technique", "static", *QUICK)
        low = small.widget("scene.path")["rect"]
        self.close(small)
        window = self.open("chess", "--technique", "static", *QUICK, "--size", "1400x900", TIMESHADE_UI_SCALE="2")
        high = window.widget("scene.path")["rect"]
        self.assertAlmostEqual((high[3] - high[1]) / (low[3] - low[1]), 2.0, delta=0.15)
        self.assertEqual(window.settle()["state"]["drawn"][0], 1400 - 2 * PANEL_WIDTH)
        self.close(window)

    def test_closing_it(self):
        """As the button in the title bar does."""
        window = self.open("pillars", "--technique", "tsm", *QUICK)
        window.ask_to_close()
        self.assertEqual(window.process.wait(timeout=30), 0)
        self.assertEqual(window.standard_error(), "")

    def test_everything_at_once(self):
        """Keys in quick succession while it plays: nothing has to come of it but a window that is alive."""
        window = self.open("chess", "--technique", "tsm", *QUICK)
        for keys in (("space", "2", "v", "1"), ("Right", "3", "h", "Left"), ("h", "r", "space", "v"), ("3", "2", "p", "F1"), ("F1", "1", "space", "3")):
            window.key(*keys)
        window.choose("scene", "pillars")
        window.key("space", "1")
        window.wait_state(technique="static", scene="pillars")
        self.close(window)


class NoDisplay(unittest.TestCase):
    def test_one_line(self):
        result = subprocess.run([PROGRAM, "view", "chess"], env={"PATH": "/usr/bin:/bin"}, capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("display", result.stderr.lower())


if __name__ == "__main__":
    if missing_tools():
        print(f"skipped: {', '.join(missing_tools())} not found")
        sys.exit(77)
    unittest.main()

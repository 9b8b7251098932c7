"""The real window, used as a person uses it: time, camera, recording, its size and its end."""

import struct
import subprocess
import time
import unittest

from desk import PANEL_WIDTH, PROGRAM, QUICK, WindowTest, headless, run_tests, shown


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

        def four(dump):
            frames.add(dump["state"]["frame"])
            return len(frames) > 3

        window.wait(four, "four frames of the loop's part")
        window.key("space")
        self.assertGreaterEqual(min(sorted(frames)[1:]), part[0])
        self.close(window)

    def test_a_recording_is_what_shot_draws(self):
        window = self.open("octopus", "--technique", "tsm", "--frame", "12", *QUICK, "--size", "700x450")
        window.settle()
        window.key("ctrl+r")
        window.wait(lambda d: d["state"]["recording"][1] >= 6, "six frames")
        window.key("ctrl+r")
        state = window.wait(lambda d: d["state"]["recorded"], "the file")["state"]
        (width, height), path = [side & ~1 for side in state["drawn"]], state["recorded"]
        found = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                "stream=width,height,r_frame_rate,nb_read_frames",
                                "-of", "csv=p=0", path], check=True, capture_output=True, text=True).stdout
        self.assertEqual(found.strip().split(","), [str(width), str(height), "24/1", str(state["recording"][1])])
        data = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-vf", "scale=flags=accurate_rnd+full_chroma_int",
                               "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], check=True, capture_output=True).stdout
        size = 3 * width * height
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        now = int(window.state()["frame"])
        self.assertEqual(now, 12 + state["recording"][1])
        for number in (0, 5):
            headless(command.replace(f"--frame={now}", f"--frame={12 + number}").split(" -o ")[0] + f" -o {number}.png",
                     window.folder)
            shot = subprocess.run(["convert", window.folder / f"{number}.png", "-crop", f"{width}x{height}+0+0",
                                   "-depth", "8", "rgb:-"],
                                  check=True, capture_output=True).stdout
            frame = data[number * size:(number + 1) * size]
            self.assertEqual(len(shot), len(frame))
            self.assertLess(sum(abs(a - b) for a, b in zip(shot, frame)) / size, 4, f"frame {number}")
        self.close(window)


    def test_a_recording_begins_as_record_does(self):
        """With what a history learns from the frames before the first, and not from standing still on it."""
        window = self.open("chess", "--technique", "history", "--frame", "14", "--set", "history.warm_up=3", *QUICK,
                           "--size", "600x380", "--compare", "history,static")
        window.settle(compared=True)
        window.key("ctrl+r")
        window.wait(lambda d: d["state"]["recording"][1] >= 3, "three frames")
        window.key("ctrl+r")
        state = window.wait(lambda d: d["state"]["recorded"], "the file")["state"]
        count = state["recording"][1]
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        command = command.replace(" shot ", " record ").replace(f"--frame={14 + count}", "--frame=14").split(" -o ")[0]
        headless(f"{command} --frames {count} -o again.mp4", window.folder)
        frames = [subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-f", "framemd5", "-"], check=True,
                                 capture_output=True, text=True).stdout
                  for path in (state["recorded"], window.folder / "again.mp4")]
        self.assertEqual(frames[0], frames[1], command)
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
        window.click("camera.name")
        window.type("from the left")
        window.key("Return")
        window.wait(lambda dump: shown(dump, "camera.view.2") == "from the left", "a bookmark with a name")
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

    def test_flight(self):
        window = self.open("pillars", "--technique", "static", *QUICK)
        window.settle()
        before = window.look_at_picture()
        # What is pressed with Ctrl is a command, and no flight once Ctrl has been let go.
        for key in ("keydown", "ctrl"), ("keydown", "d"), ("keyup", "ctrl"):
            window.hand(*key)
            window.frames(3)
        window.hand("keyup", "d")
        window.settle(hand_camera=False)
        self.assertEqual(window.look_at_picture().share_different(before, 0), 0)
        window.hand("keydown", "w")
        window.wait_state(hand_camera=True)
        window.frames(3)
        window.hand("keyup", "w")
        window.settle()
        ahead = window.look_at_picture()
        self.assertGreater(ahead.share_different(before), 0.05)
        begun = window.state()["begun"]
        time.sleep(0.5)
        self.assertEqual(window.state()["begun"], begun, "it stands where the key was let go")
        window.key("r")
        window.settle(hand_camera=False)
        self.assertEqual(window.look_at_picture().share_different(before, 0), 0)
        self.close(window)

    def test_focus(self):
        window = self.open("chess", "--technique", "static", *QUICK)
        window.settle()
        before = window.look_at_picture()
        (width, height), whole = window.state()["drawn"], window.state()["window"][0]
        left = whole - width
        window.point(left + 0.3 * width, 0.7 * height)
        for down in (True, False, True, False):
            window.hand("mousedown" if down else "mouseup", "1")
        window.settle(hand_camera=True)
        focused = window.look_at_picture()
        self.assertGreater(focused.share_different(before), 0.1)
        # What is in the middle is what was chosen: choosing it again is no change but for a pixel's rounding.
        window.point(left + 0.5 * width, 0.5 * height)
        window.key("f")
        window.settle()
        self.assertLess(window.look_at_picture().share_different(focused), 0.05)
        self.close(window)

    def test_brute_force_can_be_cancelled(self):
        window = self.open("chess", "--technique", "accumulation", *QUICK, "--set", "accumulation.renders=4096")
        window.wait(lambda dump: "cancel" in dump["widgets"] and not dump["state"]["preview"]
                    and dump["state"]["renders"][0] > 1, "progress")
        window.click("cancel")
        done = window.settle(picture="cancelled")["state"]["renders"]
        self.assertLess(done[0], 4096)
        self.assertIn(f"{done[0]} of 4096",
                      window.wait(lambda d: "Stopped" in shown(d, "progress"),
                                  "the word")["widgets"]["progress"]["value"])
        window.click("continue")
        window.wait(lambda dump: dump["state"]["renders"][0] > done[0] and dump["state"]["picture"] == "drawing",
                    "more renders")
        window.key("1")
        self.assertEqual(window.settle(technique="static")["state"]["picture"], "complete")
        self.close(window)


class Windows(WindowTest):
    def test_sizes(self):
        window = self.open("chess", "--technique", "static", *QUICK, "--spp", "1", "--map", "128")
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
        seen = window.look_at_whole_picture()
        window.key("p")
        path = window.folder / "timeshade-octopus-tsm-0007.png"
        window.wait_state(screenshot=str(path))
        data = path.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (seen.width, seen.height))
        (window.folder / "seen.ppm").write_bytes(f"P6 {seen.width} {seen.height} 255\n".encode() + seen.data)
        differing = subprocess.run(["compare", "-metric", "AE", path, window.folder / "seen.ppm", "null:"],
                                   capture_output=True, text=True)
        self.assertEqual(differing.stderr.split()[0], "0", "what is saved is what is seen")
        self.close(window)

    def test_dense_display(self):
        small = self.open("chess", "--technique", "static", *QUICK)
        low = small.reveal("scene.path")
        self.close(small)
        window = self.open("chess", "--technique", "static", *QUICK, "--size", "1400x900", TIMESHADE_UI_SCALE="2")
        high = window.reveal("scene.path")
        self.assertAlmostEqual((high[3] - high[1]) / (low[3] - low[1]), 2.0, delta=0.15)
        self.assertEqual(window.settle()["state"]["drawn"][0], 1400 - 2 * PANEL_WIDTH)
        self.close(window)

    def test_closing_it(self):
        """As the button in the title bar does."""
        window = self.open("pillars", "--technique", "tsm", *QUICK)
        window.ask_to_close()
        self.assertEqual(window.process.wait(timeout=120), 0)
        self.assertEqual(window.standard_error(), "")

    def test_everything_at_once(self):
        """Keys in quick succession while it plays: nothing has to come of it but a window that is alive."""
        window = self.open("chess", "--technique", "tsm", *QUICK)
        for keys in (("space", "2", "v", "1"), ("Right", "3", "h", "Left"), ("h", "r", "space", "v"),
                     ("3", "2", "p", "F1"), ("F1", "1", "space", "3")):
            window.key(*keys)
        window.choose("scene", "pillars")
        window.key("space", "1")
        window.wait_state(technique="static", scene="pillars")
        self.close(window)


class NoDisplay(unittest.TestCase):
    def test_one_line(self):
        result = subprocess.run([PROGRAM, "view", "chess"], env={"PATH": "/usr/bin:/bin"}, capture_output=True,
                                text=True, timeout=120)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("display", result.stderr.lower())


if __name__ == "__main__":
    run_tests()

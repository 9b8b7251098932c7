"""`timeshade record`: what is in the file, that it is what `shot` draws, and what is left when something goes wrong."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM, QUICK, FileBytes, Picture, ProgramTest, environment, in_thorough_tests

SMALL = ("--size", "160x96", "--map", "64", "--spp", "2", "--set", "accumulation.renders=2", "--set",
         "history.warm_up=2")


def probe(path):
    entries = "stream=codec_name,width,height,r_frame_rate,nb_read_frames,duration"
    text = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", entries, "-of", "json", path],
                          check=True, capture_output=True).stdout
    return json.loads(text)["streams"][0]


def decoded(path, width, height):
    """The frames as bytes of RGB, rounded rather than cut off."""
    data = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-vf", "scale=flags=accurate_rnd+full_chroma_int", "-f",
                           "rawvideo", "-pix_fmt", "rgb24", "-"], check=True, capture_output=True).stdout
    size = width * height * 3
    return [data[i:i + size] for i in range(0, len(data), size)]


def luma(rgb):
    """Colour is kept at half the resolution, lightness at all of it."""
    return [0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in zip(rgb[0::3], rgb[1::3], rgb[2::3])]


def mean_difference(one, other):
    return sum(abs(a - b) for a, b in zip(one, other)) / len(one)


class RecordTest(ProgramTest):
    def fake_encoder(self, script):
        """An environment in which ffmpeg is this shell script."""
        folder = self.folder / "bin"
        folder.mkdir()
        (folder / "ffmpeg").write_text("#!/bin/sh\n" + script)
        (folder / "ffmpeg").chmod(0o755)
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        return environment(PATH=f"{folder}:{os.environ['PATH']}")

    def start(self, *arguments, **options):
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, env=environment(), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition, what, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, f"waited for {what}; there is {self.files()}")
            time.sleep(0.02)


class Videos(RecordTest):
    def test_frames_size_rate_duration(self):
        said = self.succeed("record", "chess", "-o", "F.mp4", *SMALL, "--frames", "12", "--fps", "30", "--json",
                            "F.json")
        self.assertIn("F.mp4  12 frames of 160 x 96 at 30 per second", said)
        self.assertEqual(self.files(), ["F.json", "F.mp4"])
        found = probe(self.folder / "F.mp4")
        self.assertEqual((found["codec_name"], found["width"], found["height"], found["r_frame_rate"],
                          found["nb_read_frames"]),
                         ("h264", 160, 96, "30/1", "12"))
        self.assertAlmostEqual(float(found["duration"]), 0.4, places=3)
        report = json.loads((self.folder / "F.json").read_text())
        self.assertEqual((report["frames"], report["fps"], report["parts"][0]["technique"]), (12, 30, "tsm"))

    def test_frames_are_those_of_shot_and_of_a_second_run(self):
        for technique in ("tsm", "history"):
            with self.subTest(technique=technique):
                asked = ("octopus", *SMALL, "--technique", technique, "--frame", "5")
                for name in ("F.mp4", "G.mp4"):
                    self.succeed("record", *asked, "--frames", "4", "--quality", "4", "-o", name)
                frames = decoded(self.folder / "F.mp4", 160, 96)
                self.assertEqual(frames, decoded(self.folder / "G.mp4", 160, 96))
                self.succeed("record", *asked, "--frames", "4", "-o", "pictures/")
                for number, frame in enumerate(frames):
                    picture = Picture((self.folder / f"pictures/{number:04}.png").read_bytes())
                    self.assertLess(mean_difference(frame, picture.rgb), 2.5, f"frame {number}")
                    self.assertLess(mean_difference(luma(frame), luma(picture.rgb)), 0.9, f"frame {number}")
                    # A history goes on from frame to frame; a technique without one knows no other frame.
                    if technique == "tsm" or number == 0:
                        shot = Picture(self.shot("octopus", "S.png", *asked[1:-1], str(5 + number)))
                        self.assertEqual(FileBytes(picture.rgb), FileBytes(shot.rgb))
                    self.assertGreater(mean_difference(frame, frames[number - 1]), 0.05,
                                       "frames that follow each other differ")

    def test_other_codecs_and_quality(self):
        sizes = {}
        for codec, quality in (("h264", 4), ("h264", 40), ("hevc", 30)):
            self.succeed("record", "octopus", "-o", "F.mp4", *SMALL, "--frames", "3", "--codec", codec, "--quality",
                         quality)
            self.assertEqual(probe(self.folder / "F.mp4")["codec_name"], codec)
            sizes[codec, quality] = (self.folder / "F.mp4").stat().st_size
        self.assertGreater(sizes["h264", 4], 2 * sizes["h264", 40])

    def test_a_script_of_parts(self):
        parts = [{"scene": "pillars", "technique": "static", "frames": 2, "title": "First", "caption": "A still map."},
                 {"scene": "chess", "compare": "tsm,exact", "seam": [0, 1], "frames": 3, "frame": 4, "step": 0.5},
                 {"scene": "chess", "camera": "table", "camera_to": "rook", "frames": 3, "set": {"tsm.bias": 2}}]
        (self.folder / "s.json").write_text(json.dumps({"parts": parts}))
        self.succeed("record", "--script", "s.json", "-o", "out", *SMALL)
        pictures = [Picture((self.folder / f"out/{i:04}.png").read_bytes()) for i in range(8)]
        self.assertEqual(sum(1 for name in self.files() if name.startswith("out/")), 8)
        # Of a wipe from 0 to 1 all is the second's picture first and the first's at last.
        for number, technique, frame in ((2, "exact", 4), (4, "tsm", 5)):
            alone = Picture(self.shot("chess", "S.png", *SMALL, "--technique", technique, "--frame", frame))
            below = len(alone.rgb) // 3  # labels are above
            self.assertEqual(FileBytes(pictures[number].rgb[below:]), FileBytes(alone.rgb[below:]))
        # A camera's way begins and ends where the cameras are.
        for number, camera in ((5, "table"), (7, "rook")):
            alone = Picture(self.shot("chess", "S.png", *SMALL, "--set", "tsm.bias=2", "--camera", camera, "--frame",
                                      number - 5))
            self.assertLess(pictures[number].share_of_pixels_off(alone, 8), 0.01)
        # A caption darkens the lower edge and nothing above.
        bare = Picture(self.shot("pillars", "S.png", *SMALL, "--technique", "static", "--frame", "0"))
        half = len(bare.rgb) // 2
        self.assertEqual(FileBytes(pictures[0].rgb[:half]), FileBytes(bare.rgb[:half]))
        self.assertNotEqual(FileBytes(pictures[0].rgb[half:]), FileBytes(bare.rgb[half:]))


    @in_thorough_tests
    def test_the_demo_script(self):
        """One frame of every part; every technique is in it."""
        script = json.loads((pathlib.Path(__file__).parents[2] / "assets/demo.json").read_text())
        self.succeed("record", "--demo", "-o", "out", "--frames", "1", "--json", "F.json", "--size", "160x90", "--map",
                     "64", "--spp", "1",
                     "--set", "history.warm_up=1")
        report = json.loads((self.folder / "F.json").read_text())
        self.assertEqual((report["size"], len(report["parts"]), report["frames"]),
                         ([160, 90], len(script["parts"]), len(script["parts"])))
        shown = {name.split(":")[0] for part in report["parts"]
                 for name in part.get("compare", [part.get("technique")])}
        self.assertLessEqual({"static", "tsm", "interleaved", "temporal", "ranges", "history", "exact", "accumulation",
                              "integral"},
                             shown)
        self.assertAlmostEqual(sum(part["frames"] for part in script["parts"]) / script["options"]["fps"], 60, delta=3)
        for part in script["parts"]:
            self.assertTrue(part["title"] and part["caption"])


class Endings(RecordTest):
    ASKED = ("record", "pillars", *SMALL, "--technique", "static", "--frames", "4")

    def test_an_ending_decides_the_container(self):
        for name, muxer, codec in (("F.MP4", "mov,mp4", "h264"), ("F.mov", "mov,mp4", "h264"),
                                   ("F.mkv", "matroska", "h264"), ("F.WebM", "matroska,webm", "av1"),
                                   ("F.gif", "gif", "gif")):
            with self.subTest(name=name):
                self.assertIn(f"{name}  4 frames", self.succeed(*self.ASKED, "-o", name))
                found = json.loads(subprocess.run(
                    ["ffprobe", "-v", "error", "-show_entries", "format=format_name", "-of", "json",
                     self.folder / name], check=True, capture_output=True).stdout)
                self.assertTrue(found["format"]["format_name"].startswith(muxer), found)
                stream = probe(self.folder / name)
                self.assertEqual((stream["codec_name"], stream["nb_read_frames"]), (codec, "4"))
                first = (self.folder / name).read_bytes()
                if codec != "av1":  # its encoder's threads are its own affair
                    self.succeed(*self.ASKED, "-o", name)
                    self.assertEqual(FileBytes((self.folder / name).read_bytes()), FileBytes(first))
                (self.folder / name).unlink()

    def test_other_endings_are_refused_by_name(self):
        for name in ("F.avi", "F.mpg", "F.png", "F.MKVX", "F.m4v", "frames.2"):
            self.refuse(2, (name, ".mp4", ".mkv", "folder"), *self.ASKED, "-o", name)
        for name, codec in (("F.webm", "h264"), ("F.gif", "hevc"), ("F.mov", "av1")):
            self.refuse(2, (codec, pathlib.Path(name).suffix), *self.ASKED, "-o", name, "--codec", codec)

    def test_folders(self):
        (self.folder / "there.v2").mkdir()
        for name in ("out", "new.v2/", "there.v2"):
            self.succeed(*self.ASKED[:-1], "1", "-o", name)
            self.assertIn(f"{name.rstrip('/')}/0000.png", self.files())


class FullDisks(RecordTest):
    """An encoder whose file may not grow beyond a size, as on a full disk. ffmpeg 5.1 ends with 0 where that hinders it
    only when it writes the index."""
    ASKED = ("record", "pillars", "--size", "320x240", "--map", "64", "--spp", "1", "--technique", "static", "--frames",
             "12", "--quality", "0")

    def limited(self, size):
        return (f"trap '' XFSZ\nulimit -f {size // 512}\nexec {shutil.which('ffmpeg')} \"$@\"\n")

    def test_no_file_and_one_line(self):
        for name in ("F.mp4", "F.mkv"):
            self.succeed(*self.ASKED, "-o", name)
            size = (self.folder / name).stat().st_size
            (self.folder / name).unlink()
            env = self.fake_encoder(self.limited(size))
            for limit in (16 * 1024, 300 * 1024, size // 2, size - 600):
                if limit > size - 600:
                    continue
                with self.subTest(name=name, limit=limit, size=size):
                    (self.folder / "bin/ffmpeg").write_text("#!/bin/sh\n" + self.limited(limit))
                    self.refuse(1, (f"cannot write {name}: ffmpeg ended",), *self.ASKED, "-o", name, env=env,
                                leaves=("bin", "bin/ffmpeg"))
            shutil.rmtree(self.folder / "bin")

    def test_an_encoder_that_fails_in_its_trailer_alone(self):
        env = self.fake_encoder(f"{shutil.which('ffmpeg')} \"$@\"\ntruncate -s -300 /proc/self/fd/3\nexit 0\n")
        self.refuse(1, ("cannot write F.mp4: ffmpeg ended without an error, but",), *self.ASKED, "-o", "F.mp4", env=env,
                    leaves=("bin", "bin/ffmpeg"))
        (self.folder / "bin/ffmpeg").write_text("#!/bin/sh\ncat >/dev/null\nexit 0\n")
        self.refuse(1, ("cannot write F.mp4: ffmpeg ended without an error, but it cannot be read back",), *self.ASKED,
                    "-o", "F.mp4", env=env, leaves=("bin", "bin/ffmpeg"))

    def test_nothing_to_read_it_back_with(self):
        env = self.fake_encoder("cat >/dev/null\n")
        self.refuse(1, ("ffprobe", "expected"), *self.ASKED, "-o", "F.mp4",
                    env=dict(env, PATH=str(self.folder / "bin")), leaves=("bin", "bin/ffmpeg"))


class WhatGoesWrong(RecordTest):
    ASKED = ("record", "chess", "-o", "F.mp4", *SMALL, "--frames", "40")

    def test_arguments(self):
        cases = (
            (("scene",), ("record", "-o", "F.mp4")),
            (("161x96", "even"), ("record", "chess", "-o", "F.mp4", *SMALL, "--size", "161x96")),
            (("--quality", "'52'"), (*self.ASKED, "--quality", "52")),
            (("--codec", "'mp3'"), (*self.ASKED, "--codec", "mp3")),
            (("--script", "scene"), (*self.ASKED, "--script", "s.json")),
            (("--compare",), (*self.ASKED, "--compare", "tsm")),
            (("nonsense", "expected"), (*self.ASKED, "--compare", "tsm,nonsense")),
        )
        for mentions, arguments in cases:
            self.refuse(2, mentions, *arguments)
        self.refuse(1, ("missing/F.mp4", "No such file"), "record", "chess", "-o", "missing/F.mp4", *SMALL)
        self.refuse(1, ("missing.json", "cannot read"), "record", "--script", "missing.json", "-o", "F.mp4")
        for part, code, mentions in (({}, 1, ("part 2", "scene")), ({"scene": "chess", "spp": 0}, 2, ("part 2", "'0'")),
                                     ({"scene": "chess", "seam": 2}, 1,
                                      ("part 2", "seam")), ({"scene": "chess", "wrong": 2}, 1, ("s.json:1", "wrong"))):
            (self.folder / "s.json").write_text(json.dumps({"parts": [{"scene": "chess"}, part]}))
            self.refuse(code, ("s.json", *mentions), "record", "--script", "s.json", "-o", "F.mp4", leaves=("s.json",))

    def test_no_encoder(self):
        self.refuse(1, ("ffmpeg", "expected"), *self.ASKED, env=environment(PATH="/nonexistent"))

    def test_an_encoder_that_dies(self):
        env = self.fake_encoder("head -c 300000 >/dev/null\necho 'out of pencils' >&2\nexit 3\n")
        self.refuse(1, ("F.mp4", "after", "exit code 3", "out of pencils"), *self.ASKED, env=env,
                    leaves=("bin", "bin/ffmpeg"))

    def test_an_encoder_that_is_killed_and_one_that_fails_at_the_end(self):
        env = self.fake_encoder("head -c 100000 >/dev/null\nkill -9 $$\n")
        self.refuse(1, ("F.mp4", "signal 9"), *self.ASKED, env=env, leaves=("bin", "bin/ffmpeg"))
        (self.folder / "bin/ffmpeg").write_text("#!/bin/sh\ncat >/dev/null\nexit 1\n")
        self.refuse(1, ("F.mp4", "after 2 frames", "exit code 1"), *self.ASKED[:-1], "2", env=env,
                    leaves=("bin", "bin/ffmpeg"))

    def test_what_was_there_stays(self):
        (self.folder / "F.mp4").write_bytes(b"old")
        env = self.fake_encoder("exit 1\n")
        self.refuse(1, ("F.mp4",), *self.ASKED, env=env, leaves=("F.mp4", "bin", "bin/ffmpeg"))
        self.assertEqual((self.folder / "F.mp4").read_bytes(), b"old")

    def test_stopped_by_a_signal(self):
        """The file that it leaves holds as many frames as it says."""
        self.succeed(*self.ASKED[:-1], "1")  # compiles what is found compiled below
        os.unlink(self.folder / "F.mp4")
        for name in ("SIGINT", "SIGTERM"):
            for seconds in (1.0, 5.0, 25.0):  # until a frame is there, however busy the machine
                errors = self.errors_of_stopped(name, seconds)
                if "before the first" not in errors:
                    break
                self.assertEqual(self.files(), [])
            self.assertRegex(errors,
                             rf"^timeshade: error: stopped by {name} after \d+ of 100000 frames; F.mp4 holds these\n$")
            self.assertEqual(self.files(), ["F.mp4"])
            self.assertEqual(probe(self.folder / "F.mp4")["nb_read_frames"], errors.split("after ")[1].split()[0])
            os.unlink(self.folder / "F.mp4")

    def errors_of_stopped(self, name, seconds):
        # The whole group, as a terminal does: it must not reach the encoder.
        process = self.start(*self.ASKED[:-1], "100000", start_new_session=True)
        self.wait_for(lambda: any(name.endswith(".part") for name in self.files()), "the encoder's file")
        time.sleep(seconds)
        os.killpg(process.pid, getattr(signal, name))
        out, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (1, ""))
        return errors

    def test_killed(self):
        """Nothing can be renamed any more, but the encoder closes its own file."""
        process = self.start(*self.ASKED[:-1], "100000")
        self.wait_for(lambda: any(name.endswith(".part") for name in self.files()), "the encoder's file")
        time.sleep(1.0)
        process.kill()
        process.communicate(timeout=60)
        (left,) = self.files()
        self.assertTrue(left.endswith(".part"))
        known = -1
        for _ in range(100):  # the encoder is nobody's child now
            size = (self.folder / left).stat().st_size
            if size == known and size > 100:
                break
            known = size
            time.sleep(0.2)
        self.assertGreater(int(probe(self.folder / left)["nb_read_frames"]), 0)

    def test_pictures_so_far_are_kept(self):
        process = self.start("record", "chess", "-o", "out", *SMALL, "--frames", "100000")
        self.wait_for(lambda: "out/0002.png" in self.files(), "three pictures")
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        count = int(errors.split("after ")[1].split()[0])
        self.assertEqual(self.files(), ["out", *(f"out/{i:04}.png" for i in range(count))])
        Picture((self.folder / f"out/{count - 1:04}.png").read_bytes())


class Instants(ProgramTest):
    def test_one_instant_of_the_shutter(self):
        """Frame 10 open from 9.7 to 10.3: its instants are still pictures of other times."""
        asked = ("octopus", "S.png", *QUICK, "--technique", "tsm")
        for u, frame in ((0, "9.7"), (0.5, "10"), (1, "10.3")):
            instant = self.shot(*asked, "--frame", "10", "--shutter", "0.6", "--shutter-position", "centre",
                                "--instant", u)
            still = Picture(self.shot(*asked, "--frame", frame, "--shutter", "0"))
            self.assertLess(Picture(instant).share_of_pixels_off(still, 4), 0.002, f"u = {u}")
        self.assertGreater(Picture(instant).share_of_pixels_off(Picture(self.shot(*asked, "--frame", "10", "--shutter",
                                                                                  "0.6")), 4), 0.02)

if __name__ == "__main__":
    unittest.main()

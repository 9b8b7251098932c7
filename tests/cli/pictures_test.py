"""Pictures of every scene with every technique on every headless back end."""

import json
import struct
import unittest
import zlib

from program import CONTEXTS, SCENES, TECHNIQUES, THOROUGH, Picture, ProgramTest, drawn, environment

SMALL = ("--spp", "8", "--size", "200x150", "--map", "256", "--set", "accumulation.renders=8", "--gl-debug")
# Noise of stochastic maps, blur or none: each of these has marks of its own.
MARKED = ("static", "tsm", "accumulation")


class Pictures(ProgramTest):
    def test_every_scene_technique_and_context(self):
        pictures = {}
        for number, technique in enumerate(TECHNIQUES):
            for scene in SCENES:
                if not (THOROUGH or technique in MARKED or scene == SCENES[number % len(SCENES)]):
                    continue  # as a rule the others in one scene
                with self.subTest(scene=scene, technique=technique):
                    command = ("--technique", technique, "--context", "egl", *SMALL)
                    first = self.shot(scene, "first.png", *command)
                    picture = pictures[scene, technique] = Picture(first)
                    self.assertEqual((picture.width, picture.height), (200, 150))
                    self.assertGreater(picture.mean(), 16.0, "as good as black")
                    self.assertLess(picture.mean(), 240.0, "as good as white")
                    if scene != SCENES[number % len(SCENES)] or technique not in drawn(TECHNIQUES):
                        continue  # one scene a technique is drawn more than once
                    self.assertEqual(first, self.shot(scene, "again.png", *command),
                                     "the same command gave two pictures")
                    for context in CONTEXTS[1:]:  # with the same programs
                        other = Picture(self.shot(scene, "other.png", "--technique", technique, *SMALL,
                                                  "--context", context))
                        # Two drivers may round a depth or a colour differently, next to an edge also a whole test.
                        self.assertLessEqual(picture.share_of_pixels_off(other, 2), 1e-3,
                                             f"--context {context} differs")
        for technique in TECHNIQUES if THOROUGH else MARKED:
            for a, b in (("chess", "octopus"), ("octopus", "pillars"), ("pillars", "chess")):
                self.assertGreater(pictures[a, technique].share_of_pixels_off(pictures[b, technique], 8), 0.3, (a, b))
        for scene in SCENES:
            for a, b in zip(MARKED, MARKED[1:] + MARKED[:1]):
                self.assertGreater(pictures[scene, a].share_of_pixels_off(pictures[scene, b], 2), 0.005, (scene, a, b))

    def test_the_size_of_the_promise(self):
        data = self.shot("chess", "F.png", "--technique", "tsm", "--spp", "8", "--size", "640x480", "--map", "512",
                         "--gl-debug")
        picture = Picture(data)
        self.assertEqual((picture.width, picture.height), (640, 480))
        self.assertGreater(picture.mean(), 16.0)
        # However many threads a software renderer has.
        one = self.shot("chess", "G.png", "--technique", "tsm", "--spp", "8", "--size", "640x480", "--map", "512",
                        env=environment(LP_NUM_THREADS=1))
        self.assertEqual(data, one)

    def test_every_setting_is_drawn_without_complaint(self):
        plain = self.shot("pillars", "default.png", *SMALL, "--technique", "tsm")
        for setting in ("tsm.dynamic_bias=on", "tsm.bias=16", "tsm.slope_bias=8"):
            with self.subTest(setting=setting):
                self.assertNotEqual(plain, self.shot("pillars", "F.png", *SMALL, "--technique", "tsm",
                                                     "--set", setting))
        plain = self.shot("pillars", "default.png", *SMALL, "--technique", "static")
        for radius in (1, 2, 3):
            with self.subTest(pcf_radius=radius):
                soft = self.shot("pillars", "F.png", *SMALL, "--technique", "static",
                                 "--set", f"static.pcf_radius={radius}")
                self.assertNotEqual(plain, soft)

    def test_what_changes_the_picture(self):
        """Each option on its own, against one picture without it."""
        quick = ("--technique", "tsm", "--spp", "2", "--size", "96x72", "--map", "128")
        plain = self.shot("chess", "default.png", *quick)
        for option in (("--seed", "2"), ("--frame", "7"), ("--time", "0.7"), ("--shutter", "3"), ("--camera", "knight"),
                       ("--view", "visibility"), ("--spp", "3"), ("--map", "64"), ("--fps", "7", "--shutter", "1"),
                       ("--shutter-position", "end"), ("--shutter-response", "tent"),
                       ("--shutter-response", "gaussian"),
                       ("--shutter-response", "gaussian", "--shutter-width", "0.3"), ("--size", "72x96")):
            with self.subTest(option=option):
                self.assertNotEqual(plain, self.shot("chess", "F.png", *quick, *option))
        self.assertEqual(plain, self.shot("chess", "F.png", *quick, "--seed", "1"), "1 is the default seed")
        self.assertEqual(plain, self.shot("chess", "F.png", *quick, "--shutter-response", "box"), "as it is by default")

    def test_a_response_is_about_motion_alone(self):
        """Where nothing moves all instants are alike, whatever counts more."""
        for technique in drawn(TECHNIQUES, 1):
            quick = ("--technique", technique, "--spp", "3", "--size", "64x48", "--map", "64", "--shutter", "0",
                     "--set", "accumulation.renders=3")
            plain = self.shot("chess", "box.png", *quick)
            for response in ("tent", "gaussian"):
                with self.subTest(technique=technique, response=response):
                    self.assertEqual(plain, self.shot("chess", "F.png", *quick, "--shutter-response", response))

    def test_motion_steps(self):
        """One step is what was there before; those that the samples cannot share are lowered, in one line."""
        command = ("--technique", "exact", *SMALL)
        one = self.shot("cubes", "one.png", *command)
        self.assertEqual(one, self.shot("cubes", "same.png", *command, "--motion-steps", "1"))
        eight = self.shot("cubes", "eight.png", *command, "--motion-steps", "8")
        self.assertNotEqual(one, eight)
        self.assertEqual(eight, self.shot("cubes", "again.png", *command, "--motion-steps", "8"))
        lowered = self.run_program("shot", "cubes", "-o", "lowered.png", *command, "--motion-steps", "32")
        self.assertEqual((lowered.returncode, lowered.stderr),
                         (0, "timeshade: note: motion steps: 8 instead of 32, since 8 samples a pixel are shared by "
                             "all pieces alike\n"))
        self.assertEqual(eight, (self.folder / "lowered.png").read_bytes())
        self.refuse(1, ("history", "expected --motion-steps 1, not 8"), "shot", "cubes", "-o", "F.png",
                    "--technique", "history", *SMALL, "--motion-steps", "8", leaves=self.files())

    def test_negative_and_fractional_frames(self):
        quick = ("--size", "96x72", "--spp", "1", "--map", "64")
        self.assertNotEqual(self.shot("chess", "a.png", *quick, "--frame", "10"),
                            self.shot("chess", "b.png", *quick, "--frame", "10.5"))
        self.assertNotEqual(self.shot("pillars", "a.png", *quick, "--frame", "-3"),
                            self.shot("pillars", "b.png", *quick, "--frame=-9"))

    def test_a_history_is_drawn_first(self):
        """A picture depends on its frame alone, wherever the sequence begins; and it says what was drawn before it."""
        quick = ("--technique", "history", "--spp", "1", "--size", "96x72", "--map", "128",
                 "--set", "history.warm_up=3")
        self.succeed("shot", "chess", "-o", "F.png", *quick, "--frame", "10", "--frames", "3")
        alone = self.shot("chess", "alone.png", *quick, "--frame", "12")
        self.assertEqual((self.folder / "F.0002.png").read_bytes(), alone)
        self.assertEqual(alone, self.shot("chess", "again.png", *quick, "--frame", "12"))
        self.assertNotEqual(alone, self.shot("chess", "cold.png", *quick, "--frame", "12",
                                             "--set", "history.warm_up=0"))
        self.assertNotEqual(alone, self.shot("chess", "held.png", *quick, "--frame", "12", "--set", "history.hold=5"))
        said = self.succeed("shot", "chess", "-o", "said.png", *quick, "--frame", "12", "--explain",
                            "--json", "said.json")
        self.assertIn("frames 9 to 11", said)
        manifest = json.loads((self.folder / "said.json").read_text())
        self.assertEqual(manifest["warm_up"], {"frames_before": 3, "times_held": 0})

    def test_time_is_a_frame_number(self):
        quick = ("--spp", "2", "--size", "96x72", "--map", "128", "--fps", "10")
        self.assertEqual(self.shot("chess", "a.png", *quick, "--frame", "15"),
                         self.shot("chess", "b.png", *quick, "--time", "1.5"))

    def test_extremes_of_size(self):
        for size in ("1x1", "1x200", "200x1", "3x5"):
            with self.subTest(size=size):
                picture = Picture(self.shot("octopus", "F.png", "--size", size, "--spp", "32", "--map", "16"))
                self.assertEqual(f"{picture.width}x{picture.height}", size)

    def test_no_display_is_opened(self):
        """A display that is named but not there makes no difference to headless work."""
        quick = ("--spp", "1", "--size", "64x48")
        plain = self.shot("chess", "a.png", *quick)
        self.assertEqual(plain, self.shot("chess", "b.png", *quick,
                                          env=environment(DISPLAY=":99", WAYLAND_DISPLAY="wayland-99")))


class TheReaderOfPictures(unittest.TestCase):
    """The measure itself, on pictures made by hand."""

    @staticmethod
    def made(rows, width):
        def chunk(kind, body):
            return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        header = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows))) +
                chunk(b"IEND", b""))

    def test_filters(self):
        """Two pixels a row, every row the same colours, each stored with another filter."""
        wanted = bytes((10, 20, 30, 250, 100, 7))
        left = bytes(3) + wanted[:3]
        rows = [b"\0" + wanted,
                b"\1" + bytes((v - l) % 256 for v, l in zip(wanted, left)),
                b"\2" + bytes(6),
                b"\3" + bytes((v - (l + v) // 2) % 256 for v, l in zip(wanted, left)),
                b"\4" + bytes(6)]  # with the same row above, Paeth's predictor is right
        self.assertEqual(Picture(self.made(rows, 2)).rgb, wanted * 5)

    def test_share_of_pixels_off(self):
        a = Picture(self.made([b"\0" + bytes((0, 0, 0, 9, 9, 9)), b"\0" + bytes(6)], 2))
        b = Picture(self.made([b"\0" + bytes((3, 0, 3, 9, 11, 9)), b"\0" + bytes(6)], 2))
        self.assertEqual(a.share_of_pixels_off(b, 2), 0.25)
        self.assertEqual(a.share_of_pixels_off(b, 1), 0.5)
        self.assertEqual(a.share_of_pixels_off(a, 0), 0.0)

    def test_damage_is_seen(self):
        data = bytearray(self.made([b"\0" + bytes(6)], 2))
        data[-20] ^= 1
        with self.assertRaises(ValueError):
            Picture(bytes(data))


if __name__ == "__main__":
    unittest.main()

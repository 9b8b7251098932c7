"""What the program prints and writes beside pictures: lists, plans, manifests, sequences, settings files."""

import json
import re
import unittest

from program import COMPUTED, CONTEXTS, PROGRAM, QUICK, SCENES, TECHNIQUES, Picture, ProgramTest, drawn, \
    in_thorough_tests


class Convergence(ProgramTest):
    PUBLISHED = "history:as_published=on:published_bias=0.5"
    COMMON = ("--size", "64x48", "--map", "64", "--spp", "1", "--shutter", "0", "-o", "F")

    def wrong_pixels(self):
        """Percent of wrong pixels by curve and number of frames."""
        return {key: traced for key, (traced, _) in self.both_targets().items()}

    def both_targets(self):
        """The same against the ray tracer and against each curve's own converged picture."""
        rows = [line.rsplit(",", 3) for line in (self.folder / "F/frusta.csv").read_text().splitlines()[1:]]
        return {(name.strip('"'), int(frames)): (float(traced), float(own)) for name, frames, traced, own in rows}

    @in_thorough_tests
    def test_variants_are_measured_frame_by_frame(self):
        self.succeed("measure", "frusta", "--convergence", "1,20", "--techniques", f"{self.PUBLISHED},history",
                     *self.COMMON)
        wrong = self.wrong_pixels()
        self.assertEqual(len(wrong), 2 * 4)
        self.assertLess(wrong["history", 20], wrong["history", 1])
        self.assertLess(wrong["history", 20], wrong[self.PUBLISHED, 20])
        self.assertNotEqual(wrong["history, after motion", 1], wrong["history", 1])
        strip = Picture((self.folder / "F/frusta-strip.png").read_bytes())
        self.assertEqual((strip.width, strip.height), (2 * (2 * 48 + 1) - 1, 2 * (2 * 48 + 1) - 1))
        report = (self.folder / "F/report.md").read_text()
        for name in ("frusta.png", "frusta-own.png"):
            self.assertIn(name, report)
            Picture((self.folder / "F" / name).read_bytes())

    def test_a_picture_comes_nearer_to_its_own_converged_one(self):
        self.succeed("measure", "frusta", "--convergence", "1,20,256", "--techniques", "history", *self.COMMON)
        own = {frames: off for (name, frames), (_, off) in self.both_targets().items() if name == "history"}
        self.assertGreater(own[1], own[20])
        self.assertEqual(own[256], 0.0, "that is the picture itself")

    def test_by_default_all_that_converge(self):
        self.succeed("measure", "frusta", "--history-frames", "1,2", *self.COMMON)
        self.assertEqual({name for name, _ in self.wrong_pixels()}, {"history", "history, after motion"})

    def test_what_is_drawn_once_is_refused(self):
        self.refuse(2, ("--convergence", "tsm", "history"), "measure", "frusta", "--convergence", "1",
                    "--techniques", "tsm", "-o", "F")


class Lists(ProgramTest):
    def test_text(self):
        text = self.succeed("list")
        for word in (*SCENES, *COMPUTED, *TECHNIQUES, "tsm.bias", "cubes.count", "frusta.rows", "static.pcf_radius",
                     "accumulation.renders", "texels", "renders"):
            self.assertIn(word, text)

    def test_json(self):
        listed = json.loads(self.succeed("list", "--json"))
        self.assertEqual([scene["name"] for scene in listed["scenes"]], [*SCENES, *COMPUTED])
        self.assertTrue(set(TECHNIQUES) <= {technique["name"] for technique in listed["techniques"]})
        for scene in listed["scenes"]:
            self.assertGreater(len(scene["summary"]), 10, scene)
            self.assertEqual(bool(scene["settings"]), scene["name"] in COMPUTED)
        for technique in listed["techniques"]:
            for key in ("title", "summary", "source"):
                self.assertGreater(len(technique[key]), 2, technique)
        for owner in listed["scenes"] + listed["techniques"]:
            keys = [setting["key"] for setting in owner["settings"]]
            self.assertEqual(len(keys), len(set(keys)), owner)
            for setting in owner["settings"]:
                with self.subTest(owner=owner["name"], setting=setting["key"]):
                    self.assertRegex(setting["key"], r"^[a-z][a-z0-9_]*$")
                    self.assertGreater(len(setting["help"]), 20)
                    if isinstance(setting["default"], bool):
                        continue
                    self.assertLess(setting["minimum"], setting["maximum"])
                    self.assertTrue(setting["minimum"] <= setting["default"] <= setting["maximum"])
                    if "choices" in setting:
                        self.assertEqual(setting["maximum"] + 1, len(setting["choices"]))
                    else:
                        self.assertGreater(len(setting["unit"]), 0)

    def test_every_setting_takes_its_limits(self):
        """What is listed is what the command line takes: both limits, and nothing beyond them."""
        for technique in json.loads(self.succeed("list", "--json"))["techniques"]:
            both = {"lowest": [], "highest": []}
            for setting in technique["settings"]:
                name = f"{technique['name']}.{setting['key']}"
                switch = isinstance(setting["default"], bool)
                low, high = ("off", "on") if switch else (setting["minimum"], setting["maximum"])
                both["lowest"] += ["--set", f"{name}={low}"]
                # Of what is drawn over and over the most takes minutes.
                often = setting.get("unit") in ("renders", "frames")
                both["highest"] += ["--set", f"{name}={low if often else high}"]
                if not switch:
                    self.refuse(2, (name,), "shot", "chess", "-o", "F.png", "--set", f"{name}={setting['minimum'] - 1}")
                    self.refuse(2, (name,), "shot", "chess", "-o", "F.png", "--set", f"{name}={setting['maximum'] + 1}")
            for name, settings in both.items() if technique["name"] in drawn(TECHNIQUES) else ():
                with self.subTest(technique=technique["name"], settings=name):
                    self.shot("octopus", "F.png", *QUICK, "--technique", technique["name"], *settings, "--gl-debug")
                    (self.folder / "F.png").unlink()

    def test_every_scene_setting_takes_its_limits(self):
        for scene in json.loads(self.succeed("list", "--json"))["scenes"]:
            if not scene["settings"] or scene["name"] not in (*SCENES, *drawn(COMPUTED)):
                continue
            both = {"minimum": [], "maximum": []}
            for setting in scene["settings"]:
                name = f"{scene['name']}.{setting['key']}"
                if isinstance(setting["default"], bool):
                    both["minimum"] += ["--set", f"{name}=off"]
                    both["maximum"] += ["--set", f"{name}=on"]
                    continue
                for limit, beyond in (("minimum", -1), ("maximum", 1)):
                    both[limit] += ["--set", f"{name}={setting[limit]}"]
                    self.refuse(2, (name, "expected"), "shot", scene["name"], "-o", "F.png",
                                "--set", f"{name}={setting[limit] + beyond}")
            for limit, settings in both.items():
                with self.subTest(scene=scene["name"], settings=limit):
                    self.shot(scene["name"], "F.png", *QUICK, *settings, "--gl-debug")
                    (self.folder / "F.png").unlink()

    def test_scene_settings_reach_the_picture_and_the_report(self):
        usual = self.shot("cubes", "usual.png", *QUICK)
        few = self.shot("cubes", "few.png", *QUICK, "--set", "cubes.count=40", "--json", "few.json")
        self.assertNotEqual(usual, few)
        self.assertEqual(json.loads((self.folder / "few.json").read_text())["scene_settings"],
                         {"count": 40, "speed": 2, "turn": 6, "size": 0.4, "seed": 1})
        (self.folder / "s.json").write_text('{"set": {"cubes.count": 40}}')
        self.assertEqual(self.shot("cubes", "file.png", *QUICK, "--settings", "s.json"), few)
        self.assertEqual(self.shot("cubes", "again.png", *QUICK, "--settings", "s.json", "--set", "cubes.count=500"),
                         usual)
        self.assertNotEqual(self.shot("cubes", "seed.png", *QUICK, "--set", "cubes.seed=2"), usual)

    def test_views_and_figures_of_a_technique(self):
        arguments = ("--technique", "exact", "--set", "cubes.count=40", *QUICK)
        final = Picture(self.shot("cubes", "final.png", *arguments))
        view = Picture(self.shot("cubes", "view.png", *arguments, "--view", "candidates", "--json", "view.json"))
        self.assertEqual((view.width, final.height), (final.width, 48))
        self.assertGreater(view.height, final.height + 20, "a scale stands below")
        report = json.loads((self.folder / "view.json").read_text())
        self.assertEqual([f["value"] for f in report["figures"] if f["name"] == "dynamic triangles"], [480])
        text = self.succeed("shot", "cubes", "-o", "again.png", *arguments, "--explain")
        self.assertRegex(text, r"(?m)^counted +dynamic triangles: 480$")
        # The values themselves, not their colours: counts per sample, the same in all channels.
        self.assertNotEqual(self.shot("cubes", "view.exr", *arguments, "--view", "candidates"),
                            self.shot("cubes", "final.exr", *arguments))
        self.refuse(2, ("--view candidates", "tsm", "none of its own"), "shot", "cubes", "-o", "F.png",
                    "--view", "candidates", leaves=self.files())
        self.refuse(2, ("--view candidates", "pictures"), "verify", "cubes", *arguments, "--view", "candidates",
                    leaves=self.files())

    def test_the_camera_path(self):
        still, path = (self.shot("frusta", f"{camera}.png", *QUICK, "--camera", camera, "--frame", 60)
                       for camera in ("still", "path"))
        self.assertNotEqual(still, path)
        self.assertEqual(self.shot("frusta", "later.png", *QUICK, "--camera", "path", "--frame", 300), path)

    def test_analytic_cases(self):
        text = self.succeed("cases", "--technique", "static", "--map", "128", "--json", "F.json", "-o", "F.png")
        self.assertRegex(text, r"\d+ right, \d+ off as predicted, 0 wrong")
        cells = json.loads((self.folder / "F.json").read_text(encoding="utf-8"))
        self.assertGreater(len(cells), 30)
        Picture((self.folder / "F.png").read_bytes())

    def test_devices(self):
        text = self.succeed("list", "--devices")
        devices = json.loads(self.succeed("list", "--devices", "--json"))
        self.assertEqual([device["index"] for device in devices], list(range(len(devices))))
        for device in devices:
            self.assertIn(device["name"], text)
        if devices:
            self.shot("chess", "F.png", *QUICK, "--device", "0")
            self.assertIn("EGL device 0", self.manifest("--device", "0")["gl"]["back_end"])

    def test_help_and_version(self):
        self.assertRegex(self.succeed("--version"), r"^timeshade \d+\.\d+\.\d+ \(commit \w+\)\n$")
        text = self.succeed("--help")
        for word in ("view", "shot", "pictures", "list"):
            self.assertIn(word, text)
        self.assertEqual(text, self.succeed("-h"))
        options = self.succeed("shot", "--help")
        for word in ("--technique", "--spp", "--size", "--map", "--frame", "--time", "--fps", "--shutter", "--seed",
                     "--context", "--set", "--settings", "--camera", "--clip", "--view", "--explain", "--json",
                     "--device", "--output"):
            self.assertIn(word, options)

    def manifest(self, *arguments):
        self.succeed("shot", "chess", "-o", "M.png", *QUICK, "--json", "M.json", *arguments)
        return json.loads((self.folder / "M.json").read_text(encoding="utf-8"))


class Plans(ProgramTest):
    def explain(self, scene, *arguments):
        return self.succeed("shot", scene, "-o", "F.png", *QUICK, "--explain", *arguments)

    def test_passes_and_reasons(self):
        for technique in TECHNIQUES:
            with self.subTest(technique=technique):
                text = self.explain("chess", "--technique", technique)
                for name in ("sample", "build", "lookup"):
                    self.assertRegex(text, rf"(?m)^{name}(/[\w ]+)? +.*\w+ \w+ \w+", "a pass with its reason")
                self.assertRegex(text, r"(?m)^device +\S+")
                self.assertRegex(text, r"(?m)^sample +\d+ of \d+ triangles: ")

    def test_what_moves(self):
        self.assertRegex(self.explain("pillars"), r"(?m)^sample .* 0 of \d+ triangles move, the light moves")
        self.assertRegex(self.explain("chess", "--frame", "26"), r"(?m)^sample .*[1-9]\d* of \d+ triangles move")
        self.assertNotIn("response", self.explain("pillars", "--shutter-response", "box"))
        self.assertRegex(self.explain("pillars", "--shutter-response", "tent", "--spp", "2"),
                         r"(?m)^response +tent: [^;]+$")
        self.assertRegex(self.explain("pillars", "--shutter-response", "tent", "--spp", "1"),
                         r"(?m)^response +tent: .*; without effect on one sample a pixel")
        self.assertRegex(self.explain("pillars", "--shutter-response", "gaussian", "--shutter-width", "0.25",
                                      "--spp", "2"),
                         r"(?m)^response +Gaussian .* 0\.25 of the shutter$")
        self.assertRegex(self.explain("chess", "--shutter", "0", "--shutter-response", "tent"),
                         r"(?m)^response +tent: .*; without effect, as nothing moves$")
        still = self.explain("chess", "--shutter", "0")
        self.assertRegex(still, r"(?m)^sample .* 0 of \d+ triangles move, "
                                r"the light stands still, the camera stands still")


class Manifests(ProgramTest):
    def test_everything_that_the_frame_needs(self):
        for context in CONTEXTS:
            self.succeed("shot", "octopus", "-o", "F.png", "--technique", "tsm", "--spp", "3", "--size", "65x33",
                         "--map", "128", "--seed", "7", "--frame", "12", "--set", "tsm.bias=0.25",
                         "--set", "tsm.dynamic_bias=on", "--json", "F.json",
                         "--context", context)
            report = json.loads((self.folder / "F.json").read_text(encoding="utf-8"))
            wanted = {"scene": "octopus", "technique": "tsm", "spp": 3, "size": [65, 33], "map": 128, "seed": 7,
                      "frame": 12.0}
            self.assertEqual({key: report[key] for key in wanted}, wanted)
            self.assertEqual(report["settings"]["bias"], 0.25)
            self.assertEqual(report["settings"]["dynamic_bias"], "both_times")
            self.assertIn("slope_bias", report["settings"])
            self.assertIn(context, report["gl"]["back_end"].lower())
            for key in ("vendor", "renderer", "version"):
                self.assertGreater(len(report["gl"][key]), 0)
            times = {name: value for name, value in report["milliseconds"].items() if "/" not in name}
            total = times.pop("total")
            self.assertEqual(set(times), {"sample", "build", "lookup", "shade"})
            self.assertTrue(all(value > 0.0 for value in times.values()), times)
            self.assertAlmostEqual(total, sum(times.values()), places=6)
            sizes = dict(report["bytes"])
            self.assertEqual(sizes.pop("total"), sum(sizes.values()))
            # Three layers: R32UI ids and one depth, R32F visibility; depth and velocity of the map.
            self.assertEqual(sizes["visibility"], 65 * 33 * 3 * 4)
            self.assertGreaterEqual(sizes["samples"], 65 * 33 * (3 + 1) * 4)
            self.assertGreaterEqual(sizes["technique"], 128 * 128 * 3 * (4 + 4))

    def test_a_report_repeats_its_frame(self):
        first = self.shot("chess", "a.png", "--technique", "static", "--size", "96x72", "--spp", "2", "--map", "64",
                          "--seed", "3", "--set", "static.pcf_radius=1", "--json", "a.json")
        report = json.loads((self.folder / "a.json").read_text(encoding="utf-8"))
        settings = [f"--set={report['technique']}.{key}={value}".lower() for key, value in report["settings"].items()]
        again = self.shot(report["scene"], "b.png", "--technique", report["technique"], "--spp", report["spp"],
                          "--size", "{}x{}".format(*report["size"]), "--map", report["map"], "--seed", report["seed"],
                          "--frame", report["frame"], "--fps", report["fps"], "--shutter", report["shutter"], *settings)
        self.assertEqual(first, again)


    def test_responses_that_are_not_usual_are_named(self):
        quick = ("--size", "64x48", "--spp", "2", "--map", "64")
        for response, named in ((("box",), {}), (("tent",), {"shutter_response": "tent"}),
                                (("gaussian", "--shutter-width", "0.3"),
                                 {"shutter_response": "gaussian", "shutter_width": 0.3})):
            for command in (("shot", "chess", "-o", "F.png"),
                            ("verify", "chess", "--technique", "static", "--reference-rays", "0")):
                self.succeed(*command, *quick, "--json", "F.json", "--shutter-response", *response)
                report = json.loads((self.folder / "F.json").read_text(encoding="utf-8"))
                self.assertEqual({k: v for k, v in report.items() if k in ("shutter_response", "shutter_width")}, named)


class PixelCentres(ProgramTest):
    """Where a pixel's samples lie: a frame's option, which a technique may ask for."""
    PUBLISHED = ("--technique", "history", "--set", "history.as_published=on")

    def centres(self, *arguments):
        """The picture, and whether its manifest says that samples lie at pixel centres."""
        picture = self.shot("chess", "C.png", *QUICK, "--json", "C.json", *arguments)
        return picture, json.loads((self.folder / "C.json").read_text()).get("pixel_centres", False)

    def test_an_option_of_the_frame(self):
        anywhere, at_centres = self.centres()
        self.assertFalse(at_centres)
        centred, at_centres = self.centres("--pixel-centres")
        self.assertTrue(at_centres)
        self.assertNotEqual(centred, anywhere)
        (self.folder / "S.json").write_text('{"pixel-centres": true}')
        self.assertEqual(self.centres("--settings", "S.json"), (centred, True))

    def test_a_technique_asks_for_it(self):
        asked, at_centres = self.centres(*self.PUBLISHED)
        self.assertTrue(at_centres)
        self.assertEqual(self.centres(*self.PUBLISHED, "--pixel-centres"), (asked, True))
        self.assertFalse(self.centres("--technique", "history")[1])
        verified = json.loads(self.succeed("verify", "chess", *QUICK, *self.PUBLISHED, "--json", "-"))
        self.assertTrue(verified["pixel_centres"])

    def test_what_is_compared_has_the_same_samples(self):
        self.shot("chess", "C.png", *QUICK, "--compare", "tsm,history:as_published=on", "--json", "C.json")
        compared = json.loads((self.folder / "C.json").read_text())["compare"]
        self.assertEqual([one["pixel_centres"] for one in compared], [True, True])


class Sequences(ProgramTest):
    def test_a_frame_of_a_sequence_is_the_frame_from_a_cold_start(self):
        for technique in drawn(TECHNIQUES, 2):
            with self.subTest(technique=technique):
                common = ("--technique", technique, "--size", "96x72", "--spp", "2", "--map", "64",
                          "--set", "accumulation.renders=3")
                before = self.files()
                self.succeed("shot", "chess", "-o", "F.png", *common, "--frame", "20", "--frames", "3")
                names = sorted(set(self.files()) - set(before))
                self.assertEqual(names, ["F.0000.png", "F.0001.png", "F.0002.png"])
                frames = [(self.folder / name).read_bytes() for name in names]
                self.assertEqual(len(set(frames)), 3, "the scene stands still")
                for i, frame in enumerate(frames):
                    self.assertTrue(frame == self.shot("chess", "cold.png", *common, "--frame", 20 + i),
                                    f"frame {20 + i}")
                for path in self.folder.iterdir():
                    path.unlink()

    def test_pictures(self):
        text = self.succeed("pictures", "-o", "new/folder", *QUICK)
        self.assertEqual([name for name in self.files() if name.endswith(".png")],
                         [f"new/folder/{scene}.png" for scene in SCENES])
        for scene in SCENES:
            self.assertRegex(text, rf"(?m)^{scene} +[\d. ]+ /.*/new/folder/{scene}\.png$")
            picture = Picture((self.folder / "new" / "folder" / f"{scene}.png").read_bytes())
            self.assertEqual((picture.width, picture.height), (64, 48))
            # The same as one at a time.
            self.assertTrue((self.folder / "new" / "folder" / f"{scene}.png").read_bytes() ==
                            self.shot(scene, "F.png", *QUICK))

    def test_pictures_of_two_techniques(self):
        pair = (*QUICK, "--compare", "tsm,exact", "--seam", "0.3")
        text = self.succeed("pictures", "-o", "pair", *pair)
        for scene in SCENES:
            self.assertRegex(text, rf"(?m)^{scene}, tsm +[\d. ]+ /.*/pair/{scene}\.png$")
            self.assertRegex(text, rf"(?m)^{scene}, exact +[\d. ]+ /.*/pair/{scene}\.png$")
            self.assertTrue((self.folder / "pair" / f"{scene}.png").read_bytes() == self.shot(scene, "F.png", *pair))

    def test_every_output_names_the_device(self):
        line = self.succeed("shot", "chess", "-o", "F.png", *QUICK)
        self.assertRegex(line, r"^/.*/F\.png  [\d.]+ ms with compiling shaders  .+ \(.+\)\n$")
        if re.search("llvmpipe|softpipe|SwiftShader", line):
            self.assertIn("SOFTWARE RENDERER", line)


class SettingsFiles(ProgramTest):
    FILE = {"technique": "tsm", "spp": 3, "size": "96x72", "map": 128, "seed": 9, "frame": 21, "shutter": 1.5,
            "shutter-response": "gaussian", "shutter-width": 0.25, "camera": "knight",
            "explain": False, "gl-debug": True, "set": {"tsm.bias": 2, "tsm.dynamic_bias": True, "static.bias": 3.5}}
    OPTIONS = ("--technique", "tsm", "--spp", "3", "--size", "96x72", "--map", "128", "--seed", "9", "--frame", "21",
               "--shutter", "1.5", "--shutter-response", "gaussian", "--shutter-width", "0.25", "--camera", "knight",
               "--gl-debug", "--set", "tsm.bias=2", "--set", "tsm.dynamic_bias=on", "--set", "static.bias=3.5")

    def write(self, name, content):
        (self.folder / name).write_text(json.dumps(content), encoding="utf-8")
        return name

    def test_the_same_as_the_options(self):
        name = self.write("s.json", self.FILE)
        wanted = self.shot("chess", "a.png", *self.OPTIONS)
        self.assertEqual(wanted, self.shot("chess", "b.png", "--settings", name))
        self.assertEqual(wanted, self.shot("chess", "c.png", f"--settings={name}"))
        self.assertNotEqual(wanted, self.shot("chess", "d.png", "--size", "96x72"))

    def test_the_command_line_wins(self):
        name = self.write("s.json", self.FILE)
        wanted = self.shot("chess", "a.png", *self.OPTIONS, "--seed", "4", "--set", "tsm.bias=1")
        self.assertEqual(wanted, self.shot("chess", "b.png", "--settings", name, "--seed", "4", "--set", "tsm.bias=1"))
        self.assertEqual(wanted, self.shot("chess", "c.png", "--seed", "4", "--set", "tsm.bias=1", "--settings", name))

    def test_of_two_files_the_later_wins(self):
        first, second = self.write("1.json", self.FILE), self.write("2.json", {"seed": 4, "set": {"tsm.bias": 1}})
        wanted = self.shot("chess", "a.png", *self.OPTIONS, "--seed", "4", "--set", "tsm.bias=1")
        self.assertEqual(wanted, self.shot("chess", "b.png", "--settings", first, "--settings", second))

    def test_switches_and_negative_numbers(self):
        name = self.write("s.json", {"explain": True, "frame": -3, "size": "64x48", "spp": 1})
        self.assertIn("lookup", self.succeed("shot", "pillars", "-o", "F.png", "--settings", name))
        self.assertEqual((self.folder / "F.png").read_bytes(),
                         self.shot("pillars", "G.png", "--frame", "-3", "--size", "64x48", "--spp", "1"))


if __name__ == "__main__":
    unittest.main()

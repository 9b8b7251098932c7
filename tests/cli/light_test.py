"""Light, ground, exposure: of any scene, by options, settings files and reports."""

import json
import unittest

from box_model import LOWEST, box_model
from program import QUICK, Picture, ProgramTest

SMALL = ("--size", "96x72", "--spp", "4", "--map", "128", "--reference-rays", "0", "--max-ppm", "40")
MOVING = ("--light-direction=40,50", "--light-move=0.6,0,-0.3", "--light-turn=4,3")


class Light(ProgramTest):
    def test_what_is_not_changed_draws_the_same_bytes(self):
        for scene in ("pillars", "cubes", "foliage", "case:light_slides"):
            with self.subTest(scene=scene):
                plain = self.shot(scene, "F.png", *QUICK)
                self.assertEqual(plain, self.shot(scene, "G.png", *QUICK, "--light-intensity", 1, "--exposure", 0,
                                                  "--tone-map", "filmic", "--light-move", "0,0,0", "--light-turn", 0,
                                                  "--ground", "off"))

    def test_every_change_is_seen(self):
        pictures = {self.shot("cubes", "F.png", *QUICK)}
        changes = (("--light-direction", "40,50"), ("--light-direction", "1,2,1"), ("--light-distance", "9"),
                   ("--light-cone", "12"), ("--light-intensity", "0.5"), ("--light-move", "3,0,0"),
                   ("--light-turn", "12"), ("--light-turn", "0,12"), ("--exposure", "1"), ("--tone-map", "reinhard"),
                   ("--tone-map", "linear"))
        for change in changes:
            pictures.add(self.shot("cubes", "F.png", *QUICK, *change))
        self.assertEqual(len(pictures), len(changes) + 1)

    def test_radiance_does_not_know_how_it_is_shown(self):
        plain = self.shot("cubes", "F.exr", *QUICK)
        self.assertEqual(plain, self.shot("cubes", "F.exr", *QUICK, "--exposure", -2, "--tone-map", "linear"))
        seen = self.shot("cubes", "F.png", *QUICK, "--view", "visibility")
        self.assertEqual(seen, self.shot("cubes", "F.png", *QUICK, "--view", "visibility", "--exposure", -2))

    def test_azimuth_and_elevation_are_a_vector(self):
        self.assertEqual(self.shot("foliage", "F.png", *QUICK, "--light-direction", "90,45"),
                         self.shot("foliage", "G.png", *QUICK, "--light-direction", "90.0,4.5e1"))
        angles = Picture(self.shot("foliage", "F.png", *QUICK, "--light-direction", "90,45"))
        vector = Picture(self.shot("foliage", "G.png", *QUICK, "--light-direction", "3,3,0"))
        self.assertLess(angles.share_of_pixels_off(vector, 4), 0.02)

    def test_settings_files(self):
        typed = self.shot("cubes", "F.png", *QUICK, *MOVING, "--exposure", "0.5", "--tone-map", "reinhard")
        (self.folder / "s.json").write_text(json.dumps({
            "light-direction": "40,50", "light-move": "0.6,0,-0.3", "light-turn": "4,3", "exposure": 0.5,
            "tone-map": "reinhard"}))
        self.assertEqual(typed, self.shot("cubes", "G.png", *QUICK, "--settings", "s.json"))

    def test_a_light_that_moves_and_turns_is_the_truth(self):
        """In a scene of files and in a computed one, whose own lights stand still or move."""
        for scene in ("cubes", "pillars", "foliage"):
            moving = ("--light-turn=10,-6",) if scene == "foliage" else MOVING
            with self.subTest(scene=scene):
                text = self.succeed("verify", scene, "--technique", "exact", *SMALL, "--explain", *moving)
                self.assertRegex(text, r"(?m)^sample .* the light turns by")
                self.assertRegex(text, r"(?m)^light +.*turns by 1?[04] degrees a frame, rises by")

    def test_reports(self):
        self.succeed("shot", "cubes", "-o", "F.png", *QUICK, *MOVING, "--exposure", 1, "--json", "F.json")
        self.assertEqual(json.loads((self.folder / "F.json").read_text())["changed"],
                         {"light-direction": "40,50", "light-move": "0.6,0,-0.3", "light-turn": "4,3", "exposure": "1"})
        text = self.succeed("shot", "cubes", "-o", "F.png", *QUICK, "--exposure", 1, "--explain")
        self.assertRegex(text, r"(?m)^look +exposure \+1 stops, tone map filmic$")
        self.assertNotRegex(text, r"(?m)^light ")

    def test_a_video_of_a_moving_light(self):
        self.succeed("record", "cubes", "-o", "frames", *QUICK, "--frames", 2, "--light-move", "2,0,0", "--json",
                     "F.json", "--fps", "24000/1001", "--frame", 3)
        for i in range(2):
            self.assertEqual((self.folder / f"frames/{i:04}.png").read_bytes(),
                             self.shot("cubes", "F.png", *QUICK, "--light-move", "2,0,0", "--frame", 3 + i, "--fps",
                                       "24000/1001"))
        self.assertEqual(json.loads((self.folder / "F.json").read_text())["fps"], 24000 / 1001)


class Ground(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "box.gltf").write_text(box_model())

    def noted(self, *arguments):
        done = self.run_program("shot", "box.gltf", "-o", "F.png", *QUICK, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr

    def test_a_file_without_one_gets_one(self):
        self.assertRegex(self.noted("--json", "F.json"), r"^timeshade: note: .*ground is added at the height 0\.249")
        ground = json.loads((self.folder / "F.json").read_text())["ground"]
        self.assertLess(abs(ground["height"] - LOWEST), 1e-3)
        self.assertLess(ground["height"], LOWEST)
        with_ground = Picture((self.folder / "F.png").read_bytes())
        self.assertEqual(self.noted("--ground", "off", "--json", "F.json"), "")
        self.assertNotIn("ground", json.loads((self.folder / "F.json").read_text()))
        without = Picture((self.folder / "F.png").read_bytes())
        self.assertGreater(with_ground.share_of_pixels_off(without, 8), 0.2)
        self.assertEqual(self.noted("--ground", "on"), "")
        self.assertEqual(Picture((self.folder / "F.png").read_bytes()).rgb, with_ground.rgb)

    def test_it_is_where_it_is_asked_for(self):
        text = self.succeed("shot", "box.gltf", "-o", "F.png", *QUICK, "--ground", "on", "--ground-height", "-2",
                            "--ground-size", "7", "--explain")
        self.assertRegex(text, r"(?m)^ground +added at the height -2, 7 wide$")

    def test_a_shadow_falls_on_it_and_is_the_truth(self):
        for more in ((), ("--light-direction=-70,40", "--light-move=0.5,0,0.2", "--light-turn=3")):
            done = self.run_program("verify", "box.gltf", "--technique", "exact", *SMALL, "--json", "v.json", *more)
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
            report = json.loads((self.folder / "v.json").read_text())
            self.assertGreater(report["shadowed"], 0.02 * report["tested"])

    def test_scenes_with_a_ground_get_none(self):
        for scene in ("chess", "octopus", "pillars"):
            plain = self.shot(scene, "F.png", *QUICK)
            self.assertEqual(plain, self.shot(scene, "G.png", *QUICK, "--ground", "off"))

    def test_which_light(self):
        (self.folder / "box.gltf").write_text(box_model(("left", "right")))
        first = self.noted()
        self.assertIn("one light is used; 1 left out: right (--light)", first)
        drawn = (self.folder / "F.png").read_bytes()
        for word in ("right", "2"):
            self.assertIn("1 left out: left", self.noted("--light", word, "--json", "F.json"))
            self.assertNotEqual((self.folder / "F.png").read_bytes(), drawn)
            self.assertEqual(json.loads((self.folder / "F.json").read_text())["light"], "right")
        self.assertIn("2 left out: left, right", self.noted("--light", "fitted"))
        done = self.run_program("shot", "box.gltf", "-o", "F.png", *QUICK, "--light", "middle")
        self.assertEqual(done.returncode, 1)
        self.assertIn('has no light "middle"; it has: left, right', done.stderr)


if __name__ == "__main__":
    unittest.main()

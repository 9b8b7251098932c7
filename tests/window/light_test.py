"""The real window: the light and the ground of somebody's own file."""

import pathlib
import sys

from desk import PANEL_WIDTH, QUICK, WindowTest, headless, in_thorough_tests, pixels, run_tests, shown

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from box_model import box_model  # noqa: E402  pylint: disable=wrong-import-position


class LightAndGround(WindowTest):
    def open_box(self):
        self.saved = 0
        window = self.open("pillars", "--technique", "exact", *QUICK)
        (window.folder / "box.gltf").write_text(box_model(("left", "right")))
        window.settle()
        window.click("scene.path")
        window.type("./box.gltf")
        window.key("Return")
        window.settle(scene="./box.gltf", loading="")
        for section in ("light", "ground"):
            window.click(f"section.{section}")
            window.wait(lambda d, s=section: shown(d, f"section.{s}"), "the section")
        return window

    def picture(self, window):
        window.key("p")
        state = window.wait(lambda d: d["state"]["screenshot"] and d["state"]["saved"] > self.saved, "a picture")
        self.saved = state["state"]["saved"]
        return pixels(state["state"]["screenshot"])

    def test_they_are_set_copied_and_reset(self):
        window = self.open_box()
        plain = self.picture(window)
        self.assertGreater(window.drag_slider("light.azimuth", 0.8), 20)
        window.drag_slider("light.move.x", 0.7)
        window.drag_slider("exposure", 0.6)
        window.choose("tone-map", "reinhard")
        window.drag_slider("ground.height", 0.4)
        window.settle()
        elevation = window.widget("light.elevation")["value"]
        width, height = window.state()["window"]
        window.hand("keydown", "ctrl")
        window.drag((PANEL_WIDTH + width) / 2, height / 2, (PANEL_WIDTH + width) / 2, height / 2 + 60)
        window.hand("keyup", "ctrl")
        window.wait(lambda d: shown(d, "light.elevation") and shown(d, "light.elevation") < elevation - 5,
                    "a lower light")
        self.assertFalse(window.settle()["state"]["hand_camera"], "the camera stays")
        window.choose("light", "right")
        window.settle(loading="")
        changed = self.picture(window)
        self.assertNotEqual(changed == plain, True)

        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        for word in ("--light=right", "--light-direction=", "--light-move=", "--exposure=", "--tone-map=reinhard",
                     "--ground-height="):
            self.assertIn(word, command)
        headless(command, window.folder)
        self.assertEqual(changed == pixels(window.folder / command.split(" -o ")[1]), True, "the very picture")

        window.key("ctrl+s")
        window.wait(lambda d: (window.folder / "timeshade-settings.json").exists(), "the file")
        window.click("light.reset")
        window.click("ground.reset")
        window.choose("light", "left")
        window.settle(loading="")
        self.assertEqual(self.picture(window) == plain, True, "as it was")
        window.key("ctrl+o")
        window.wait(lambda d: shown(d, "tone-map") == "Reinhard", "the settings")
        window.settle()
        self.assertEqual(self.picture(window) == changed, True, "from the file")
        self.close(window)

    @in_thorough_tests
    def test_another_scene_has_its_own(self):
        window = self.open_box()
        window.drag_slider("light.azimuth", 0.8)
        window.choose("ground", "off")
        window.wait(lambda d: "ground.height" not in d["widgets"], "no ground")
        window.choose("scene", "cubes")
        window.settle(scene="cubes")
        self.assertNotIn("ground", window.wait(lambda d: True, "a dump")["widgets"])
        self.assertNotIn("light.reset", window.dump()["widgets"])
        self.close(window)


if __name__ == "__main__":
    run_tests()

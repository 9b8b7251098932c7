"""The real window: the ground truth and a file as side B of a comparison."""

import pathlib
import re
import shutil
import tempfile

from desk import QUICK, WindowTest, headless, in_thorough_tests, pixels, run_tests, shown


class Partners(WindowTest):
    @in_thorough_tests
    def test_the_ground_truth_and_a_file(self):
        cache = tempfile.mkdtemp(prefix="timeshade-cache-")
        self.addCleanup(shutil.rmtree, cache, ignore_errors=True)
        window = self.open("pillars", "--technique", "exact", *QUICK, "--size", "560x290", XDG_CACHE_HOME=cache)
        window.settle()
        window.key("p")
        alone = window.wait(lambda d: d["state"]["saved"] == 1, "a file")["state"]["screenshot"]
        window.choose("compare", "truth")
        window.wait(lambda d: re.match(r"Ground truth, \d+ spp$", d["state"].get("compare.second", "")), "rays")
        window.wait(lambda d: d["state"]["compared"] and d["state"]["compare"] == ["exact", "truth"], "all rays", 240)
        self.assertEqual(window.state()["compare.second"], "Ground truth, 256 spp")
        window.click("compare.mode/difference")
        dump = window.wait(lambda d: "compare.legend" in d["state"], "the difference")
        self.assertEqual(dump["state"]["compare.legend"], "63.8 of 255 levels apart")
        window.choose("compare.gain", "16 x")
        window.wait(lambda d: d["state"].get("compare.legend", "").startswith("15.9 of"), "another gain")
        (width, height), (whole, _) = window.state()["drawn"], window.state()["window"]
        window.point(whole - width / 2, height / 2)
        pixel = window.wait(lambda d: d["state"].get("compare.pixel"), "a pixel")["state"]["compare.pixel"]
        one, other, apart = (list(map(int, numbers.split())) for numbers in
                             re.match(r"A (.+)   B (.+)   apart (.+)$", pixel).groups())
        self.assertEqual(apart, [abs(a - b) for a, b in zip(one, other)])
        seen = window.look().data
        at = 3 * (int(height / 2) * whole + int(whole - width / 2))
        self.assertEqual(list(seen[at:at + 3]), [min(255, 16 * level) for level in apart], "as bright as it says")
        # As the command draws it, which finds the rays in the cache.
        window.key("p")
        saved = window.wait(lambda d: d["state"]["saved"] == 2, "the file")["state"]["screenshot"]
        window.key("ctrl+c")
        command = window.wait(lambda d: d["state"]["command"], "the command")["state"]["command"]
        self.assertIn("--compare-gain=16", command)
        headless(command.split(" -o ")[0] + " -o again.png", window.folder, XDG_CACHE_HOME=cache)
        self.assertEqual(pixels(saved) == pixels(window.folder / "again.png"), True, command)
        # The picture of before is the same as the picture: nothing but black.
        window.click("compare.path")
        window.type(alone)
        window.key("Return")
        dump = window.settle(compare=["exact", alone], compared=True)
        self.assertEqual(window.wait(lambda d: "compare.legend" in d["state"], "the difference")["state"]
                         ["compare.second"], f"- {pathlib.Path(alone).name}|")
        window.point(whole - width / 2, height / 3)
        window.wait(lambda d: d["state"].get("compare.pixel", "").endswith("apart 0 0 0"), "no difference")
        window.key("x")
        window.wait(lambda d: "side A" in shown(d, "notice"), "that a file can't be A")
        # Another size is said, and can be had.
        window.resize(600, 300)
        window.wait(lambda d: "compare.complaint" in d["widgets"], "the sizes")
        window.click("compare.fit")
        window.settle(drawn=[width, height], compared=True)
        window.click("compare.path")
        window.type("./nowhere.png")
        window.key("Return")
        window.wait(lambda d: "nowhere.png" in shown(d, "notice"), "the reason")
        self.assertEqual(window.settle()["state"]["compare"][1], alone, "as before")
        self.close(window)


if __name__ == "__main__":
    run_tests()

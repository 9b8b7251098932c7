"""Two pictures of a moment in one: techniques, the ground truth, and files."""

import json
import unittest

from program import QUICK, Picture, ProgramTest


class Compared(ProgramTest):
    def test_wipe_side_and_difference(self):
        alone = {name: Picture(self.shot("pillars", "S.png", *QUICK, "--technique", name)) for name in ("tsm", "exact")}
        asked = (*QUICK, "--compare", "tsm,exact")
        row = 64 * 3
        wipe = Picture(self.shot("pillars", "S.png", *asked, "--seam", "0.25", "--json", "S.json"))
        self.assertEqual([one["technique"] for one in json.loads((self.folder / "S.json").read_text())["compare"]],
                         ["tsm", "exact"])
        side = Picture(self.shot("pillars", "S.png", *asked, "--compare-mode", "side"))
        far = Picture(self.shot("pillars", "S.png", *asked, "--compare-mode", "difference"))
        for y in range(24, 48):  # below the labels
            tsm, exact = (alone[name].rgb[y * row:(y + 1) * row] for name in ("tsm", "exact"))
            self.assertEqual(wipe.rgb[y * row:(y + 1) * row][:15 * 3], tsm[:15 * 3])
            self.assertEqual(wipe.rgb[y * row:(y + 1) * row][18 * 3:], exact[18 * 3:])
            self.assertEqual(side.rgb[y * row:(y + 1) * row][:31 * 3], tsm[16 * 3:47 * 3])
            self.assertEqual(side.rgb[y * row:(y + 1) * row][34 * 3:], exact[18 * 3:48 * 3])
            self.assertEqual(far.rgb[y * row:(y + 1) * row],
                             bytes(min(255, 4 * abs(a - b)) for a, b in zip(tsm, exact)))

    def test_the_ground_truth_and_files_as_second(self):
        seam = ("--seam", "0")  # all of it is the second's
        below = slice(24 * 64 * 3, None)  # the labels
        traced = Picture(self.shot("pillars", "T.png", *QUICK, "--compare", "tsm,truth", *seam, "--json", "T.json"))
        made = json.loads((self.folder / "T.json").read_text())["compare"]
        self.assertEqual((made[0]["technique"], made[1]), ("tsm", {"picture": "truth", "spp": 256, "size": [64, 48]}))
        many = Picture(self.shot("pillars", "E.png", *QUICK, "--technique", "exact", "--spp", "32"))
        far = sum(abs(a - b) for a, b in zip(traced.rgb[below], many.rgb[below])) / len(many.rgb[below])
        self.assertLess(far, 2.5, "as exact with many samples")
        # A file comes back as it is, an EXR as the picture that it was written beside.
        shown = Picture(self.shot("pillars", "A.png", *QUICK, "--technique", "static"))
        self.shot("pillars", "A.exr", *QUICK, "--technique", "static")
        for name, reach in (("A.png", 0), ("A.exr", 1)):
            wiped = Picture(self.shot("pillars", "S.png", *QUICK, "--compare", f"static,{name}", *seam))
            self.assertLessEqual(max(abs(a - b) for a, b in zip(wiped.rgb[below], shown.rgb[below])), reach, name)
        asked = (*QUICK, "--compare", "static,A.png", "--compare-mode", "difference")
        self.assertEqual(set(Picture(self.shot("pillars", "S.png", *asked)).rgb[below]), {0})
        # A gain is a factor, and own samples are drawn.
        asked = (*QUICK, "--compare", "static,static:spp=1", "--compare-mode", "difference", "--compare-gain")
        one, nine = (Picture(self.shot("pillars", "S.png", *asked, gain)).rgb[below] for gain in ("1", "9"))
        self.assertGreater(max(one), 20)
        self.assertEqual(nine, bytes(min(255, 9 * level) for level in one))

    def test_what_can_t_be_compared_is_one_line(self):
        self.shot("pillars", "A.png", *QUICK)
        (self.folder / "broken.png").write_bytes(b"no picture")
        for pair, code, words in (("static,A.png", 1, ("A.png", "64 x 48", "32 x 24")),
                                  ("static,nowhere.exr", 1, ("nowhere.exr",)),
                                  ("static,broken.png", 1, ("broken.png",)),
                                  ("truth,tsm", 2, ("truth", "technique first")),
                                  ("A.png,tsm", 2, ("A.png", "technique first")),
                                  ("tsm,exact:spp=33", 2, ("spp=33", "1 to 32")),
                                  ("tsm:spp=3,exact", 2, ("--spp 3",))):
            self.refuse(code, words, "shot", "pillars", *QUICK, "--size", "32x24", "--compare", pair, "-o", "S.png",
                        leaves=("A.png", "broken.png"))
        self.refuse(2, ("truth", "two techniques"), "pictures", "-o", "F", *QUICK, "--compare", "tsm,truth",
                    leaves=("A.png", "broken.png"))

    def test_a_video_beside_the_ground_truth(self):
        asked = ("pillars", "--size", "32x24", "--map", "64", "--spp", "2", "--compare", "tsm,truth", "--frame", "3")
        self.succeed("record", *asked, "--frames", "2", "-o", "out/")
        still = self.shot(*asked[:1], "S.png", *asked[1:])
        self.assertEqual((self.folder / "out/0000.png").read_bytes() == still, True, "the frame is the picture")


if __name__ == "__main__":
    unittest.main()

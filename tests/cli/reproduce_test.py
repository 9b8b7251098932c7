"""A paper's figures redrawn: steps, verdicts, going on, and what is wrong said in a line. With lists of our own."""

import json
import pathlib
import unittest

from program import ProgramTest, environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
SMALL = "--size 32x24 --map 32 --spp 2"


def wrong_samples(name, technique):
    """A step that counts wrong samples, and a value of them."""
    step = f"verify rising --technique {technique} {SMALL} --reference-rays 0 --json verify.json"
    return step, {"label": name, "unit": "ppm", "file": f"{name}/verify.json", "at": "/ppm"}


class Reproduce(ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / "data"
        papers = self.data / "assets" / "papers"
        papers.mkdir(parents=True)
        (self.data / "shaders").symlink_to(ROOT / "shaders")
        (self.data / "assets" / "scenes").symlink_to(ROOT / "assets" / "scenes")
        for name in ("page.css", "page.js"):
            (papers / name).symlink_to(ROOT / "assets" / "papers" / name)
        self.env = environment(TIMESHADE_DATA="data")  # steps find it too, though they work elsewhere

    def declare(self, figures, name="tiny2001"):
        paper = {"name": name, "authors": "A. Nobody", "year": 2001, "title": "Tiny <things>", "figures": figures}
        (self.data / "assets" / "papers" / f"{name}.json").write_text(json.dumps(paper))

    def figure(self, better, worse, more=()):
        steps, values = {}, {}
        for name, technique in (("a", better), ("b", worse)):
            steps[name], values[name] = wrong_samples(name, technique)
        steps["picture"] = f"shot rising {SMALL} -o picture.png"
        steps.update(more)
        return {"figure": "3.1", "status": "reproduced", "caption": "c", "steps": steps, "values": values,
                "pairs": [{"left": {"file": "picture/picture.png", "caption": "l"},
                           "right": {"file": "picture/picture.png", "caption": "r"}}],
                "claims": [{"says": "a is right more often", "stands": "section 1", "picture": "picture/picture.png",
                            "rule": {"test": "less", "of": ["a", "b"]}}]}

    def reproduce(self, *arguments, code=0):
        done = self.run_program("reproduce", "tiny2001", "-o", "out", *arguments, env=self.env)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def contents(self):
        """Bytes of all files of the run."""
        out = self.folder / "out"
        return {str(path.relative_to(out)): path.read_bytes() for path in out.rglob("*") if path.is_file()}

    def test_steps_run_once_and_go_on_where_one_is_missing(self):
        self.declare([{"figure": "1", "status": "drawing", "caption": "d"}, self.figure("exact", "tsm")])
        said = self.reproduce()
        self.assertIn("1 confirmed, 0 refuted", said)
        before = self.contents()
        for name in ("report.md", "index.html", "3.1/a/step.json", "3.1/a/verify.json", "3.1/picture/picture.png"):
            self.assertIn(name, before)
        again = self.reproduce()
        self.assertEqual(again.count("was done"), 3, again)
        self.assertEqual(self.contents(), before, "nothing changes where all is there")
        (self.folder / "out/3.1/picture/picture.png").unlink()
        (self.folder / "out/3.1/a/step.json").write_text("{}")
        again = self.reproduce()
        self.assertEqual((again.count("was done"), again.count(": done")), (1, 2), again)
        after = self.contents()
        for name in ("3.1/picture/picture.png", "3.1/a/verify.json"):
            self.assertEqual(after[name], before[name], name)
        step = json.loads(after["3.1/a/step.json"])
        self.assertEqual(step["exit_code"], 0)
        self.assertTrue(step["command"].startswith("timeshade verify rising --technique exact"))

    def test_a_verdict_turns_with_the_technique(self):
        self.declare([self.figure("tsm", "exact")])
        self.assertIn("0 confirmed, 1 refuted", self.reproduce("--claims", "claims.md"))
        claims = (self.folder / "claims.md").read_text()
        self.assertIn("| **refuted** | does not hold: a (", claims)
        self.assertIn("| [ours](pictures/claims/tiny2001-3.1-picture.png) |", claims)
        self.assertEqual((self.folder / "pictures/claims/tiny2001-3.1-picture.png").read_bytes(),
                         (self.folder / "out/3.1/picture/picture.png").read_bytes())
        page = (self.folder / "out/index.html").read_text()
        self.assertIn('<b class="refuted">refuted</b> does not hold: a (', page)
        self.assertIn("Tiny &lt;things&gt;", page)
        self.assertIn("Redrawn by Timeshade", page)
        self.assertNotIn("http:", page)

    def test_one_failed_step_does_not_end_the_rest(self):
        self.declare([self.figure("exact", "tsm", {"bad": "shot /nowhere.glb -o x.png"})])
        said = self.reproduce(code=1)
        self.assertIn("bad: failed with exit code 1: timeshade: error: ", said)
        self.assertIn("1 confirmed", said)
        for name in ("report.md", "index.html"):
            self.assertRegex((self.folder / "out" / name).read_text(), "exit code 1: timeshade: error: .*nowhere")
        self.declare([self.figure("nosuch", "tsm")])
        self.assertIn("0 confirmed, 0 refuted, 1 not comparable", self.reproduce(code=1))

    def test_several_papers_have_folders_of_their_own(self):
        drawing = [{"figure": "1", "status": "drawing", "caption": "d"}]
        self.declare(drawing)
        self.declare(drawing, "other2002")
        done = self.run_program("reproduce", "other2002,tiny2001,other2002", "-o", "out", env=self.env)
        self.assertEqual((done.returncode, done.stdout.count("index.html")), (0, 2), done.stderr)
        for name in ("tiny2001", "other2002"):
            self.assertIn("An explanatory drawing", (self.folder / "out" / name / "report.md").read_text())

    def test_one_figure_alone(self):
        self.declare([{"figure": "1", "status": "drawing", "caption": "d"}, self.figure("exact", "tsm")])
        self.reproduce("1")
        self.assertIn("1 of 2 figures", (self.folder / "out/report.md").read_text())
        self.assertFalse((self.folder / "out/3.1").exists())


class Refusals(ProgramTest):
    def test_names_that_are_not_there(self):
        self.refuse(2, ["reproduce hong2016: no such paper (did you mean hong2017?)", "palmer", "or all"],
                    "reproduce", "hong2016", "-o", "out")
        self.refuse(2, ["reproduce scherzer2007 7: no such figure", "1, 2, 3, 4, 5, 6"],
                    "reproduce", "scherzer2007", "7", "-o", "out")
        self.refuse(2, ["reproduce all 3"], "reproduce", "all", "3", "-o", "out")
        self.refuse(2, ["reproduce palmer,hong2017 3"], "reproduce", "palmer,hong2017", "3", "-o", "out")
        self.refuse(2, ["output"], "reproduce", "palmer")
        self.refuse(2, ["paper"], "reproduce", "-o", "out")
        self.refuse(2, ["claims.txt", ".md"], "reproduce", "palmer", "-o", "out", "--claims", "claims.txt")


if __name__ == "__main__":
    unittest.main()

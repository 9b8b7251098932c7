"""A measured row is used again for just what it was made with, and a folder has one writer."""

import fcntl
import json
import os
import pathlib
import shutil
import sys
import unittest

from program import PROGRAM, ProgramTest, environment

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "verify"))
from small_scene import write_small_scene  # noqa: E402  pylint: disable=wrong-import-position


class Journal(ProgramTest):
    """Every change of what is measured is measured."""

    SHORT = ("--techniques", "static", "--spps", "1", "--rounds", "2", "--reference", "1", "--reference-rays", "0",
             "--map", "32")

    def setUp(self):
        super().setUp()
        self.model = self.folder / "model.gltf"
        write_small_scene(self.model)
        # Buffers in a file of their own, which is edited as well.
        document = json.loads(self.model.read_text())
        uri = document["buffers"][0]["uri"]
        import base64  # pylint: disable=import-outside-toplevel
        (self.folder / "model.bin").write_bytes(base64.b64decode(uri.split(",")[1]))
        document["buffers"][0]["uri"] = "model.bin"
        self.model.write_text(json.dumps(document))

    def measure(self, *arguments, size="24x16", **options):
        """Rows that were measured by this run, and what it said."""
        before = self.rows()
        done = self.run_program("measure", "model.gltf", "-o", "M", "--size", size, *self.SHORT, *arguments, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        after = self.rows()
        self.assertEqual(after[:len(before)], before, "rows of other runs stay as they are")
        return len(after) - len(before), done.stderr

    def rows(self):
        path = self.folder / "M" / "rows.jsonl"
        return path.read_text().splitlines() if path.exists() else []

    def expect_measured_again(self, part, *arguments, **options):
        count, said = self.measure(*arguments, **options)
        self.assertEqual(count, 3, f"{part}: expected every state anew")
        self.assertIn("timeshade: note: ", said)
        self.assertIn(part, said)
        self.assertEqual(self.measure(*arguments, **options), (0, ""), "the second time it is known")

    def test_rows_are_known_by_everything_that_they_depend_on(self):
        self.assertEqual(self.measure(), (3, ""))
        self.assertEqual(self.measure(), (0, ""), "nothing has changed")
        self.expect_measured_again("frame", size="25x16")
        self.expect_measured_again("frame", "--shutter-position", "end")
        self.expect_measured_again("frame", "--shutter", "0.25")
        self.expect_measured_again("frame", "--shutter-response", "tent")
        self.expect_measured_again("frame", "--shutter-response", "gaussian")
        self.expect_measured_again("frame", "--shutter-response", "gaussian", "--shutter-width", "0.3")
        self.assertEqual(self.measure("--shutter-response", "box"), (0, ""), "the usual one")
        self.expect_measured_again("frame", "--frame", "3")
        self.expect_measured_again("frame", "--seed", "9")
        pose = "0,9,0.5,1,0,0,0,0,-1,0,1,0,0.9,0.1"
        self.expect_measured_again("frame", "--pose", pose)
        self.expect_measured_again("settings", "--set", "static.bias=3")
        self.expect_measured_again("measurement", "--sequence", "2")
        shaders = self.folder / "shaders"
        shutil.copytree(ROOT / "shaders", shaders)
        changed = environment(TIMESHADE_SHADERS=shaders)
        self.assertEqual(self.measure(env=changed), (0, ""), "the same text in another folder")
        with open(shaders / "passes" / "shade.frag", "a", encoding="utf-8") as stream:
            stream.write("\n// changed\n")
        self.expect_measured_again("shaders", env=changed)
        data = bytearray((self.folder / "model.bin").read_bytes())
        data[1] ^= 1  # one bit of a vertex of the floor
        (self.folder / "model.bin").write_bytes(data)
        self.expect_measured_again("model")
        document = json.loads(self.model.read_text())
        document["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 90
        self.model.write_text(json.dumps(document))
        self.expect_measured_again("model")

    def test_plans_clips_textures_and_programs_are_part_of_it(self):
        document = json.loads(self.model.read_text())
        shutil.copy(ROOT / "tests" / "fuzz" / "corpus" / "image" / "small.png", self.folder / "colour.png")
        document["images"] = [{"uri": "colour.png"}]
        document["textures"] = [{"source": 0}]
        document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
        for mesh in document["meshes"]:
            mesh["primitives"][0]["material"] = 0
        document["animations"].append({**document["animations"][0], "name": "again"})
        self.model.write_text(json.dumps(document))
        self.assertEqual(self.measure(), (3, ""))
        self.assertEqual(self.measure(), (0, ""))
        self.expect_measured_again("clip", "--clip", "again")
        self.expect_measured_again("frame", "--force-dynamic")
        shutil.copy(ROOT / "tests" / "fuzz" / "corpus" / "image" / "palette.png", self.folder / "colour.png")
        self.expect_measured_again("model")
        # Another commit, or the same with other changes: another binary.
        other = self.folder / "timeshade"
        other.write_bytes(pathlib.Path(PROGRAM).read_bytes() + b"\0")
        other.chmod(0o755)
        self.expect_measured_again("program", executable=other)

    def test_what_is_no_journal_is_refused(self):
        (self.folder / "M").mkdir()
        rows = self.folder / "M" / "rows.jsonl"
        for text, why in (("no JSON\n", "no journal"), ("[" * 5000 + "\n", "no journal"),
                          ('{"spp": 1e300}\n', "no journal"), ("[" + "1," * (1 << 20) + "1]\n", "a line of")):
            with self.subTest(text=text[:20]):
                rows.write_text(text)
                self.refuse(1, ("M/rows.jsonl", why, "expected"), "measure", "model.gltf", "-o", "M", *self.SHORT,
                            leaves=("M", "M/rows.jsonl", "model.bin", "model.gltf"))
                self.assertEqual(rows.read_text(), text)
        os.truncate(rows, (256 << 20) + 1)
        self.refuse(1, ("M/rows.jsonl", "more than"), "measure", "model.gltf", "-o", "M", *self.SHORT,
                    leaves=("M", "M/rows.jsonl", "model.bin", "model.gltf"))

    def test_a_report_holds_rows_of_its_own_run_alone(self):
        self.measure()
        first = (self.folder / "M" / "accuracy.csv").read_text()
        self.measure(size="40x30")
        self.assertEqual(len((self.folder / "M" / "accuracy.csv").read_text().splitlines()), len(first.splitlines()))
        self.measure()
        self.assertEqual((self.folder / "M" / "accuracy.csv").read_text(), first)

    def test_a_folder_has_one_writer(self):
        (self.folder / "M").mkdir()
        descriptor = os.open(self.folder / "M", os.O_RDONLY)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        for arguments in (("measure", "cubes", *self.SHORT), ("measure", "cubes", "--effects"),
                          ("record", "cubes", "--frames", "1", "--size", "16x16")):
            self.refuse(1, ("M", "another timeshade"), *arguments, "-o", "M/" if arguments[0] == "record" else "M",
                        leaves=("M", "model.bin", "model.gltf"))
        os.close(descriptor)
        self.measure()

    def test_pipes_and_links_in_a_journals_place(self):
        (self.folder / "M").mkdir()
        os.mkfifo(self.folder / "M" / "rows.jsonl")
        done = self.run_program("measure", "model.gltf", "-o", "M", "--size", "16x16", *self.SHORT, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("not a regular file", done.stderr)


if __name__ == "__main__":
    unittest.main()

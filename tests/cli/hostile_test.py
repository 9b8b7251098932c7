"""Files, folders and streams that somebody else prepared: one line, exit code 1, and nothing of theirs is touched."""

import json
import os
import pathlib
import pty
import subprocess
import sys
import unittest

from program import PROGRAM, QUICK, ProgramTest, environment

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "verify"))
from small_scene import write_small_scene  # noqa: E402  pylint: disable=wrong-import-position

SHOT = ("shot", "chess", "-o", "F.png", *QUICK)


class SettingsFiles(ProgramTest):
    def test_they_describe_a_picture_and_never_a_place(self):
        for key in ("json", "output", "o", "dump", "device", "context", "settings", "script"):
            with self.subTest(key=key):
                (self.folder / "s.json").write_text(f'{{\n "spp": 2,\n "{key}": "somewhere"}}')
                self.refuse(1, (f"s.json:3: \"{key}\"", "expected"), *SHOT, "--settings", "s.json", leaves=("s.json",))
                for script in (f'{{"parts": [{{"scene": "chess"}},\n {{"scene": "cubes",\n "{key}": "x"}}]}}',
                               f'{{"options": {{"spp": 1,\n\n "{key}": "x"}}, "parts": [{{"scene": "cubes"}}]}}'):
                    (self.folder / "s.json").write_text(script)
                    self.refuse(1, (f"s.json:3: \"{key}\"", "expected"), "record", "--script", "s.json", "-o",
                                "V.mp4", leaves=("s.json",))

    def test_depth_and_size_have_limits(self):
        deep = "[" * 100000 + "]" * 100000
        (self.folder / "s.json").write_text(f'{{"spp": {deep}}}')
        self.refuse(1, ("s.json", "nested"), *SHOT, "--settings", "s.json", leaves=("s.json",))
        (self.folder / "s.json").write_text(f'{{"parts": {deep}}}')
        self.refuse(1, ("s.json", "expected"), "record", "--script", "s.json", "-o", "V.mp4", leaves=("s.json",))

    def test_only_files_of_some_size_are_read(self):
        os.mkfifo(self.folder / "pipe")
        with open(self.folder / "large", "wb") as file:
            file.truncate((4 << 20) + 1)
        for path, why in (("/dev/zero", "not a regular file"), ("pipe", "not a regular file"),
                          ("large", "more than 4194304 bytes"), (".", "Is a directory")):
            with self.subTest(path=path):
                self.refuse(1, ("--settings", path, why, "expected"), *SHOT, "--settings", path, timeout=60,
                            leaves=("large", "pipe"))
                self.refuse(1, ("--script", path, why, "expected"), "record", "--script", path, "-o", "V.mp4",
                            timeout=60, leaves=("large", "pipe"))
        config = self.folder / "config" / "timeshade"
        config.mkdir(parents=True)
        os.mkfifo(config / "window.json")
        self.refuse(1, ("DISPLAY",), "view", "chess", env=environment(XDG_CONFIG_HOME=self.folder / "config"),
                    timeout=60, leaves=self.files())

    def test_what_takes_long_to_place_is_read_at_once(self):
        """Long keys around many, and as many settings that are wrong."""
        many = ",".join(f'"k{i}": 0' for i in range(100000))
        (self.folder / "s.json").write_text(f'{{"{"x" * (1 << 20)}": {{{many}}}}}')
        self.refuse(1, ("s.json:1", "expected"), *SHOT, "--settings", "s.json", timeout=60, leaves=("s.json",))
        (self.folder / "s.json").write_text(f'{{"scene": "chess", "{"x" * (1 << 20)}": [{"[]," * 500000}[]]}}')
        self.refuse(1, ("s.json:1", "expected"), *SHOT, "--settings", "s.json", timeout=60, leaves=("s.json",))
        parts = ",".join(["{}"] * 100000)
        (self.folder / "s.json").write_text(f'{{"parts": [{parts}]}}')
        self.refuse(1, ("s.json", "100000 parts", "at most"), "record", "--script", "s.json", "-o", "V.mp4",
                    timeout=60, leaves=("s.json",))


class Targets(ProgramTest):
    def plant(self, name, owner=65534):
        """A link at the name to a file that must stay as it is."""
        precious = self.folder / "precious"
        precious.write_text("precious")
        (self.folder / name).symlink_to(precious)
        os.lchown(self.folder / name, owner, owner)
        return precious

    @unittest.skipUnless(os.geteuid() == 0, "needs root to make another user's link")
    def test_links_of_others_are_not_followed(self):
        for name, command in (("F.png", SHOT), ("V.mp4", ("record", "chess", "-o", "V.mp4", "--frames", "1", *QUICK)),
                              ("r.json", (*SHOT, "--json", "r.json"))):
            with self.subTest(name=name):
                precious = self.plant(name)
                done = self.run_program(*command)
                self.assertEqual(done.returncode, 1)
                self.assertIn("another user", done.stderr)
                self.assertEqual(precious.read_text(), "precious")
                (self.folder / name).unlink()

    def test_own_links_are_followed(self):
        precious = self.plant("F.png", os.geteuid())
        self.succeed(*SHOT)
        self.assertEqual(precious.read_bytes()[:4], b"\x89PNG")
        self.assertTrue((self.folder / "F.png").is_symlink())

    def test_a_replaced_file_keeps_its_permissions(self):
        for name, command in (("F.png", SHOT), ("V.mp4", ("record", "chess", "-o", "V.mp4", "--frames", "1", *QUICK))):
            (self.folder / name).write_text("old")
            (self.folder / name).chmod(0o600)
            self.succeed(*command)
            self.assertEqual((self.folder / name).stat().st_mode & 0o777, 0o600)

    def test_what_killed_runs_left_is_tidied_up(self):
        left = self.folder / "F.png.0123456789abcdef.part"
        left.write_text("half")
        others = [self.folder / name for name in ("F.png.part", "F.png.0123456789abcdeg.part", "G.png.01.part")]
        for other in others:
            other.write_text("not ours")
        self.succeed(*SHOT)
        self.assertFalse(left.exists())
        self.assertTrue(all(other.exists() for other in others))

    def test_names_that_look_like_options_or_patterns(self):
        for name in ("-y.mp4", "a:b.mp4", "50%d.mp4", "pipe:1.mp4"):
            with self.subTest(name=name):
                self.succeed("record", "chess", f"--output={name}", "--frames", "1", *QUICK)
                self.assertIn(b"ftyp", (self.folder / name).read_bytes()[:16])
                (self.folder / name).unlink()


class Streams(ProgramTest):
    def test_a_full_or_closed_standard_error_changes_nothing(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments, code in ((("shot", "nonsense", "-o", "F.png"), 2),
                                    (("shot", "missing.glb", "-o", "F.png"), 1), (SHOT, 0)):
                done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, env=environment(), stderr=full,
                                      stdout=subprocess.DEVNULL, check=False)
                self.assertEqual(done.returncode, code)
                closed = subprocess.run(["sh", "-c", 'exec "$0" "$@" 2>&-', PROGRAM, *arguments], cwd=self.folder,
                                        env=environment(), stdout=subprocess.DEVNULL, check=False)
                self.assertEqual(closed.returncode, code)

    def test_a_reader_that_is_gone_is_an_error_of_writing(self):
        with subprocess.Popen([PROGRAM, "list", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              env=environment()) as process:
            process.stdout.close()
            said = process.stderr.read().decode()
        self.assertIn(process.returncode, (0, 1), said)  # 0 where all of it fitted into the pipe before

    def test_names_in_files_do_not_change_the_terminal(self):
        """Escape sequences, also those of C1, and characters that turn the direction of writing."""
        evil = "\x1b]0;title\x07\x1b[2J\u009b31m\u202edesrever\u2066\u200f\n"
        write_small_scene(self.folder / "m.gltf")
        document = json.loads((self.folder / "m.gltf").read_text())
        document["materials"] = [{"name": evil, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
        document["textures"] = [{"source": 0}]
        document["images"] = [{"name": evil, "uri": "nowhere.png"}]
        document["animations"][0]["name"] = evil
        document["nodes"][0]["name"] = evil
        for mesh in document["meshes"]:
            mesh["primitives"][0]["material"] = 0
        (self.folder / "m.gltf").write_text(json.dumps(document))
        for arguments in (("shot", "m.gltf", "-o", "F.png", *QUICK), ("shot", "m.gltf", "-o", "F.png", "--clip", "x"),
                          ("shot", f"{evil}.gltf", "-o", "F.png")):
            with self.subTest(arguments=arguments[1]):
                seen = self.on_terminal(*arguments)
                self.assertTrue(seen)
                for bad in ("\x1b", "\x07", "\u009b", "\u202e", "\u2066", "\u200f"):
                    self.assertNotIn(bad, seen)

    def on_terminal(self, *arguments):
        """What the program writes to a terminal as standard error."""
        main, terminal = pty.openpty()
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, env=environment(), stderr=terminal,
                                   stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        os.close(terminal)
        seen = b""
        while True:
            try:
                part = os.read(main, 65536)
            except OSError:
                break
            if not part:
                break
            seen += part
        process.wait()
        os.close(main)
        return seen.decode()


if __name__ == "__main__":
    unittest.main()

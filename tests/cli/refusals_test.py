"""Whatever is wrong with the command line, the files or the machine is said in one line, before anything is written."""

import os
import pathlib
import subprocess
import unittest

from program import CONTEXTS, QUICK, TECHNIQUES, ProgramTest, environment

SHOT = ("shot", "chess", "-o", "F.png", *QUICK)


class BadArguments(ProgramTest):
    """Exit code 2, at once: none of these needs a context."""

    def refuse_usage(self, mentions, *arguments):
        # No OpenGL at all in this environment, so that a run that gets past the check fails with another code.
        self.refuse(2, mentions, *arguments, env=environment(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent"), timeout=60)

    def test_values_of_options(self):
        """Every value stands in the message, and so does the option or what was expected."""
        numbers = ("nan", "inf", "-inf", "one", " 3", "3 ", "0x10", "1e999", "3;", "")
        cases = {
            "--spp": ("0", "-1", "33", "8.5", "8x", "99999999999999999999", *numbers),
            "--map": ("0", "15", "8193", "-512", "512.5", "1024x", "x768", "1024x15", "8193x64", "64x64x64", "64X64",
                      *numbers),
            "--seed": ("-1", "1.5", "4294967296", *numbers),
            "--device": ("-1", "1001", "0.5", *numbers),
            "--frames": ("0", "-3", "100001", "2.5", *numbers),
            "--frame": ("1000001", "-1e7", *numbers),
            "--time": ("1000001", "-1e7", *numbers),
            "--fps": ("0", "-24", "0.01", "1e6", "24/0", "1/1001", "24000/", "/1001", "24/1/1", "-24/1", "24/1.5",
                      *numbers),
            "--instant": ("-0.1", "1.1", *numbers),
            "--shutter": ("-0.1", "16.5", *numbers),
            "--size": ("640", "640x", "x480", "0x480", "640x0", "-640x480", "16385x1", "1x16385", "640x480x3",
                       "640X480",
                       "640*480", "99999999999x1", "nanxnan", "640.5x480", ""),
            "--shutter-position": ("middle", "2", "Start", ""),
            "--shutter-response": ("triangle", "1", "Tent", ""),
            "--samples": ("both", "Intervals", "1", ""),
            "--time-strata": ("0", "-1", "33", "2.5", *numbers),
            "--motion-steps": ("0", "3", "64", "-2", "8.0", *numbers),
            "--shutter-width": ("0", "0.04", "2.1", "-0.2", *numbers),
            "--context": ("glx", "2", "EGL", ""),
            "--view": ("wrong", "1", "Final", ""),
            "--technique": ("nonsense", "TSM", "tsm ", "0", ""),
            "--camera": ("",),
            "--clip": ("",),
            "--json": ("",),
            "--light": ("",),
            "--light-direction": ("30", "30,91", "361,0", "1,2,3,4", "0,0,0", "30;40", "30,", ",", "30,40 ", "a,b",
                                  *(f"{n},{n}" for n in numbers if n), ""),
            "--light-distance": ("0", "-1", "2e9", *numbers),
            "--light-cone": ("0", "85", "-20", *numbers),
            "--light-intensity": ("-1", "1e7", *numbers),
            "--light-move": ("1", "1,2", "1,2,3,4", "1,2,nan", "inf,0,0", "1,2,2e9", "1, 2,3", ""),
            "--light-turn": ("361", "1,2,3", "5,", "5,400", *numbers),
            "--ground": ("maybe", "1", "On", ""),
            "--ground-height": ("2e9", *numbers),
            "--ground-size": ("0", "-3", "2e9", *numbers),
            "--exposure": ("17", "-16.5", *numbers),
            "--tone-map": ("aces", "0", "Filmic", ""),
        }
        for option, values in cases.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    # Joined, since a value that begins with a dash may be an option; but nothing is not joined.
                    given = (f"{option}={value}",) if value else (option, value)
                    self.refuse_usage((value, option.lstrip("-"), "expected"), *SHOT, *given)

    def test_a_width_is_the_gaussians(self):
        for response in ((), ("--shutter-response", "box"), ("--shutter-response", "tent")):
            self.refuse_usage(("--shutter-width 0.2", "expected", "--shutter-response gaussian"), *SHOT,
                              "--shutter-width", "0.2", *response)

    def test_interval_samples_have_no_time(self):
        """What is about camera samples and their times is refused, not drawn of something else."""
        intervals = ("--samples", "intervals")
        for arguments in (("verify", "crossing", "--technique", "exact", "--max-ppm", "1"),
                          ("verify", "crossing", "--technique", "exact", "--dump", "D"),
                          ("epipolar", "crossing", "-o", "F.png"), ("view", "crossing")):
            with self.subTest(arguments=arguments):
                self.refuse_usage(("--samples intervals", "expected strata"), *arguments, *intervals)

    def test_what_takes_one_linear_motion(self):
        steps = ("--motion-steps", "4")
        for arguments in (("shot", "crossing", "-o", "F.png", "--samples", "intervals"),
                          ("verify", "crossing", "--technique", "exact", "--dump", "D"),
                          ("epipolar", "crossing", "-o", "F.png")):
            with self.subTest(arguments=arguments):
                self.refuse_usage(("--motion-steps 4", "one linear motion", "expected"), *arguments, *steps)

    def test_settings_of_techniques(self):
        for setting in ("", "=", "tsm", "tsm.bias", "tsm=1", ".bias=1", "tsm.bias=", "tsm.bias=nan", "tsm.bias=inf",
                        "tsm.bias=-1",
                        "tsm.bias=64.5", "tsm.bias=1 ", "tsm.bias= 1", "tsm.bias=0x1", "tsm.bias=1,5", "tsm.=1",
                        "tsm.Bias=1",
                        "tsm.nonsense=1", "nonsense.bias=1", "tsm.dynamic_bias=maybe", "tsm.dynamic_bias=3",
                        "tsm.dynamic_bias=",
                        "static.pcf_radius=4", "static.pcf_radius=1.5", "accumulation.renders=0",
                        "accumulation.renders=5000",
                        "accumulation.renders=1e9", "accumulation.renders=nan"):
            with self.subTest(setting=setting):
                # Of a key that does not exist the value is no matter. Also where another technique is drawn.
                wrong = setting.split("=")[0] if setting in ("tsm.=1", "tsm.Bias=1", "tsm.nonsense=1") else setting
                wrong = "nonsense" if setting.startswith("nonsense") else wrong
                for technique in TECHNIQUES:
                    self.refuse_usage((wrong, "expected"), *SHOT, "--technique", technique, "--set", setting)

    def test_scene_settings(self):
        for setting in ("cubes.nonsense=1", "cubes.count=", "cubes.count=0", "cubes.count=1.5", "cubes.count=25001",
                        "cubes.speed=nan",
                        "cubes.speed=16.1", "Cubes.count=5", "chess.count=5", "nonsense.count=5", "cubes=5",
                        ".count=5"):
            with self.subTest(setting=setting):
                self.refuse_usage(("expected",), "shot", "cubes", "-o", "F.png", "--set", setting)
        # Also where another scene is drawn.
        self.refuse_usage(("cubes.count=0", "expected"), *SHOT, "--set", "cubes.count=0")
        self.refuse(1, ("--clip walk", "cubes"), "shot", "cubes", "-o", "F.png", "--clip", "walk")

    def test_what_a_scene_does_not_have(self):
        """Known once the scene is there, still before there is a context."""
        for option, value in (("--light-distance", "3"), ("--light-cone", "20"), ("--light-move", "1,0,0")):
            self.refuse_usage((f"{option} {value}", "sun", "expected"), "shot", "foliage", "-o", "F.png", option, value)
        self.refuse(1, ("--light 2", "cubes"), "shot", "cubes", "-o", "F.png", "--light", "2")
        self.refuse(1, ("--ground on", "cubes"), "shot", "cubes", "-o", "F.png", "--ground", "on")
        self.refuse(1, ("--ground on", "case:"), "shot", "case:static_all", "-o", "F.png", "--ground", "on")
        self.refuse(1, ('"candle"', "it has: lamp"), *SHOT, "--light", "candle")

    def test_what_was_meant(self):
        self.refuse_usage(("did you mean --technique?", "timeshade help shot"), *SHOT, "--techniqe", "tsm")
        self.refuse_usage(("did you mean --shutter-position?",), *SHOT, "--shutterposition=end")
        self.refuse_usage(("did you mean exact?",), *SHOT, "--technique", "exat")
        self.refuse_usage(("did you mean octopus?",), "shot", "octpus", "-o", "F.png")
        self.refuse_usage(("'shoot'", "did you mean shot?"), "shoot", "chess", "-o", "F.png")
        self.refuse_usage(("did you mean tsm.bias?",), *SHOT, "--set", "tsm.bais=1")
        self.refuse_usage(("did you mean cubes?",), "shot", "cubes", "-o", "F.png", "--set", "cube5.count=3")
        self.refuse_usage(("help measur", "did you mean measure?"), "help", "measur")

    def test_scenes(self):
        for scene in ("", "nonsense", "Chess", "chess ", "chess.glbx"):
            with self.subTest(scene=scene):
                self.refuse_usage((f"'{scene}'", "expected", "octopus"), "shot", scene, "-o", "F.png")

    def test_cameras_are_named(self):
        # Known only once the scene is read, still before there is a context.
        self.refuse_usage(("--camera nonsense", "expected", "table", "knight", "rook"), *SHOT, "--camera", "nonsense")

    def test_outputs(self):
        for output in ("", ".png", "F", "F.jpg", "F.PNG", "F.png ", "F.png.txt", "png"):
            with self.subTest(output=output):
                self.refuse_usage((output, "expected", ".exr"), "shot", "chess", "-o", output)

    def test_what_is_missing_or_too_much(self):
        self.refuse_usage(("--output",), "shot", "chess")
        self.refuse_usage(("scene",), "shot", "-o", "F.png")
        self.refuse_usage(("--output",), "pictures")
        self.refuse_usage(("--nonsense",), *SHOT, "--nonsense")
        self.refuse_usage(("--nonsense",), *SHOT, "--nonsense=3")
        self.refuse_usage(("-x",), *SHOT, "-x")
        self.refuse_usage(("octopus",), *SHOT, "octopus")
        self.refuse_usage(("--frame", "--time"), *SHOT, "--frame", "1", "--time", "1")
        self.refuse_usage(("--nonsense",), "list", "--nonsense")
        self.refuse_usage(("chess",), "list", "chess")
        self.refuse_usage(("--nonsense",), "--nonsense")
        for option in ("--spp", "--technique", "--set", "--settings", "--json", "-o"):
            self.refuse_usage((option.lstrip("-"),), "shot", "chess", option)

    def test_line_ends_in_values(self):
        self.refuse_usage(("expected", "one two  three"), *SHOT, "--technique", "one\ntwo\r\nthree")
        self.refuse_usage(("expected", "one two"), *SHOT, "--spp", "one\ntwo")
        self.refuse_usage(("expected",), "shot", "one\ntwo", "-o", "F.png")


class SettingsFiles(ProgramTest):
    def refuse_file(self, code, text, mentions):
        (self.folder / "s.json").write_bytes(text if isinstance(text, bytes) else text.encode())
        self.refuse(code, mentions, *SHOT, "--settings", "s.json", leaves=("s.json",))

    def test_files_that_cannot_be_read(self):
        self.refuse(1, ("missing.json", "expected"), *SHOT, "--settings", "missing.json")
        self.refuse(1, ("''", "expected"), *SHOT, "--settings", "")
        self.refuse(1, (str(self.folder), "expected"), *SHOT, "--settings", self.folder)
        self.refuse_file(1, "", ("s.json", "expected"))

    def test_files_that_are_not_json(self):
        for text in ("spp = 8", '{"spp": 8', '{"spp": 8} trailing', "{'spp': 8}", b"\xff\xfe\x00", b"\0\0\0\0",
                     b'{}\0{"\xc4":',
                     "[" * 5000):
            with self.subTest(text=text[:20]):
                self.refuse_file(1, text, ("s.json", "expected"))

    def test_files_that_hold_something_else(self):
        for text in ("[]", "3", '"chess"', "null", "true"):
            with self.subTest(text=text):
                self.refuse_file(1, text, ("s.json", "expected an object"))
        for text in ('{"spp": [8]}', '{"spp": null}', '{"spp": {"a": 1}}', '{"set": [1]}'):
            with self.subTest(text=text):
                self.refuse_file(1, text, ("s.json", "s", "expected"))
        for text in ('{"settings": "s.json"}', '{"help": true}'):
            with self.subTest(text=text):
                self.refuse_file(1, text, ("s.json", "expected"))

    def test_the_line_is_named(self):
        for text, line, mentions in (('{\n "technique": "exact",\n "spp": 0\n}', 3, ("'0'",)),
                                     ('{\n "set": {\n  "tsm.dynamic_bias": true,\n\n  "tsm.bias": 99}}', 5,
                                      ("tsm.bias=99",)),
                                     ('{\n\n "frame": 1, "time": 1}', 3, ("time",))):
            self.refuse_file(2, text, (f"s.json:{line}: ", *mentions))
        self.refuse_file(1, '{\n "spp": 8,\n oops}', ("s.json:3: ", "expected"))
        self.refuse_file(1, '{"spp": 2,\n "window": {"spp": 5},\n\n "wrong": 1}', ("s.json:4: ", "wrong"))
        self.refuse_file(1, '{\n "spp": [8]}', ("s.json:2: ", "array", "expected"))

    def test_values_in_files(self):
        cases = {'{"nonsense": 8}': ("nonsense",), '{"": 8}': ("expected",), '{"spp": 0}': ("spp", "'0'"),
                 '{"spp": "many"}': ("spp", "many"),
                 '{"spp": true}': ("spp", "true"), '{"spp": 8.5}': ("spp", "8.5"), '{"frame": 1e999}': (),
                 '{"set": {"tsm.bias": "much"}}': ("tsm.bias", "much"),
                 '{"set": {"tsm.nonsense": 1}}': ("tsm.nonsense",),
                 '{"set": {"tsm.bias": [1]}}': ("tsm.bias", "[1]"), '{"set": {"tsm.bias": null}}': ("tsm.bias", "null"),
                 '{"technique": "nonsense"}': ("nonsense",), '{"technique": "a\\nb"}': ("a b",),
                 '{"explain": "maybe"}': ("explain", "maybe"),
                 '{"frame": 1, "time": 1}': ("frame", "time"),
                 '{"camera": ""}': ("camera", "''"), '{"spp": ""}': ("spp", "''")}
        for text, mentions in cases.items():
            with self.subTest(text=text):
                (self.folder / "s.json").write_text(text)
                code = 1 if "1e999" in text or ': 8}' in text else 2
                self.refuse(code, mentions, *SHOT, "--settings", "s.json", leaves=("s.json",))


class SceneFiles(ProgramTest):
    def test_files_that_are_not_there(self):
        for path in ("missing.glb", "missing.gltf", "missing/missing", "/nonexistent/a.glb"):
            with self.subTest(path=path):
                self.refuse(1, (path,), "shot", path, "-o", "F.png")

    def test_files_that_are_no_scenes(self):
        contents = {"empty.glb": b"", "text.gltf": b"not a scene", "json.gltf": b"{}",
                    "cut.glb": b"glTF\x02\0\0\0\xff\0\0\0",
                    "zeros.glb": bytes(64), "list.gltf": b"[]", "picture.glb": b"\x89PNG\r\n\x1a\n"}
        for name, content in contents.items():
            (self.folder / name).write_bytes(content)
        (self.folder / "folder.glb").mkdir()
        present = [*contents, "folder.glb"]
        for name in present:
            with self.subTest(name=name):
                self.refuse(1, (name,), "shot", name, "-o", "F.png", leaves=present)

    def test_clips_are_named(self):
        self.refuse(1, ("nonsense", "motion"), *SHOT, "--clip", "nonsense")

    def test_a_scene_folder_that_is_not_there(self):
        self.refuse(1, ("/nonexistent",), *SHOT, env=environment(TIMESHADE_SCENES="/nonexistent"))


class Machines(ProgramTest):
    """A machine without OpenGL, with too old a one, without a display."""

    def broken_osmesa(self):
        """Libraries that come first and cannot be loaded: as good as none."""
        folder = self.folder / "libraries"
        folder.mkdir()
        for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
            (folder / name).write_bytes(b"not a library")
        return folder

    def test_no_egl(self):
        self.refuse(1, ("EGL",), *SHOT, "--context", "egl",
                    env=environment(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent"))

    @unittest.skipUnless("osmesa" in CONTEXTS, "this machine has no OSMesa")
    def test_no_egl_falls_back_on_osmesa(self):
        out = self.succeed(*SHOT, "--json", "r.json", env=environment(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent"))
        self.assertIn("F.png", out)
        self.assertIn("OSMesa", (self.folder / "r.json").read_text())

    def test_no_osmesa(self):
        libraries = self.broken_osmesa()
        self.refuse(1, ("OSMesa",), *SHOT, "--context", "osmesa", env=environment(LD_LIBRARY_PATH=libraries),
                    leaves=self.files())

    def test_neither(self):
        libraries = self.broken_osmesa()
        env = environment(LD_LIBRARY_PATH=libraries, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        self.refuse(1, ("EGL", "OSMesa"), *SHOT, env=env, leaves=self.files())
        self.refuse(1, ("EGL", "OSMesa"), "pictures", "-o", "libraries", env=env, leaves=self.files())

    def test_too_old(self):
        if "Mesa" not in self.succeed(*SHOT):
            self.skipTest("only Mesa can be told to be older than it is")
        (self.folder / "F.png").unlink()
        for context in CONTEXTS:
            with self.subTest(context=context):
                self.refuse(1, ("3.3", "4.5"), *SHOT, "--context", context,
                            env=environment(MESA_GL_VERSION_OVERRIDE="3.3", MESA_GLSL_VERSION_OVERRIDE="330"))

    def test_no_such_device(self):
        self.refuse(1, ("EGL device 999", "expected"), *SHOT, "--device", "999")
        if "osmesa" in CONTEXTS:
            self.refuse(2, ("--device 0", "expected"), *SHOT, "--device", "0", "--context", "osmesa")

    def test_no_display(self):
        for display in (None, ":99", "nonsense"):
            with self.subTest(display=display):
                env = environment(DISPLAY=display, XDG_RUNTIME_DIR=self.folder)
                self.refuse(1, ("DISPLAY",), "view", "chess", env=env, timeout=60)
                self.refuse(1, ("DISPLAY",), env=env, timeout=60)
                self.refuse(1, ("DISPLAY",), *SHOT, "--context", "window", env=env, timeout=60)

    def test_shaders_that_are_not_there(self):
        self.refuse(1, ("/nonexistent",), *SHOT, env=environment(TIMESHADE_SHADERS="/nonexistent"))

    def copied_shaders(self):
        sources = pathlib.Path(__file__).resolve().parents[2] / "shaders"
        subprocess.run(["cp", "-r", sources, self.folder / "shaders"], check=True)
        os.chmod(self.folder / "shaders", 0o755)

    def test_includes_without_end(self):
        self.copied_shaders()
        chain = self.folder / "shaders" / "chain"
        chain.mkdir()
        count = 300  # a chain of 60,000 would be refused no differently
        for i in range(count):
            (chain / f"{i}.glsl").write_text(f'#include "chain/{i + 1}.glsl"\n')
        (chain / f"{count}.glsl").write_text("")
        (chain / "zero.glsl").symlink_to("/dev/zero")
        os.mkfifo(chain / "pipe.glsl")
        with open(chain / "large.glsl", "wb") as file:
            file.truncate((4 << 20) + 1)
        present = self.files()
        shade = self.folder / "shaders" / "passes" / "shade.frag"
        text = shade.read_text()
        for name, why in (("0", "at most 256"), ("zero", "not a regular file"), ("pipe", "not a regular file"),
                          ("large", "more than")):
            with self.subTest(name=name):
                shade.write_text(f'#include "chain/{name}.glsl"\n{text}')
                self.refuse(1, ("chain/", why, "expected"), *SHOT, timeout=120,
                            env=environment(TIMESHADE_SHADERS=self.folder / "shaders"), leaves=present)

    def test_a_shader_with_an_error(self):
        self.copied_shaders()
        shade = self.folder / "shaders" / "passes" / "shade.frag"
        shade.write_text(shade.read_text() + "\nvoid broken() { undeclared = 1.0; }\n")
        present = self.files()
        self.refuse(1, ("passes/shade.frag", "undeclared"), *SHOT,
                    env=environment(TIMESHADE_SHADERS=self.folder / "shaders"), leaves=present)


if __name__ == "__main__":
    unittest.main()

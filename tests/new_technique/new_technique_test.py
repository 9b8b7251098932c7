#!/usr/bin/env python3
"""A technique made by scripts/new_technique.py costs two folders and one line, and passes the tests as it is."""
import json
import os
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["TIMESHADE_BUILD"])


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        words = shlex.join(map(str, command))
        raise AssertionError(f"{words}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class NewTechnique(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not (ROOT / ".git").exists():
            raise unittest.SkipTest("the project's files are those that its git repository has: there is none")
        cls.work = Path(tempfile.mkdtemp(prefix="timeshade-new-technique-"))
        cls.copy = cls.work / "tree"
        files = run("git", "-C", ROOT, "ls-files", "-co", "--exclude-standard", "-z").split("\0")
        for name in filter(None, files):
            if (ROOT / name).is_file():
                (cls.copy / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(ROOT / name, cls.copy / name)
        git = ("git", "-C", cls.copy, "-c", "user.name=test", "-c", "user.email=test@example.com")
        run(*git, "init", "-q")
        run(*git, "add", "-A")
        run(*git, "commit", "-q", "-m", "before")
        run("python3", cls.copy / "scripts" / "new_technique.py", "plain", "Plain map")
        cls.objects = cls.compile()
        cls.environment = {**os.environ, "TIMESHADE_SHADERS": str(cls.copy / "shaders")}
        cls.program = cls.link("timeshade")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.work)

    @classmethod
    def compile(cls):
        """The registry and the new technique, with the flags of the registry as it was built."""
        registry = str(ROOT / "renderer" / "techniques" / "registry.cpp")
        entries = json.loads((BUILD / "compile_commands.json").read_text())
        entry = next(e for e in entries if e["file"] == registry)
        flags = re.sub(r" -o \S+ -c \S+$", "", entry["command"])
        for folder in ("renderer", "shaders"):
            flags = flags.replace(str(ROOT / folder), str(cls.copy / folder))
        objects = []
        for source in ("registry.cpp", "plain/plain_shadow.cpp"):
            out = cls.work / (source.replace("/", "_") + ".o")
            run("bash", "-c", f"{flags} -o {out} -c {cls.copy / 'renderer' / 'techniques' / source}", cwd=BUILD)
            objects.append(str(out))
        return objects

    @classmethod
    def link(cls, target):
        """A program of the build with the new objects before its libraries."""
        commands = run("ninja", "-C", BUILD, "-t", "commands", target).splitlines()
        command = next(c for c in reversed(commands) if f" -o {target} " in c)
        command = command[command.index("/"):] if command.startswith(":") else command
        command = re.sub(r" && :$", "", command)
        out = cls.work / Path(target).name
        command = command.replace(f" -o {target} ", f" -o {out} {' '.join(cls.objects)} ")
        run("bash", "-c", command, cwd=BUILD)
        return out

    def test_costs_two_folders_and_one_line(self):
        status = run("git", "-C", self.copy, "status", "--porcelain").splitlines()
        self.assertEqual(sorted(status), [" M renderer/techniques/registry.def", "?? renderer/techniques/plain/",
                                          "?? shaders/techniques/plain/"])
        numbers = run("git", "-C", self.copy, "diff", "--numstat").split()
        self.assertEqual(numbers[:2], ["1", "0"], "one line is added, none is changed")

    def test_follows_the_style(self):
        for check in ("format", "columns", "file_lengths", "function_lengths", "words", "techniques"):
            done = subprocess.run(["python3", "-B", self.copy / "tests" / "style" / "style_test.py", check, self.copy],
                                  capture_output=True, text=True)
            self.assertIn(done.returncode, (0, 77), f"{check}: {done.stdout}{done.stderr}")

    def test_is_listed_with_its_settings(self):
        listed = json.loads(run(self.program, "list", "--json", env=self.environment))
        plain = next(t for t in listed["techniques"] if t["name"] == "plain")
        self.assertEqual(plain["title"], "Plain map")

    def test_draws_what_static_draws(self):
        def numbers(technique):
            options = ("--size", "96x72", "--spp", "2", "--map", "128", "--reference-rays", "0", "--json", "-")
            return json.loads(run(self.program, "verify", "chess", "--technique", technique, *options,
                                  env=self.environment))
        plain, static = numbers("plain"), numbers("static")
        self.assertEqual(plain["ppm"], static["ppm"])
        self.assertGreater(plain["shadowed"], 0)

    def test_passes_the_tests_of_every_technique(self):
        tests = self.link("tests/test_technique")
        listed = run(tests, "--gtest_list_tests", env=self.environment)
        self.assertRegex(listed, r"(?i)plain")
        run(tests, "--gtest_filter=*plain*:*Plain*", env=self.environment, timeout=500)


if __name__ == "__main__":
    unittest.main()

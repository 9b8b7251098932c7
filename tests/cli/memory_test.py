"""One budget for a scene: what a small file expands to is refused in one line before it is allocated."""

import base64
import json
import struct
import subprocess
import sys
import unittest

from program import PROGRAM, QUICK, ProgramTest, environment

MEBIBYTE = 1 << 20
# A process begins with the peak of the one that starts it, so a small one does.
LAUNCHER = """
import os, sys
_, status, usage = os.wait4(os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ), 0)
print(os.waitstatus_to_exitcode(status), usage.ru_maxrss)
"""


def buffer_of(data):
    return {"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}


def grid(side):
    """Positions and indices of side x side quads in the plane z = 0, which its vertices share."""
    positions = [(x / side, y / side, 0.0) for y in range(side + 1) for x in range(side + 1)]
    indices = []
    for y in range(side):
        for x in range(side):
            a = y * (side + 1) + x
            indices += [a, a + 1, a + side + 2, a, a + side + 2, a + side + 1]
    return positions, indices


def model(side=8, nodes=1):
    """A grid of 2 side^2 triangles, and nodes that all show it."""
    positions, indices = grid(side)
    data = b"".join(struct.pack("<3f", *p) for p in positions) + struct.pack(f"<{len(indices)}I", *indices)
    first = 12 * len(positions)
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(nodes))}],
            "buffers": [buffer_of(data)],
            "bufferViews": [{"buffer": 0, "byteLength": first},
                            {"buffer": 0, "byteOffset": first, "byteLength": len(data) - first}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5125, "count": len(indices), "type": "SCALAR"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "nodes": [{"mesh": 0, "translation": [i % 50, i // 50, 0]} for i in range(nodes)]}


def with_few_corners(document):
    document["accessors"][1]["count"] = 3
    return document


def with_targets(targets):
    """Morph targets that are all one accessor."""
    document = model(side=100)
    document["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 0}] * targets
    return document


def with_keys(accessors):
    """Animations whose keys are the same bytes, read by accessors of their own."""
    document = model()
    count = 50000
    document["buffers"].append(buffer_of(struct.pack(f"<{count}f", *range(count)) + bytes(12 * count)))
    document["bufferViews"] += [{"buffer": 1, "byteLength": 4 * count},
                                {"buffer": 1, "byteOffset": 4 * count, "byteLength": 12 * count}]
    document["animations"] = [{"samplers": [], "channels": []}]
    for i in range(accessors):
        document["accessors"] += [{"bufferView": 2, "componentType": 5126, "count": count, "type": "SCALAR",
                                   "min": [0], "max": [count]},
                                  {"bufferView": 3, "componentType": 5126, "count": count, "type": "VEC3"}]
        document["animations"][0]["samplers"].append({"input": 2 + 2 * i, "output": 3 + 2 * i})
        document["animations"][0]["channels"].append({"sampler": i, "target": {"node": 0, "path": "translation"}})
    return document


def with_skins(skins, joints):
    """Skins that share their joints."""
    document = model(nodes=1)
    document["nodes"] += [{} for _ in range(joints)]
    document["scenes"][0]["nodes"] = list(range(joints + 1))
    document["skins"] = [{"joints": list(range(1, joints + 1))} for _ in range(skins)]
    return document


class Budget(ProgramTest):
    def peak_of(self, *arguments):
        """Exit code, standard error, and the largest resident size of a run, in bytes. Without a ground, of which
        there would be a note."""
        done = subprocess.run([sys.executable, "-S", "-c", LAUNCHER, PROGRAM, *map(str, arguments), "--ground", "off"],
                              cwd=self.folder,
                              env=environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True)
        code, kibibytes = done.stdout.splitlines()[-1].split()
        return int(code), done.stderr, 1024 * int(kibibytes)

    def setUp(self):
        super().setUp()
        self.write(model())
        code, said, self.least = self.peak_of("shot", "m.gltf", "-o", "F.png", *QUICK)
        self.assertEqual((code, said), (0, ""))

    def write(self, document):
        (self.folder / "m.gltf").write_text(json.dumps(document, separators=(",", ":")))

    def test_what_a_file_expands_to_is_refused_first(self):
        for what, limit, document in (("triangles over all instances", 1000, model(side=40, nodes=1000)),
                                      ("vertices over all instances", 32, with_few_corners(model(side=40, nodes=1000))),
                                      ("morph", 64, with_targets(1000)),
                                      ("key", 64, with_keys(200)),
                                      ("joints", 128, with_skins(200, 2000)),
                                      ("JSON", 64, {**model(), "extras": [{} for _ in range(100000)]}),
                                      ("the bytes of m.gltf", 1, model(side=300)), ("data URIs", 50, model(side=450))):
            with self.subTest(what=what):
                self.write(document)
                code, said, peak = self.peak_of("shot", "m.gltf", "-o", "G.png", *QUICK, "--memory-limit", f"{limit}M")
                self.assertEqual(code, 1, said)
                self.assertEqual(said.count("\n"), 1, said)
                self.assertIn(what, said)
                self.assertIn("--memory-limit", said)
                self.assertIn(f"{limit}.0 MiB", said)
                self.assertLess(peak, self.least + 1.2 * limit * MEBIBYTE)
                self.assertFalse((self.folder / "G.png").exists())

    def test_what_is_within_the_budget_takes_no_more(self):
        """Each just below what is refused, so that what was counted is nearly all of the limit."""
        for limit, document in ((256, model(side=40, nodes=80)), (96, with_targets(600)), (96, with_keys(70)),
                                (128, {**model(), "extras": [{} for _ in range(50000)]})):
            self.write(document)
            code, said, peak = self.peak_of("shot", "m.gltf", "-o", "F.png", *QUICK, "--memory-limit", f"{limit}M")
            self.assertEqual((code, said), (0, ""))
            self.assertLess(peak, self.least + 1.2 * limit * MEBIBYTE)

    def test_bad_values(self):
        for value in ("", "5", "M", "5X", "0M", "-1G", "1.5G", "2T", "1025G", "99999999999999999999G", "512 M"):
            with self.subTest(value=value):
                self.refuse(2, ("--memory-limit", f"'{value}'", "expected"), "shot", "chess",
                            "-o", "G.png", "--memory-limit", value, leaves=("F.png", "m.gltf"))
        (self.folder / "s.json").write_text('{"memory-limit": "64G"}')
        self.refuse(1, ("memory-limit", "expected"), "shot", "chess", "-o", "G.png", "--settings", "s.json",
                    leaves=("F.png", "m.gltf", "s.json"))


if __name__ == "__main__":
    unittest.main()

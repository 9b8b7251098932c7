"""A leaf that is cut out of a card by its alpha, under a sun that turns, in a file made here: `verify` by its own
oracle, and its samples against the definition by brute force, with alpha read here from the image that was written.

usage: cutouts_test.py PROGRAM SOURCE_FOLDER
"""

import base64
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

from brute_force import clearance_of, meeting, rows

PROGRAM = sys.argv[1]
SIDE = 20
REPEAT, CLAMP, MIRRORED = 10497, 33071, 33648


def alpha_of(column, row):
    """A leaf with lobes and a hole, soft at its edges."""
    x, y = (2 * column + 1) / SIDE - 1, (2 * row + 1) / SIDE - 1
    inside = min(0.75 - 0.2 * math.cos(5 * math.atan2(y, x)) - math.hypot(x, y), math.hypot(x - 0.2, y) - 0.2)
    return round(255 * min(1, max(0, 0.5 + 3 * inside)))


def png():
    lines = b"".join(b"\0" + b"".join(bytes((90, 160, 60, alpha_of(c, r))) for c in range(SIDE)) for r in range(SIDE))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIDE, SIDE, 8, 6, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def texel(number, wrap):
    if wrap == REPEAT:
        return number % SIDE
    if wrap == MIRRORED:
        number %= 2 * SIDE
        return min(number, 2 * SIDE - 1 - number)
    return min(max(number, 0), SIDE - 1)


def alpha_at(s, t, wrap):
    """Of the image at texture coordinates, bilinearly."""
    x, y = s * SIDE - 0.5, t * SIDE - 0.5
    left, top = math.floor(x), math.floor(y)
    sums = 0.0
    for i in (0, 1):
        for j in (0, 1):
            weight = (x - left if i else 1 - x + left) * (y - top if j else 1 - y + top)
            sums += weight * alpha_of(texel(left + i, wrap), texel(top + j, wrap))
    return sums / 255


CARD = [(-1.2, 2.0, 1.0), (1.2, 2.3, 1.0), (1.2, 2.3, -1.0), (-1.2, 2.0, -1.0)]
CORNERS = [(0, 1, 2), (0, 2, 3)]


class Leaf:
    """The file, and what is known of its alpha."""

    def __init__(self, wrap=CLAMP, repeats=1.0, cutoff=0.5, mode="MASK", moves=True):
        self.wrap, self.cutoff = wrap, cutoff
        self.coordinates = [(-0.3 * repeats + 0.3, repeats), (repeats, repeats), (repeats, 0.0), (0.0, 0.0)]
        ground = [(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)]
        half = 0.5 * math.radians(8)
        parts = [b"".join(struct.pack("<3f", *v) for v in ground + CARD),
                 struct.pack("<6H", 0, 1, 2, 0, 2, 3),
                 b"".join(struct.pack("<2f", *t) for t in self.coordinates),
                 struct.pack("<2f", 0, 1),
                 self.turns(-half) + self.turns(half),
                 struct.pack("<6f", -0.3, 0, 0, 0.4, 0.2, 0.1),
                 png()]
        data, views = b"", []
        for part in parts:
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
            data += part + bytes(-len(part) % 4)
        yaw, pitch = 0.5 * math.radians(35), 0.5 * math.radians(-43)
        beside = [math.cos(yaw) * math.sin(pitch), math.sin(yaw) * math.cos(pitch), -math.sin(yaw) * math.sin(pitch),
                  math.cos(yaw) * math.cos(pitch)]
        channels = [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}]
        if moves:
            channels.append({"sampler": 1, "target": {"node": 1, "path": "translation"}})

        def accessor(view, component, count, kind, start=0):
            return {"bufferView": view, "byteOffset": start, "componentType": component, "count": count, "type": kind}

        self.document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3]}],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 2}]}},
            "nodes": [{"mesh": 0}, {"mesh": 1},
                      {"extensions": {"KHR_lights_punctual": {"light": 0}},
                       "rotation": struct.unpack("<4f", self.turns(0))},
                      {"camera": 0, "translation": [3.5, 6, 5], "rotation": beside}],
            "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2}]},
                       {"primitives": [{"attributes": {"POSITION": 1, "TEXCOORD_0": 3}, "indices": 2, "material": 0}]}],
            "materials": [{"name": "leaf", "alphaMode": mode, "alphaCutoff": cutoff, "doubleSided": True,
                           "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": wrap, "wrapT": wrap}],
            "images": [{"bufferView": 6, "mimeType": "image/png"}],
            "accessors": [dict(accessor(0, 5126, 4, "VEC3"), min=[-4, 0, -4], max=[4, 0, 4]),
                          dict(accessor(0, 5126, 4, "VEC3", 48), min=[-1.2, 2, -1], max=[1.2, 2.3, 1]),
                          accessor(1, 5123, 6, "SCALAR"), accessor(2, 5126, 4, "VEC2"),
                          dict(accessor(3, 5126, 2, "SCALAR"), min=[0], max=[1]), accessor(4, 5126, 2, "VEC4"),
                          accessor(5, 5126, 2, "VEC3")],
            "animations": [{"samplers": [{"input": 4, "output": 5}, {"input": 4, "output": 6}],
                            "channels": channels}],
            "bufferViews": views,
            "buffers": [{"byteLength": len(data),
                         "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}

    @staticmethod
    def turns(angle):
        """Light from above, off by the angle about z."""
        s = math.sqrt(0.5)
        c, n = math.cos(angle / 2 + 0.15), math.sin(angle / 2 + 0.15)
        return struct.pack("<4f", -s * c, -s * n, s * n, s * c)

    def covers(self, number, weights):
        """Triangles 2 and 3 are the card's."""
        if number < 2:
            return True
        at = [sum(w * self.coordinates[c][i] for w, c in zip(weights, CORNERS[int(number) - 2])) for i in (0, 1)]
        return alpha_at(at[0], at[1], self.wrap) >= self.cutoff


class Cutouts(unittest.TestCase):
    def verify(self, leaf, technique, *more, size="160x120"):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "leaf.gltf")
            with open(path, "w", encoding="utf-8") as stream:
                json.dump(leaf.document, stream)
            done = subprocess.run([PROGRAM, "verify", path, "--technique", technique, "--size", size, "--spp", "4",
                                   "--map", "256", "--reference-rays", "0", "--json", "-", "--frame", "0", "--shutter",
                                   "1", "--fps", "1",
                                   *(more or ("--dump", os.path.join(folder, "dump")))],
                                  capture_output=True, text=True, check=False)
            if done.returncode != 0:
                return done.stderr
            return (json.loads(done.stdout), *(rows(os.path.join(folder, "dump", name + ".csv"))
                                               for name in ("triangles", "light", "samples")))

    def by_brute_force(self, leaf, triangles, light, samples):
        """How many samples are dark, and of how many the program said something else."""
        dark_ones = wrong = seen_through = 0
        by_number = {triangle[0]: triangle for triangle in triangles}
        for _, _, _, u, number, x, y, z, is_tested, lit in samples:
            if not is_tested:
                continue
            point = [x, y, z]
            towards = [-1e3 * (a + (b - a) * u) for a, b in zip(light[0][6:9], light[0][6:9])]
            clearance = clearance_of(by_number[number], u)
            dark = False
            for t in triangles:
                met = meeting(t, u, point, towards, clearance) if t[0] != number else None
                if met is not None:
                    dark = dark or leaf.covers(t[0], met)
                    seen_through += not leaf.covers(t[0], met)
            dark_ones += dark
            wrong += dark == (lit >= 0.5)
        return dark_ones, wrong, seen_through

    def test_a_leaf_under_a_moving_sun(self):
        for options in ({}, {"wrap": REPEAT, "repeats": 2.0}, {"wrap": MIRRORED, "repeats": 1.7, "cutoff": 0.3},
                        {"moves": False, "cutoff": 0.8}):
            with self.subTest(**options):
                leaf = Leaf(**options)
                report = self.verify(leaf, "exact", size="480x360")[0]
                print(options, {k: report[k] for k in ("tested", "shadowed", "disagree", "ppm", "primary_disagree")})
                self.assertGreater(report["shadowed"], 3000)
                self.assertLessEqual(report["ppm"], 10)
                self.assertEqual(report["primary_disagree"], 0)

    def test_without_any_code_of_the_program(self):
        for options in ({}, {"wrap": REPEAT, "repeats": 2.0, "cutoff": 0.6}):
            with self.subTest(**options):
                leaf = Leaf(**options)
                # A sun that stands still: the dump names one direction.
                leaf.document["animations"][0]["channels"].pop(0)
                report, triangles, light, samples = self.verify(leaf, "exact")
                dark, wrong, seen_through = self.by_brute_force(leaf, triangles, light, samples)
                print(options, "dark", dark, "reported", report["shadowed"], "wrong", wrong, "through", seen_through)
                self.assertGreater(dark, 300)
                self.assertGreater(seen_through, 300)
                self.assertLessEqual(abs(dark - report["shadowed"]), 2)
                self.assertLessEqual(wrong, 2)

    def test_what_blends_is_whole(self):
        whole = self.verify(Leaf(mode="OPAQUE"), "exact")[0]
        blended = self.verify(Leaf(mode="BLEND"), "exact")[0]
        masked = self.verify(Leaf(), "exact")[0]
        self.assertEqual(blended["shadowed"], whole["shadowed"])
        self.assertLess(masked["shadowed"], 0.9 * whole["shadowed"])

    def test_interval_samples_refuse_it(self):
        words = self.verify(Leaf(), "exact", "--samples", "intervals")
        self.assertIsInstance(words, str)
        self.assertIn('the material "leaf" is cut out by its alpha', words)
        self.assertEqual(len(words.strip().splitlines()), 1, words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

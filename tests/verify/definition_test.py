"""A shadow does not depend on how large the ground is or how far away the light: the same post throws the same one.

usage: definition_test.py PROGRAM SOURCE_FOLDER
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

PROGRAM = sys.argv[1]


def box(low, high):
    """Twelve triangles, counter-clockwise from outside."""
    c = [[(low, high)[i >> a & 1][a] for a in range(3)] for i in range(8)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return [c[i] for f in faces for i in (f[0], f[1], f[2], f[0], f[2], f[3])]


def turned(vertices, axes):
    """With the given vectors in the places of x, y and z."""
    return [[sum(v[a] * axes[a][i] for a in range(3)) for i in range(3)] for v in vertices]


def quaternion(axes):
    """Of the rotation that takes x, y and z to the columns."""
    (a, d, g), (b, e, h), (c, f, i) = axes
    w = math.sqrt(max(0, 1 + a + e + i)) / 2
    x, y, z = (math.sqrt(max(0, 1 + s)) / 2 for s in (a - e - i, e - a - i, i - a - e))
    return [math.copysign(x, h - f), math.copysign(y, c - g), math.copysign(z, d - b), w]


def looking(eye, target, up):
    back = [e - t for e, t in zip(eye, target)]
    norm = math.dist(eye, target)
    back = [b / norm for b in back]
    right = [up[1] * back[2] - up[2] * back[1], up[2] * back[0] - up[0] * back[2], up[0] * back[1] - up[1] * back[0]]
    norm = math.hypot(*right)
    right = [r / norm for r in right]
    above = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
             back[0] * right[1] - back[1] * right[0]]
    return quaternion([right, above, back])


def write_post(path, side, light, light_at, axes=((1, 0, 0), (0, 1, 0), (0, 0, 1)), tilt=0.0):
    """A post of 0.4 x 2 x 0.4 on a ground of the given side; `axes`: where x, y (up) and z point."""
    h = side / 2
    ground = [[x, tilt * x, z] for x, z in ((-h, -h), (-h, h), (h, h), (-h, -h), (h, h), (h, -h))]
    vertices = turned(ground + box([-0.2, -0.1 if tilt else 0.0, -0.2], [0.2, 2.0, 0.2]), axes)
    data = b"".join(struct.pack("<3f", *v) for v in vertices)
    flat = [[f(v[a] for v in vertices) for a in range(3)] for f in (min, max)]
    eye, at = turned([[3.0, 4.0, 5.0], light_at], axes)
    target, up = turned([[0.6, 0.0, 0.0], [0.0, 1.0, 0.0]], axes)
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [light]}},
        "nodes": [{"mesh": 0},
                  {"camera": 0, "translation": eye, "rotation": looking(eye, target, up)},
                  {"translation": at, "rotation": looking(at, [0, 0, 0], up),
                   "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3",
                       "min": flat[0], "max": flat[1]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}
    with open(path, "w", encoding="utf-8") as stream:
        json.dump(document, stream)


SUN = {"type": "directional"}
SPOT = {"type": "spot", "intensity": 1000, "spot": {"outerConeAngle": 0.5}}
Z_UP = ((1, 0, 0), (0, 0, 1), (0, -1, 0))


class Definition(unittest.TestCase):
    def dark(self, *scene, **options):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "post.gltf")
            write_post(path, *scene, **options)
            done = subprocess.run([PROGRAM, "verify", path, "--technique", "exact", "--size", "96x72", "--spp", "2",
                                   "--map", "256", "--reference-rays", "0", "--json", "-"], capture_output=True,
                                  text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            # A receiver on a triangle of 50,000 units is known to some thousandths of a unit in floats.
            self.assertLessEqual(report["disagree"], 3 if scene[0] < 1e5 else 10)
            return report["shadowed"]

    def same_on_all_grounds(self, light, light_at, **options):
        expected = self.dark(20.0, light, light_at, **options)
        self.assertGreater(expected, 100)
        for side in (1000.0, 50000.0, 100000.0):
            with self.subTest(side=side):
                self.assertAlmostEqual(self.dark(side, light, light_at, **options), expected, delta=2)

    def test_under_a_sun(self):
        self.same_on_all_grounds(SUN, [-4.0, 6.0, 1.0])

    def test_under_a_spot(self):
        self.same_on_all_grounds(SPOT, [-4.0, 6.0, 1.0])

    def test_where_z_is_up(self):
        self.same_on_all_grounds(SUN, [-3.0, 6.0, 2.0], axes=Z_UP)

    def test_far_lights(self):
        expected = self.dark(20.0, SPOT, [-4.0, 6.0, 1.0], tilt=0.1)
        near = self.dark(20.0, SUN, [-4.0, 6.0, 1.0])
        self.assertGreater(expected, 100)
        for distance in (100.0, 1000.0, 20000.0):
            far = self.dark(20.0, {**SPOT, "spot": {"outerConeAngle": max(0.01, 10.0 / distance)}},
                            [c * distance for c in (-4.0, 6.0, 1.0)])
            self.assertAlmostEqual(far, near, delta=6, msg=f"{distance} times as far, almost a sun")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

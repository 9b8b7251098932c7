"""Checks `verify` without any of its code: reads its dump, tests every sample against every triangle by brute force,
and expects the disagreement that was reported.

usage: dump_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile

from small_scene import write_small_scene

PROGRAM = sys.argv[1]


def rows(path):
    with open(path, newline="", encoding="utf-8") as stream:
        reader = csv.reader(stream)
        next(reader)
        return [[float(x) for x in row] for row in reader]


def mix(a, b, u):
    return [x + (y - x) * u for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def clearance_of(triangle, u):
    """How near a caster's plane may pass a receiver on the triangle: 2^-21 of its largest coordinate at the time."""
    return 2.0**-21 * max(abs(c) for c in mix(triangle[1:10], triangle[10:19], u))


def blocks(triangle, u, point, towards, clearance):
    """Does the segment from the point, along `towards`, meet the triangle before its end, farther than the clearance
    from the triangle's plane?"""
    v = [sub(mix(triangle[3 * i + 1:3 * i + 4], triangle[3 * i + 10:3 * i + 13], u), point) for i in range(3)]
    e = [dot(towards, cross(v[1], v[2])), dot(towards, cross(v[2], v[0])), dot(towards, cross(v[0], v[1]))]
    if min(e) < 0 < max(e) or e == [0, 0, 0]:
        return False
    volume = dot(v[0], cross(v[1], v[2]))
    normal = cross(sub(v[1], v[0]), sub(v[2], v[0]))
    return 0 < volume / sum(e) < 1 and abs(volume) > clearance * dot(normal, normal)**0.5


def main():
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "small.gltf")
        write_small_scene(scene)
        dump = os.path.join(folder, "dump")
        command = [PROGRAM, "verify", scene, "--technique", "tsm", "--size", "40x30", "--spp", "4", "--map", "32",
                   "--reference-rays", "0", "--json", "-", "--dump", dump,
                   "--frame", "0", "--shutter", "1", "--fps", "1"]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise SystemExit(f"FAIL: {' '.join(command)}: {result.stderr}")
        report = json.loads(result.stdout)
        triangles = rows(os.path.join(dump, "triangles.csv"))
        by_number = {triangle[0]: triangle for triangle in triangles}
        light = rows(os.path.join(dump, "light.csv"))[0]
        directional = light[9] < -1
        tested = disagree = shadowed = 0
        for px, py, k, u, number, x, y, z, is_tested, lit in rows(os.path.join(dump, "samples.csv")):
            if not is_tested:
                continue
            tested += 1
            point = [x, y, z]
            towards = [-1e3 * c for c in light[6:9]] if directional else sub(mix(light[0:3], light[3:6], u), point)
            clearance = clearance_of(by_number[number], u)
            dark = any(blocks(t, u, point, towards, clearance) for t in triangles if t[0] != number)
            shadowed += dark
            disagree += dark == (lit >= 0.5)
        print(f"tested {tested} (reported {report['tested']}), shadowed {shadowed} ({report['shadowed']}), "
              f"disagree {disagree} ({report['disagree']})")
        # Nine digits of a receiver's place move it by 1e-9: one sample in some thousands lies that near to an edge.
        slack = max(1, tested // 2000)
        good = (tested == report["tested"] and abs(shadowed - report["shadowed"]) <= slack
                and abs(disagree - report["disagree"]) <= slack and tested > 1000 and disagree > 20
                and not math.isnan(report["ppm"]))
        raise SystemExit(0 if good else 1)


main()

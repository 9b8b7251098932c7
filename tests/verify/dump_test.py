"""Checks `verify` without any of its code: reads its dump, tests every sample against every triangle by brute force,
and expects the disagreement that was reported.

usage: dump_test.py PROGRAM SOURCE_FOLDER
"""

import json
import math
import os
import subprocess
import sys
import tempfile

from brute_force import clearance_of, meeting, mix, rows, sub
from small_scene import write_small_scene

PROGRAM = sys.argv[1]


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
            dark = any(meeting(t, u, point, towards, clearance) for t in triangles if t[0] != number)
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

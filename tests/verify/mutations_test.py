"""Breaks the shadow lookup on purpose, one line at a time, in a copy of the shaders, and expects `verify` to notice.

usage: mutations_test.py PROGRAM SOURCE_FOLDER
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile

PROGRAM, SOURCE = sys.argv[1], sys.argv[2]

# name, scene, technique, file, right line, wrong line
MUTATIONS = [
    ("bias sign flipped", "chess", "tsm", "lib/light_map.glsl",
     "return bias * m.texel + slopeBias * min(rise, 16.0 * m.texel);",
     "return -(bias * m.texel + slopeBias * min(rise, 16.0 * m.texel));"),
    ("times swapped", "pillars", "tsm", "techniques/tsm/lookup.frag",
     "MapPoint m = mapPointOf(r, r.time);", "MapPoint m = mapPointOf(r, 1.0 - r.time);"),
    ("one texel of offset", "chess", "tsm", "techniques/tsm/lookup.frag",
     "if (!texelOf(m, texel)) return false;", "if (!texelOf(m, texel)) return false; texel.x += 1;"),
    ("strata off by one", "pillars", "tsm", "techniques/tsm/lookup.frag",
     "texelFetch(depthMap, ivec3(texel, layer), 0).x",
     "texelFetch(depthMap, ivec3(texel, (layer + 1u) % layers), 0).x"),
    # Against brute force: tsm's own false shadows on pillars are more than this adds.
    ("light frozen at u = 0", "pillars", "accumulation", "passes/shadow_map_lookup.frag",
     "MapPoint m = mapPointOf(pointAt(t, r.triangle, r.barycentrics, instant), instant);",
     "MapPoint m = mapPointOf(pointAt(t, r.triangle, r.barycentrics, instant), 0.0);"),
]

# The same samples and the same map before and after, to the last bit: what changes is the mutation alone. Each must
# add at least a tenth to the disagreement.
LEAST_GROWTH = 1.1


def disagreement(scene, technique, shaders):
    environment = dict(os.environ, TIMESHADE_SHADERS=shaders)
    command = [PROGRAM, "verify", scene, "--technique", technique, "--set", "accumulation.renders=4",
               "--size", "240x180", "--spp", "4", "--map", "512", "--reference-rays", "0", "--json", "-"]
    result = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(f"FAIL: {' '.join(command)}: {result.stderr}")
    return json.loads(result.stdout)["ppm"]


def main():
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        right = os.path.join(SOURCE, "shaders")
        baseline = {case: disagreement(*case, right) for case in sorted({m[1:3] for m in MUTATIONS})}
        for name, scene, technique, file, line, wrong_line in MUTATIONS:
            shaders = os.path.join(folder, name.replace(" ", "_"))
            shutil.copytree(right, shaders)
            path = os.path.join(shaders, file)
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
            if text.count(line) != 1:
                raise SystemExit(f"FAIL: {file} no longer has the line that '{name}' breaks: {line}")
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text.replace(line, wrong_line))
            ppm = disagreement(scene, technique, shaders)
            before = baseline[scene, technique]
            caught = ppm >= LEAST_GROWTH * before
            print(f"{'caught' if caught else 'MISSED'}: {name} on {scene}: {before:.0f} -> {ppm:.0f} ppm")
            failures += not caught
    raise SystemExit(1 if failures else 0)


main()

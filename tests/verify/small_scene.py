"""A scene of a few triangles with everything that matters: a moving caster, a moving light, a still floor."""

import base64
import json
import struct


def write_small_scene(path):
    """A floor of 8 x 8 units, a quad of 2 x 2 units that slides over it within one second, a spot that slides too."""
    floor = [(-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4)]
    quad = [(-1, 2, 1), (1, 2, 1), (1, 2, -1), (-1, 2, -1)]
    positions = b"".join(struct.pack("<3f", *v) for v in floor + quad)
    indices = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    times = struct.pack("<2f", 0, 1)
    quad_path = struct.pack("<6f", -1.5, 0, 0.3, 1.5, 0.5, -0.4)
    light_path = struct.pack("<6f", 1, 6, 0.5, 0, 7, 1.5)
    data = positions + indices + times + quad_path + light_path
    views, offset = [], 0
    for part in (positions, indices, times, quad_path, light_path):
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(part)})
        offset += len(part)

    def accessor(view, component, count, kind, start=0, **bounds):
        return dict({"bufferView": view, "byteOffset": start, "componentType": component, "count": count,
                     "type": kind}, **bounds)

    down = [-0.7071067811865476, 0, 0, 0.7071067811865476]  # turns -z to -y
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 100,
                                                           "spot": {"outerConeAngle": 0.9}}]}},
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 2, 3]}],
        "nodes": [
            {"mesh": 0},
            {"mesh": 1},
            {"extensions": {"KHR_lights_punctual": {"light": 0}}, "rotation": down},
            {"camera": 0, "translation": [0, 9, 0], "rotation": down},
        ],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": p}, "indices": 2}]} for p in (0, 1)],
        "materials": [],
        "accessors": [
            accessor(0, 5126, 4, "VEC3", 0, min=[-4, 0, -4], max=[4, 0, 4]),
            accessor(0, 5126, 4, "VEC3", 48, min=[-1, 2, -1], max=[1, 2, 1]),
            accessor(1, 5123, 6, "SCALAR"),
            accessor(2, 5126, 2, "SCALAR", min=[0], max=[1]),
            accessor(3, 5126, 2, "VEC3"),
            accessor(4, 5126, 2, "VEC3"),
        ],
        "animations": [{
            "samplers": [{"input": 3, "output": 4}, {"input": 3, "output": 5}],
            "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}},
                         {"sampler": 1, "target": {"node": 2, "path": "translation"}}],
        }],
        "bufferViews": views,
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    }
    del document["materials"]
    with open(path, "w", encoding="utf-8") as stream:
        json.dump(document, stream)

"""A glTF file of a box that moves above nothing, as text."""

import base64
import json
import struct

CORNERS = [(x, y, z) for z in (-0.5, 0.5) for y in (0.0, 1.0) for x in (-0.5, 0.5)]
TRIANGLES = (0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6)
LOWEST = 0.25


def box_model(lights=()):
    """It sinks to y = LOWEST and rises again, along x. `lights`: names of spots that shine down on it."""
    parts = [struct.pack("<24f", *(number for corner in CORNERS for number in corner)),
             struct.pack("<36H", *TRIANGLES), struct.pack("<3f", 0, 1, 2),
             struct.pack("<9f", -1, 1.5, 0, 0, LOWEST, 0, 1, 1.5, 0)]
    views, offset = [], 0
    for part in parts:
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(part)})
        offset += len(part)
    data = b"".join(parts)
    kinds = ((5126, 8, "VEC3"), (5123, 36, "SCALAR"), (5126, 3, "SCALAR"), (5126, 3, "VEC3"))
    nodes = [{"name": "box", "mesh": 0}]
    for i, name in enumerate(lights):
        nodes.append({"name": name, "translation": [2.0 - 4.0 * i, 6, 0], "rotation": [-0.70710678, 0, 0, 0.70710678],
                      "extensions": {"KHR_lights_punctual": {"light": 0}}})
    model = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": views,
        "accessors": [{"bufferView": i, "componentType": kind, "count": count, "type": shape}
                      for i, (kind, count, shape) in enumerate(kinds)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "nodes": nodes, "scenes": [{"nodes": list(range(len(nodes)))}], "scene": 0,
        "animations": [{"samplers": [{"input": 2, "output": 3}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
    }
    if lights:
        model["extensionsUsed"] = ["KHR_lights_punctual"]
        model["extensions"] = {"KHR_lights_punctual": {"lights": [
            {"type": "spot", "intensity": 100, "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.7}}]}}
    return json.dumps(model)

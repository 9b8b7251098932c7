"""Writes one binary glTF 2.0 file: meshes, nodes, skins, cameras, one light, one clip, embedded pictures."""

import json
import struct

from .mesh import corner_normals, require_closed
from .vectors import look_at

BYTE, SHORT, INT, FLOAT = 5121, 5123, 5125, 5126
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
FORMATS = {BYTE: "B", SHORT: "H", INT: "I", FLOAT: "f"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
WEIGHT_STEPS = 255


def tidy(values, digits=6):
    """Rounded, and without negative zeros: what is written must not depend on the last bit of a sine."""
    return [round(v, digits) + 0.0 for v in values]


class Document:
    def __init__(self, name, frame, fps, shutter):
        self.json = {
            "asset": {"version": "2.0", "generator": "Timeshade assets/generate.py", "copyright": "CC0 1.0"},
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": []}},
            "scene": 0,
            "scenes": [{"name": name, "nodes": [],
                        "extras": {"timeshade": {"frame": frame, "fps": fps, "shutter": shutter}}}],
            "nodes": [], "meshes": [], "materials": [], "cameras": [],
            "animations": [{"name": "motion", "channels": [], "samplers": []}],
            "accessors": [], "bufferViews": [],
        }
        self.fps = fps
        self.binary = bytearray()
        self.clocks = {}

    # Data ------------------------------------------------------------------------------------------------

    def view(self, data, target=None):
        while len(self.binary) % 4:
            self.binary.append(0)
        entry = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            entry["target"] = target
        self.binary.extend(data)
        self.json["bufferViews"].append(entry)
        return len(self.json["bufferViews"]) - 1

    def accessor(self, rows, kind, component=FLOAT, target=None, bounds=False, normalized=False, digits=6):
        """`rows` is a flat list of numbers."""
        if component == FLOAT:
            rows = tidy(rows, digits)
        width = WIDTHS[kind]
        entry = {"bufferView": self.view(struct.pack(f"<{len(rows)}{FORMATS[component]}", *rows), target),
                 "componentType": component, "count": len(rows) // width, "type": kind}
        if normalized:
            entry["normalized"] = True
        if bounds:
            # The bounds must match the stored values, which are single precision.
            stored = struct.unpack(f"<{len(rows)}f", struct.pack(f"<{len(rows)}f", *rows))
            entry["min"] = [min(stored[i::width]) for i in range(width)]
            entry["max"] = [max(stored[i::width]) for i in range(width)]
        self.json["accessors"].append(entry)
        return len(self.json["accessors"]) - 1

    # Materials -------------------------------------------------------------------------------------------

    def texture(self, png):
        images = self.json.setdefault("images", [])
        images.append({"mimeType": "image/png", "bufferView": self.view(png)})
        self.json.setdefault("samplers", [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}])
        textures = self.json.setdefault("textures", [])
        textures.append({"sampler": 0, "source": len(images) - 1})
        return len(textures) - 1

    def material(self, name, colour, roughness, texture=None):
        surface = {"baseColorFactor": [*colour, 1.0], "metallicFactor": 0.0, "roughnessFactor": roughness}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
        self.json["materials"].append({"name": name, "pbrMetallicRoughness": surface, "doubleSided": False})
        return len(self.json["materials"]) - 1

    # Meshes ----------------------------------------------------------------------------------------------

    def mesh(self, name, mesh, materials, crease=40.0, texture_coordinates=None):
        """Vertices are split only where normals differ. `materials` is indexed by the triangles' part.

        texture_coordinates(part, position) must be continuous: it is evaluated once per vertex.
        """
        require_closed(mesh, name)
        primitives = self.primitives(mesh, crease, texture_coordinates)
        entry = {"name": name, "primitives": []}
        for part, attributes, indices in primitives:
            entry["primitives"].append({"attributes": attributes, "indices": indices, "material": materials[part]})
        self.json["meshes"].append(entry)
        return len(self.json["meshes"]) - 1

    def recoloured(self, name, source, materials):
        """The same geometry again with other materials: the two sides' pieces share their buffers."""
        original = self.json["meshes"][source]
        entry = {"name": name, "primitives": [dict(p) for p in original["primitives"]]}
        for primitive, material in zip(entry["primitives"], materials):
            primitive["material"] = material
        self.json["meshes"].append(entry)
        return len(self.json["meshes"]) - 1

    def primitives(self, mesh, crease, texture_coordinates):
        mesh.round_positions()
        normals = corner_normals(mesh, crease)
        skinned = mesh.influences and mesh.influences[0] is not None
        result = []
        for part in sorted({t[3] for t in mesh.triangles}):
            known, order, indices = {}, [], []
            for triangle, corners in zip(mesh.triangles, normals):
                if triangle[3] != part:
                    continue
                for key in zip(triangle[:3], corners):
                    if key not in known:
                        known[key] = len(order)
                        order.append(key)
                    indices.append(known[key])
            attributes = {
                "POSITION": self.accessor([x for v, _ in order for x in mesh.positions[v]], "VEC3",
                                          target=ARRAY_BUFFER, bounds=True),
                "NORMAL": self.accessor([x for _, n in order for x in n], "VEC3", target=ARRAY_BUFFER)}
            if texture_coordinates:
                attributes["TEXCOORD_0"] = self.accessor(
                    [x for v, _ in order for x in texture_coordinates(part, mesh.positions[v])], "VEC2",
                    target=ARRAY_BUFFER, digits=5)
            if skinned:
                attributes.update(self.skin_attributes([mesh.influences[v] for v, _ in order]))
            component = SHORT if len(order) < 65535 else INT
            result.append((part, attributes,
                           self.accessor(indices, "SCALAR", component, target=ELEMENT_ARRAY_BUFFER)))
        return result

    def skin_attributes(self, influences):
        joints, weights = [], []
        for influence in influences:
            strongest = sorted(influence, key=lambda pair: (-pair[1], pair[0]))[:4]
            total = sum(weight for _, weight in strongest)
            steps = [int(round(weight / total * WEIGHT_STEPS, 3)) for _, weight in strongest]
            steps[0] += WEIGHT_STEPS - sum(steps)
            padding = 4 - len(strongest)
            joints.extend([joint if step else 0 for (joint, _), step in zip(strongest, steps)] + [0] * padding)
            weights.extend(steps + [0] * padding)
        return {"JOINTS_0": self.accessor(joints, "VEC4", BYTE, target=ARRAY_BUFFER),
                "WEIGHTS_0": self.accessor(weights, "VEC4", BYTE, target=ARRAY_BUFFER, normalized=True)}

    # Nodes -----------------------------------------------------------------------------------------------

    def node(self, name, translation=None, rotation=None, root=True, **content):
        entry = {"name": name}
        if translation is not None:
            entry["translation"] = tidy(translation)
        if rotation is not None:
            entry["rotation"] = tidy(rotation)
        entry.update(content)
        self.json["nodes"].append(entry)
        index = len(self.json["nodes"]) - 1
        if root:
            self.json["scenes"][0]["nodes"].append(index)
        return index

    def camera(self, name, eye, target, field_of_view, near, far):
        """`field_of_view` in radians, from the bottom of the picture to its top."""
        self.json["cameras"].append({"name": name, "type": "perspective", "perspective": {
            "yfov": round(field_of_view, 6), "aspectRatio": 4.0 / 3.0, "znear": near, "zfar": far}})
        return self.node(name, eye, look_at(eye, target), camera=len(self.json["cameras"]) - 1)

    def spot(self, name, position, target, colour, intensity, inner, outer):
        lights = self.json["extensions"]["KHR_lights_punctual"]["lights"]
        lights.append({"name": name, "type": "spot", "color": list(colour), "intensity": intensity,
                       "spot": {"innerConeAngle": round(inner, 6), "outerConeAngle": round(outer, 6)}})
        return self.node(name, position, look_at(position, target),
                         extensions={"KHR_lights_punctual": {"light": len(lights) - 1}})

    # Motion ----------------------------------------------------------------------------------------------

    def animate(self, node, path, keys):
        """One key per frame, from frame 0 to the end of the loop, whose last key is the first again."""
        if tidy(keys[0]) != tidy(keys[-1]):
            raise ValueError(f"the motion of node {node} does not close: {keys[0]} and {keys[-1]}")
        if len(keys) not in self.clocks:
            self.clocks[len(keys)] = self.accessor([i / self.fps for i in range(len(keys))], "SCALAR", bounds=True)
        values = self.accessor([x for key in keys for x in key], "VEC4" if path == "rotation" else "VEC3")
        animation = self.json["animations"][0]
        animation["samplers"].append({"input": self.clocks[len(keys)], "output": values, "interpolation": "LINEAR"})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": node, "path": path}})

    # File ------------------------------------------------------------------------------------------------

    def pack(self):
        while len(self.binary) % 4:
            self.binary.append(0)
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.json, separators=(",", ":"), ensure_ascii=True).encode("ascii")
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self.binary)
        return (struct.pack("<4sII", b"glTF", 2, total) + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(self.binary), b"BIN\x00") + bytes(self.binary))

"""Closed triangle meshes, and the few ways of making them that the scenes need.

A Mesh knows positions and triangles only. Normals come last, from the positions as they are stored in
the file, so that a rounding difference between two machines' sines cannot leak into them.
"""

import math

from .vectors import add, cross, dot, length, normalize, scale, subtract

POSITION_DIGITS = 5
NORMAL_DIGITS = 5


class Mesh:
    """Positions, and triangles (a, b, c, part) wound counter-clockwise seen from outside.

    `part` picks the material; `influences` holds ((joint, weight), ...) per position where skinned.
    """

    def __init__(self):
        self.positions = []
        self.triangles = []
        self.influences = []

    def vertex(self, position, influence=None):
        self.positions.append(position)
        self.influences.append(influence)
        return len(self.positions) - 1

    def triangle(self, a, b, c, part=0):
        # Rings may share vertices: what collapses to a line there is left out.
        if a != b and b != c and c != a:
            self.triangles.append((a, b, c, part))

    def quad(self, a, b, c, d, part=0):
        self.triangle(a, b, c, part)
        self.triangle(a, c, d, part)

    def merge(self, other, transform=None, part=None):
        """Adds another closed mesh: solids may overlap, each stays closed on its own."""
        first = len(self.positions)
        for position in other.positions:
            self.positions.append(transform(position) if transform else position)
        self.influences.extend(other.influences)
        for a, b, c, own_part in other.triangles:
            self.triangles.append((a + first, b + first, c + first, own_part if part is None else part))
        return self

    def bridge(self, lower, upper, part=0):
        """Quads between two rings of equal size that run counter-clockwise seen from the upper's side."""
        count = len(lower)
        for i in range(count):
            j = (i + 1) % count
            self.quad(lower[i], lower[j], upper[j], upper[i], part)

    def cap(self, ring, centre, part=0):
        """A fan over a ring that runs counter-clockwise seen from outside."""
        for i in range(len(ring)):
            self.triangle(ring[i], ring[(i + 1) % len(ring)], centre, part)

    def round_positions(self):
        self.positions = [tuple(round(x, POSITION_DIGITS) + 0.0 for x in p) for p in self.positions]


def lathe(profile, segments, part=0):
    """A turned solid: profile (radius, height) from the axis at the bottom to the axis at the top."""
    mesh = Mesh()
    rings = []
    for radius, height in profile:
        if radius <= 1e-9:
            rings.append(mesh.vertex((0.0, height, 0.0)))
            continue
        ring = []
        for i in range(segments):
            # Against the sense of the angle in x and z, so that the ring runs counter-clockwise from above.
            angle = -2.0 * math.pi * i / segments
            ring.append(mesh.vertex((radius * math.cos(angle), height, radius * math.sin(angle))))
        rings.append(ring)
    for below, above in zip(rings, rings[1:]):
        if isinstance(below, int):
            mesh.cap(above[::-1], below, part)
        elif isinstance(above, int):
            mesh.cap(below, above, part)
        else:
            mesh.bridge(below, above, part)
    return mesh


def ellipsoid(centre, radii, segments, rows, part=0):
    profile = [(math.sin(math.pi * i / rows), -math.cos(math.pi * i / rows)) for i in range(rows + 1)]
    profile[0], profile[-1] = (0.0, -1.0), (0.0, 1.0)
    unit = lathe(profile, segments, part)
    unit.positions = [add(centre, (p[0] * radii[0], p[1] * radii[1], p[2] * radii[2])) for p in unit.positions]
    return unit


def grid_box(low, high, columns, rows, height=None, part=0, side_part=None):
    """A box whose top and bottom are divided into columns x rows; `height(x, z)` bends its top."""
    mesh = Mesh()
    side = part if side_part is None else side_part
    layers = []
    for y in (low[1], high[1]):
        layer = []
        for j in range(rows + 1):
            z = low[2] + (high[2] - low[2]) * j / rows
            line = []
            for i in range(columns + 1):
                x = low[0] + (high[0] - low[0]) * i / columns
                lift = height(x, z) if height and y == high[1] else 0.0
                line.append(mesh.vertex((x, y + lift, z)))
            layer.append(line)
        layers.append(layer)
    bottom, top = layers
    for j in range(rows):
        for i in range(columns):
            mesh.quad(top[j][i], top[j + 1][i], top[j + 1][i + 1], top[j][i + 1], part)
            mesh.quad(bottom[j][i], bottom[j][i + 1], bottom[j + 1][i + 1], bottom[j + 1][i], side)

    def border(layer):
        """Counter-clockwise seen from above: along +x at the greatest z, and back at the least."""
        return (layer[rows][:columns] + [layer[j][columns] for j in range(rows, 0, -1)]
                + layer[0][columns:0:-1] + [layer[j][0] for j in range(rows)])

    mesh.bridge(border(bottom), border(top), side)
    return mesh


def require_closed(mesh, name):
    """Every edge must be walked as often one way as the other: no holes, and one winding throughout."""
    balance = {}
    for a, b, c, _ in mesh.triangles:
        for start, end in ((a, b), (b, c), (c, a)):
            key = (min(start, end), max(start, end))
            balance[key] = balance.get(key, 0) + (1 if start < end else -1)
    open_edges = sum(1 for value in balance.values() if value)
    if open_edges:
        raise ValueError(f"{name}: {open_edges} edges are open or wound both ways")


def face_normals(positions, triangles):
    """Normals scaled by twice the area, (0, 0, 0) for a triangle without one."""
    result = []
    for a, b, c, _ in triangles:
        result.append(cross(subtract(positions[b], positions[a]), subtract(positions[c], positions[a])))
    return result


def corner_angle(origin, a, b):
    u, v = subtract(a, origin), subtract(b, origin)
    size = length(u) * length(v)
    return math.acos(min(1.0, max(-1.0, dot(u, v) / size))) if size > 0.0 else 0.0


def corner_normals(mesh, crease_degrees):
    """One unit normal per triangle corner: neighbours round a vertex count when they bend less than the crease.

    Each face weighs by its angle at the vertex, so the result does not depend on how quads were split.
    """
    positions, triangles = mesh.positions, mesh.triangles
    faces = [normalize(n) if dot(n, n) > 0.0 else None for n in face_normals(positions, triangles)]
    around = [[] for _ in positions]
    for index, (a, b, c, _) in enumerate(triangles):
        if faces[index] is None:
            raise ValueError(f"triangle {index} has no area")
        for here, left, right in ((a, b, c), (b, c, a), (c, a, b)):
            weight = corner_angle(positions[here], positions[left], positions[right])
            around[here].append((index, scale(faces[index], weight)))
    limit = math.cos(math.radians(crease_degrees))
    smooth_everywhere = crease_degrees >= 180.0
    shared = {}
    result = []
    for index, corners in enumerate(triangles):
        own = faces[index]
        normals = []
        for here in corners[:3]:
            if smooth_everywhere and here in shared:
                normals.append(shared[here])
                continue
            total = (0.0, 0.0, 0.0)
            for other, weighted in around[here]:
                if smooth_everywhere or dot(own, faces[other]) >= limit:
                    total = add(total, weighted)
            normal = normalize(total) if dot(total, total) > 1e-20 else own
            normal = tuple(round(x, NORMAL_DIGITS) + 0.0 for x in normal)
            shared[here] = normal
            normals.append(normal)
        result.append(normals)
    return result

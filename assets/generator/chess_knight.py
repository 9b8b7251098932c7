"""The knight: a horse's head and neck, carved over a turned base. It looks along +X.

The carving is a stack of oval slices. Each slice is drawn by hand in the side view, as the point on the
throat's side and the point on the mane's side; the slices fan round the throat from the chest to the lips.
"""

import math

from .chess_pieces import SEGMENTS, bead, foot
from .mesh import Mesh, ellipsoid, lathe
from .vectors import add, catmull_rom, cross, normalize, scale, smoothstep, subtract

# front x, front y, back x, back y, half width
SLICES = (
    (0.225, 0.250, -0.225, 0.250, 0.200),
    (0.245, 0.335, -0.240, 0.335, 0.185),
    (0.230, 0.435, -0.255, 0.450, 0.162),
    (0.170, 0.540, -0.255, 0.590, 0.142),
    (0.105, 0.620, -0.235, 0.735, 0.126),
    (0.072, 0.682, -0.185, 0.875, 0.116),
    (0.075, 0.712, -0.105, 0.985, 0.114),
    (0.105, 0.700, -0.005, 1.040, 0.122),
    (0.145, 0.672, 0.085, 1.025, 0.130),
    (0.192, 0.645, 0.160, 0.972, 0.122),
    (0.240, 0.622, 0.228, 0.893, 0.100),
    (0.282, 0.598, 0.288, 0.812, 0.084),
    (0.312, 0.566, 0.348, 0.745, 0.080),
    (0.338, 0.532, 0.398, 0.690, 0.081),
    (0.366, 0.515, 0.424, 0.640, 0.072),
    (0.392, 0.520, 0.428, 0.596, 0.048),
)
MANE_LOCKS = 9
ROWS = 38
AROUND = 20

# Lines pressed into the wood, in the side view: points, depth, and half width.
GROOVES = (
    (((0.412, 0.580), (0.375, 0.592), (0.335, 0.622)), 0.020, 0.024),
    (((0.055, 0.720), (0.028, 0.800), (0.055, 0.890)), 0.020, 0.040),
)
# Bosses: centre x, y, height, radius.
BOSSES = ((0.145, 0.775, 0.026, 0.075), (0.180, 0.895, 0.020, 0.045), (0.385, 0.650, 0.014, 0.032))


def distance_to_line(x, y, points):
    best = 1e9
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        dx, dy = bx - ax, by - ay
        t = min(1.0, max(0.0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)))
        best = min(best, math.hypot(x - ax - t * dx, y - ay - t * dy))
    return best


def relief(x, y):
    """How far the carving stands out (or in) at a place of the side view."""
    height = 0.0
    for points, depth, width in GROOVES:
        height -= depth * math.exp(-(distance_to_line(x, y, points) / width) ** 2)
    for centre_x, centre_y, boss, radius in BOSSES:
        height += boss * math.exp(-(math.hypot(x - centre_x, y - centre_y) / radius) ** 2)
    return height


def head():
    mesh = Mesh()
    rings = []
    for front_x, front_y, back_x, back_y, half_width in catmull_rom(SLICES, ROWS):
        middle = ((front_x + back_x) / 2.0, (front_y + back_y) / 2.0)
        half = ((front_x - back_x) / 2.0, (front_y - back_y) / 2.0)
        ring = []
        for i in range(AROUND):
            # Against the angle's sense: the slices climb from the base, their rings run counter-clockwise from above.
            angle = -2.0 * math.pi * i / AROUND
            c, s = math.cos(angle), math.sin(angle)
            # A little squarer than an ellipse: flat cheeks, and a narrow ridge along the crest.
            wide = math.copysign(abs(s) ** 0.85, s)
            x, y = middle[0] + half[0] * c, middle[1] + half[1] * c
            z = half_width * wide
            # The carving fades towards the ridges in front and behind, where both sides meet.
            z += math.copysign(relief(x, y) * smoothstep(0.05, 0.75, abs(s)), s)
            ring.append(mesh.vertex((x, y, z)))
        rings.append(ring)
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper)
    for ring, last in ((rings[0][::-1], False), (rings[-1], True)):
        centre = scale(tuple(sum(mesh.positions[v][k] for v in ring) for k in range(3)), 1.0 / AROUND)
        if last:
            # The lips bulge a little instead of ending flat.
            centre = add(centre, (0.016, -0.012, 0.0))
        mesh.cap(ring, mesh.vertex(centre))
    return mesh


def mane():
    """A toothed crest down the back of the neck, from between the ears to the foot of the neck."""
    outline = catmull_rom([(b[2], b[3]) for b in SLICES[1:8]], 3 * MANE_LOCKS + 1)
    mesh = Mesh()
    rings = []
    for number, (x, y) in enumerate(outline):
        before, after = outline[max(number - 1, 0)], outline[min(number + 1, len(outline) - 1)]
        along = normalize((after[0] - before[0], after[1] - before[1], 0.0))
        outwards = (-along[1], along[0], 0.0)
        # Each lock starts flush and ends in a step, like the teeth of a saw seen from the side.
        lock = (number % 3) / 3.0
        height = 0.008 + 0.034 * (1.0 - lock) ** 0.8
        width = 0.056 * (0.8 + 0.2 * (1.0 - lock))
        fade = min(1.0, 0.25 + number / 3.0, 0.25 + (len(outline) - 1 - number) / 3.0)
        ring = []
        for rise, side in ((-0.055, -1.0), (0.002, -0.95), (height * fade, -0.35), (height * fade, 0.35),
                           (0.002, 0.95), (-0.055, 1.0)):
            ring.append(mesh.vertex(add((x, y, width * side), scale(outwards, rise))))
        rings.append(ring)
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper)
    for ring, centre in ((rings[0][::-1], outline[0]), (rings[-1], outline[-1])):
        mesh.cap(ring, mesh.vertex((centre[0], centre[1], 0.0)))
    return mesh


def ear(side):
    """A pointed shell: an ellipse that shrinks towards the tip and leans forwards."""
    mesh = Mesh()
    root, tip = (0.020, 1.000, side * 0.062), (0.055, 1.175, side * 0.085)
    axis = normalize(subtract(tip, root))
    wide = normalize(cross(axis, (0.25, 0.0, side )))
    deep = cross(wide, axis)
    rings = []
    for share, size in ((0.0, 0.75), (0.25, 1.0), (0.5, 0.88), (0.75, 0.52), (0.92, 0.18)):
        centre = add(root, scale(subtract(tip, root), share))
        ring = []
        for i in range(8):
            angle = 2.0 * math.pi * i / 8
            ring.append(mesh.vertex(add(centre, add(scale(wide, 0.050 * size * math.cos(angle)),
                                                    scale(deep, -0.026 * size * math.sin(angle))))))
        rings.append(ring)
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper)
    mesh.cap(rings[0][::-1], mesh.vertex(root))
    mesh.cap(rings[-1], mesh.vertex(tip))
    return mesh


def knight():
    profile = foot(0.345) + bead(0.255, 0.225, 0.275, 3) + [(0.0, 0.28)]
    mesh = lathe(profile, SEGMENTS)
    mesh.merge(head())
    mesh.merge(mane())
    for side in (-1.0, 1.0):
        mesh.merge(ear(side))
        mesh.merge(ellipsoid((0.182, 0.888, side * 0.112), (0.034, 0.025, 0.022), 8, 6))
    return mesh

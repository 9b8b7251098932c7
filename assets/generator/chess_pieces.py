"""The turned Staunton pieces: pawn, rook, bishop, queen, king. One square of the board is one unit wide."""

import math

from .mesh import Mesh, ellipsoid, lathe
from .vectors import add, catmull_rom, cross, dot, normalize, scale

SEGMENTS = 20


def bead(radius, low, high, count=4):
    """The half-round edge of a collar: (radius, height) from its lower to its upper rim."""
    half = (high - low) / 2.0
    return [(radius - half + half * math.sin(math.pi * i / count), low + half * (1.0 - math.cos(math.pi * i / count)))
            for i in range(count + 1)]


def foot(radius):
    """The weighted base all pieces share, scaled by its radius; it ends where the stem begins."""
    shape = ((0.0, 0.0), (0.98, 0.0), (1.0, 0.05), (0.99, 0.17), (0.91, 0.22),
             (0.89, 0.33), (0.78, 0.46), (0.66, 0.52), (0.65, 0.58))
    return [(radius * r, radius * y) for r, y in shape]


def stem(points, count):
    """A smooth outline through (radius, height) points, without its first point, where the part below ends."""
    return catmull_rom(points, count)[1:]


def sphere_profile(radius, centre, start_degrees, count):
    """From `start_degrees` below the equator up to the pole."""
    result = []
    for i in range(count + 1):
        angle = math.radians(-start_degrees + (90.0 + start_degrees) * i / count)
        result.append((radius * math.cos(angle), centre + radius * math.sin(angle)))
    result[-1] = (0.0, centre + radius)
    return result


def pawn():
    profile = foot(0.30)
    profile += stem([profile[-1], (0.135, 0.26), (0.105, 0.40), (0.10, 0.50)], 4)
    profile += [(0.13, 0.515)] + bead(0.19, 0.53, 0.585, 3)[1:-1] + [(0.12, 0.60)]
    profile += sphere_profile(0.168, 0.735, 48.0, 6)
    return lathe(profile, 16)


def ring_wall(mesh, inner, outer, bottom, low, high, sectors, is_high):
    """A round wall with battlements, closed: its height changes from sector to sector."""
    def circle(radius, height):
        return [mesh.vertex((radius * math.cos(-2.0 * math.pi * i / sectors), height,
                             radius * math.sin(-2.0 * math.pi * i / sectors))) for i in range(sectors)]

    outer_bottom, outer_low, outer_high = circle(outer * 0.93, bottom), circle(outer, low), circle(outer, high)
    inner_low, inner_high = circle(inner, low), circle(inner, high)
    floor = circle(inner, low - 0.05)
    centre_floor = mesh.vertex((0.0, low - 0.05, 0.0))
    centre_bottom = mesh.vertex((0.0, bottom, 0.0))
    mesh.bridge(outer_bottom, outer_low)
    mesh.cap(outer_bottom[::-1], centre_bottom)
    mesh.cap(floor, centre_floor)
    for i in range(sectors):
        j = (i + 1) % sectors
        mesh.quad(inner_low[i], inner_low[j], floor[j], floor[i])
        if is_high(i):
            mesh.quad(outer_low[i], outer_low[j], outer_high[j], outer_high[i])
            mesh.quad(outer_high[i], outer_high[j], inner_high[j], inner_high[i])
            mesh.quad(inner_high[i], inner_high[j], inner_low[j], inner_low[i])
            if not is_high(i - 1):
                mesh.quad(outer_low[i], outer_high[i], inner_high[i], inner_low[i])
            if not is_high(j):
                mesh.quad(outer_low[j], inner_low[j], inner_high[j], outer_high[j])
        else:
            mesh.quad(outer_low[i], outer_low[j], inner_low[j], inner_low[i])


def drop_unused(mesh):
    used = sorted({v for t in mesh.triangles for v in t[:3]})
    number = {old: new for new, old in enumerate(used)}
    mesh.positions = [mesh.positions[v] for v in used]
    mesh.influences = [mesh.influences[v] for v in used]
    mesh.triangles = [(number[a], number[b], number[c], part) for a, b, c, part in mesh.triangles]
    return mesh


def rook():
    profile = foot(0.35)
    profile += stem([profile[-1], (0.185, 0.30), (0.165, 0.48), (0.175, 0.62)], 6)
    profile += bead(0.245, 0.635, 0.685, 3) + [(0.215, 0.70), (0.225, 0.74), (0.0, 0.74)]
    mesh = lathe(profile, SEGMENTS)
    # Six battlements of three sectors, with one sector open between them.
    ring_wall(mesh, 0.165, 0.265, 0.72, 0.86, 0.96, 24, lambda i: i % 4 != 3)
    return drop_unused(mesh)


def egg_radius(y, low, high, widest, radius):
    """The radius at height y of an egg from low to high, which is widest at that share of its height."""
    t = (y - low) / (high - low)
    if t <= 0.0 or t >= 1.0:
        return 0.0
    # A power of the height moves the widest place below the centre.
    power = math.log(0.5) / math.log(widest)
    return radius * math.sin(math.pi * t ** power) ** 0.62


def distance_inside(inside, start, direction, limit):
    """How far from start along a direction points are inside, by bisection."""
    near, far = 0.0, limit
    for _ in range(40):
        half = (near + far) / 2.0
        if inside(add(start, scale(direction, half))):
            near = half
        else:
            far = half
    return near


def slit_levels(bottom, top):
    """Offsets of the slices from -bottom to top, and whether the slit cuts them: a step at each of its sides."""
    half_slit, place = 0.019, 0.05
    shares = [0.5 - 0.5 * math.cos(math.pi * i / 10) for i in range(11)]
    offsets = [-bottom + (top + bottom) * s for s in shares[1:-1]]
    offsets = [o for o in offsets if abs(o - place) > half_slit + 0.012]
    levels = [(o, False) for o in offsets if o < place]
    levels += [(place - half_slit, False), (place - half_slit, True), (place + half_slit, True),
               (place + half_slit, False)]
    return levels + [(o, False) for o in offsets if o > place]


def cut_mitre(centre, low, high, widest, radius):
    """The bishop's head: an egg with the oblique slit that makes it a mitre.

    The egg is sliced across the slit's own direction, so that the slit is a plain step between slices.
    """
    across = normalize((-0.62, 0.78, 0.0))
    along, side = normalize((0.78, 0.62, 0.0)), (0.0, 0.0, 1.0)
    middle = (0.0, centre, 0.0)
    floor, count = 0.03, 18

    def reach(start, direction):
        def inside(p):
            return math.hypot(p[0], p[2]) < egg_radius(p[1], low, high, widest, radius)
        return distance_inside(inside, start, direction, 2.0 * (high - low))

    top, bottom = reach(middle, across), reach(middle, scale(across, -1.0))
    levels = slit_levels(bottom, top)
    mesh = Mesh()
    rings = []
    for level, (offset, cut) in enumerate(levels):
        # The slice's own centre: half-way between the egg's two sides along the slit.
        start = add(middle, scale(across, offset))
        forward, backward = reach(start, along), reach(start, scale(along, -1.0))
        heart = add(start, scale(along, (forward - backward) / 2.0))
        is_step = level > 0 and levels[level - 1][1] != cut
        ring = []
        for i in range(count):
            angle = 2.0 * math.pi * i / count
            direction = add(scale(along, math.cos(angle)), scale(side, -math.sin(angle)))
            point = add(heart, scale(direction, reach(heart, direction)))
            beyond = dot(add(point, scale(middle, -1.0)), along) - floor
            if cut and beyond > 0.0:
                point = add(point, scale(along, -beyond))
            # Behind the slit's floor both rings of a step are the same.
            ring.append(rings[-1][i] if is_step and beyond <= 0.0 else mesh.vertex(point))
        rings.append(ring)
    if dot(cross(along, scale(side, -1.0)), across) < 0.0:
        rings = [ring[::-1] for ring in rings]
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper)
    mesh.cap(rings[0][::-1], mesh.vertex(add(middle, scale(across, -bottom))))
    mesh.cap(rings[-1], mesh.vertex(add(middle, scale(across, top))))
    return mesh


def bishop():
    profile = foot(0.335)
    profile += stem([profile[-1], (0.15, 0.30), (0.11, 0.50), (0.10, 0.70)], 7)
    profile += bead(0.205, 0.71, 0.765, 3) + [(0.12, 0.775)] + bead(0.16, 0.785, 0.825, 3) + [(0.0, 0.85)]
    mesh = lathe(profile, SEGMENTS)
    mesh.merge(cut_mitre(1.0, 0.80, 1.22, 0.40, 0.178))
    mesh.merge(ellipsoid((0.0, 1.245, 0.0), (0.042, 0.045, 0.042), 10, 6))
    return mesh


def crown(bottom, top, narrow, wide, points, dip, dish):
    """A flaring crown whose rim dips between its points, hollow down to `dish`."""
    mesh = Mesh()
    count = points * 4
    heights = (0.0, 0.35, 0.7, 1.0)
    rows = [(narrow + (wide - narrow) * h ** 1.6, bottom + (top - bottom) * h, h) for h in heights]
    rows += [(wide - 0.035, top + 0.004, 1.0), (wide - 0.055, top - 0.05, 0.6), (0.11, dish, 0.0)]
    rings = []
    for radius, height, rim in rows:
        ring = []
        for i in range(count):
            angle = -2.0 * math.pi * i / count
            notch = dip * rim ** 6 * (0.5 - 0.5 * math.cos(points * angle)) ** 1.5
            ring.append(mesh.vertex((radius * math.cos(angle), height - notch, radius * math.sin(angle))))
        rings.append(ring)
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper)
    mesh.cap(rings[0][::-1], mesh.vertex((0.0, bottom, 0.0)))
    mesh.cap(rings[-1], mesh.vertex((0.0, dish + 0.02, 0.0)))
    return mesh


def tall_body(radius, waist, neck, neck_height):
    profile = foot(radius)
    profile += stem([profile[-1], (waist * 1.35, neck_height * 0.36), (waist, neck_height * 0.64),
                     (neck, neck_height)], 8)
    return profile


def queen():
    profile = tall_body(0.38, 0.125, 0.125, 0.93)
    profile += bead(0.235, 0.94, 1.00, 3) + [(0.15, 1.01)] + bead(0.185, 1.02, 1.06, 3) + [(0.0, 1.08)]
    mesh = lathe(profile, SEGMENTS)
    mesh.merge(crown(1.05, 1.39, 0.125, 0.235, 9, 0.055, 1.375))
    dome = [(0.0, 1.33)] + sphere_profile(0.17, 1.31, -20.0, 4)[:-1]
    mesh.merge(lathe(dome + sphere_profile(0.062, 1.52, 50.0, 6), 16))
    return mesh


def cross_solid(centre_height, arm, narrow, wide, half_depth):
    """A cross with flaring arms and a bevel all round."""
    outline = []
    for quarter in range(4):
        for x, y in ((narrow, narrow), (arm * 0.97, wide), (arm, 0.0), (arm * 0.97, -wide)):
            c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter]
            outline.append((x * c - y * s, x * s + y * c))
    # Counter-clockwise seen from +Z, starting anywhere.
    outline.sort(key=lambda p: round(math.atan2(p[1], p[0]), 9))
    mesh = Mesh()

    def ring(size, depth):
        return [mesh.vertex((x * size, centre_height + y * size, depth)) for x, y in outline]

    bevel = 0.82
    rings = [ring(bevel, -half_depth), ring(1.0, -0.55 * half_depth), ring(1.0, 0.55 * half_depth),
             ring(bevel, half_depth)]
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper)
    mesh.cap(rings[0][::-1], mesh.vertex((0.0, centre_height, -half_depth)))
    mesh.cap(rings[-1], mesh.vertex((0.0, centre_height, half_depth)))
    return mesh


def king():
    profile = tall_body(0.40, 0.14, 0.14, 1.02)
    profile += bead(0.255, 1.03, 1.095, 3) + [(0.165, 1.105)] + bead(0.20, 1.115, 1.16, 3)
    profile += [(0.145, 1.17), (0.155, 1.26), (0.185, 1.37), (0.225, 1.455)] + bead(0.24, 1.455, 1.495, 3)[1:]
    profile += [(0.17, 1.52), (0.09, 1.555), (0.055, 1.575), (0.05, 1.60), (0.0, 1.62)]
    mesh = lathe(profile, SEGMENTS)
    mesh.merge(cross_solid(1.70, 0.115, 0.030, 0.062, 0.036))
    return mesh

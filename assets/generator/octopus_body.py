"""The octopus at rest: one watertight skin from the mantle's tip to the tips of eight straight arms.

The skin is a sheet of columns. Under the head every arm takes its share of them for the upper half of its
own rings; the same columns go on below, towards the mouth. Neighbouring arms meet in a single vertex, the
web's edge. Suckers and eyes are closed solids set into the skin.
"""

import math

from .mesh import Mesh
from .vectors import add, catmull_rom, cross, mix, normalize, scale, smoothstep, subtract

ARMS = 8
ARM_JOINTS = 11
ARM_LENGTH = 4.7
ARM_START = 0.60
BONE = ARM_LENGTH / ARM_JOINTS

HALF = 9                  # columns over one arm; its rings have twice as many vertices
COLUMNS = ARMS * HALF
ARM_RINGS = 74
SKIRT_ROWS = 9
MOUTH_ROWS = 5
MANTLE_ROWS = 34

SKIN, EYE, PUPIL, SUCKER = 0, 1, 2, 3
BODY, MANTLE, MANTLE_TIP, FIRST_ARM_JOINT = 0, 1, 2, 3

# The mantle's cross-sections from its tip to where the web begins: height, depth behind, half width, half depth.
MANTLE_SECTIONS = (
    (1.86, -1.62, 0.16, 0.13), (1.84, -1.42, 0.40, 0.34), (1.76, -1.12, 0.60, 0.52), (1.58, -0.80, 0.70, 0.60),
    (1.32, -0.50, 0.66, 0.58), (1.06, -0.25, 0.53, 0.49), (0.84, -0.08, 0.43, 0.42), (0.64, 0.0, 0.42, 0.42),
    (0.46, 0.02, 0.45, 0.45))
EYE_CENTRES = ((0.40, 0.84, 0.17), (-0.40, 0.84, 0.17))
# Where the mantle hangs on the body, and where its hind half hangs on it.
MANTLE_PIVOT, MANTLE_TIP_PIVOT = (0.0, 0.80, -0.05), (0.0, 1.42, -0.62)


def arm_direction(arm):
    angle = 2.0 * math.pi * (arm + 0.5) / ARMS
    return (math.sin(angle), 0.0, math.cos(angle))


def arm_side(arm):
    """To the arm's left, so that side, up and outwards make a right-handed frame."""
    x, _, z = arm_direction(arm)
    return (z, 0.0, -x)


def arm_radius(s):
    share = min(1.0, max(0.0, s / ARM_LENGTH))
    return 0.235 * (1.0 - share) ** 0.85 * (1.0 - 0.25 * share) + 0.014


def arm_joint(arm, number):
    return FIRST_ARM_JOINT + arm * ARM_JOINTS + number


# Joint weights --------------------------------------------------------------------------------------------

def bell(x):
    """The quadratic B-spline: three bones share every place, and their shares change smoothly."""
    x = abs(x)
    return 0.75 - x * x if x < 0.5 else 0.5 * (1.5 - x) ** 2 if x < 1.5 else 0.0


def arm_influence(arm, s):
    """(joint, weight) pairs at a distance s along the arm; what lies before its first bone belongs to the body."""
    weights = {}
    for number in range(-3, ARM_JOINTS + 2):
        weight = bell(s / BONE - number - 0.5)
        if weight > 0.0:
            joint = BODY if number < 0 else arm_joint(arm, min(number, ARM_JOINTS - 1))
            weights[joint] = weights.get(joint, 0.0) + weight
    return tuple(sorted(weights.items()))


def blend(first, second, share):
    weights = {}
    for influence, factor in ((first, 1.0 - share), (second, share)):
        for joint, weight in influence:
            if weight * factor > 0.0:
                weights[joint] = weights.get(joint, 0.0) + weight * factor
    return tuple(sorted(weights.items()))


def web_influence(arm, across, s):
    """`across` runs from -1 to 1 over an arm; at the web's edge the two neighbours pull alike."""
    own = arm_influence(arm, s)
    near = smoothstep(0.25, 1.75, abs(across)) * (1.0 - smoothstep(0.0, 0.7, s))
    other = (arm + (1 if across > 0.0 else -1)) % ARMS
    return blend(own, arm_influence(other, s), near)


# The skin -------------------------------------------------------------------------------------------------

def ring_point(arm, s, angle):
    """A point of the arm's cross-section: angle 0 is towards the next arm, a quarter turn on is the top."""
    radius = arm_radius(s)
    open_web = 1.0 - smoothstep(-0.05, 0.85, s)
    half_width = radius + (ARM_START * math.tan(math.pi / ARMS) - radius) * open_web
    half_height = radius * (0.94 - 0.10 * open_web)
    up = math.sin(angle)
    # The underside, where the suckers stand, is flatter than the back.
    lift = half_height * (up if up > 0.0 else 0.78 * up)
    centre = scale(arm_direction(arm), ARM_START + s)
    return add(centre, add(scale(arm_side(arm), half_width * math.cos(angle)), (0.0, lift, 0.0)))


def hermite(start, start_tangent, end, end_tangent, t):
    t2, t3 = t * t, t * t * t
    return tuple((2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * b + (3 * t2 - 2 * t3) * c + (t3 - t2) * d
                 for a, b, c, d in zip(start, start_tangent, end, end_tangent))


def column_angle(column):
    return 2.0 * math.pi * column / COLUMNS


def mantle_rings():
    """Rows of points from the mantle's tip down, with the share of each mantle joint."""
    rows = catmull_rom(MANTLE_SECTIONS, MANTLE_ROWS)
    rings = []
    for number, (height, depth, half_width, half_depth) in enumerate(rows):
        before, after = rows[max(number - 1, 0)], rows[min(number + 1, MANTLE_ROWS - 1)]
        down = normalize((0.0, after[0] - before[0], after[1] - before[1]))
        if number == MANTLE_ROWS - 1:
            down = (0.0, -1.0, 0.0)
        forward = normalize(cross(down, (1.0, 0.0, 0.0)))
        ring = []
        for column in range(COLUMNS):
            angle = column_angle(column)
            point = (half_width * math.sin(angle), height, depth)
            point = add(point, scale(forward, half_depth * math.cos(angle)))
            for eye in EYE_CENTRES:
                # A hood swells round each eye.
                away = subtract(point, eye)
                near = math.exp(-(away[0] ** 2 + away[1] ** 2 + away[2] ** 2) / 0.042)
                point = add(point, scale(normalize((eye[0], 0.10, 0.20)), 0.13 * near))
            ring.append(point)
        rings.append(ring)
    return rings


def mantle_influence(point):
    hang = smoothstep(0.55, 1.10, point[1] - 0.25 * point[2])
    hind = smoothstep(0.35, 1.25, -point[2])
    return blend(blend(((BODY, 1.0),), ((MANTLE, 1.0),), hang), ((MANTLE_TIP, 1.0),), hang * hind)


def add_skin(mesh):
    rings = mantle_rings()
    rows = [[mesh.vertex(p, mantle_influence(p)) for p in ring] for ring in rings]
    tip = scale(tuple(sum(p[k] for p in rings[0]) for k in range(3)), 1.0 / COLUMNS)
    tip = add(tip, (0.0, 0.02, -0.07))
    mesh.cap(rows[0], mesh.vertex(tip, mantle_influence(tip)), SKIN)

    # Where the columns reach the arms. Column c belongs to arm c // HALF, whose left edge is its last column.
    rim_points = []
    for column in range(COLUMNS):
        arm, step = divmod(column, HALF)
        rim_points.append((arm, math.pi * (1.0 - step / HALF), -1.0 + 2.0 * step / HALF))
    head = rings[-1]
    for row in range(1, SKIRT_ROWS):
        t = row / SKIRT_ROWS
        ring = []
        for column, (arm, angle, across) in enumerate(rim_points):
            end = ring_point(arm, 0.0, angle)
            outwards = normalize((head[column][0], 0.0, head[column][2]))
            point = hermite(head[column], (0.12 * outwards[0], -0.42, 0.12 * outwards[2]),
                            end, scale(arm_direction_of(arm, across), 0.34), t)
            ring.append(mesh.vertex(point, web_influence(arm, across, -0.62 * (1.0 - t))))
        rows.append(ring)

    arm_rings = []
    shared = [mesh.vertex(ring_point(arm, 0.0, math.pi), web_influence(arm, -1.0, 0.0)) for arm in range(ARMS)]
    for arm in range(ARMS):
        first = []
        for step in range(2 * HALF):
            if step == 0:
                first.append(shared[arm])
            elif step == HALF:
                first.append(shared[(arm + 1) % ARMS])
            else:
                angle = math.pi * (1.0 - step / HALF)
                first.append(mesh.vertex(ring_point(arm, 0.0, angle),
                                         web_influence(arm, -math.cos(angle), 0.0)))
        arm_rings.append(first)
    rim = [arm_rings[column // HALF][column % HALF] for column in range(COLUMNS)]
    rows.append(rim)
    for upper, lower in zip(rows, rows[1:]):
        mesh.bridge(lower, upper, SKIN)

    below = []
    for column in range(COLUMNS):
        arm, step = divmod(column, HALF)
        below.append(arm_rings[arm][-step] if step else arm_rings[arm][0])
    for row in range(1, MOUTH_ROWS):
        t = row / MOUTH_ROWS
        ring = []
        for column, (arm, angle, across) in enumerate(rim_points):
            start = ring_point(arm, 0.0, -angle)
            point = mix(start, (0.0, -0.05, 0.0), t)
            ring.append(mesh.vertex(point, web_influence(arm, across, -0.62 * t)))
        mesh.bridge(ring, below, SKIN)
        below = ring
    mesh.cap(below[::-1], mesh.vertex((0.0, -0.05, 0.0), ((BODY, 1.0),)), SKIN)

    for arm in range(ARMS):
        add_arm(mesh, arm, arm_rings[arm])


def arm_direction_of(arm, across):
    """Outwards at a column: along the arm over its middle, between two arms at the web's edge."""
    edge = arm_direction(arm + (0.5 if across > 0.0 else -0.5))
    return normalize(mix(arm_direction(arm), edge, abs(across) ** 3))


def add_arm(mesh, arm, ring):
    for number in range(1, ARM_RINGS + 1):
        # Rings stand closer towards the tip, which is thinner and curls more.
        share = number / ARM_RINGS
        s = ARM_LENGTH * (1.25 * share - 0.25 * share * share)
        following = []
        for step in range(2 * HALF):
            angle = math.pi * (1.0 - step / HALF)
            following.append(mesh.vertex(ring_point(arm, s, angle), web_influence(arm, -math.cos(angle), s)))
        mesh.bridge(following, ring, SKIN)
        ring = following
    tip = scale(arm_direction(arm), ARM_START + ARM_LENGTH + 0.012)
    mesh.cap(ring[::-1], mesh.vertex(tip, arm_influence(arm, ARM_LENGTH)), SKIN)


# What is set into the skin --------------------------------------------------------------------------------

# A cup: radius and height, both in sucker radii, from its root inside the arm over its rim to its bottom.
CUP = ((0.72, -0.50), (1.00, 0.20), (0.80, 0.34), (0.48, 0.10))
CUP_SIDES = 8


def add_suckers(mesh, arm):
    s = 0.16
    side, outwards = arm_side(arm), arm_direction(arm)
    while s < ARM_LENGTH * 0.95:
        size = 0.37 * arm_radius(s)
        # The two rows stand staggered, as they do on the animal.
        for across in (-1, 1):
            place = s + (0.55 * size if across > 0 else -0.55 * size)
            angle = math.radians(-90.0 + 31.0 * across)
            foot = ring_point(arm, place, angle)
            normal = normalize(add(scale(side, math.cos(angle)), (0.0, 1.28 * math.sin(angle), 0.0)))
            add_cup(mesh, foot, normal, outwards, size, arm_influence(arm, place))
        s += 2.5 * size + 0.02


def add_cup(mesh, foot, normal, along, size, influence):
    across = cross(normal, along)
    rings = []
    for radius, height in CUP:
        ring = []
        for i in range(CUP_SIDES):
            angle = 2.0 * math.pi * i / CUP_SIDES
            point = add(scale(along, math.cos(angle)), scale(across, math.sin(angle)))
            ring.append(mesh.vertex(add(add(foot, scale(normal, height * size)), scale(point, radius * size)),
                                    influence))
        rings.append(ring)
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper, SUCKER)
    mesh.cap(rings[0][::-1], mesh.vertex(add(foot, scale(normal, CUP[0][1] * size)), influence), SUCKER)
    mesh.cap(rings[-1], mesh.vertex(add(foot, scale(normal, 0.02 * size)), influence), SUCKER)


def add_ball(mesh, centre, axes, radii, influence, part, sides=16, rows=10):
    """An ellipsoid with its own axes (right-handed)."""
    def at(angle, height):
        ring = math.sqrt(max(0.0, 1.0 - height * height))
        local = (radii[0] * ring * math.cos(angle), radii[1] * ring * math.sin(angle), radii[2] * height)
        return add(centre, add(add(scale(axes[0], local[0]), scale(axes[1], local[1])), scale(axes[2], local[2])))

    rings = []
    for row in range(1, rows):
        height = -math.cos(math.pi * row / rows)
        rings.append([mesh.vertex(at(2.0 * math.pi * i / sides, height), influence) for i in range(sides)])
    for lower, upper in zip(rings, rings[1:]):
        mesh.bridge(lower, upper, part)
    mesh.cap(rings[0][::-1], mesh.vertex(at(0.0, -1.0), influence), part)
    mesh.cap(rings[-1], mesh.vertex(at(0.0, 1.0), influence), part)


def add_eyes(mesh):
    for centre in EYE_CENTRES:
        outwards = normalize((centre[0], 0.09, 0.20))
        level = normalize(cross((0.0, 1.0, 0.0), outwards))
        axes = (level, cross(outwards, level), outwards)
        influence = mantle_influence(centre)
        middle = add(centre, scale(outwards, 0.060))
        add_ball(mesh, middle, axes, (0.120, 0.100, 0.110), influence, EYE)
        # The pupil of an octopus is a bar that lies level.
        add_ball(mesh, add(middle, scale(outwards, 0.092)), axes, (0.066, 0.024, 0.026), influence, PUPIL, 12, 8)


def octopus_mesh():
    mesh = Mesh()
    add_skin(mesh)
    for arm in range(ARMS):
        add_suckers(mesh, arm)
    add_eyes(mesh)
    return mesh

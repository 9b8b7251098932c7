"""The octopus scene: eight skinned arms that curl at their own pace over rippled sand."""

import math

from .glb import FLOAT, Document
from .images import mottled
from .mesh import grid_box
from .octopus_body import (ARM_JOINTS, ARM_START, ARMS, BONE, MANTLE_PIVOT, MANTLE_TIP_PIVOT,
                           arm_direction, arm_radius, arm_side, octopus_mesh)
from .vectors import add, axis_angle, catmull_rom, multiply, rotate, scale, smoothstep, subtract

NAME = "octopus"
FRAMES = 72
DEFAULT_FRAME = 29
FPS = 24
SHUTTER = 1.0

BODY_HEIGHT = 0.78
CLEARANCE = 0.03
SAND_CELLS = 42

# Per arm: the direction of its bones from base to tip, as curves of elevation and of heading away from its
# own direction (degrees); the size of the waves in both; whole waves per loop; a phase; and whether it rests
# on the sand, to be lowered until it touches, or is held above it.
ARM_MOTIONS = (
    dict(up=(-30, -28, -2, 6, 40, 120, 200), aside=(0, 8, 30, 60, 80, 90, 100), wave=(12, 26), cycles=3, phase=0.00,
         rests=True),
    dict(up=(36, 50, 40, 0, -36, -44, 10), aside=(0, 6, 12, 6, -10, -30, -60), wave=(17, 20), cycles=3,
         phase=0.35, rests=False),
    dict(up=(-28, -30, -4, 2, 6, 20, 50), aside=(0, -10, -28, -10, 40, 110, 190), wave=(8, 26), cycles=4, phase=0.62,
         rests=True),
    dict(up=(12, 26, 34, 50, 90, 160, 250), aside=(0, 6, 16, 22, 26, 30, 30), wave=(18, 18), cycles=2, phase=0.15,
         rests=False),
    dict(up=(-30, -28, -3, 2, 4, 10, 30), aside=(0, 8, 34, 70, 120, 190, 280), wave=(6, 24), cycles=3, phase=0.80,
         rests=True),
    dict(up=(40, 52, 40, 0, -40, -60, -30), aside=(0, -8, -16, -10, 10, 40, 90), wave=(17, 22), cycles=4, phase=0.45,
         rests=False),
    dict(up=(-30, -26, 0, 8, 20, 60, 130), aside=(0, -6, -20, -45, -75, -95, -110), wave=(9, 26), cycles=4, phase=0.10,
         rests=True),
    dict(up=(10, 16, 26, 44, 80, 140, 220), aside=(0, 10, 24, 36, 40, 36, 30), wave=(17, 20), cycles=3, phase=0.70,
         rests=False),
)


def directions(motion, frame):
    """(elevation, heading) of each bone in degrees: a pose, and a wave that runs down the arm."""
    turn = 2.0 * math.pi * motion["cycles"] * frame / FRAMES
    pose = catmull_rom(list(zip(motion["up"], motion["aside"])), ARM_JOINTS)
    result = []
    for joint, (up, aside) in enumerate(pose):
        along = joint / (ARM_JOINTS - 1)
        phase = turn + 2.0 * math.pi * (motion["phase"] - 0.9 * along)
        up += motion["wave"][0] * (0.15 + 0.85 * along) * math.sin(phase)
        # The base bends least sideways: neighbouring arms share the web between them.
        aside += motion["wave"][1] * smoothstep(-0.1, 0.5, along) * math.cos(phase)
        up += motion.get("lift", 0.0) * (1.0 - smoothstep(0.1, 0.45, along))
        result.append((up, aside))
    return result


def bone_rotations(arm, motion, frame):
    """Rotations against rest of the arm's bones in the body's frame."""
    # A turn about the arm's own side lowers its far end, hence the sign.
    return [multiply(axis_angle((0.0, 1.0, 0.0), aside), axis_angle(arm_side(arm), -up))
            for up, aside in directions(motion, frame)]


def joint_rotations(arm, motion, frame):
    """The same, each relative to the bone before it, as the skeleton wants them."""
    before = (0.0, 0.0, 0.0, 1.0)
    result = []
    for rotation in bone_rotations(arm, motion, frame):
        x, y, z, w = before
        result.append(multiply((-x, -y, -z, w), rotation))
        before = rotation
    return result


def lowest_point(arm, motion):
    """The arm's height above the sand, at its lowest at any time of the loop."""
    outwards = arm_direction(arm)
    lowest = 1e9
    for frame in range(0, FRAMES, 3):
        position = add((0.0, BODY_HEIGHT, 0.0), scale(outwards, ARM_START))
        for joint, rotation in enumerate(bone_rotations(arm, motion, frame)):
            step = rotate(rotation, scale(outwards, BONE / 2.0))
            for half in (0.5, 1.0):
                position = add(position, step)
                lowest = min(lowest, position[1] - 1.12 * arm_radius((joint + half) * BONE))
    return lowest


def settle(arm, motion):
    """Turns the arm at its base until it just touches the sand, or at least stays above it."""
    low, high = -40.0, 60.0
    if not motion["rests"] and lowest_point(arm, motion) >= CLEARANCE:
        return motion
    for _ in range(14):
        middle = (low + high) / 2.0
        if lowest_point(arm, dict(motion, lift=middle)) < CLEARANCE:
            low = middle
        else:
            high = middle
    return dict(motion, lift=high)


def sand():
    """A slab with low waves on top, never above the floor's level, divided most finely under the octopus."""
    slab = grid_box((-1.0, -0.35, -1.0), (1.0, 0.0, 1.0), SAND_CELLS, SAND_CELLS)
    for number, (x, y, z) in enumerate(slab.positions):
        x, z = 6.5 * x + 5.5 * x ** 3 - 2.5, 6.5 * z + 5.5 * z ** 3 - 5.0
        if y == 0.0:
            crest = math.sin(3.1 * z + 1.1 * x + 0.9 * math.sin(0.7 * x - 0.4 * z))
            y = 0.028 * (crest - 1.0) + 0.02 * (math.sin(0.5 * x + 0.8) * math.sin(0.6 * z) - 1.0)
        slab.positions[number] = (x, y, z)
    return slab


def add_skeleton(document):
    """Nodes and their inverse bind matrices; at rest no joint is turned."""
    places = {}

    def joint(name, place, parent=None):
        node = document.node(name, subtract(place, places[parent] if parent is not None else (0.0, 0.0, 0.0)),
                             root=False)
        places[node] = place
        if parent is not None:
            document.json["nodes"][parent].setdefault("children", []).append(node)
        return node

    body = joint("body", (0.0, 0.0, 0.0))
    mantle = joint("mantle", MANTLE_PIVOT, body)
    tip = joint("mantle tip", MANTLE_TIP_PIVOT, mantle)
    joints = [body, mantle, tip]
    arms = []
    for arm in range(ARMS):
        parent, chain = body, []
        for number in range(ARM_JOINTS):
            parent = joint(f"arm {arm + 1}.{number + 1}",
                           scale(arm_direction(arm), ARM_START + BONE * number), parent)
            chain.append(parent)
        arms.append(chain)
        joints.extend(chain)
    matrices = []
    for node in joints:
        x, y, z = places[node]
        matrices.extend([1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -x, -y, -z, 1.0])
    document.json["skins"] = [{"name": "octopus", "joints": joints, "skeleton": body,
                               "inverseBindMatrices": document.accessor(matrices, "MAT4", FLOAT)}]
    return body, mantle, tip, arms


def animate(document, body, mantle, tip, arms):
    frames = range(FRAMES + 1)

    def wave(frame, cycles, phase):
        return math.sin(2.0 * math.pi * (cycles * (frame % FRAMES) / FRAMES + phase))

    document.animate(body, "translation", [(0.05 * wave(f, 1, 0.1), BODY_HEIGHT + 0.05 + 0.05 * wave(f, 2, 0.0),
                                            0.05 * wave(f, 1, 0.4)) for f in frames])
    document.animate(mantle, "rotation", [multiply(axis_angle((1.0, 0.0, 0.0), 6.0 * wave(f, 2, 0.3)),
                                                   axis_angle((0.0, 0.0, 1.0), 5.0 * wave(f, 1, 0.0)))
                                          for f in frames])
    document.animate(tip, "rotation", [multiply(axis_angle((1.0, 0.0, 0.0), 8.0 * wave(f, 2, 0.15)),
                                                axis_angle((0.0, 1.0, 0.0), 9.0 * wave(f, 1, 0.85)))
                                       for f in frames])
    for arm, chain in enumerate(arms):
        motion = settle(arm, ARM_MOTIONS[arm])
        poses = [joint_rotations(arm, motion, f % FRAMES) for f in frames]
        for number, node in enumerate(chain):
            document.animate(node, "rotation", [pose[number] for pose in poses])


def build():
    document = Document(NAME, DEFAULT_FRAME, FPS, SHUTTER)
    document.camera("reef", (2.9, 7.8, 9.7), (0.75, 0.5, 0.15), 0.565, 0.1, 60.0)
    document.camera("eye", (3.4, 4.4, 9.4), (0.0, 1.25, 0.0), 0.40, 0.1, 60.0)
    document.camera("above", (0.4, 12.5, 4.6), (0.5, 0.0, 0.2), 0.62, 0.1, 60.0)
    document.spot("sun shaft", (-8.0, 9.6, -3.6), (0.6, 0.0, 0.5), (0.96, 0.98, 1.0), 680.0, 0.44, 0.60)

    spots = document.texture(mottled(31, (168, 92, 70), (255, 226, 200), 22, 70, 0.35))
    grains = document.texture(mottled(41, (196, 184, 160), (255, 248, 232), 24, 128, 0.65))
    skin = document.material("skin", (0.84, 0.36, 0.22), 0.42, spots)
    eye = document.material("eye", (0.88, 0.66, 0.22), 0.25)
    pupil = document.material("pupil", (0.02, 0.02, 0.025), 0.3)
    sucker = document.material("suckers", (0.95, 0.72, 0.60), 0.5)
    sand_surface = document.material("sand", (0.95, 0.80, 0.60), 0.95, grains)

    floor = document.mesh("sand", sand(), [sand_surface], crease=60.0,
                          texture_coordinates=lambda part, p: (0.35 * p[0], 0.35 * p[2]))
    document.node("sand", mesh=floor)
    body, mantle, tip, arms = add_skeleton(document)
    document.json["scenes"][0]["nodes"].append(body)
    mesh = document.mesh("octopus", octopus_mesh(), [skin, eye, pupil, sucker], crease=180.0,
                         texture_coordinates=lambda part, p: (0.4 * p[0] + 0.13 * p[1], 0.4 * p[2] + 0.31 * p[1]))
    document.node("octopus", mesh=mesh, skin=0)
    animate(document, body, mantle, tip, arms)
    return document.pack()

"""The chess scene: a game in motion. A knight leaps, the queen slides in, and the rook she takes falls and rolls."""

import math

from .chess_knight import knight
from .chess_pieces import bishop, king, pawn, queen, rook
from .glb import Document
from .images import mottled, wood
from .mesh import grid_box
from .vectors import add, axis_angle, mix, multiply, rotate, smoothstep

NAME = "chess"
FRAMES = 96
DEFAULT_FRAME = 20
FPS = 24
SHUTTER = 0.6

TABLE = -0.38
MAKERS = {"king": king, "queen": queen, "rook": rook, "bishop": bishop, "knight": knight, "pawn": pawn}

# A square, or a place on the table beside the board as (x, z).
WHITE = (("king", "g1"), ("queen", "c1"), ("rook", "e1"), ("bishop", "b2"), ("bishop", "d3"), ("knight", "c3"),
         ("pawn", "a2"), ("pawn", "b3"), ("pawn", "d5"), ("pawn", "e3"), ("pawn", "f2"), ("pawn", "g2"),
         ("pawn", "h3"), ("pawn", (-5.35, 0.9)))
BLACK = (("king", "g8"), ("rook", "d8"), ("rook", "b8"), ("bishop", "b7"), ("bishop", "g7"), ("knight", "c5"),
         ("knight", (-5.4, -1.2)), ("pawn", "a6"), ("pawn", "c6"), ("pawn", "d6"), ("pawn", "e7"), ("pawn", "f7"),
         ("pawn", "g6"), ("pawn", "h7"), ("pawn", (-5.9, 0.1)))
QUEEN_FROM, QUEEN_TO = "a4", "h4"
KNIGHT_FROM, KNIGHT_TO = "f3", "g5"
ROOK_FROM = "h4"


def square(name):
    """The centre of a square such as "e4": files run along +X, ranks along -Z, white sits at +Z."""
    return (ord(name[0]) - ord("a") - 3.5, 0.0, 3.5 - (int(name[1]) - 1))


def place(where):
    return square(where) if isinstance(where, str) else (where[0], TABLE, where[1])


def turn(kind, is_white, where):
    """Horses face the other side, a little askew as people set them down; bishops show their slit."""
    heading = 90.0 if is_white else -90.0
    if kind == "knight":
        heading += 24.0 if is_white else -28.0
    askew = 37.0 * math.sin(12.9898 * where[0] + 78.233 * where[2])
    return axis_angle((0.0, 1.0, 0.0), heading + (askew if kind not in ("knight", "king") else 0.3 * askew))


# Motion: everything plays forwards, rests, and plays backwards again, so the clip closes on itself. --------


def play_time(frame):
    """Frames of forward motion at a frame of the loop: its second half mirrors the first."""
    frame %= FRAMES
    return min(frame, FRAMES - frame)


def queen_pose(t):
    start, end = square(QUEEN_FROM), square(QUEEN_TO)
    share = smoothstep(10.0, 27.0, t)
    return add(start, ((end[0] - start[0]) * share, 0.0, 0.0)), turn("queen", False, end)


def knight_pose(t):
    start, end = square(KNIGHT_FROM), square(KNIGHT_TO)
    run = min(1.0, max(0.0, (t - 11.0) / 14.0))
    share = 0.3 * run + 0.7 * smoothstep(0.0, 1.0, run)
    position = mix(start, end, share)
    # It soars over the queen's lane before she comes by.
    lift = 1.95 * math.sin(math.pi * share) ** 1.15
    rear = 17.0 * math.sin(2.0 * math.pi * share)
    heading = axis_angle((0.0, 1.0, 0.0), 52.0 - 26.0 * share)
    return (position[0], lift, position[2]), multiply(heading, axis_angle((0.0, 0.0, 1.0), rear))


class RookFall:
    """The captured rook tips over, drops off the board's edge and rolls across the table."""

    def __init__(self, mesh):
        self.points = mesh.positions
        self.start = square(ROOK_FROM)
        self.facing = turn("rook", True, self.start)

    def ground(self, x):
        """The board is a step above the table; the step is rounded so that the fall is not a jump."""
        return TABLE * smoothstep(4.75, 5.45, x)

    def pose(self, t):
        tip = smoothstep(15.0, 29.0, t)
        run = min(1.0, max(0.0, (t - 15.0) / 20.0))
        share = smoothstep(0.0, 0.14, run) * (1.0 - (1.0 - run) ** 2.0)
        x = self.start[0] + 2.45 * share
        z = self.start[2] + 0.5 * share
        # It falls towards +Z, so that it can roll on towards +X.
        upright = multiply(axis_angle((0.0, 1.0, 0.0), 16.0 * share),
                           multiply(axis_angle((1.0, 0.0, -0.25), 97.0 * tip),
                                    axis_angle((0.0, 1.0, 0.0), -140.0 * smoothstep(18.0, 38.0, t))))
        rotation = multiply(upright, self.facing)
        lowest = min(rotate(rotation, p)[1] for p in self.points)
        return (x, self.ground(x) - lowest, z), rotation


def animate(document, node, pose):
    keys = [pose(play_time(frame)) for frame in range(FRAMES + 1)]
    document.animate(node, "translation", [position for position, _ in keys])
    document.animate(node, "rotation", [rotation for _, rotation in keys])


# The board ------------------------------------------------------------------------------------------------

LIGHT_SQUARE, DARK_SQUARE, FRAME = 0, 1, 2


def board():
    """One closed slab: squares of two woods within a frame that stands a little lower at its edge."""
    lines = [-4.62, -4.56, -4.06, -4.0] + [-3.0 + i for i in range(7)] + [4.0, 4.06, 4.56, 4.62]
    count = len(lines)

    def height(x, z):
        reach = max(abs(x), abs(z))
        return -0.06 if reach > 4.6 else 0.012 if 4.02 < reach < 4.58 else 0.0

    def part(x, z):
        if max(abs(x), abs(z)) > 4.0:
            return FRAME
        return DARK_SQUARE if (math.floor(x) + math.floor(z)) % 2 else LIGHT_SQUARE

    slab = grid_box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0), count - 1, count - 1)
    for number, (x, y, z) in enumerate(slab.positions):
        x, z = (lines[int(round((v + 1.0) / 2.0 * (count - 1)))] for v in (x, z))
        slab.positions[number] = (x, height(x, z) if y > 0.0 else TABLE, z)
    triangles = []
    for a, b, c, _ in slab.triangles:
        corners = [slab.positions[v] for v in (a, b, c)]
        on_top = all(p[1] > TABLE for p in corners)
        middle = [sum(p[k] for p in corners) / 3.0 for k in range(3)]
        triangles.append((a, b, c, part(middle[0], middle[2]) if on_top else FRAME))
    slab.triangles = triangles
    return slab


def build():
    document = Document(NAME, DEFAULT_FRAME, FPS, SHUTTER)
    document.camera("table", (5.2, 9.7, 11.7), (0.65, 0.1, 0.2), 0.555, 0.1, 60.0)
    document.camera("knight", (7.0, 6.4, 10.0), (0.9, 0.8, -2.0), 0.30, 0.1, 60.0)
    document.camera("rook", (11.4, 5.2, 9.2), (4.0, 0.1, 0.0), 0.32, 0.1, 60.0)
    document.spot("lamp", (-12.2, 8.6, -5.2), (0.6, 0.0, 0.2), (1.0, 0.93, 0.82), 1500.0, 0.42, 0.56)

    maple = document.texture(wood(3, (214, 186, 146), (252, 236, 208)))
    walnut = document.texture(wood(7, (176, 138, 112), (250, 226, 200)))
    cloth = document.texture(mottled(5, (196, 198, 200), (255, 255, 255), 64, 128, 0.6, 128))
    white_wood = document.material("boxwood", (0.97, 0.90, 0.76), 0.38, maple)
    black_wood = document.material("ebonised wood", (0.27, 0.17, 0.13), 0.34, walnut)
    light_square = document.material("maple squares", (0.92, 0.80, 0.62), 0.5, maple)
    dark_square = document.material("walnut squares", (0.46, 0.27, 0.19), 0.5, walnut)
    frame = document.material("frame", (0.28, 0.14, 0.10), 0.45, walnut)
    baize = document.material("baize", (0.32, 0.48, 0.42), 0.95, cloth)

    def table_coordinates(part, p):
        return (0.35 * p[0], 0.35 * p[2])

    def grain(part, p):
        # Wood drawn through the solid: the picture continues along one slanting direction.
        return (0.55 * p[0] + 0.23 * p[2] + 0.13 * part, 0.45 * p[1] + 0.17 * p[2])

    table = document.mesh("table", grid_box((-15.0, TABLE - 0.3, -17.0), (10.0, TABLE, 8.0), 14, 14), [baize],
                          texture_coordinates=table_coordinates)
    document.node("table", mesh=table)
    slab = document.mesh("board", board(), [light_square, dark_square, frame],
                         texture_coordinates=lambda part, p: (0.31 * p[0] + 0.2 * part, 0.21 * p[2] + 0.3 * p[1]))
    document.node("board", mesh=slab)

    shapes = {kind: make() for kind, make in MAKERS.items()}
    meshes = {}
    for kind, shape in shapes.items():
        # The horse is carved, the others are turned: its softer edges are not edges at all.
        crease = 62.0 if kind == "knight" else 40.0
        meshes["white", kind] = document.mesh(kind, shape, [white_wood], crease, texture_coordinates=grain)
        meshes["black", kind] = document.recoloured("black " + kind, meshes["white", kind], [black_wood])
    for side, pieces in (("white", WHITE), ("black", BLACK)):
        for kind, where in pieces:
            position = place(where)
            document.node(f"{side} {kind} {where if isinstance(where, str) else 'captured'}", position,
                          turn(kind, side == "white", position), mesh=meshes[side, kind])

    moving = (("black queen, sliding", ("black", "queen"), queen_pose),
              ("white knight, leaping", ("white", "knight"), knight_pose),
              ("white rook, captured", ("white", "rook"), RookFall(shapes["rook"]).pose))
    for name, which, pose in moving:
        position, rotation = pose(0)
        node = document.node(name, position, rotation, mesh=meshes[which])
        animate(document, node, pose)
    return document.pack()

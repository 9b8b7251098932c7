"""The pillars: an arc of fluted columns that stand still while the light flies up and away from them."""

import math

from .glb import Document
from .images import mottled
from .mesh import Mesh, grid_box, lathe
from .vectors import add, axis_angle

NAME = "pillars"
FRAMES = 40
DEFAULT_FRAME = 10
FPS = 24
SHUTTER = 1.0

FLUTES = 16
# Points across one flute, as (share of its width, depth): a narrow fillet, then a hollow.
FLUTE = ((0.0, 0.0), (0.14, 0.0), (0.32, 0.72), (0.57, 1.0), (0.82, 0.72))

LIGHT_CENTRE = (-14.5, 9.8, -1.5)
# The light swings this far to either side of the centre: mostly upwards, and away from the pillars.
LIGHT_SWING = (-3.6, 5.6, 3.8)
LIGHT_TARGET = (0.5, 0.0, -1.5)

# The pillars stand on an arc round the light's foot, so that their shadows spread like a fan.
PILLARS, RADIUS, STEP_DEGREES = 9, 12.0, 10.5


def fluted_shaft(bottom, top, bottom_radius, top_radius):
    mesh = Mesh()
    depth = 0.17 * bottom_radius
    # The flutes run out at both ends; the radius swells a little (entasis) between them.
    levels = ((0.0, 0.0), (0.02, 0.0), (0.05, 1.0), (0.35, 1.0), (0.65, 1.0), (0.94, 1.0), (0.975, 0.0), (1.0, 0.0))
    rings = []
    for share, fluting in levels:
        height = bottom + (top - bottom) * share
        radius = bottom_radius + (top_radius - bottom_radius) * share + 0.03 * bottom_radius * math.sin(math.pi * share)
        ring = []
        for flute in range(FLUTES):
            for across, hollow in FLUTE:
                angle = -2.0 * math.pi * (flute + across) / FLUTES
                r = radius - depth * hollow * fluting
                ring.append(mesh.vertex((r * math.cos(angle), height, r * math.sin(angle))))
        rings.append(ring)
    for below, above in zip(rings, rings[1:]):
        mesh.bridge(below, above)
    mesh.cap(rings[0][::-1], mesh.vertex((0.0, bottom, 0.0)))
    mesh.cap(rings[-1], mesh.vertex((0.0, top, 0.0)))
    return mesh


def torus_profile(radius, low, high, count):
    """The rounded edge of a ring-shaped moulding, from below to above."""
    half = (high - low) / 2.0
    return [(radius + half * math.sin(math.pi * i / count), low + half * (1.0 - math.cos(math.pi * i / count)))
            for i in range(count + 1)]


def pillar():
    mesh = Mesh()
    mesh.merge(grid_box((-0.62, 0.0, -0.62), (0.62, 0.22, 0.62), 1, 1))
    base = ([(0.0, 0.22)] + torus_profile(0.49, 0.22, 0.40, 4) + [(0.46, 0.43)]
            + torus_profile(0.44, 0.45, 0.56, 4) + [(0.0, 0.56)])
    mesh.merge(lathe(base, 24))
    mesh.merge(fluted_shaft(0.54, 3.92, 0.42, 0.35))
    capital = ([(0.0, 3.88)] + torus_profile(0.355, 3.88, 3.96, 3) + [(0.37, 3.99), (0.37, 4.05), (0.43, 4.12),
               (0.52, 4.19), (0.57, 4.26), (0.57, 4.30), (0.0, 4.30)])
    mesh.merge(lathe(capital, 24))
    mesh.merge(grid_box((-0.60, 4.30, -0.60), (0.60, 4.50, 0.60), 1, 1))
    return mesh


def light_position(frame):
    """A straight there-and-back path; it is at its centre, and at its fastest, at the default frame."""
    phase = math.sin(2.0 * math.pi * (frame - DEFAULT_FRAME - SHUTTER / 2.0) / FRAMES)
    return add(LIGHT_CENTRE, tuple(phase * x for x in LIGHT_SWING))


def pillar_place(number):
    angle = math.radians(STEP_DEGREES * (number - (PILLARS - 1) / 2.0))
    position = (LIGHT_CENTRE[0] + RADIUS * math.cos(angle), 0.0, LIGHT_CENTRE[2] + RADIUS * math.sin(angle))
    return position, -math.degrees(angle)


def build():
    document = Document(NAME, DEFAULT_FRAME, FPS, SHUTTER)
    document.camera("colonnade", (5.0, 16.4, 18.4), (0.05, 0.5, -0.7), 0.62, 0.1, 90.0)
    document.camera("above", (1.8, 27.0, 10.0), (1.4, 0.0, -1.2), 0.66, 0.1, 90.0)
    document.camera("between", (15.5, 7.0, 12.5), (0.4, 1.2, -1.0), 0.50, 0.1, 90.0)
    light = document.spot("rising light", light_position(0), LIGHT_TARGET, (1.0, 0.95, 0.86), 1500.0, 0.78, 0.95)

    stone = document.texture(mottled(11, (206, 200, 190), (255, 252, 246), 9, 90, 0.35, 128))
    ground = document.texture(mottled(21, (188, 186, 182), (250, 246, 238), 6, 120, 0.5, 128))
    marble = document.material("marble", (0.96, 0.90, 0.80), 0.55, stone)
    plane = document.material("limestone floor", (0.88, 0.80, 0.69), 0.9, ground)

    floor = document.mesh("floor", grid_box((-24.0, -0.2, -28.0), (16.0, 0.0, 12.0), 24, 24), [plane],
                          texture_coordinates=lambda part, p: (0.25 * p[0], 0.25 * p[2]))
    document.node("floor", mesh=floor)
    column = document.mesh("pillar", pillar(), [marble], crease=38.0,
                           texture_coordinates=lambda part, p: (0.3 * (p[0] + 0.6 * p[2]), 0.3 * (p[1] + 0.4 * p[2])))
    for number in range(PILLARS):
        position, heading = pillar_place(number)
        document.node(f"pillar {number + 1}", position, axis_angle((0.0, 1.0, 0.0), heading), mesh=column)

    document.animate(light, "translation", [light_position(i % FRAMES) for i in range(FRAMES + 1)])
    return document.pack()

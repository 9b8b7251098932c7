"""What `verify --dump` writes, and the definition of shadow by brute force: no code of the program's."""

import csv


def rows(path):
    with open(path, newline="", encoding="utf-8") as stream:
        reader = csv.reader(stream)
        next(reader)
        return [[float(x) for x in row] for row in reader]


def mix(a, b, u):
    return [x + (y - x) * u for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def clearance_of(triangle, u):
    """How near a caster's plane may pass a receiver on the triangle: 2^-21 of its largest coordinate at the time."""
    return 2.0**-21 * max(abs(c) for c in mix(triangle[1:10], triangle[10:19], u))


def meeting(triangle, u, point, towards, clearance):
    """Where the segment from the point, along `towards`, meets the triangle before its end, farther than the clearance
    from the triangle's plane: barycentrics, or None."""
    v = [sub(mix(triangle[3 * i + 1:3 * i + 4], triangle[3 * i + 10:3 * i + 13], u), point) for i in range(3)]
    e = [dot(towards, cross(v[1], v[2])), dot(towards, cross(v[2], v[0])), dot(towards, cross(v[0], v[1]))]
    if min(e) < 0 < max(e) or e == [0, 0, 0]:
        return None
    volume = dot(v[0], cross(v[1], v[2]))
    normal = cross(sub(v[1], v[0]), sub(v[2], v[0]))
    met = 0 < volume / sum(e) < 1 and abs(volume) > clearance * dot(normal, normal)**0.5
    return [x / sum(e) for x in e] if met else None

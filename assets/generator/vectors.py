"""Three-component vectors as tuples, and quaternions as (x, y, z, w), the order glTF uses."""

import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, factor):
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def normalize(a):
    return scale(a, 1.0 / length(a))


def mix(a, b, weight):
    return tuple(x + (y - x) * weight for x, y in zip(a, b))


def smoothstep(low, high, x):
    x = min(1.0, max(0.0, (x - low) / (high - low)))
    return x * x * (3.0 - 2.0 * x)


def catmull_rom(points, count):
    """`count` points spread evenly in parameter over a curve through `points` (tuples of any size)."""
    result = []
    last = len(points) - 1
    for i in range(count):
        t = last * i / (count - 1)
        k = min(int(t), last - 1)
        f = t - k
        before, start, end, after = (points[max(k - 1, 0)], points[k], points[k + 1], points[min(k + 2, last)])
        result.append(tuple(
            0.5 * (2 * b + (c - a) * f + (2 * a - 5 * b + 4 * c - d) * f * f + (3 * b - a - 3 * c + d) * f ** 3)
            for a, b, c, d in zip(before, start, end, after)))
    return result


def axis_angle(axis, degrees):
    half = math.radians(degrees) / 2.0
    s = math.sin(half)
    x, y, z = normalize(axis)
    return (x * s, y * s, z * s, math.cos(half))


def multiply(p, q):
    """The rotation that turns by q first and by p afterwards."""
    px, py, pz, pw = p
    qx, qy, qz, qw = q
    return (pw * qx + px * qw + py * qz - pz * qy,
            pw * qy - px * qz + py * qw + pz * qx,
            pw * qz + px * qy - py * qx + pz * qw,
            pw * qw - px * qx - py * qy - pz * qz)


def rotate(q, v):
    u = (q[0], q[1], q[2])
    t = scale(cross(u, v), 2.0)
    return add(add(v, scale(t, q[3])), cross(u, t))


def look_at(eye, target):
    """The rotation that turns -Z (where glTF's cameras and lights look) from eye to target, +Y upwards."""
    back = normalize(subtract(eye, target))
    right = normalize(cross((0.0, 1.0, 0.0), back))
    up = cross(back, right)
    m = ((right[0], up[0], back[0]), (right[1], up[1], back[1]), (right[2], up[2], back[2]))
    trace = m[0][0] + m[1][1] + m[2][2]
    if trace > 0.0:
        s = 2.0 * math.sqrt(trace + 1.0)
        return ((m[2][1] - m[1][2]) / s, (m[0][2] - m[2][0]) / s, (m[1][0] - m[0][1]) / s, s / 4.0)
    # The largest diagonal element keeps the division well away from zero.
    i = max(range(3), key=lambda k: m[k][k])
    j, k = (i + 1) % 3, (i + 2) % 3
    s = 2.0 * math.sqrt(1.0 + m[i][i] - m[j][j] - m[k][k])
    q = [0.0] * 4
    q[i] = s / 4.0
    q[j] = (m[j][i] + m[i][j]) / s
    q[k] = (m[k][i] + m[i][k]) / s
    q[3] = (m[k][j] - m[j][k]) / s
    return tuple(q)

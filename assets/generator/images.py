"""Small pictures for the materials: a PNG writer and repeating value noise, both of the standard library."""

import math
import random
import struct
import zlib


def write_png(width, height, pixel):
    """An 8-bit RGB picture; pixel(x, y) gives three bytes."""
    lines = bytearray()
    for y in range(height):
        lines.append(0)
        for x in range(width):
            lines.extend(pixel(x, y))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", stored(bytes(lines)))
            + chunk(b"IEND", b""))


def stored(data):
    """A zlib stream without compression: what a compressor makes of the same bytes differs between its versions."""
    stream = bytearray(b"\x78\x01")
    for start in range(0, len(data), 65535):
        block = data[start:start + 65535]
        last = start + 65535 >= len(data)
        stream.extend(struct.pack("<BHH", last, len(block), len(block) ^ 0xFFFF) + block)
    return bytes(stream) + struct.pack(">I", zlib.adler32(data))


class Noise:
    """Smooth values in [0, 1] that repeat after one unit in both directions."""

    def __init__(self, seed, cells_x, cells_y):
        source = random.Random(seed)
        self.cells_x, self.cells_y = cells_x, cells_y
        self.values = [[source.random() for _ in range(cells_x)] for _ in range(cells_y)]

    def __call__(self, u, v):
        x, y = u * self.cells_x, v * self.cells_y
        i, j = math.floor(x), math.floor(y)
        f, g = x - i, y - j
        f, g = f * f * (3 - 2 * f), g * g * (3 - 2 * g)
        i0, i1 = i % self.cells_x, (i + 1) % self.cells_x
        upper, lower = self.values[j % self.cells_y], self.values[(j + 1) % self.cells_y]
        return ((upper[i0] * (1 - f) + upper[i1] * f) * (1 - g) + (lower[i0] * (1 - f) + lower[i1] * f) * g)


def shade(dark, light, amount):
    return bytes(min(255, max(0, int(a + (b - a) * amount + 0.5))) for a, b in zip(dark, light))


def wood(seed, dark, light, size=256):
    """Wood whose grain runs along v: bands that wander, with fine pores drawn out along the grain."""
    wander = Noise(seed, 3, 2)
    bands = Noise(seed + 1, 14, 1)
    pores = Noise(seed + 2, 96, 6)

    def pixel(x, y):
        u, v = x / size, y / size
        shifted = u + 0.10 * (wander(u, v) - 0.5)
        rings = 0.5 + 0.5 * math.sin(2.0 * math.pi * (5.0 * u + 1.4 * wander(u, v)))
        amount = 0.50 * bands(shifted, v) + 0.32 * rings + 0.18 * pores(u, v)
        return shade(dark, light, amount)

    return write_png(size, size, pixel)


def mottled(seed, dark, light, coarse, fine, fine_share, size=256):
    """Two scales of noise: grains of sand, or the spots of a skin."""
    large = Noise(seed, coarse, coarse)
    small = Noise(seed + 1, fine, fine)

    def pixel(x, y):
        u, v = x / size, y / size
        return shade(dark, light, (1.0 - fine_share) * large(u, v) + fine_share * small(u, v))

    return write_png(size, size, pixel)

"""A small model that takes seconds to load and leaves nothing of what took so long."""

import json
import struct
import zlib

from memory_test import buffer_of, model


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def image_that_fails_at_its_end(side):
    """A PNG of 16-bit pixels, all black, without its last rows: takes long to decode and leaves nothing."""
    packer, row = zlib.compressobj(1), bytes(1 + 8 * side)
    packed = b"".join(packer.compress(row) for _ in range(side - 2)) + packer.flush()
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 16, 6, 0, 0, 0)) +
            chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def with_images(count, data):
    """Materials with images of their own, which are all the same bytes."""
    document = model()
    document["buffers"].append(buffer_of(data))
    document["bufferViews"].append({"buffer": 1, "byteLength": len(data)})
    document["images"] = [{"bufferView": 2, "mimeType": "image/png"} for _ in range(count)]
    document["textures"] = [{"source": i} for i in range(count)]
    document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(count)]
    return document


def slow_model():
    """The text of a .gltf: a hundred images of 64 MiB each, of which a file may decode 1 GiB."""
    return json.dumps(with_images(100, image_that_fails_at_its_end(4096)))

"""Pictures as PNG files, each row as what differs from the one above, which is quick and packs most of them well."""

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

QUICK = 1
"""How hard they are packed."""
_TYPES = {(np.dtype(np.uint8), 3): (8, 2), (np.dtype(np.uint16), 2): (16, 0)}
_UP = 2


def png(picture: NDArray[np.uint8] | NDArray[np.uint16]) -> bytes:
    """The file of a picture: colours (rows, columns, 3) of 8 bits, or numbers (rows, columns) of 16."""
    depth, kind = _TYPES[picture.dtype, picture.ndim]
    rows, columns = picture.shape[:2]
    plain = np.ascontiguousarray(picture, picture.dtype.newbyteorder(">")).view(np.uint8).reshape(rows, -1)
    lines = np.empty((rows, plain.shape[1] + 1), np.uint8)
    lines[:, 0], lines[0, 1:] = _UP, plain[0]
    np.subtract(plain[1:], plain[:-1], out=lines[1:, 1:])
    header = struct.pack(">IIBBBBB", columns, rows, depth, kind, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"IDAT", zlib.compress(lines.data, QUICK)) + _chunk(
        b"IEND", b"")


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

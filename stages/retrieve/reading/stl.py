"""STL meshes, binary and text."""

import numpy as np

from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.pieces import Piece, count

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])


def parse(data: bytes, name: str) -> list[Piece]:
    """One piece; corners at the same place become one vertex."""
    corners = _binary(data, name) if _is_binary(data) else _text(data, name)
    if not np.isfinite(corners).all():
        raise Broken(f"{name}: vertices that are not finite numbers")
    vertices, inverse = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    return [Piece(vertices, inverse.reshape(-1, 3).astype(np.int64))]


def _is_binary(data: bytes) -> bool:
    # Some binary files begin with "solid" too; the length settles it.
    return len(data) >= 84 and len(data) >= 84 + 50 * int.from_bytes(data[80:84], "little") or not data[:5] == b"solid"


def _binary(data: bytes, name: str) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    if len(data) < 84:
        raise Broken(f"{name}: ends early")
    faces = int.from_bytes(data[80:84], "little")
    count(3 * faces, faces, name)
    if len(data) < 84 + 50 * faces:
        raise Broken(f"{name}: ends early, {faces} faces announced")
    return np.frombuffer(data, _RECORD, faces, 84)["corners"].astype(np.float64)


def _text(data: bytes, name: str) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    lines = (line.split() for line in data.decode("ascii", errors="replace").splitlines())
    try:
        points = [[float(v) for v in words[1:4]] for words in lines if words[:1] == ["vertex"]]
        return np.asarray(points, float).reshape(-1, 3, 3)
    except ValueError:
        raise Broken(f"{name}: not a text STL") from None

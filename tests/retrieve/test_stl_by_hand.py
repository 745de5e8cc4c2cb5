"""STL files of a few bytes."""

import struct

import numpy as np
import pytest

from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.stl import parse

CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0.5))
FACE = struct.pack("<12fH", 0, 0, 0, *np.ravel(CORNERS), 0)


def binary(announced: int, faces: int, head: bytes = b"by hand") -> bytes:
    return head.ljust(80) + struct.pack("<I", announced) + FACE * faces


@pytest.mark.parametrize("head", [b"by hand", b"solid as some programs begin"])
def test_a_triangle(head: bytes) -> None:
    (piece,) = parse(binary(1, 1, head), "m.stl")
    assert sorted(map(tuple, piece.vertices[piece.faces[0]].tolist())) == sorted(CORNERS)


def test_files_that_end_early_say_how() -> None:
    with pytest.raises(Broken, match="m.stl: ends early, 5 faces announced"):
        parse(binary(5, 0), "m.stl")
    with pytest.raises(Broken, match="m.stl: ends early, 2 faces announced"):
        parse(binary(2, 1), "m.stl")
    with pytest.raises(Broken, match="m.stl: ends early$"):
        parse(binary(0, 0)[:-1], "m.stl")

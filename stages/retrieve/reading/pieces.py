"""What every reader makes of its files, before units, frame and joints are settled."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.retrieve.reading.limits import FACES, VERTICES, Broken
from apartgen.stages.things.asset import Material

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Piece:
    """A mesh of one material in the file's frame: `vertices` (n, 3), `faces` (m, 3), `uv` (n, 2)."""

    vertices: Array
    faces: NDArray[np.int64]
    material: Material = field(default_factory=lambda: Material("plain"))
    uv: Array | None = None

    def moved(self, matrix: Array) -> "Piece":
        """Under a 4 × 4 transform; a mirroring one turns the faces round."""
        vertices = self.vertices @ matrix[:3, :3].T + matrix[:3, 3]
        flipped = float(np.linalg.det(matrix[:3, :3])) < 0
        return Piece(vertices, self.faces[:, ::-1] if flipped else self.faces, self.material, self.uv)


def sound(piece: Piece, name: str) -> Piece:
    """The piece if its numbers make sense, its degenerate faces dropped; Broken otherwise."""
    count(len(piece.vertices), len(piece.faces), name)
    if not np.isfinite(piece.vertices).all():
        raise Broken(f"{name}: vertices that are not finite numbers")
    if len(piece.faces) and (piece.faces.min() < 0 or piece.faces.max() >= len(piece.vertices)):
        raise Broken(f"{name}: faces refer to vertices that do not exist")
    a, b, c = np.moveaxis(piece.vertices[piece.faces], 1, 0)
    solid = np.linalg.norm(np.cross(b - a, c - a), axis=1) > 1e-12
    uv = piece.uv if piece.uv is not None and np.isfinite(piece.uv).all() else None
    return Piece(piece.vertices, piece.faces[solid], piece.material, uv)


def count(vertices: int, faces: int, name: str) -> None:
    """Broken when a mesh is larger than accepted."""
    if faces > FACES or vertices > VERTICES:
        raise Broken(f"{name}: {faces} faces and {vertices} vertices, more than the {FACES} and {VERTICES} accepted")


def gathered(groups: Iterable[Iterable[Piece]], name: str) -> list[Piece]:
    """All pieces in one list; Broken as soon as together they are more than is accepted."""
    found: list[Piece] = []
    vertices = faces = 0
    for piece in (piece for group in groups for piece in group):
        vertices, faces = vertices + len(piece.vertices), faces + len(piece.faces)
        count(vertices, faces, name)
        found.append(piece)
    return found

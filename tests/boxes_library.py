"""A library of plain boxes in any size a category allows."""

import numpy as np

from stages.asset import Asset, Link, Material, Mesh
from stages.categories import TABLE

FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                  [0, 6, 4], [1, 5, 7], [1, 7, 3]])


class Boxes:
    """Assets are boxes; `asked` counts the searches."""

    def __init__(self) -> None:
        self.asked = 0

    def nearest(self, category, size, latent, limit=None):
        self.asked += 1
        kind = TABLE[category]
        wanted = np.clip(size, kind.min, kind.max)
        if limit is not None:
            wanted = np.minimum(wanted, limit)
        if (wanted < np.asarray(kind.min) - 1e-9).any():
            return None
        size = tuple(float(s) for s in wanted)
        corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.array(size) / 2
        mesh = Mesh(corners, FACES, Material("plain"))
        name = "x".join(f"{s:.3f}" for s in size)
        return Asset("boxes", name, category, "plain", size, [Link("body", [mesh], [], 1.0)])


class Empty:
    """A library with nothing smaller."""

    def nearest(self, category, size, latent, limit=None):
        return None

"""A library of plain boxes in any size a category allows, with fronts that open as the category says.

What a home holds already is boxes, too: `of(home)` makes these known.
"""

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.schemas.retrieve import Joint
from apartgen.stages.things.asset import Asset, Link, Material, Mesh
from apartgen.stages.things.categories import DRAWER_TRAVEL, TABLE, leaves
from apartgen.stages.things.solids import slab

FRONT = 0.02

FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6],
                  [0, 6, 4], [1, 5, 7], [1, 7, 3]])


def joints(category, size):
    """Leaves hung in turn on their left and right, one drawer, or one flap, as wide as the box."""
    d, w, h = size
    kind = TABLE[category]
    front, back = d / 2, d / 2 - FRONT
    if kind.opens == "drawer":
        extent = ((-d / 2 + 0.02, -w / 2, -h / 2), (front, w / 2, h / 2))
        return [Joint(name="drawer", type="slide", axis=(1, 0, 0), origin=(0, 0, 0), range=(0, DRAWER_TRAVEL * d),
                      part="slider_drawer", extent=extent)]
    if kind.opens == "flap":
        extent = ((back, -w / 2, -h / 2), (front, w / 2, -h / 2 + kind.flap * h))
        return [Joint(name="flap", type="hinge", axis=(0, 1, 0), origin=(front, 0, -h / 2), range=(0, np.pi / 2),
                      part="hinge_door", extent=extent)]
    if kind.opens == "leaf":
        n = leaves(category, w)
        return [_leaf(i, w / n, -w / 2 + i * w / n, back, front, h) for i in range(n)]
    return []


def _leaf(i, width, right, back, front, h):
    left_hung = i % 2 == 1
    return Joint(name=f"leaf_{i}", type="hinge", axis=(0, 0, 1 if left_hung else -1),
                 origin=(front, right + width * left_hung, 0), range=(0, np.pi / 2), part="hinge_door",
                 extent=((back, right, -h / 2), (front, right + width, h / 2)))


class Boxes:
    """Assets are boxes; `asked` counts the searches."""

    def __init__(self) -> None:
        self.asked = 0
        self.known = {}

    def of(self, home):
        """The library with what a home's objects are made of; of several with one key, the first."""
        for o in home.objects:
            self.known.setdefault((o.asset.library, o.asset.id), _boxes(o))
        return self

    def nearest(self, category, size, latent, limit=None, like=""):
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
        half = np.array(size) / 2
        moving = [Link(joint.name, [], [slab(*joint.extent)], 1.0, joint) for joint in joints(category, size)]
        return Asset("boxes", name, category, "plain", size, [Link("body", [mesh], [slab(-half, half)], 1.0), *moving])

    def alternatives(self, category, size, latent, like=""):
        return []

    def load_asset(self, library, id):
        if (library, id) not in self.known:
            raise BadInput(f"asset library {library!r} is not open")
        return self.known[library, id]


def _boxes(o):
    half = np.asarray(o.size) / 2
    parts = [Link(j.name, [], [slab(*j.extent)], 0.0, j) for j in o.joints if j.extent is not None]
    base = Link("base", [], [slab(-half, half)], 0.0)
    return Asset(o.asset.library, o.asset.id, o.category, "", o.size, [base, *parts])


class Empty(Boxes):
    """A library with nothing smaller."""

    def nearest(self, category, size, latent, limit=None, like=""):
        return None

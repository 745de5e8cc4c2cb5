"""Who looks at what past what stands between: a sofa at its television, an armchair at the low table."""

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.space.boxes import Boxes, of
from apartgen.stages.use import kinds

VIEWS = ((kinds.SOFAS, frozenset({"tv_stand"}), kinds.TABLES),
         (frozenset({"armchair"}), frozenset({"coffee_table"}), frozenset({"armchair"})))
"""Who looks, at what, and what must not stand between."""
TINY = 1e-9
NONE = of(())
Flags = NDArray[np.bool_]


def barred(name: str, boxes: Array, names: Sequence[str], there: Array, leaves: Boxes = NONE) -> Flags:
    """Which candidates (n, 7) make a table stand between a sofa and its television, or an armchair between another one
    and the low table, whichever of these they are; or are armchairs that a door that stands open parts from it."""
    kind, found = kinds.basic(name), np.zeros(len(boxes), bool)
    if kind == "armchair" and leaves.n:
        doors = np.column_stack([leaves.center[:, :2], leaves.yaw, leaves.size[:, :2]])
        tables = [box for o, box in zip(names, there, strict=True) if kinds.basic(o) == "coffee_table"]
        for table, door in product(tables, doors):
            found |= crossed(boxes, table[None], door[None])
    views = [view for view in VIEWS if any(kind in some for some in view)]
    others = [kinds.basic(o) for o in names] if views else []
    for view in views:
        rows = [[k for k, o in enumerate(others) if o in some] for some in view]
        for own in (i for i, some in enumerate(view) if kind in some):
            for row in product(*([-1] if i == own else some for i, some in enumerate(rows))):
                if len(set(row)) == len(row):
                    found |= crossed(*(boxes if k < 0 else there[k][None] for k in row))
    return found


def crossed(one: Array, two: Array, boxes: Array) -> Flags:
    """Whether the way from the middle of one thing to that of another leads through a box, (n, 7) or (1, 7) each."""
    half = boxes[:, 3:5] / 2
    start, end = (np.stack(_turned(thing[:, :2] - boxes[:, :2], boxes[:, 2]), -1) for thing in (one, two))
    way = np.where(np.abs(end - start) < TINY, TINY, end - start)
    enters, leaves = (-half - start) / way, (half - start) / way
    first, last = np.minimum(enters, leaves).max(1), np.maximum(enters, leaves).min(1)
    return np.asarray((first < last) & (last > 0) & (first < 1))


def _turned(offset: Array, yaw: Array) -> tuple[Array, Array]:
    c, s = np.cos(yaw), np.sin(yaw)
    return offset[..., 0] * c + offset[..., 1] * s, offset[..., 1] * c - offset[..., 0] * s

"""The way to the seats of a sofa round a corner, which its chaise and its low table leave: past the open end of the
table, or past that of the sofa."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.layout.relations.company import Seen
from apartgen.stages.layout.relations.tokens import Array, upright
from apartgen.stages.space.boxes import Boxes, stand_in
from apartgen.stages.things.chaises import seat_depth
from apartgen.stages.use import kinds

SOFA, LOW = "corner_sofa", "coffee_table"
WAY, SHALLOW = 0.42, 0.06
"""How wide it is, and so deep in it something is no hindrance yet, m."""
HIGH = 0.9
"""What hangs above is none, m."""
SOLID = kinds.ON_THE_FLOOR - kinds.CHAIRS - kinds.SMALL_SEATS - {SOFA, LOW}
"""What nobody pushes aside to sit down."""
Flags = NDArray[np.bool_]


def shut(name: str, boxes: Array, names: Sequence[str], there: Array, space: Space) -> Flags:
    """Which low tables (n, 7) leave no way to such seats, or what else takes the last one that there is."""
    kind, found = kinds.basic(name), np.zeros(len(boxes), bool)
    others = [kinds.basic(o) for o in names]
    if SOFA not in others or kind not in SOLID | {LOW}:
        return found
    solid = upright(there[[o in SOLID for o in others]])
    sofas, tables = (there[[o == one for o in others]] for one in (SOFA, LOW))
    for sofa in sofas:
        past = _ways(sofa, boxes if kind == LOW else tables)
        taken = [(outside(way, space) > SHALLOW) | stand_in(way, solid, SHALLOW) for way in past]
        if kind == LOW:
            found |= np.all(taken, 0)
        elif len(tables) and not (closed := np.all(taken, 0)).all():
            met = [stand_in(upright(boxes), way.take(~closed), SHALLOW) | one[~closed].any()
                   for way, one in zip(past, taken, strict=True)]
            found |= np.all(met, 0)
    return found


def _ways(sofa: Array, tables: Array) -> tuple[Boxes, Boxes]:
    """Floor past the open end of each low table (n, 7), from the seats on, and past that of the sofa, (n,) each."""
    seen, front = Seen(sofa[None], tables), seat_depth(float(sofa[3])) - float(sofa[3]) / 2
    far, end = seen.x[0] + seen.extent[0, :, 0], seen.y[0] - seen.extent[0, :, 1]
    same = np.ones(len(tables))
    return _floor(sofa, front * same, far, end), _floor(sofa, front * same, (front + WAY) * same, -sofa[4] / 2 * same)


def _floor(sofa: Array, near: Array, far: Array, end: Array) -> Boxes:
    """From `near` to `far` before a sofa's middle, and to the right of an `end`, (n,)."""
    x, y, (c, s) = (near + far) / 2, end - WAY / 2, (np.cos(sofa[2]), np.sin(sofa[2]))
    center = np.column_stack([sofa[0] + c * x - s * y, sofa[1] + s * x + c * y, np.full(len(x), HIGH / 2)])
    size = np.column_stack([far - near, np.full(len(x), WAY), np.full(len(x), HIGH)])
    return Boxes(center.astype(float), size.astype(float), np.full(len(x), float(sofa[2])))

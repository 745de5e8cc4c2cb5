"""Corner units of a finished run are no deeper than what stands beside them, the run round the corner growing up to
them: where its last unit ends is not known when its first is placed."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import order
from apartgen.stages.layout.relations.exchange import valid
from apartgen.stages.layout.relations.runs import BETWEEN, IN_LINE, MORE, local
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

TURNED, NEAR = 0.99, 0.05
"""Sine from which on units look another way, and how far they are apart at most where they are joined, m."""
LITTLE = 0.02
"""What nobody sees, m."""
GROWS = ("kitchen_base", "kitchen_drawers", "kitchen_sink")
"""Units made in any width."""


def squared(there: Furniture, fixed: int, empty: Callable[[], Furniture]) -> Furniture:
    """The furniture with corner units as deep as their line, where one of the row that ends at such a unit's front can
    be so much wider and nothing breaks; the first `fixed` are given and stay."""
    for k in range(fixed, len(there.names)):
        if there.names[k] in kinds.CLOSED and (boxes := _flush(there, k, fixed)) is not None:
            there = valid(there, boxes, empty) or there
    return there


def _flush(there: Furniture, k: int, fixed: int) -> Array | None:
    """All boxes (n, 7) with a corner unit no deeper than its line; None where it is not, or no unit makes up for it."""
    corner, boxes = there.boxes[k], there.boxes
    units = np.array([name in order.runs() for name in there.names]) & (np.arange(len(boxes)) != k)
    x, y = local(boxes[:, :2], corner[:2], float(corner[2]))
    turn = boxes[:, 2] - corner[2]
    beside = units & (np.cos(turn) > TURNED) & (np.abs(np.abs(y) - (corner[4] + boxes[:, 4]) / 2) < NEAR)
    beside &= np.abs(x - (boxes[:, 3] - corner[3]) / 2) < IN_LINE
    more = float(corner[3] - boxes[beside, 3].max(initial=0.0)) - MORE
    row = _row(boxes, units & (np.abs(np.sin(turn)) > TURNED), x, float(corner[3]) / 2)
    grows = next((i for i in row if there.names[i] in GROWS and i >= fixed
                  and boxes[i, 4] + more <= TABLE[there.names[i]].max[1]), None)
    if not beside.any() or more < LITTLE or grows is None or min(row[: row.index(grows) + 1]) < fixed:
        return None
    out = boxes.copy()
    ahead = np.array([np.cos(corner[2]), np.sin(corner[2])])
    out[k, :2] -= more / 2 * ahead
    out[k, 3] -= more
    for i in row[: row.index(grows)]:
        out[_above(boxes, i), :2] -= more * ahead
    out[grows, :2] -= more / 2 * ahead
    out[grows, 4] += more
    return out


def _row(boxes: Array, turned: NDArray[np.bool_], x: Array, front: float) -> list[int]:
    """Units side by side from a corner unit's front on, those nearest first; x of their middles before it."""
    row, edge = list[int](), front
    for i in np.argsort(x, kind="stable").tolist():
        if turned[i] and abs(float(x[i] - boxes[i, 4] / 2) - edge) < NEAR:
            row.append(i)
            edge = float(x[i] + boxes[i, 4] / 2)
    return row


def _above(boxes: Array, i: int) -> NDArray[np.bool_]:
    """A unit and all that is above its middle part."""
    x, y = local(boxes[:, :2], boxes[i, :2], float(boxes[i, 2]))
    found: NDArray[np.bool_] = (np.abs(x) < boxes[i, 3] / 2) & (np.abs(y) < boxes[i, 4] / 4)
    found &= boxes[:, 5] > boxes[i, 6] - BETWEEN
    found[i] = True
    return found

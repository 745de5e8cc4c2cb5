"""How a parallel gripper takes hold of a small thing: across one of its collision pieces, near its centre of mass.

From above where it is narrow enough that way, else across its thickness from a side.
"""

from typing import NamedTuple

import numpy as np

from apartgen.stages.things.asset import Array, Collider, Link
from apartgen.stages.things.body import inertia
from apartgen.stages.things.solids import corners

WIDEST = 0.075
"""A gripper of 80 mm stroke takes nothing wider, m."""
CLEAR = 0.004
"""How much wider than the thing it is open before, m."""
DEEP = 0.02
"""How far the fingers reach over an edge, m."""
MOST = 3
"""So many ways are told of a thing."""
_LEAST = 0.006
"""Pieces lower or thinner than this are not what one holds, m."""
_AXES = np.eye(3)


class Hold(NamedTuple):
    """Where between the jaws, from where they come, along which way they close, in the thing's frame, and how far they
    are open before, m.
    """

    at: Array
    approach: Array
    close: Array
    width: float


def holds(link: Link) -> list[Hold]:
    """The best ways first: from above, near the vertical through the centre of mass."""
    middle = inertia(link).center
    found = [(cost, k, hold) for k, (cost, hold) in enumerate(
        (_cost(hold, middle), hold) for piece in link.colliders for hold in _across(piece, middle))]
    chosen: list[Hold] = []
    for _, _, hold in sorted(found, key=lambda row: row[:2]):
        if len(chosen) < MOST and not any(_alike(hold, other) for other in chosen):
            chosen.append(hold)
    return chosen


def _across(piece: Collider, middle: Array) -> list[Hold]:
    """Ways across a piece: between its sides from above, and between its top and underside from each side."""
    points = corners(piece)
    lo, hi = points.min(0), points.max(0)
    size, center = hi - lo, (lo + hi) / 2
    found = []
    for axis in (0, 1):
        if size[axis] <= WIDEST and size[2] >= _LEAST:
            at = np.clip(middle, lo, hi)
            at[axis] = center[axis]
            at[1 - axis] = center[1 - axis] if piece.kind == "cylinder" else at[1 - axis]
            at[2] = min(max(middle[2], hi[2] - 2 * DEEP), hi[2] - min(DEEP, size[2] / 2))
            found.append(Hold(at, -_AXES[2], _AXES[axis], float(size[axis]) + CLEAR))
    if size[2] <= WIDEST:
        for axis, side in ((0, 1.0), (1, 1.0), (0, -1.0), (1, -1.0)):
            at = center.copy()
            at[1 - axis] = center[1 - axis] if piece.kind == "cylinder" else np.clip(middle, lo, hi)[1 - axis]
            edge = hi[axis] if side > 0 else lo[axis]
            at[axis] = edge - side * min(2 * DEEP, size[axis] / 2)
            found.append(Hold(at, -side * _AXES[axis], _AXES[2], float(size[2]) + CLEAR))
    return found


def _cost(hold: Hold, middle: Array) -> float:
    """How far the weight is off the hold: what turns in the jaws; from above is the better the narrower."""
    off = hold.at - middle
    level = float(np.hypot(off[0], off[1]))
    sideways = 0.0 if hold.approach[2] < -0.5 else 0.03
    return round(level + 0.3 * abs(float(off[2])) + sideways + 0.1 * hold.width, 5)


def _alike(a: Hold, b: Hold) -> bool:
    return bool(np.abs(a.at - b.at).max() < 0.01 and a.approach @ b.approach > 0.9 and abs(a.close @ b.close) > 0.9)

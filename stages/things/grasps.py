"""How a parallel gripper takes hold of a small thing: across one of its collision pieces, near its centre of mass.

From above, from a side and from between where it is narrow enough across, else across its thickness from a side.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.things.asset import Array, Collider, Link
from apartgen.stages.things.body import inertia
from apartgen.stages.things.solids import corners

WIDEST = 0.075
"""A gripper of 80 mm stroke takes nothing wider, m."""
CLEAR = 0.004
"""How much wider than the thing it is open before, m."""
TIP, THICK, BROAD = 0.01, 0.008, 0.02
"""Fingers reach so far beyond where they hold, and are so thick and so broad, m."""
BITES = (0.01, 0.03)
"""How far below or behind an edge a thing is held, m."""
_ABOVE = 0.0015
"""Between the tips and what a thing stands on, m."""
_AXES = np.eye(3)
_UP = _AXES[2]
_BESIDE, _SLANTING, _FLAT = 0.03, 0.02, 0.08
"""What it costs to come from a side, to come slanting, and to close up and down, m off the centre of mass."""


class Hold(NamedTuple):
    """Where between the jaws, from where they come, along which way they close, in the thing's frame, and how far they
    are open before, m.
    """

    at: Array
    approach: Array
    close: Array
    width: float


def holds(link: Link) -> list[Hold]:
    """Every way, the best first: from above, near the vertical through the centre of mass."""
    middle = inertia(link).center
    bounds = [corners(piece) for piece in link.colliders]
    low = min(float(points[:, 2].min()) for points in bounds)
    found = [hold for piece, points in zip(link.colliders, bounds) for hold in _across(piece, points, middle, low)]
    return [found[k] for k in np.argsort(_costs(found, middle), kind="stable")]


def unlike(order: Sequence[int], same: Sequence[Sequence[bool]], most: int) -> list[int]:
    """The first so many of an order of ways that are not nearly the `same`."""
    chosen: list[int] = []
    for k in order:
        if len(chosen) < most and not any(same[k][other] for other in chosen):
            chosen.append(k)
    return chosen


def alike(at: Array, approach: Array, close: Array) -> NDArray[np.bool_]:
    """Which of ways (k, 3) are nearly the same, (k, k)."""
    near = np.abs(at[:, None] - at[None]).max(2, initial=0.0) < 0.01
    return np.asarray(near & (approach @ approach.T > 0.9) & (np.abs(close @ close.T) > 0.9))


def _across(piece: Collider, points: Array, middle: Array, low: float) -> Iterator[Hold]:
    """Ways across a piece of a thing that stands at height `low`."""
    lo, hi = points.min(0), points.max(0)
    size, near = hi - lo, np.minimum(np.maximum(middle, lo), hi)
    for turn in np.arange(4) * np.pi / 4 if piece.kind == "cylinder" else (0.0, np.pi / 2):
        close = np.array([np.cos(turn), np.sin(turn), 0.0]).round(9)
        width = float(piece.size[0] * 2 if piece.kind == "cylinder" else abs(close @ size))
        if width <= WIDEST:
            yield from _between(piece, lo, hi, middle, near, low, close, width + CLEAR)
    if size[2] <= WIDEST:
        for axis, side in ((0, 1.0), (1, 1.0), (0, -1.0), (1, -1.0)):
            at = (lo + hi) / 2
            at[1 - axis] = at[1 - axis] if piece.kind == "cylinder" else near[1 - axis]
            for bite in BITES[::-1]:
                at[axis] = (hi[axis] if side > 0 else lo[axis]) - side * min(bite, size[axis] / 2)
                yield Hold(at.copy(), -side * _AXES[axis], _UP, float(size[2]) + CLEAR)


def _between(
    piece: Collider, lo: Array, hi: Array, middle: Array, near: Array, low: float, close: Array, width: float
) -> Iterator[Hold]:
    """Ways with the jaws level: from above, from both sides, and from between these; `near` is what of the piece is
    nearest to the centre of mass.
    """
    along = np.array([-close[1], close[0], 0.0])
    half, center = float(abs(along @ (hi - lo))) / 2, (lo + hi) / 2
    off = float(along @ (near - center)) if piece.kind == "box" else 0.0
    lowest = low + TIP + _ABOVE
    for z in _heights(hi[2], middle[2], lo[2], lowest):
        for shift in (off, *((off - half / 2, off + half / 2) if piece.kind == "box" and half > BROAD else ())):
            shift = min(max(shift, min(BROAD / 2 - half, 0.0)), max(half - BROAD / 2, 0.0))
            yield Hold(_level(center + shift * along, z), -_UP, close, width)
    deep = [min(bite, half) for bite in BITES] if piece.kind == "box" else [half]
    for side in (1.0, -1.0):
        for z in _heights(hi[2] - 0.002, middle[2], lo[2], max(lowest, low + BROAD / 2 + _ABOVE)):
            for bite in deep:
                yield Hold(_level(center + side * (half - bite) * along, z), -side * along, close, width)
        slanting = (-side * along - _UP) / np.sqrt(2)
        z = max(float(hi[2]) - BITES[0], low + (TIP + BROAD / 2) / np.sqrt(2) + _ABOVE)
        for bite in (half, min(deep[0], half)) if z < hi[2] else ():
            yield Hold(_level(center + side * (half - bite) * along, z), slanting, close, width)


def _heights(top: float, middle: float, bottom: float, lowest: float) -> list[float]:
    """Below the top, and near the middle; at least so high that the tips are clear of the ground."""
    wanted = [top - bite for bite in BITES if top - bite > bottom or bite == BITES[0]]
    wanted += [middle] if bottom < middle < top - 2 * BITES[1] else []
    return sorted({round(max(float(z), lowest), 5) for z in wanted}, reverse=True)


def _level(at: Array, z: float) -> Array:
    return np.array([at[0], at[1], z])


def _costs(found: Sequence[Hold], middle: Array) -> list[float]:
    """How far the weight is off each hold: what turns in the jaws; from above is the better the narrower."""
    x, y, z = (np.array([hold.at for hold in found]).reshape(-1, 3) - middle).T
    down, up = np.array([(hold.approach[2], hold.close[2]) for hold in found]).reshape(-1, 2).T
    way = np.select([up > 0.5, down > -0.5, down > -0.9], [_FLAT, _BESIDE, _SLANTING], 0.0)
    cost = np.hypot(x, y) + 0.3 * np.abs(z) + way + 0.1 * np.array([hold.width for hold in found])
    return [round(value, 5) for value in cost.tolist()]

"""What stands around a place: how near others of a category are, how tokens lie to each other, what is in the way."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import clear, describe
from apartgen.stages.layout.relations.tokens import OBJECT, WALL, Array, Ints, seen

SLACK = 0.015
"""Contact that is none, m; offsets are known to half a bin."""
NEAR = 0.3
"""Others of a category that are so near to a token are at it, m."""


class Known(NamedTuple):
    """`alike` (B, Q, T), how near others of the category asked for are to each token; `relations` (B, J, T, RELATIONS),
    how each lies to each; `there` (B, Q, J), objects that stand; `lacks` (B, Q, T, FITS) free stretches of walls."""

    alike: NDArray[np.float32]
    relations: NDArray[np.float32]
    there: NDArray[np.bool_]
    lacks: NDArray[np.float32]


def known_of(boxes: Array, kind: Ints, category: Ints, asked: Ints, there: Ints, solid: Array, sort: Ints) -> Known:
    """What the first `there` (B, Q) tokens say about where an object `asked` for (B, Q) may be described from; `solid`
    (B, T, 7) and `sort` (B, T) are what they keep others from."""
    view = seen(boxes[:, None], boxes)
    stands = (kind == OBJECT)[:, None] & (np.arange(boxes.shape[1])[None, None] < there[..., None])
    near = alike(view, boxes, category, asked, there)
    free = clear.stretches(
        np.ascontiguousarray(boxes, np.float32), kind == WALL, np.ascontiguousarray(solid, np.float32),
        np.ascontiguousarray(sort), np.ascontiguousarray(there), clear.DEEP)
    lacks = np.maximum(1 - free[..., None] / clear.LONG, 0) * (kind == WALL)[:, None, :, None, None]
    return Known(near, relations(view), stands, lacks.reshape(*lacks.shape[:3], -1).astype(np.float32))


def relations(view: Array) -> NDArray[np.float32]:
    """How tokens lie in the frames of others (B, J, T, 9), as numbers (B, J, T, RELATIONS)."""
    x, y, yaw, ex, ey = (view[..., k] for k in range(5))
    past = np.abs(y) - ey
    return np.stack([x / 3, y / 3, np.cos(yaw), np.sin(yaw), ex, ey, past, np.tanh(3 * past), np.tanh(2 * x),
                     np.log1p(np.abs(x)), np.tanh(3 * (np.abs(x) - ex))], -1).astype(np.float32)


def alike(view: Array, boxes: Array, category: Ints, asked: Ints, there: Ints) -> NDArray[np.float32]:
    """How near to each token others of the category asked for stand, (B, Q, T), 1 at it and 0 far off: boxes (B, T, 7)
    in the frames of each other (B, T, T, 9), category (B, T), asked (B, Q); the first `there` (B, Q) tokens count."""
    past = [np.maximum(np.abs(view[..., k]) - boxes[:, :, None, 3 + k] / 2, 0) for k in (0, 1)]
    near = np.exp(-np.hypot(*past) / NEAR)
    counts = (category[:, None] == asked[..., None]) & (asked[..., None] >= 0)
    counts &= np.arange(boxes.shape[1])[None, None] < there[..., None]
    return np.asarray((near[:, None] * counts[:, :, None]).max(-1), np.float32)


def beside(view: Array, half: Array, kind: Ints, sort: Ints, same: NDArray[np.bool_]) -> NDArray[np.float32]:
    """What stands at each side of references with half extents (R, 2), (R, SIDES, SORTS): others of the category asked
    for, `same` (R, T); and what leaves no room there. Tokens are seen (R, T, 9), their kinds and sorts (R, T)."""
    near = at_sides(view, np.broadcast_to(half[:, None], (*kind.shape, 2)), sort, same)
    return _sides(np.asarray(near.any(1)))


def at_sides(view: Array, half: Array, sort: Ints, same: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether tokens (..., 9) are others of the category asked for at a side of references with half extents (..., 2),
    and whether they leave no room there, (..., SIDES, 2)."""
    side, gap, over = describe.sides(view, half, True)
    gap = np.where(over, 0.0, describe.GAPS[describe.gap_bin(gap)])
    near = np.stack([same & (gap < 2 * NEAR), (sort > 0) & (sort < 3) & (gap < NEAR)], -1)
    return np.asarray(near[..., None, :] & (side[..., None] == np.arange(describe.SIDES))[..., None])


def _sides(near: NDArray[np.bool_]) -> NDArray[np.float32]:
    """As numbers among as many as there are sorts, (R, SIDES, SORTS)."""
    return np.pad(near, ((0, 0), (0, 0), (0, clear.SORTS - 2))).astype(np.float32)


@dataclass
class Met:
    """What keeps objects away: solids (R, T, 9) as seen from references with half extents (R, 2), and their sorts."""

    view: Array
    sort: Ints
    half: Array

    def told(self, said: describe.Attributes, axis: Ints) -> Array:
        """How deep objects stand in what there is, and what they lack of some free room on each side, at every offset
        along an axis (R,), as numbers (R, OFFSETS, MEETS); the other coordinate is that of their gap, or of `along`
        where they are over their reference and the axis is the front."""
        place, half, unknown = standing(said, axis, self.half)
        sort = np.where(unknown[:, None], 0, self.sort)
        there = (np.ascontiguousarray(self.view, np.float32), np.ascontiguousarray(sort), np.ascontiguousarray(axis),
                 place, half, describe.OFFSETS, describe.OFFSET, SLACK)
        lacks = np.maximum(1 - clear.rooms(*there)[..., None] / clear.NEEDS, 0)
        return np.concatenate([clear.depths(*there), lacks.reshape(*lacks.shape[:2], -1)], -1)


def standing(said: describe.Attributes, axis: Ints, own: Array) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Where objects stand whose offset along an axis (R,) is not known yet, as `clear.depths` has it: place (R, 3),
    half extents (R, 2), and whether the other coordinate is not known either; references have half extents `own`
    (R, 2)."""
    ex, ey = describe.extents(said.heading, said.size)
    sign = np.where((said.side == describe.BACK) | (said.side == describe.RIGHT), -1.0, 1.0)
    host, reach = np.where(axis == 1, own[:, 0], own[:, 1]), np.where(axis == 1, ex, ey)
    other = np.where(said.side == describe.OVER, said.along, sign * (host + describe.GAPS[said.gap] + reach))
    place = np.stack([other, said.low, said.low + said.size[..., 2]], -1).astype(np.float32)
    half = np.stack([np.where(axis == 1, ey, ex), reach], -1).astype(np.float32)
    return place, half, (said.side == describe.OVER) & (axis == 1)

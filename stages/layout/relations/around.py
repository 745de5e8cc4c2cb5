"""What stands around a place: how near others of a category are, how tokens lie to each other, what is in the way."""

from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray

from apartgen.stages.layout.relations import clear, describe
from apartgen.stages.layout.relations.network import Known
from apartgen.stages.layout.relations.tokens import OBJECT, WALL, Array, Ints, seen

SLACK = 0.015
"""Contact that is none, m; offsets are known to half a bin."""
NEAR = 0.3
"""Others of a category that are so near to a token are at it, m."""


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
    return Known(torch.from_numpy(near), torch.from_numpy(relations(view)), torch.from_numpy(stands),
                 torch.from_numpy(lacks.reshape(*lacks.shape[:3], -1).astype(np.float32)))


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
    said = describe.describe(view, np.broadcast_to(half[:, None], (*kind.shape, 2)), np.full_like(kind, OBJECT))
    gap = np.where(said.side == describe.OVER, 0.0, describe.GAPS[said.gap])
    out = np.zeros((len(view), describe.SIDES, clear.SORTS), np.float32)
    for k in range(describe.SIDES):
        here = said.side == k
        out[:, k, 0] = (here & same & (gap < 2 * NEAR)).any(1)
        out[:, k, 1] = (here & (sort > 0) & (sort < 3) & (gap < NEAR)).any(1)
    return out


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
        ex, ey = describe.extents(said.heading, said.size)
        sign = np.where((said.side == describe.BACK) | (said.side == describe.RIGHT), -1.0, 1.0)
        own, reach = np.where(axis == 1, self.half[:, 0], self.half[:, 1]), np.where(axis == 1, ex, ey)
        other = np.where(said.side == describe.OVER, said.along, sign * (own + describe.GAPS[said.gap] + reach))
        place = np.stack([other, said.low, said.low + said.size[..., 2]], -1)
        half = np.stack([np.where(axis == 1, ey, ex), reach], -1)
        unknown = (said.side == describe.OVER) & (axis == 1)
        sort = np.where(unknown[:, None], 0, self.sort)
        there = (np.ascontiguousarray(self.view, np.float32), np.ascontiguousarray(sort), np.ascontiguousarray(axis),
                 place.astype(np.float32), half.astype(np.float32), describe.OFFSETS, describe.OFFSET, SLACK)
        lacks = np.maximum(1 - clear.rooms(*there)[..., None] / clear.NEEDS, 0)
        return np.concatenate([clear.depths(*there), lacks.reshape(*lacks.shape[:2], -1)], -1)

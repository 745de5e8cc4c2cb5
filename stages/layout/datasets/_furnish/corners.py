"""Corners of kitchen runs: a closed unit joins the worktops of two legs.

Nothing in a corner could open: its front stands at the sides of its neighbours. So the unit there has no door, and is
so long that what opens on one leg does not meet what opens on the other.
"""

from dataclasses import replace

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors, kernels
from apartgen.stages.layout.datasets._furnish.group import Group, Part, rows
from apartgen.stages.layout.datasets._furnish.legs import VOID, Leg
from apartgen.stages.layout.datasets._furnish.space import TOUCH, Space
from apartgen.stages.space.boxes import Array

NAME = "kitchen_corner"
GAP = 0.003
"""Between units, m."""
TALL = 1.3
"""Between two units higher than this there is no worktop to be joined, m."""
AHEAD = 0.9
"""Units of one leg look the same way, within this cosine."""


def joined(space: Space, path: list[Leg], legs: list[list[Part]], depth: float, height: float,
           apart: bool = True) -> tuple[list[list[Part]], list[Part]] | None:
    """The legs with those at the ends moved away from their corners by as far as units across them open, and a closed
    unit that fills each corner; None where there is no room for that. Where not `apart`, none is moved."""
    if len(path) == 1:
        return legs, []
    legs, fill, cut = [list(leg) for leg in legs], [], depth + VOID - GAP
    for i in range(len(path) - 1):
        before, after = legs[i], legs[i + 1]
        if not before or not after:
            continue
        first = i == 0
        k, out = i if first else i + 1, _out(before[-1], after[0], first) if apart else 0.0
        if out > _spare(space, path[k], legs[k]) and len(path) == 2:
            first, k, out = False, 1, _out(before[-1], after[0], False)
        if out > _spare(space, path[k], legs[k]):
            return None
        legs[k] = [_moved(space, p, path[k].side, -out if first else out) for p in legs[k]]
        if min(before[-1].size[2], after[0].size[2]) <= TALL:
            fill.append(_unit(space, path[i if first else i + 1].side, np.array([cut, cut + out, height]), first))
    return legs, fill


def _out(before: Part, after: Part, first: bool) -> float:
    """How far one of two units at a corner is moved away, m: as far as the other one opens."""
    moved, other = (before, after) if first else (after, before)
    return max(0.0, other.opens - VOID + GAP) if moved.opens > 0 else 0.0


def _spare(space: Space, leg: Leg, some: list[Part]) -> float:
    """How much longer a leg is than its units, m."""
    return leg.high - leg.low - 2 * GAP - float(sum(p.size[1] for p in some))


def _moved(space: Space, p: Part, side: int, by: float) -> Part:
    x, y = space.shape.along[side] * by
    return replace(p, x=p.x + float(x), y=p.y + float(y))


def _unit(space: Space, k: int, size: Array, end: bool) -> Part:
    """With its back to wall `k`, in the corner at its end or at its beginning."""
    shape, size = space.shape, np.round(size, 3)
    along = float(shape.length[k]) - anchors.OFF - size[1] / 2 if end else anchors.OFF + size[1] / 2
    xy = shape.start[k] + shape.along[k] * along + shape.normal[k] * (size[0] / 2 + anchors.OFF)
    return Part(NAME, float(xy[0]), float(xy[1]), size, float(np.arctan2(shape.normal[k, 1], shape.normal[k, 0])))


def hinder(parts: list[Part], apart: bool = True) -> bool:
    """Whether something stands before what opens round a corner from it, or where `apart` opens into what opens."""
    here = rows(Group(tuple(parts)), anchors.free(np.zeros((1, 2)), np.zeros(1)))
    yaw, opens = np.array([p.yaw for p in parts]), np.array([p.opens > 0 for p in parts])
    across = (np.cos(yaw[:, None] - yaw[None]) < AHEAD) & opens[:, None]
    others = np.ascontiguousarray(np.concatenate([here.body[0], here.sweep[0]]))
    forbidden = np.concatenate([across, across & opens[None] & apart], 1)
    return bool(kernels.clash(np.ascontiguousarray(here.sweep), others, forbidden, TOUCH)[0])

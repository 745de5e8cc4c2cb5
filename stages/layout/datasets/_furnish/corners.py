"""Corners of kitchen runs: a closed unit joins the worktops of two legs.

Nothing in a corner could open: its front stands at the sides of its neighbours. So the unit there has no door.
"""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors, kernels
from apartgen.stages.layout.datasets._furnish.group import Group, Part, rows
from apartgen.stages.layout.datasets._furnish.legs import VOID, Leg
from apartgen.stages.layout.datasets._furnish.space import TOUCH, Space

NAME = "kitchen_corner"
GAP = 0.003
"""Between units, m."""
TALL = 1.3
"""Between two units higher than this there is no worktop to be joined, m."""
AHEAD = 0.9
"""Units of one leg look the same way, within this cosine."""


def units(space: Space, path: list[Leg], legs: list[list[Part]], depth: float, height: float) -> list[Part]:
    """A unit for each corner of the path at which units of two legs meet, as deep as wide."""
    shape, size = space.shape, np.round(np.array([depth + VOID - GAP, depth + VOID - GAP, height]), 3)
    out = []
    for leg, before, after in zip(path[:-1], legs[:-1], legs[1:], strict=True):
        if not before or not after or min(before[-1].size[2], after[0].size[2]) > TALL:
            continue
        k = leg.side
        along = float(shape.length[k]) - anchors.OFF - size[1] / 2
        xy = shape.start[k] + shape.along[k] * along + shape.normal[k] * (size[0] / 2 + anchors.OFF)
        yaw = float(np.arctan2(shape.normal[k, 1], shape.normal[k, 0]))
        out.append(Part(NAME, float(xy[0]), float(xy[1]), size, yaw))
    return out


def hinder(parts: list[Part]) -> bool:
    """Whether something stands before what opens round a corner from it, as deep fridges and long flaps do."""
    here = rows(Group(tuple(parts)), anchors.free(np.zeros((1, 2)), np.zeros(1)))
    yaw, opens = np.array([p.yaw for p in parts]), np.array([p.opens > 0 for p in parts])
    across = (np.cos(yaw[:, None] - yaw[None]) < AHEAD) & opens[:, None]
    return bool(kernels.clash(np.ascontiguousarray(here.sweep), np.ascontiguousarray(here.body[0]), across, TOUCH)[0])

"""What a candidate place costs: distance moved, and a price for every requirement it breaks."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stages.boxes import Boxes, penetration
from stages.categories import TABLE, reach
from stages.layout.projection.space import Space, outside

Array = NDArray[np.float64]
SOFT = frozenset(name for name, kind in TABLE.items() if kind.soft)
"""What shares its place with other things."""
SLACK = 0.004
"""Contact that is none, m; half of what metrics allow."""
TURN = 0.5
"""A turn by 90° costs as much as a shift of this many metres."""
BROKEN = 10.0
"""At or above this a place breaks a requirement."""


@dataclass
class Placed:
    """What already stands: boxes, b′, which of it is no hindrance, which is a seat or table with the object, and how
    far (m) the two may be drawn into one another."""

    boxes: Boxes
    grown: Boxes
    soft: NDArray[np.bool_]
    seated: NDArray[np.bool_]
    tuck: Array


def grown(category: str, found: Boxes) -> Boxes:
    """b′: boxes grown in front by what their open parts sweep."""
    far = reach(category, found.size)
    heading = np.stack([np.cos(found.yaw), np.sin(found.yaw)], -1)
    center, size = found.center.copy(), found.size.copy()
    center[..., :2] += heading * far[..., None] / 2
    size[..., 0] += far
    return Boxes(center, size, found.yaw)


def cost(found: Boxes, category: str, center: Array, yaw: float, placed: Placed, space: Space) -> Array:
    """Cost of each candidate (n,) for an object the model put at `center` and `yaw`."""
    moved = np.linalg.norm(found.center[:, :2] - center[:2], axis=1)
    total = moved + TURN * (1 - np.cos(found.yaw - yaw))
    beyond = outside(found, space)
    total += np.where(beyond > SLACK, 40 + 100 * beyond, 0)
    if category in SOFT:
        return np.asarray(total)
    wide = grown(category, found)
    has_reach = wide.size[0, 0] > found.size[0, 0] + 1e-6
    if has_reach:
        total += _price(outside(wide, space), 12)
    if space.zones.n:
        blocked = penetration(found, space.zones)
        total += _price(blocked[:, ~space.window].max(1, initial=-1), 30) + _price(
            blocked[:, space.window].max(1, initial=-1), 12
        )
        if has_reach:
            total += _price(penetration(wide, space.zones)[:, ~space.window].max(1, initial=-1), 6)
    return np.asarray(total + _meetings(found, wide, category, placed, has_reach))


def _meetings(found: Boxes, wide: Boxes, category: str, placed: Placed, has_reach: bool) -> Array:
    """Price of standing in others, of sweeping others, of being swept, and of sweeps that meet."""
    hard = ~placed.soft
    if not hard.any():
        return np.zeros(found.n)
    seated, solid, swept = placed.seated[hard], placed.boxes.take(hard), placed.grown.take(hard)
    depth = penetration(found, solid)
    total = _sum(depth - placed.tuck[hard], 20)
    apart = ~seated
    moving = (swept.size[:, 0] > solid.size[:, 0] + 1e-6) & apart
    if moving.any():
        total = total + _sum(penetration(found, swept.take(moving)), 14)
        if has_reach:
            total = total + _sum(penetration(wide, swept.take(moving)), 10.5)
    if has_reach and apart.any():
        total = total + _sum(penetration(wide, solid.take(apart)), 14)
    return np.asarray(total)


def _price(depth: Array, price: float) -> Array:
    return np.where(depth > SLACK, price + 5 * price * np.maximum(depth, 0), 0)


def _sum(depth: Array, price: float) -> Array:
    return np.asarray(_price(depth, price).sum(1))

"""What a candidate place costs: distance moved, and a price for every requirement it breaks."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection import kernels
from apartgen.stages.layout.projection.kernels import Others, writable
from apartgen.stages.layout.projection.space import Space, outside
from apartgen.stages.space.boxes import Boxes, penetration
from apartgen.stages.things.categories import TABLE, reach

Array = NDArray[np.float64]
SOFT = frozenset(name for name, kind in TABLE.items() if kind.soft)
"""What shares its place with other things."""
HANGINGS = frozenset(name for name, kind in TABLE.items() if kind.soft and kind.place == "wall")
"""Cloth that hangs where a door may open."""
SLACK = 0.004
"""Contact that is none, m; half of what metrics allow."""
TURN = 0.5
"""A turn by 90° costs as much as a shift of this many metres."""
FARTHEST = 4.0
"""A longer way costs no more than this, m; it alone breaks no requirement."""
BROKEN = 10.0
"""At or above this a place breaks a requirement."""


@dataclass
class Meets:
    """For every object (row) of a room: which others hinder it, which are a seat or table with it, and how far the
    two may be drawn into one another, m; all (n, n)."""

    hard: NDArray[np.bool_]
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


def cost(found: Boxes, category: str, center: Array, yaw: float, placed: Others, space: Space) -> Array:
    """Cost of each candidate (n,) for an object the model put at `center` and `yaw`."""
    moved = np.linalg.norm(found.center[:, :2] - center[:2], axis=1)
    way = np.minimum(moved, FARTHEST) + TURN * (1 - np.cos(found.yaw - yaw))
    if category in SOFT:
        beyond = outside(found, space)
        return np.asarray(way + np.where(beyond > SLACK, 40 + 100 * beyond, 0) + _in_swings(found, category, space))
    return kernels.prices(
        writable(found), reach(category, found.size), way, placed, space.kept_clear, space.walls, SLACK, BROKEN)


def _in_swings(found: Boxes, category: str, space: Space) -> Array:
    """Price of cloth that hangs where a door opens."""
    doors = space.zones.take(~space.window)
    if category not in HANGINGS or not doors.n:
        return np.zeros(found.n)
    return _price(penetration(found, doors).max(1), 30)


def standing_costs(boxes: Boxes, wide: Boxes, categories: list[str], meets: "Meets", space: Space) -> Array:
    """What each object (n,) of a room costs where it is, among the others; `wide` are the boxes b′."""
    n = boxes.n
    beyond = outside(boxes, space)
    total = np.where(beyond > SLACK, 40 + 100 * beyond, 0.0)
    soft = np.array([name in SOFT for name in categories], bool)
    opens = (wide.size[:, 0] > boxes.size[:, 0] + 1e-6) & ~soft
    total += np.where(opens, _price(outside(wide, space), 12), 0)
    if space.zones.n:
        blocked = penetration(boxes, space.zones)
        doors, windows = (blocked[:, which].max(1, initial=-1) for which in (~space.window, space.window))
        cloth = np.array([name in HANGINGS for name in categories], bool)
        total += np.where(~soft | cloth, _price(doors, 30), 0) + np.where(soft, 0, _price(windows, 12))
        swept = penetration(wide, space.zones)[:, ~space.window].max(1, initial=-1)
        total += np.where(opens, _price(swept, 6), 0)
    if n < 2:
        return np.asarray(total)
    apart = meets.hard & ~meets.seated
    other_opens = apart & (wide.size[:, 0] > boxes.size[:, 0] + 1e-6)[None]
    body, swept = penetration(boxes), penetration(boxes, wide)
    # penetration(boxes, wide)[i, k] is body i in sweep k, so its transpose is sweep i in body k.
    total += np.where(meets.hard, _price(body - meets.tuck, 20), 0).sum(1)
    total += np.where(other_opens, _price(swept, 14), 0).sum(1)
    total += np.where(other_opens & opens[:, None], _price(penetration(wide), 10.5), 0).sum(1)
    total += np.where(apart & opens[:, None], _price(swept.T, 14), 0).sum(1)
    return np.asarray(total)


def _price(depth: Array, price: float) -> Array:
    return np.where(depth > SLACK, price + 5 * price * np.maximum(depth, 0), 0)

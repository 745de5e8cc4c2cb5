"""Tops that things stand on: at which height, and where on it another one fits."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Polygon

from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.tops import heights

Array = NDArray[np.float64]

CELLS = 12
"""A top is looked at on a grid of CELLS² points."""
FLAT = 0.002
"""Heights within this are one level, m."""
BEYOND = 0.02
"""What is as wide as a top may stand so far beyond its edge, m: out of the way of what is beside it."""
EDGE = 0.01
"""Points this far inside the edge are looked at, m."""
TOUCH = 1e-4
"""What enters another no deeper, m, touches it: turns are written to four digits."""


class Top(NamedTuple):
    """An object others stand on: its box (1), its level surface's height above the floor, and the grid's heights.

    `points` (p, 2) are in its own frame, `clear` (p) says which of them are at the level.
    """

    box: Boxes
    level: float
    points: Array
    clear: NDArray[np.bool_]


def top(asset: Asset, box: Boxes) -> Top:
    """The level that most of an asset's surface seen from above has."""
    half = np.maximum(box.size[0, :2] / 2 - EDGE, 0.001)
    ticks = np.linspace(-1, 1, CELLS)
    points = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), -1).reshape(-1, 2) * half
    z = heights(asset, points)
    seen = z[np.isfinite(z)]
    if not len(seen):
        return Top(box, float(box.center[0, 2] + box.size[0, 2] / 2), points, np.zeros(len(points), bool))
    near = np.abs(seen[:, None] - seen[None]) <= FLAT
    level = float(seen[near[int(np.argmax(near.sum(1)))]].max())
    return Top(box, float(box.center[0, 2] + level), points, np.abs(z - level) <= FLAT)


def _covered(under: Top, item: Boxes) -> tuple[bool, float]:
    """Whether nothing of the top rises into the item, and the share of the item's middle that it carries."""
    seen = boxes.local(under.points @ boxes.axes(under.box)[0] + under.box.center[0, :2], item)[0]
    half = item.size[0, :2] / 2
    under_it = (np.abs(seen) <= half).all(1)
    core = (np.abs(seen) <= np.maximum(half * 0.7, 0.05)).all(1)
    carried = float(under.clear[core].mean()) if core.any() else 0.0
    return bool(under.clear[under_it].all()), carried


def stand(item: Boxes, under: Top, taken: Boxes, floor: Polygon) -> Boxes | None:
    """The item (1) on the top's level, as near as can be to where it was and clear of what stands there already; if
    need be a little beyond the top's edge, as what is wider stands anyhow, as long as that is within the walls."""
    spare = (under.box.size[0, :2] - _turned(item, under)) / 2
    reach = np.maximum(spare, 0)
    for far in (reach, np.maximum(reach, BEYOND)):
        for placed in _spots(item, under, far):
            level, carried = _covered(under, placed)
            clear = not taken.n or boxes.penetration(placed, taken).max() <= TOUCH
            within = (far is reach and (spare >= 0).all()) or floor.covers(boxes.footprints(placed)[0])
            if level and carried > 0.6 and clear and within:
                return placed
    return None


def _spots(item: Boxes, under: Top, far: Array) -> Iterator[Boxes]:
    """The item on the top, its middle so far (2,) from the top's at most, the nearest to where it was first."""
    ticks = np.linspace(-1, 1, 9)
    offsets = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), -1).reshape(-1, 2) * far
    own = boxes.local(item.center[:, :2], under.box)[0]
    spots = np.concatenate([np.clip(own, -far, far), offsets])
    for spot in spots[np.argsort(np.square(spots - own).sum(1), kind="stable")]:
        xy = under.box.center[0, :2] + spot @ boxes.axes(under.box)[0]
        yield item._replace(center=np.array([[*xy, under.level + item.size[0, 2] / 2]]))


def _turned(item: Boxes, under: Top) -> Array:
    """Extents of the item's footprint along the support's axes, (2,)."""
    corners = boxes.local(boxes.corners(item)[0], under.box)[0]
    return np.asarray(np.ptp(corners, axis=0))

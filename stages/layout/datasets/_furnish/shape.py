"""What of a room does not change while it is furnished: walls, zones that stay free, a grid to walk on."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.base import RoomType
from apartgen.stages.layout.datasets._furnish import kernels
from apartgen.stages.space.boxes import Array

DOOR_CLEAR = 0.8
"""Floor kept free in front of every door, m."""
WIDE_CLEAR = 0.6
"""The same for wall-less passages wider than `WIDE`, m."""
WIDE = 1.5
LIGHT = 0.25
"""Nothing higher than the sill stands within this of a window, m."""
HEADROOM = 2.1
LEAF_MARGIN = 0.03
"""Kept free beside a door leaf's quarter circle, m."""
LEAF = 0.1
"""Thickness of an open leaf with its levers, m."""
CELL = 0.08
"""Step of the walking grid, m."""
CLEAR, SWING, WINDOW = 0, 1, 2


@dataclass(frozen=True)
class Hole:
    """An opening in the room's own wall: `a`, `b` on the boundary, counter-clockwise; `kind` as in plans."""

    a: tuple[float, float]
    b: tuple[float, float]
    kind: str
    swings: bool = False
    hinge: int = 0
    sill: float = 0.0
    head: float = 2.1


@dataclass(frozen=True)
class Shape:
    """Sides are (E,) arrays from `start` along `along`, inside towards `normal`; zones are boxes of `zone_kind`."""

    type: RoomType
    height: float
    start: Array
    along: Array
    normal: Array
    length: Array
    area: float
    windows: Array
    """(k, 8): middle x, y, inward normal x, y, half width, sill, head, side."""
    doors: Array
    """(k, 5): middle x, y, inward normal x, y, half width."""
    zone_rows: Array
    """(o, 8): what openings keep free, as the kernels want boxes."""
    zone_kind: NDArray[np.int64]
    grid: Array
    """(rows, columns, 2) points."""
    clear: Array
    """Distance of every grid point to the nearest wall or open door leaf, m; negative outside."""

    @property
    def cell(self) -> float:
        """Step of the grid, m."""
        return CELL

    @cached_property
    def cut(self) -> float:
        """Floor that is cut off in the empty room, m²."""
        part = kernels.parts(np.ascontiguousarray(self.clear >= 0.27))
        sizes = np.bincount(part.ravel())[1:]
        return float(sizes.sum() - sizes.max(initial=0)) * CELL**2

    @property
    def end(self) -> Array:
        """Where each side ends, (E, 2)."""
        return np.roll(self.start, -1, 0)


def of(type: RoomType, corners: Array, holes: list[Hole], height: float) -> Shape:
    """The shape of a room with counter-clockwise corners (E, 2)."""
    corners = _simplified(np.asarray(corners, float))
    step = np.roll(corners, -1, 0) - corners
    length = np.hypot(*step.T)
    along = step / length[:, None]
    normal = np.stack([-along[:, 1], along[:, 0]], 1)
    windows, doors = _holes(holes, corners, normal)
    zones, kind = _zones(holes, corners, normal, height)
    grid = _grid(corners)
    x, y = corners.T
    area = float((x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2)
    clear = kernels.walls_away(grid, corners)
    if leaves := _leaves(holes, corners, normal):
        clear = np.minimum(clear, kernels.away(grid, np.array(leaves), 1.0))
    return Shape(type, height, corners, along, normal, length, area, windows, doors, zones, kind, grid, clear)


def _simplified(corners: Array) -> Array:
    """Without repeated or collinear corners."""
    before, after = corners - np.roll(corners, 1, 0), np.roll(corners, -1, 0) - corners
    turn = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0])
    return corners[turn > 1e-6]


def _side(middle: Array, corners: Array) -> int:
    along = np.roll(corners, -1, 0) - corners
    share = np.clip(((middle - corners) * along).sum(1) / (along**2).sum(1), 0, 1)
    return int(np.argmin(((corners + share[:, None] * along - middle) ** 2).sum(1)))


def _holes(holes: list[Hole], corners: Array, normal: Array) -> tuple[Array, Array]:
    windows, doors = [], []
    for hole in holes:
        a, b = np.array(hole.a), np.array(hole.b)
        middle, half = (a + b) / 2, float(np.hypot(*(b - a))) / 2
        side = _side(middle, corners)
        if hole.kind == "window":
            windows.append([*middle, *normal[side], half, hole.sill, hole.head, side])
        else:
            doors.append([*middle, *normal[side], half])
    return np.array(windows).reshape(-1, 8), np.array(doors).reshape(-1, 5)


def _zones(holes: list[Hole], corners: Array, normal: Array, height: float) -> tuple[Array, NDArray[np.int64]]:
    rows, kinds = [], []
    for hole in holes:
        a, b = np.array(hole.a), np.array(hole.b)
        n = normal[_side((a + b) / 2, corners)]
        wide = float(np.hypot(*(b - a)))
        for kind, depth, lo, hi in _zone(hole, wide, height):
            across = wide + 2 * LEAF_MARGIN * (kind == SWING)
            rows.append([*((a + b) / 2 + n * depth / 2), (lo + hi) / 2, depth, across, hi - lo, *n])
            kinds.append(kind)
    return np.ascontiguousarray(np.array(rows).reshape(-1, 8)), np.array(kinds, np.int64)


def _leaves(holes: list[Hole], corners: Array, normal: Array) -> list[list[float]]:
    """Door leaves standing open at a right angle, as boxes."""
    rows = []
    for hole in holes:
        if hole.swings and hole.kind in ("door", "entrance"):
            a, b = np.array(hole.a), np.array(hole.b)
            n, wide = normal[_side((a + b) / 2, corners)], float(np.hypot(*(b - a)))
            out = (b - a) / wide if hole.hinge == 0 else (a - b) / wide
            at = (hole.a, hole.b)[hole.hinge] + n * wide / 2 + out * LEAF / 2
            rows.append([*at, 1.0, wide, LEAF, 2.0, *n])
    return rows


def _zone(hole: Hole, wide: float, height: float) -> list[tuple[int, float, float, float]]:
    """(kind, depth, lowest, highest) of what an opening keeps free."""
    if hole.kind == "window":
        return [(WINDOW, LIGHT, hole.sill, hole.head)]
    depth = WIDE_CLEAR if wide > WIDE else DOOR_CLEAR
    top = min(HEADROOM, height)
    return [(CLEAR, depth, 0.0, top)] + ([(SWING, wide + 0.04, 0.0, top)] if hole.swings else [])


def _grid(corners: Array) -> Array:
    lo, hi = corners.min(0), corners.max(0)
    x, y = (np.arange(lo[i] + CELL / 2, hi[i], CELL) for i in (0, 1))
    return np.stack(np.meshgrid(x, y, indexing="ij"), -1)

"""The free floor of a room on a raster: what keeps walkers off it, and what that cuts off."""

import copy
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property

import numpy as np
import shapely
from numpy.typing import NDArray

from apartgen.stages.layout.projection import kernels_floor
from apartgen.stages.layout.projection.kernels_floor import Doors, Prices, Raster, Walkers
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Standing
from apartgen.stages.space import boxes, grid
from apartgen.stages.space.boxes import Boxes

RADII = {0.16: 12.0, 0.27: 8.0}
"""Radius of who walks, m: that of the usual metric (0.15) and that of a common robot (0.25), which goes round open
doors, each with room for the raster's error; and how many metres of shifting it is worth that no floor is cut off."""
WIDER = {"hallway": 0.36}
"""Radius of the second by type of room where people walk with things in their hands: .7 m are left between what stands
there."""
BESIDE = 0.16
"""Radius of who is to get beside every object, m."""
UNREACHED = 0.8
"""Getting beside one more object is worth as many metres."""
BEFORE = (0.25, 0.8)
"""So far before the open parts of an object the common robot stands to use it, m."""
CLOSE = 0.3
"""What is no farther from an object that is out of reach may be what shuts it in, m."""
DOOR = 0.2
"""A door shut off counts as this share of the floor."""
SLIVER = 0.02
"""A share of the free floor that may be cut off."""
LOW, FLAT = 1.5, 0.03
"""What hangs with its centre above, or rises no higher, is in nobody's way, m."""
Bodies = Mapping[int, Boxes]
Row = tuple[float, float, float, float, float, float]
"""x, y, depth, width, yaw of an object, and how far it opens."""
NOTHING: Bodies = {}
SHUT, HUNG = -1.0, -2.0
"""How far what nobody opens does so, and what hangs above something, over which one gets at it."""
SHUT_ALL: Mapping[int, float] = {}


def walked_in(base: str | None) -> dict[float, float]:
    """Radii of who walks in a room of a type, m, and what each is worth."""
    (first, worth), (second, less) = RADII.items()
    return {first: worth, WIDER.get(base or "", second): less}


class Paths:
    """How many obstacles keep each walker off each cell of a room, (radii, rows, columns), and what stands there."""

    def __init__(self, room: Standing, space: Space, radii: Mapping[float, float] = RADII) -> None:
        self.walkers = Walkers(np.array(list(radii)), np.array(list(radii.values())))
        floor = shapely.Polygon(space.corners)
        self.cells = grid.over(floor)
        self.inner = np.stack([grid.raster(floor.buffer(-r, join_style="mitre"), self.cells) for r in radii])
        self.count = np.zeros(self.inner.shape, np.int16)
        self.bodies: dict[int, Boxes] = {}
        self.rows: dict[int, Row] = {}
        self.known: dict[tuple[tuple[Row, ...], float], float] = {}
        for k in np.flatnonzero(in_the_way(room)):
            self.add(int(k), room.boxes.take([k]))
        before = space.zones.center[~space.window, :2] - self.cells.origin
        column, row = np.clip((before / self.cells.resolution).astype(int), 0, np.array(self.cells.shape[::-1]) - 1).T
        # A door before which a walker has no room, whatever stands there, is nobody's fault.
        self.doors = []
        for r, inner in zip(radii, self.inner, strict=True):
            if r > BESIDE:
                inner &= grid.near(space.leaves, self.cells, r) == 0
            usable = inner[row, column]
            self.doors.append((row[usable], column[usable]))
        rows, columns = (np.concatenate(part) for part in zip(*self.doors, strict=True))
        self.door_cells = Doors(rows, columns, np.repeat(np.arange(len(radii)), [len(rows) for rows, _ in self.doors]))
        self.prices = Prices(SLIVER, DOOR, UNREACHED, self._beside, *BEFORE)

    @cached_property
    def raster(self) -> Raster:
        """The cells as `kernels_floor` takes them."""
        (x, y), (rows, columns) = self.cells.origin, self.cells.shape
        return Raster(float(x), float(y), float(self.cells.resolution), rows, columns)

    def fork(self) -> "Paths":
        """A copy to which others may be added."""
        other = copy.copy(self)
        other.count, other.bodies, other.rows = self.count.copy(), dict(self.bodies), dict(self.rows)
        return other

    def add(self, k: int, box: Boxes, opens: float = SHUT) -> None:
        """Object `k` stands there from now on, and opens so far, m, where the common robot is to use it."""
        self.bodies[k], self.rows[k], self.known = box, _row(box, opens), {}
        kernels_floor.shade(self.count, np.array(self.rows[k]), self.walkers.radii, 1, self.raster)

    def remove(self, k: int) -> None:
        """Object `k` is gone."""
        del self.bodies[k]
        self.known = {}
        kernels_floor.shade(self.count, np.array(self.rows.pop(k)), self.walkers.radii, -1, self.raster)

    def parts(self, which: int) -> tuple[grid.Labels, NDArray[np.int64], int]:
        """Parts of the floor for the walker of a radius, their sizes, and the one with most doors' floor, 0 without
        any."""
        labels, sizes = grid.connected(self.inner[which] & (self.count[which] == 0))
        at_doors = labels[self.doors[which]]
        return labels, sizes, int(at_doors[np.argmax(sizes[at_doors])] if at_doors.any() else sizes.argmax())

    def cut_off(self, limit: float = np.inf, more: Bodies = NOTHING, opens: Mapping[int, float] = SHUT_ALL) -> float:
        """What it is worth, in metres of shifting, to join all parts of the floor, all doors and objects, with `more`
        objects there, of which some open so far; above `limit` only so much of it.

        A share of the floor beyond SLIVER and each door count for each walker, an object out of reach for the first,
        what the last can't use for it.
        """
        return self.cut_off_with([_row(box, opens.get(k, SHUT)) for k, box in more.items()], limit)

    def cut_off_with(self, more: Sequence[Row], limit: float = np.inf) -> float:
        """The same with objects given as rows."""
        what = tuple(more), limit
        if what not in self.known:
            rows = np.array([*self.rows.values(), *more]).reshape(-1, 6)
            self.known[what] = kernels_floor.cut_off(self.inner, self.count, self.walkers, rows, rows[len(self.rows) :],
                                                     self.door_cells, self.raster, self.prices, limit)
        return self.known[what]

    @property
    def _beside(self) -> float:
        return BESIDE + 1.5 * self.cells.resolution

    def unreached(self) -> set[int]:
        """Objects that do not border the part of the floor with the doors."""
        labels, _, home = self.parts(0)
        free = labels == home if home else np.zeros(labels.shape, bool)
        return {k for k, box in self.bodies.items() if not free[self._about(box, self._beside)].any()}

    def _about(self, box: Boxes, radius: float) -> boxes.Mask:
        window, near = grid.shade(box, self.cells, radius)
        found = np.zeros(self.cells.shape, bool)
        found[window] = near > 0
        return found

    def between(self) -> Callable[[int], bool]:
        """Tells whether an object lies between two parts of the floor, shuts a door in, or is out of reach or near
        what is."""
        found = []
        for r in range(len(self.walkers.radii)):
            labels, sizes, _ = self.parts(r)
            found.append(np.where((sizes > SLIVER * sizes.sum())[labels], labels, 0))
        blocked = any((labels[at] == 0).any() for at, labels in zip(self.doors, found, strict=True))
        lost = self.unreached()
        keys = list(self.bodies)
        if lost:
            every = Boxes(*(np.concatenate(part) for part in zip(*self.bodies.values(), strict=True)))
            gaps = boxes.gap(every.take([keys.index(k) for k in sorted(lost)]), every)
            lost |= {k for k, gap in zip(keys, gaps.min(0), strict=True) if gap < CLOSE}

        def borders(k: int) -> bool:
            if blocked or k in lost:
                return True
            for r, labels in zip(self.walkers.radii.tolist(), found, strict=True):
                window, beside = grid.shade(self.bodies[k], self.cells, r + 1.5 * self.cells.resolution)
                touched = np.unique(labels[window][beside > 0])
                if (touched > 0).sum() > 1:
                    return True
            return False

        return borders


def _row(box: Boxes, opens: float) -> Row:
    """Of one box, and how far it opens."""
    (x, y, _), (depth, width, _) = box.center[0].tolist(), box.size[0].tolist()
    return x, y, depth, width, float(box.yaw[0]), opens


def in_the_way(room: Standing) -> NDArray[np.bool_]:
    """What a walker has to go round, (n,)."""
    top = room.boxes.center[:, 2] + room.boxes.size[:, 2] / 2
    return np.asarray(room.there & (room.boxes.center[:, 2] < LOW) & (top > FLAT))

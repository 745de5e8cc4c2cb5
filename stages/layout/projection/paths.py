"""The free floor of a room on a raster: what keeps walkers off it, and what that cuts off."""

from collections.abc import Callable, Mapping

import numpy as np
import shapely
from numpy.typing import NDArray

from stages import boxes, grid
from stages.boxes import Boxes
from stages.layout.projection.space import Space
from stages.layout.projection.standing import Standing

RADII = {0.16: 12.0, 0.27: 8.0}
"""Radius of who walks, m: that of the usual metric (0.15) and that of a common robot (0.25), which goes round open
doors, each with room for the raster's error; and how many metres of shifting it is worth that no floor is cut off."""
BESIDE = 0.16
"""Radius of who is to get beside every object, m."""
UNREACHED = 0.8
"""Getting beside one more object is worth as many metres."""
CLOSE = 0.3
"""What is no farther from an object that is out of reach may be what shuts it in, m."""
DOOR = 0.2
"""A door shut off counts as this share of the floor."""
SLIVER = 0.02
"""A share of the free floor that may be cut off."""
LOW, FLAT = 1.5, 0.03
"""What hangs with its centre above, or rises no higher, is in nobody's way, m."""
Bodies = Mapping[int, Boxes]
Rim = tuple[grid.Window, NDArray[np.bool_]]
NOTHING: Bodies = {}


class Paths:
    """How many obstacles keep each walker off each cell of a room, and what stands there."""

    def __init__(self, room: Standing, space: Space) -> None:
        floor = shapely.Polygon(space.corners)
        self.cells = grid.over(floor)
        self.inner = {r: grid.raster(floor.buffer(-r, join_style="mitre"), self.cells) for r in RADII}
        self.count = {r: np.zeros(self.cells.shape, np.int16) for r in RADII}
        self.bodies: dict[int, Boxes] = {}
        self.rims: dict[int, Rim] = {}
        self.shades: dict[int, list[tuple[grid.Window, grid.Count]]] = {}
        for k in np.flatnonzero(in_the_way(room)):
            self.add(int(k), room.boxes.take([k]))
        before = space.zones.center[~space.window, :2] - self.cells.origin
        column, row = np.clip((before / self.cells.resolution).astype(int), 0, np.array(self.cells.shape[::-1]) - 1).T
        # A door before which a walker has no room, whatever stands there, is nobody's fault.
        self.doors = {}
        for r, inner in self.inner.items():
            if r > BESIDE:
                inner &= grid.near(space.leaves, self.cells, r) == 0
            usable = inner[row, column]
            self.doors[r] = row[usable], column[usable]

    def add(self, k: int, box: Boxes) -> None:
        """Object `k` stands there from now on."""
        self.bodies[k] = box
        self.rims[k] = self._rim(box)
        self.shades[k] = [grid.shade(box, self.cells, r) for r in self.count]
        for count, (window, hit) in zip(self.count.values(), self.shades[k]):
            count[window] += hit

    def remove(self, k: int) -> None:
        """Object `k` is gone."""
        del self.bodies[k], self.rims[k]
        for count, (window, hit) in zip(self.count.values(), self.shades.pop(k)):
            count[window] -= hit

    def parts(self, r: float, more: Bodies = NOTHING) -> tuple[grid.Labels, NDArray[np.int64], int]:
        """Parts of the floor for a walker with `more` objects there, their sizes, and the one with most doors' floor,
        0 without any."""
        free = self.inner[r] & (self.count[r] == 0)
        for box in more.values():
            window, hit = grid.shade(box, self.cells, r)
            free[window] &= hit == 0
        labels, sizes = grid.connected(free)
        at_doors = labels[self.doors[r]]
        return labels, sizes, int(at_doors[np.argmax(sizes[at_doors])] if at_doors.any() else sizes.argmax())

    def cut_off(self, limit: float = np.inf, more: Bodies = NOTHING) -> float:
        """What it is worth, in metres of shifting, to join all parts of the floor, all doors and objects, with `more`
        objects there; above `limit` only so much of it."""
        total = 0.0
        for r, worth in RADII.items():
            labels, sizes, home = self.parts(r, more)
            lost = 1 - sizes[home] / sizes.sum() if sizes[home] else 1.0
            total += worth * (float(lost) if lost > SLIVER else 0.0)
            total += DOOR * worth * float((labels[self.doors[r]] != home).sum())
            if total > limit:
                break
            if r == BESIDE:
                rims = self.rims if not more else self.rims | {k: self._rim(box) for k, box in more.items()}
                total += UNREACHED * len(_apart(rims, labels, home))
        return total

    def unreached(self) -> set[int]:
        """Objects that do not border the part of the floor with the doors."""
        labels, _, home = self.parts(BESIDE)
        return _apart(self.rims, labels, home)

    def _rim(self, box: Boxes) -> Rim:
        window, near = grid.shade(box, self.cells, BESIDE + 1.5 * self.cells.resolution)
        return window, near > 0

    def between(self) -> Callable[[int], bool]:
        """Tells whether an object lies between two parts of the floor, shuts a door in, or is out of reach or near
        what is."""
        found = {}
        for r in RADII:
            labels, sizes, _ = self.parts(r)
            found[r] = np.where((sizes > SLIVER * sizes.sum())[labels], labels, 0)
        blocked = any((labels[self.doors[r]] == 0).any() for r, labels in found.items())
        lost = self.unreached()
        keys = list(self.bodies)
        if lost:
            every = Boxes(*(np.concatenate(part) for part in zip(*self.bodies.values(), strict=True)))
            gaps = boxes.gap(every.take([keys.index(k) for k in sorted(lost)]), every)
            lost |= {k for k, gap in zip(keys, gaps.min(0), strict=True) if gap < CLOSE}

        def borders(k: int) -> bool:
            if blocked or k in lost:
                return True
            for r, labels in found.items():
                window, beside = grid.shade(self.bodies[k], self.cells, r + 1.5 * self.cells.resolution)
                touched = np.unique(labels[window][beside > 0])
                if (touched > 0).sum() > 1:
                    return True
            return False

        return borders


def _apart(rims: Mapping[int, Rim], labels: grid.Labels, home: int) -> set[int]:
    """Objects about which there is nothing of one part of the floor."""
    free = labels == home if home else np.zeros(labels.shape, bool)
    return {k for k, (window, rim) in rims.items() if not (free[window] & rim).any()}


def in_the_way(room: Standing) -> NDArray[np.bool_]:
    """What a walker has to go round, (n,)."""
    top = room.boxes.center[:, 2] + room.boxes.size[:, 2] / 2
    return np.asarray(room.there & (room.boxes.center[:, 2] < LOW) & (top > FLAT))

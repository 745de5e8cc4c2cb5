"""Keeps the free floor of a room in one piece: shifts, tucks in or narrows what cuts a part of it off."""

from collections.abc import Callable, Container
from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import NDArray

from stages import boxes, grid
from stages.boxes import Boxes
from stages.categories import TABLE
from stages.layout.projection import candidates, partners
from stages.layout.projection.costs import BROKEN, SOFT, cost
from stages.layout.projection.space import Space
from stages.layout.projection.standing import Standing, rests_on

Array = NDArray[np.float64]
RADII = {0.15: 12.0, 0.25: 8.0}
"""Radius of who walks, m: that of the usual metric and that of a common robot, which goes round open doors; and how
many metres of shifting it is worth that no floor is cut off from either."""
BESIDE = 0.15
"""Radius of who is to get beside every object, m."""
UNREACHED = 0.8
"""Getting beside one more object is worth as many metres."""
SHUT = 1.5
"""Where so much stays cut off for one thing's sake, that has no place in the room."""
CLOSE = 0.3
"""What is no farther from an object that is out of reach may be what shuts it in, m."""
DOOR = 0.2
"""A door shut off counts as this share of the floor."""
SLIVER = 0.02
"""A share of the free floor that may be cut off."""
LOW, FLAT = 1.5, 0.03
"""What hangs with its centre above, or rises no higher, is in nobody's way, m."""
SHIFTS = (0.05, 0.1, 0.16, 0.24, 0.34, 0.5, 0.7)
NARROWER = (0.92, 0.85, 0.75)
NEAR = 0.7
"""Places farther away than this are not tried, m."""
FAR = 3.0
LITTLE = frozenset({"bin", "plant", "laundry_basket", "side_table", "floor_lamp"})
"""What may go to another corner of the room, as what hangs on the walls; places farther than FAR are not tried, m."""
TRIED, PASSES = 12, 2
LEAST_GAIN = 0.05
RUN_BROKEN = 1.5
"""A unit out of line with its run costs as much as a shift of so many metres."""
PARTED = 0.4
"""Leaving a companion costs this share of what being with it is worth."""
GROUP_GAP = 0.25
"""What belongs with an object and stands as close as this moves along with it, m."""


@dataclass
class Move:
    """Objects that change place together: their indices, boxes (n,) of each, and the price (n,) of each change."""

    members: list[int]
    boxes: list[Boxes]
    price: Array


class Paths:
    """How many obstacles keep each walker off each cell of a room, and what stands there."""

    def __init__(self, room: Standing, space: Space) -> None:
        floor = shapely.Polygon(space.corners)
        self.cells = grid.over(floor)
        self.inner = {r: grid.raster(floor.buffer(-r, join_style="mitre"), self.cells) for r in RADII}
        self.count = {r: np.zeros(self.cells.shape, np.int16) for r in RADII}
        self.bodies: dict[int, Boxes] = {}
        self.rims: dict[int, tuple[grid.Window, NDArray[np.bool_]]] = {}
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
        window, near = grid.shade(box, self.cells, BESIDE + 1.5 * self.cells.resolution)
        self.rims[k] = window, near > 0
        self.shades[k] = [grid.shade(box, self.cells, r) for r in self.count]
        for count, (window, hit) in zip(self.count.values(), self.shades[k]):
            count[window] += hit

    def remove(self, k: int) -> None:
        """Object `k` is gone."""
        del self.bodies[k], self.rims[k]
        for count, (window, hit) in zip(self.count.values(), self.shades.pop(k)):
            count[window] -= hit

    def parts(self, r: float) -> tuple[grid.Labels, NDArray[np.int64], int]:
        """Parts of the floor for a walker, their sizes, and the one with most doors' floor, 0 without any."""
        labels, sizes = grid.connected(self.inner[r] & (self.count[r] == 0))
        at_doors = labels[self.doors[r]]
        return labels, sizes, int(at_doors[np.argmax(sizes[at_doors])] if at_doors.any() else sizes.argmax())

    def cut_off(self, limit: float = np.inf) -> float:
        """What it is worth, in metres of shifting, to join all parts of the floor, all doors and objects; above
        `limit` only so much of it."""
        total = 0.0
        for r, worth in RADII.items():
            labels, sizes, home = self.parts(r)
            lost = 1 - sizes[home] / sizes.sum() if sizes[home] else 1.0
            total += worth * (float(lost) if lost > SLIVER else 0.0)
            total += DOOR * worth * float((labels[self.doors[r]] != home).sum())
            if total > limit:
                break
            if r == BESIDE:
                total += UNREACHED * len(self._apart(labels, home))
        return total

    def unreached(self) -> set[int]:
        """Objects that do not border the part of the floor with the doors."""
        labels, _, home = self.parts(BESIDE)
        return self._apart(labels, home)

    def _apart(self, labels: grid.Labels, home: int) -> set[int]:
        free = labels == home if home else np.zeros(labels.shape, bool)
        return {k for k, (window, rim) in self.rims.items() if not (free[window] & rim).any()}

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


def in_the_way(room: Standing) -> NDArray[np.bool_]:
    """What a walker has to go round, (n,)."""
    top = room.boxes.center[:, 2] + room.boxes.size[:, 2] / 2
    return np.asarray(room.there & (room.boxes.center[:, 2] < LOW) & (top > FLAT))


def join(room: Standing, space: Space, needed: Container[int] = ()) -> int | None:
    """Change places, in place, small things first, while floor can be joined at a price that it is worth.

    Returns what had better leave the room, not one of the `needed`, where the way is still shut; None where it is not.
    """
    paths = Paths(room, space)
    worth = _joined(paths, room, space)
    if worth < SHUT:
        return None
    left = {}
    for k, box in list(paths.bodies.items()):
        if k not in needed and TABLE[room.items[k].category].place == "floor":
            paths.remove(k)
            left[k] = paths.cut_off()
            paths.add(k, box)
    best = min(left, key=left.__getitem__, default=None)
    return best if best is not None and left[best] < worth - SHUT else None


def _joined(paths: Paths, room: Standing, space: Space) -> float:
    """What is still cut off when no move gains any more."""
    worth = paths.cut_off()
    for _ in range(PASSES):
        if worth == 0:
            return worth
        before, borders = worth, paths.between()
        for i in sorted(paths.bodies, key=lambda k: (room.boxes.size[k, :2].prod(), k)):
            category = room.items[i].category
            if TABLE[category].place not in ("floor", "wall") or category in SOFT or not borders(i):
                continue
            tried = [(found, move) for move in moves(i, room, space) if (found := _best(move, paths, worth))]
            if not tried:
                continue
            (_, n), move = min(tried, key=lambda row: row[0][0])
            _apply(move, n, room, paths)
            worth = paths.cut_off()
            if worth == 0:
                return worth
            borders = paths.between()
        if worth == before:
            break
    return worth


def _best(move: Move, paths: Paths, worth: float) -> tuple[float, int] | None:
    """The candidate that leaves the least, and what remains with it; None where none gains."""
    old = {k: paths.bodies[k] for k in move.members if k in paths.bodies}
    for k in old:
        paths.remove(k)
    found: tuple[float, int] | None = None
    limit = worth - LEAST_GAIN
    # What is left without the objects is left wherever they go.
    bound = paths.cut_off(limit)
    for n in np.argsort(move.price, kind="stable")[:TRIED]:
        if move.price[n] + bound >= limit:
            break
        for k, places in zip(move.members, move.boxes):
            if k in old:
                paths.add(k, places.take([n]))
        total = float(move.price[n]) + paths.cut_off(limit - float(move.price[n]))
        if total < limit:
            found, limit = (total, int(n)), total
        for k in old:
            paths.remove(k)
    for k, box in old.items():
        paths.add(k, box)
    return found


def _apply(move: Move, n: int, room: Standing, paths: Paths) -> None:
    for k, places in zip(move.members, move.boxes):
        if k in paths.bodies:
            paths.remove(k)
            paths.add(k, places.take([n]))
        center, size, yaw = places.center[n].copy(), places.size[n].copy(), float(places.yaw[n])
        room.put(k, replace(room.items[k], center=center, size=size, yaw=yaw))


def moves(i: int, room: Standing, space: Space) -> list[Move]:
    """What can be done about object `i`: shifted with its group, placed anew nearby, made narrower."""
    group, alone = _group(i, room), [i, *_carried([i], room)]
    tried = [_rigid(group, _shifts(room.boxes.take([i])), room, space)]
    if len(alone) < len(group):
        tried.append(_rigid(alone, _shifts(room.boxes.take([i])), room, space))
    if len(alone) == 1:
        tried.append(_anew(i, room, space))
        if TABLE[room.items[i].category].place == "floor":
            tried += [_narrower(i, share, room, space) for share in NARROWER]
    return [_valid(move) for move in tried if (move.price < BROKEN).any()]


def _valid(move: Move) -> Move:
    good = np.flatnonzero(move.price < BROKEN)
    return Move(move.members, [places.take(good) for places in move.boxes], move.price[good])


def _carried(members: list[int], room: Standing) -> list[int]:
    """What stands on any of the members."""
    tops = [k for k, o in enumerate(room.items) if room.there[k] and TABLE[o.category].place == "top"]
    return [k for k in tops if k not in members and any(rests_on(room.items[k], room.items[m]) for m in members)]


def _group(i: int, room: Standing) -> list[int]:
    """Object `i`, what stands close by and belongs with it, and what stands on any of them."""
    near = boxes.gap(room.boxes.take([i]), room.boxes)[0]
    members = [i]
    for k, item in enumerate(room.items):
        belongs = room.items[i].category in TABLE[item.category].belongs
        if k != i and room.there[k] and belongs and TABLE[item.category].place == "floor" and near[k] < GROUP_GAP:
            members.append(k)
    return members + _carried(members, room)


def _turned(point: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([c * point[0] - s * point[1], s * point[0] + c * point[1]])


def _shifts(box: Boxes) -> Array:
    """Displacements (n, 2) along the box's own axes."""
    c, s = float(np.cos(box.yaw[0])), float(np.sin(box.yaw[0]))
    ways = np.array([[c, s], [-c, -s], [-s, c], [s, -c]])
    return np.concatenate([d * ways for d in SHIFTS])


def _rigid(members: list[int], shift: Array, room: Standing, space: Space) -> Move:
    """All members moved by each of `shift` (n, 2)."""
    found, price = [], np.linalg.norm(shift, axis=1)
    for k in members:
        item = room.items[k]
        at = np.tile(item.center, (len(shift), 1))
        at[:, :2] += shift
        boxes = Boxes(at, np.tile(item.size, (len(shift), 1)), np.full(len(shift), item.yaw))
        found.append(boxes)
        price = np.maximum(price, _price(k, boxes, members, room, space))
    return Move(members, found, price)


def _price(k: int, places: Boxes, members: list[int], room: Standing, space: Space) -> Array:
    """What each place costs object `k`; members of its group are not in its way."""
    item = room.items[k]
    if TABLE[item.category].place == "top" or not places.n:
        return np.zeros(places.n)
    others = room.others(k, item, members)
    price = cost(places, item.category, item.center, item.yaw, others, space)
    if TABLE[item.category].back:
        price = price + np.where(space.behind(places) > 0.05, 2.0, 0.0)
    standing, names = room.standing(k, members)
    here = Boxes(item.center[None], item.size[None], np.array([item.yaw]))
    if partners.in_run(item.category, here, standing, names)[0]:
        price = price + np.where(partners.in_run(item.category, places, standing, names), 0.0, RUN_BROKEN)
    spots, worth = partners.beside(item.category, item.center, item.size, standing, names)
    if spots.n and _at(here, spots)[0].any():
        price = price + np.where(_at(places, spots).any(1), 0.0, PARTED * worth.max())
    return np.asarray(price)


def _at(places: Boxes, spots: Boxes) -> NDArray[np.bool_]:
    """Which places (n,) are which of the spots (m,), (n, m)."""
    return np.asarray(np.linalg.norm(places.center[:, None, :2] - spots.center[None, :, :2], axis=-1) < 0.05)


def _anew(i: int, room: Standing, space: Space) -> Move:
    """Along the walls and at partners, not far from where it is."""
    item = room.items[i]
    standing, names = room.standing(i)
    parts = [partners.beside(item.category, item.center, item.size, standing, names)[0]]
    if TABLE[item.category].back or item.category in LITTLE:
        parts.append(candidates.along_walls(item.center, item.size, space, standing))
    found = candidates.join(parts)
    near = FAR if item.category in LITTLE or TABLE[item.category].place == "wall" else NEAR
    found = found.take(np.linalg.norm(found.center[:, :2] - item.center[:2], axis=1) < near)
    if TABLE[item.category].place == "wall":
        found = found.take(space.behind(found) < 0.03)
    return Move([i], [found], _price(i, found, [i], room, space))


def _narrower(i: int, share: float, room: Standing, space: Space) -> Move:
    """Less deep with its back where it is, and less wide about its middle or to either end."""
    item = room.items[i]
    depth, width = item.size[0], item.size[1]
    least = TABLE[item.category].min
    thin, slim = max(depth * share, least[0]), max(width * share, least[1])
    rows = [(thin, width, (thin - depth) / 2, 0.0)]
    rows += [(depth, slim, 0.0, side * (width - slim) / 2) for side in (-1, 0, 1)]
    rows += [(thin, slim, (thin - depth) / 2, side * (width - slim) / 2) for side in (-1, 0, 1)]
    at = np.array([[*(item.center[:2] + _turned(np.array([x, y]), item.yaw)), item.center[2]] for _, _, x, y in rows])
    size = np.array([[d, w, item.size[2]] for d, w, _, _ in rows])
    boxes = Boxes(at, size, np.full(len(rows), item.yaw))
    # A smaller thing than wanted is a loss like a shift.
    return Move([i], [boxes], _price(i, boxes, [i], room, space) + 2 * (depth + width - size[:, :2].sum(1)))

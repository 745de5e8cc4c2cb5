"""What can be done about an object in the way: it is shifted with its group, placed anew nearby, or made narrower."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection import candidates, partners
from apartgen.stages.layout.projection.costs import BROKEN, cost
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Standing, rests_on
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE

Array = NDArray[np.float64]
SHIFTS = (0.05, 0.1, 0.16, 0.24, 0.34, 0.5, 0.7)
NARROWER = (0.92, 0.85, 0.75)
MOVES_WITHIN = 0.7
"""Places farther away than this are not tried, m."""
FAR = 3.0
"""What may go to another corner of the room, as what hangs on the walls, goes no farther than this, m."""
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


def moves(i: int, room: Standing, space: Space) -> list[Move]:
    """What can be done about object `i`: shifted with its group, placed anew nearby, made narrower."""
    together, alone = group(i, room), [i, *_carried([i], room)]
    tried = [_rigid(together, _shifts(room.boxes.take([i])), room, space)]
    if len(alone) < len(together):
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


def group(i: int, room: Standing) -> list[int]:
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
    kind = TABLE[item.category]
    if kind.back or kind.stands.anywhere:
        parts.append(candidates.along_walls(item.center, item.size, space, standing))
    found = candidates.join(parts)
    near = FAR if kind.stands.anywhere or kind.place == "wall" else MOVES_WITHIN
    found = found.take(np.linalg.norm(found.center[:, :2] - item.center[:2], axis=1) < near)
    if kind.place == "wall":
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

"""Keeps the free floor of a room in one piece: shifts, tucks in or narrows what cuts a part of it off."""

from collections.abc import Container, Iterable
from dataclasses import replace
from itertools import combinations

import numpy as np

from apartgen.stages.layout.projection.costs import SOFT
from apartgen.stages.layout.projection.moves import Move, group, moves
from apartgen.stages.layout.projection.paths import Paths
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Standing
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE

SHUT = 1.5
"""Where so much stays cut off for one thing's sake, that has no place in the room."""
TRIED, PASSES, MOST = 12, 2, 7
LEAST_GAIN = 0.05


def join(room: Standing, space: Space, needed: Container[int] = ()) -> int | None:
    """Change places, in place, small things first, while floor can be joined at a price that it is worth.

    Returns what had better leave the room, not one of the `needed`, where the way is still shut; None where it is not.
    """
    paths = Paths(room, space)
    return in_its_way(paths, room, needed) if _joined(paths, room, space) >= SHUT else None


def in_its_way(paths: Paths, room: Standing, needed: Container[int]) -> int | None:
    """What shuts the way, alone or together with one other thing; the smaller of two."""
    worth = paths.cut_off()
    spare = [k for k in paths.bodies if k not in needed and TABLE[room.items[k].category].place == "floor"]
    left: dict[tuple[int, ...], float] = {(k,): _without((k,), paths) for k in spare}
    if min(left.values(), default=worth) > worth - SHUT:
        small = sorted(spare, key=lambda k: float(room.boxes.size[k, :2].prod()))[:MOST]
        left = {pair: _without(pair, paths) for pair in combinations(small, 2)}
    best = min(left, key=left.__getitem__, default=None)
    if best is None or left[best] > worth - SHUT * len(best):
        return None
    return best[0]


def _without(members: tuple[int, ...], paths: Paths) -> float:
    """What is cut off once some objects are gone."""
    old = _taken_out(members, paths)
    left = paths.cut_off()
    _put_back(old, paths)
    return left


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
            found = _best(i, paths, room, space, worth)
            if found is None:
                continue
            _apply(*found, room, paths)
            worth = paths.cut_off()
            if worth == 0:
                return worth
            borders = paths.between()
        if worth == before:
            break
    return worth


def _best(i: int, paths: Paths, room: Standing, space: Space, worth: float) -> tuple[Move, int] | None:
    """The change of place of object `i` that leaves the least; None where none gains."""
    best: tuple[Move, int] | None = None
    limit = worth - LEAST_GAIN
    bounds: dict[tuple[int, ...], float] = {}
    if _left_without(group(i, room), paths, limit, bounds) >= limit:
        return None
    for move in moves(i, room, space):
        bound = _left_without(move.members, paths, limit, bounds)
        old = _taken_out(move.members, paths)
        for n in np.argsort(move.price, kind="stable")[:TRIED]:
            if move.price[n] + bound >= limit:
                break
            there = {k: places.take([n]) for k, places in zip(move.members, move.boxes) if k in old}
            total = float(move.price[n]) + paths.cut_off(limit - float(move.price[n]), there)
            if total < limit:
                best, limit = (move, int(n)), total
        _put_back(old, paths)
    return best


def _left_without(members: list[int], paths: Paths, limit: float, known: dict[tuple[int, ...], float]) -> float:
    """What is left without some objects, which is left wherever they go; above `limit` only so much of it."""
    key = tuple(members)
    if key not in known:
        old = _taken_out(members, paths)
        known[key] = paths.cut_off(limit)
        _put_back(old, paths)
    return known[key]


def _taken_out(members: Iterable[int], paths: Paths) -> dict[int, Boxes]:
    old = {k: paths.bodies[k] for k in members if k in paths.bodies}
    for k in old:
        paths.remove(k)
    return old


def _put_back(old: dict[int, Boxes], paths: Paths) -> None:
    for k, box in old.items():
        paths.add(k, box)


def _apply(move: Move, n: int, room: Standing, paths: Paths) -> None:
    for k, places in zip(move.members, move.boxes):
        if k in paths.bodies:
            paths.remove(k)
            paths.add(k, places.take([n]))
        center, size, yaw = places.center[n].copy(), places.size[n].copy(), float(places.yaw[n])
        room.put(k, replace(room.items[k], center=center, size=size, yaw=yaw))

"""The projection of one room."""

from collections.abc import Container
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection import passage, runs
from apartgen.stages.layout.projection.costs import BROKEN
from apartgen.stages.layout.projection.habits import belongs_to, habits
from apartgen.stages.layout.projection.partners import BEDSIDE, SCREENS, SOFAS, WATCH, long_enough, watched
from apartgen.stages.layout.projection.placing import place
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Item, Standing
from apartgen.stages.space.boxes import gap
from apartgen.stages.things.categories import SEATS, TABLE, used_for

Array = NDArray[np.float64]
SHRINKS = (0.9, 0.8, 0.7, 0.6)
ROUNDS = 3
HEADROOM = 2.1
AT_TABLES = frozenset(name for name in SEATS if any(habit.how == "seat" for habit in habits().get(name, ())))
"""What one sits on at a table."""
ASTRAY = 0.35
"""A seat no farther from a table stands at it, m."""


def project(items: list[Item], space: Space, essential: Container[int] = ()) -> list[Item]:
    """The items in their order, each at its place; the `essential` ones choose before others of their kind."""
    wanted = _laid(runs.alike([replace(item, size=_clamped(item, space)) for item in items]))
    order = sorted(range(len(items)), key=lambda i: _rank(i, wanted, essential))
    room = Standing(wanted)
    runs.place(runs.line(wanted), room, space)
    for i in order:
        if not room.there[i]:
            room.put(i, place(i, wanted[i], room, space, wide=False))
    _turn_to_screen(order, wanted, room, space)
    for attempt in range(ROUNDS):
        broken = _at_fault(room, space, order) if attempt < ROUNDS - 1 else _broken(room, space)
        if not broken:
            break
        # Seats leave with their table and come back to it.
        follow = {k for k in order if any(belongs_to(wanted[k].category, wanted[i].category) for i in broken)}
        room.there[list(follow)] = False
        for i in order:
            if i in broken or i in follow:
                room.put(i, _largest(i, _shapes(wanted[i], attempt), room, space, wide=attempt > 0))
    before = room.boxes.center[:, :2].copy()
    in_the_way = passage.join(room, space, essential)
    _follow(np.flatnonzero(np.abs(room.boxes.center[:, :2] - before).max(1, initial=0) > 0.01), order, room, space)
    for item, cost_there, given in zip(room.items, room.costs(space), items, strict=True):
        item.cost = float(cost_there)
        item.moved = float(np.linalg.norm(item.center[:2] - given.center[:2]))
    astray = _astray(room, essential)
    out = in_the_way if in_the_way is not None else astray
    if out is not None:
        room.items[out].cost += BROKEN
    return room.items


def _laid(items: list[Item]) -> list[Item]:
    """The items, the only dining table long enough for the chairs."""
    chairs = sum(TABLE[item.category].stands.diner for item in items)
    tables = [i for i, item in enumerate(items) if TABLE[item.category].stands.widens]
    if len(tables) != 1:
        return items
    table = items[tables[0]]
    laid = replace(table, size=long_enough(table.category, table.size, chairs))
    return [laid if item is table else item for item in items]


def _turn_to_screen(order: list[int], wanted: list[Item], room: Standing, space: Space) -> None:
    """A sofa that does not see the television's stand from in front is placed anew, and what belongs with it."""
    for i in order:
        others, names = room.standing(i)
        stands = others.take(np.array([name in SCREENS for name in names], bool))
        if room.items[i].category not in SOFAS or not stands.n:
            continue
        if watched(stands, room.boxes.take([i]), [room.items[i].category])[0] >= WATCH / 2:
            continue
        with_it = [k for k in order if belongs_to(wanted[k].category, wanted[i].category)]
        room.there[[i, *with_it]] = False
        for k in (i, *with_it):
            room.put(k, place(k, wanted[k], room, space, wide=False))


def _astray(room: Standing, essential: Container[int]) -> int | None:
    """The seat farthest from any table that it could stand at, which has no place in a room that has such tables."""
    found: dict[int, float] = {}
    for i, item in enumerate(room.items):
        tables = [k for k, other in enumerate(room.items) if belongs_to(item.category, other.category)]
        if item.category in AT_TABLES and i not in essential and tables:
            found[i] = float(gap(room.boxes.take([i]), room.boxes.take(tables)).min())
    worst = max(found, key=found.__getitem__, default=None)
    return worst if worst is not None and found[worst] > ASTRAY else None


def _follow(moved: NDArray[np.intp], order: list[int], room: Standing, space: Space) -> None:
    """Rugs, lamps and what hangs at the wall go along with what moved, where they find a place."""
    names = {room.items[k].category for k in moved}
    for i in order:
        old = room.items[i]
        if TABLE[old.category].place in ("floor", "top") or not any(belongs_to(old.category, name) for name in names):
            continue
        room.there[i] = False
        new = place(i, old, room, space, wide=False)
        room.put(i, new if new.cost < BROKEN else old)


def _broken(room: Standing, space: Space) -> set[int]:
    """What breaks a requirement where it is."""
    return set(np.flatnonzero(room.there & (room.costs(space) >= BROKEN)).tolist())


def _at_fault(room: Standing, space: Space, order: list[int]) -> set[int]:
    """What has to go so that nothing is broken, of any two the one that chose later; it has no place from now on."""
    gone: set[int] = set()
    while broken := _broken(room, space):
        worst = max(broken, key=order.index)
        room.there[worst] = False
        gone.add(worst)
    return gone


def _clamped(item: Item, space: Space) -> Array:
    """Its size within what there is of its category; what hangs from the ceiling leaves headroom."""
    kind = TABLE[item.category]
    size = np.clip(item.size, kind.min, kind.max)
    if kind.place == "ceiling":
        size[2] = min(size[2], max(kind.min[2], space.height - HEADROOM))
    return np.asarray(size)


def _rank(i: int, items: list[Item], essential: Container[int]) -> tuple[int, bool, float]:
    """Parents before children, floor before walls before what stands on top; large before small."""
    item, first = items[i], i in essential
    kind = TABLE[item.category]
    level = {"floor": 0, "wall": 3, "top": 4, "flat": 5, "ceiling": 6}[kind.place]
    if kind.place == "floor" and kind.belongs and any(other.category in kind.belongs for other in items):
        # A nightstand is placed right after the bed: nothing else may take its place.
        if item.category in BEDSIDE:
            return 0, False, 0.0
        level = 1
    tables = [k for k, other in enumerate(items) if other.category in used_for("dine")]
    if kind.stands.diner and tables:
        # Right after the table, as armchairs and cabinets would take their places.
        level, late, size = max(_rank(k, items, essential) for k in tables)
        return level, late, size + 0.01
    sofas = [float(other.size[0] * other.size[1]) for other in items if other.category in SOFAS]
    if item.category in SCREENS and sofas:
        # Right after the sofas: the place across from them shall not be taken.
        return level, not first, 0.01 - min(sofas)
    first &= not (kind.is_for("lounge") and item.category not in SOFAS and bool(sofas))
    return level, not first, -float(item.size[0] * item.size[1]) * (1.5 if kind.back else 1.0)


def _shapes(item: Item, attempt: int) -> list[Item]:
    """The item as wanted and, from the second round on, smaller ones."""
    if attempt == 0:
        return [item]
    low = np.array(TABLE[item.category].min)
    return [item, *(replace(item, size=np.maximum(item.size * s, low)) for s in SHRINKS)]


def _largest(i: int, shapes: list[Item], room: Standing, space: Space, wide: bool) -> Item:
    """The first shape with a place that breaks nothing, else the cheapest."""
    tried: list[Item] = []
    for shape in shapes:
        tried.append(place(i, shape, room, space, wide))
        if tried[-1].cost < BROKEN:
            return tried[-1]
    return min(tried, key=lambda item: item.cost)

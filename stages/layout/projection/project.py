"""The projection of one room."""

from collections.abc import Container
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from stages.boxes import Boxes, gap
from stages.categories import SEATS, TABLE
from stages.layout.projection import candidates, comfort, passage, runs
from stages.layout.projection.costs import BROKEN, cost
from stages.layout.projection.habits import belongs_to
from stages.layout.projection.partners import FLUSH, SOFAS, WATCH, bedsides, beside, in_run, watched
from stages.layout.projection.space import Space
from stages.layout.projection.standing import Item, Standing
from stages.layout.projection.supports import on_support

Array = NDArray[np.float64]
LEAN = {"bench": 3.0, "sofa": 0.9, "corner_sofa": 0.9, "floor_lamp": 1.5, "coat_rack": 3.0, "side_table": 0.4,
        "bin": 3.0, "plant": 3.0, "laundry_basket": 3.0}
NEAR = 0.12
"""Things that need no wall still stand flush with one as near as LEAN says, NEAR otherwise, m."""
SHRINKS = (0.9, 0.8, 0.7, 0.6)
FLUSH_WITH = 0.03
"""What hangs at a wall is no farther from it, m."""
WINDOW_MARGIN = 0.15
ROOM_BESIDE = 1.0
"""Room for a nightstand is worth a shift of the bed by as much, m."""
ROUNDS = 3
HEADROOM = 2.1
LOOSE = frozenset({"plant", "pouffe"})
"""What people leave at any angle."""
MIDDLE = {"ceiling_lamp": 4.0, "rug": 1.5}
"""The middle of the room is worth a way of this many metres."""
AT_WINDOWS = {"radiator": 3.0}
"""So is a place below a window."""
ASTRAY = 0.35
"""A seat no farther from a table stands at it, m."""
EYES = 1.55
"""The middle of a mirror hangs no lower, m, unless it reaches to the floor."""


def project(items: list[Item], space: Space, essential: Container[int] = ()) -> list[Item]:
    """The items in their order, each at its place; the `essential` ones choose before others of their kind."""
    wanted = runs.alike([replace(item, size=_clamped(item, space)) for item in items])
    order = sorted(range(len(items)), key=lambda i: _rank(wanted[i], wanted, i in essential))
    room = Standing(wanted)
    runs.place(runs.line(wanted), room, space)
    for i in order:
        if not room.there[i]:
            room.put(i, _place(i, wanted[i], room, space, wide=False))
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


def _turn_to_screen(order: list[int], wanted: list[Item], room: Standing, space: Space) -> None:
    """A sofa that does not see the television's stand from in front is placed anew, and what belongs with it."""
    for i in order:
        others, names = room.standing(i)
        stands = others.take(np.array([name == "tv_stand" for name in names], bool))
        if room.items[i].category not in SOFAS or not stands.n:
            continue
        if watched(stands, room.boxes.take([i]), [room.items[i].category])[0] >= WATCH:
            continue
        with_it = [k for k in order if belongs_to(wanted[k].category, wanted[i].category)]
        room.there[[i, *with_it]] = False
        for k in (i, *with_it):
            room.put(k, _place(k, wanted[k], room, space, wide=False))


def _astray(room: Standing, essential: Container[int]) -> int | None:
    """The seat farthest from any table that it could stand at, which has no place in a room that has such tables."""
    found: dict[int, float] = {}
    for i, item in enumerate(room.items):
        tables = [k for k, other in enumerate(room.items) if belongs_to(item.category, other.category)]
        if item.category in SEATS - {"bench"} and i not in essential and tables:
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
        new = _place(i, old, room, space, wide=False)
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


def _rank(item: Item, items: list[Item], essential: bool) -> tuple[int, bool, float]:
    """Parents before children, floor before walls before what stands on top; large before small."""
    kind = TABLE[item.category]
    level = {"floor": 0, "wall": 3, "top": 4, "flat": 5, "ceiling": 6}[kind.place]
    if kind.place == "floor" and kind.belongs and any(other.category in kind.belongs for other in items):
        # A nightstand is placed right after the bed: nothing else may take its place.
        if item.category == "nightstand":
            return 0, False, 0.0
        level = 1
    sofas = [float(other.size[0] * other.size[1]) for other in items if other.category in SOFAS]
    if item.category == "tv_stand" and sofas:
        # Right after the sofas: the place across from them shall not be taken.
        return level, not essential, 0.01 - min(sofas)
    essential &= not (item.category == "armchair" and bool(sofas))
    return level, not essential, -float(item.size[0] * item.size[1]) * (1.5 if kind.back else 1.0)


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
        tried.append(_place(i, shape, room, space, wide))
        if tried[-1].cost < BROKEN:
            return tried[-1]
    return min(tried, key=lambda item: item.cost)


def _place(i: int, item: Item, room: Standing, space: Space, wide: bool) -> Item:
    """The item at its cheapest place; `wide` looks all over the room."""
    kind = TABLE[item.category]
    if kind.place == "top" and (stood := on_support(item, room.neighbours(i))) is not None:
        return stood
    item = replace(item, center=np.array([*item.center[:2], _height(item, space)]))
    if item.category == "curtain":
        item = _at_window(item, space)
    others = room.others(i, item)
    standing, names = room.standing(i)
    found, worth = beside(item.category, item.center, item.size, standing, names)
    if kind.place == "wall":
        flush = space.behind(found) < FLUSH_WITH
        found, worth = found.take(flush), worth[flush]
    parts = [_candidates(item, others.boxes, space, wide), found]
    liked = [np.zeros(parts[0].n), worth]
    if item.category in MIDDLE:
        parts.append(candidates.middle(item.center, item.size, space))
        liked.append(MIDDLE[item.category] * candidates.CENTRAL)
    if item.category in AT_WINDOWS:
        parts.append(candidates.under_windows(item.center, item.size, space))
        liked.append(np.full(parts[-1].n, AT_WINDOWS[item.category]))
    found, bonus = candidates.join(parts), np.concatenate(liked)
    bonus += FLUSH * in_run(item.category, found, standing, names)
    if item.category == "tv_stand":
        bonus += watched(found, standing, names)
    prices = cost(found, item.category, item.center, item.yaw, others, space)
    prices += ROOM_BESIDE * _bedsides_lost(item, found, room, space)
    fits = prices < BROKEN
    prices[fits] += (comfort.price(item.category, found, space, standing, names) - bonus)[fits]
    best = int(np.argmin(prices))
    return replace(
        item, center=found.center[best].copy(), size=found.size[best].copy(), yaw=float(found.yaw[best]),
        cost=float(prices[best]),
    )


def _bedsides_lost(item: Item, found: Boxes, room: Standing, space: Space) -> Array:
    """How many nightstands that have no place yet would find none at a bed in each of its places, (n,)."""
    waiting = [k for k, o in enumerate(room.items) if not room.there[k] and belongs_to(o.category, item.category)]
    waiting = [k for k in waiting if room.items[k].category == "nightstand"][:2]
    if not waiting or not found.n:
        return np.zeros(found.n)
    stand = room.items[waiting[0]]
    others, free = room.others(waiting[0], stand), np.zeros(found.n)
    for places in bedsides(stand.size, found):
        free += cost(places, stand.category, stand.center, stand.yaw, others, space) - _way(places, stand) < BROKEN
    return np.asarray(np.maximum(len(waiting) - free, 0))


def _way(places: Boxes, item: Item) -> Array:
    return np.asarray(np.linalg.norm(places.center[:, :2] - item.center[:2], axis=1))


def _candidates(item: Item, others: Boxes, space: Space, wide: bool) -> Boxes:
    kind = TABLE[item.category]
    yaw = candidates.snapped(item.category, item.yaw, space) if item.category not in LOOSE else item.yaw
    walls = candidates.along_walls(item.center, item.size, space, others)
    if (kind.back or item.category == "desk" or kind.place in ("wall", "top")) and walls.n:
        return walls
    parts = [candidates.about(item.center, item.size, yaw)]
    if walls.n:
        lean = LEAN.get(item.category, NEAR)
        near = np.linalg.norm(walls.center[:, :2] - item.center[:2], axis=1) < (9.0 if wide else lean)
        turned = np.cos(walls.yaw - yaw) > 0.7
        walls = walls.take(near & (turned | wide | (lean > 1)))
        # With its back to a wall is where such a thing stands by habit.
        parts = [walls] if walls.n and item.category in LEAN and not wide else [*parts, walls]
    if wide:
        parts.append(candidates.everywhere(item.center, item.size, yaw, space))
    return candidates.join(parts)


def _height(item: Item, space: Space) -> float:
    """Centre height by where the category belongs."""
    kind, tall = TABLE[item.category], float(item.size[2])
    match kind.place:
        case "floor" | "flat":
            return tall / 2
        case "ceiling":
            return space.height - tall / 2 - 0.002
        case "top":
            return min(1.1 + tall / 2, space.height - tall / 2)
        case _:
            middle = max(kind.z + tall / 2, tall / 2)
            if item.category == "mirror" and tall < EYES:
                middle = max(middle, EYES)
            return min(middle, space.height - 0.02 - tall / 2)


def _at_window(item: Item, space: Space) -> Item:
    """A curtain hangs at the window nearest to it, a little wider."""
    spans = space.spans[space.window]
    if not len(spans):
        return item
    span = spans[np.argmin(np.linalg.norm(spans.mean(1) - item.center[:2], axis=1))]
    width = np.clip(
        np.linalg.norm(span[1] - span[0]) + 2 * WINDOW_MARGIN, TABLE["curtain"].min[1], TABLE["curtain"].max[1]
    )
    mid = span.mean(0)
    return replace(item, center=np.array([*mid, item.center[2]]), size=np.array([item.size[0], width, item.size[2]]))

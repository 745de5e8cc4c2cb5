"""The place of one object among those that have theirs."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection import candidates, comfort, partners
from apartgen.stages.layout.projection.costs import BROKEN, HANGINGS, cost
from apartgen.stages.layout.projection.habits import belongs_to
from apartgen.stages.layout.projection.partners import BEDSIDE, FLUSH, SCREENS, SOFAS, bedsides, beside, in_run, watched
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Item, Standing
from apartgen.stages.layout.projection.supports import on_support
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE, used_for

Array = NDArray[np.float64]
STANDS_FLUSH = 0.12
"""Things that need no wall still stand flush with one as near as this, m, or as their category says."""
FLUSH_WITH = 0.03
"""What hangs at a wall is no farther from it, m."""
WINDOW_MARGIN = 0.15
ROOM_BESIDE = 1.0
"""Room for a nightstand is worth a shift of the bed by as much, m."""
SEAT_LOST = 1.5
"""So is room for one chair more of a table."""
EATEN_AT = used_for("dine")


def place(i: int, item: Item, room: Standing, space: Space, wide: bool) -> Item:
    """The item at its cheapest place; `wide` looks all over the room."""
    kind = TABLE[item.category]
    if kind.place == "top" and (stood := on_support(item, room.neighbours(i))) is not None:
        return stood
    item = replace(item, center=np.array([*item.center[:2], _height(item, space)]))
    if item.category in HANGINGS:
        item = _at_window(item, space)
    others = room.others(i, item)
    standing, names = room.standing(i)
    found, worth = beside(item.category, item.center, item.size, standing, names)
    if kind.place == "wall":
        flush = space.behind(found) < FLUSH_WITH
        found, worth = found.take(flush), worth[flush]
    parts = [_candidates(item, others.boxes, space, wide), found]
    liked = [np.zeros(parts[0].n), worth]
    if kind.stands.middle:
        parts.append(candidates.middle(item.center, item.size, space))
        liked.append(kind.stands.middle * candidates.CENTRAL)
    if kind.stands.at_window:
        parts.append(candidates.under_windows(item.center, item.size, space))
        liked.append(np.full(parts[-1].n, kind.stands.at_window))
    if item.category in SCREENS:
        sofas = standing.take(np.array([name in SOFAS for name in names], bool))
        parts.append(candidates.across(item.center, item.size, space, sofas))
        liked.append(np.zeros(parts[-1].n))
    found, bonus = candidates.join(parts), np.concatenate(liked)
    bonus += FLUSH * in_run(item.category, found, standing, names)
    if item.category in SCREENS:
        bonus += watched(found, standing, names)
    prices = cost(found, item.category, item.center, item.yaw, others, space)
    prices += ROOM_BESIDE * _bedsides_lost(item, found, room, space)
    prices += SEAT_LOST * _seats_lost(item, found, room, space)
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
    waiting = [k for k in waiting if room.items[k].category in BEDSIDE][:2]
    if not waiting or not found.n:
        return np.zeros(found.n)
    stand = room.items[waiting[0]]
    others, free = room.others(waiting[0], stand), np.zeros(found.n)
    for places in bedsides(stand.category, stand.size, found):
        free += cost(places, stand.category, stand.center, stand.yaw, others, space) - _way(places, stand) < BROKEN
    return np.asarray(np.maximum(len(waiting) - free, 0))


def _seats_lost(item: Item, found: Boxes, room: Standing, space: Space) -> Array:
    """How many seats that have no place yet would find none at a table in each of its places, (n,)."""
    waiting = [k for k, o in enumerate(room.items) if not room.there[k] and TABLE[o.category].stands.diner]
    if not waiting or item.category not in EATEN_AT or not found.n:
        return np.zeros(found.n)
    chair = room.items[waiting[0]]
    others, seats = room.others(waiting[0], chair), np.zeros(found.n)
    for places in partners.around(chair.size, found):
        seats += cost(places, chair.category, chair.center, chair.yaw, others, space) - _way(places, chair) < BROKEN
    return np.asarray(np.maximum(len(waiting) - seats, 0))


def _way(places: Boxes, item: Item) -> Array:
    return np.asarray(np.linalg.norm(places.center[:, :2] - item.center[:2], axis=1))


def _candidates(item: Item, others: Boxes, space: Space, wide: bool) -> Boxes:
    kind = TABLE[item.category]
    yaw = candidates.snapped(item.category, item.yaw, space) if not kind.stands.any_angle else item.yaw
    walls = candidates.along_walls(item.center, item.size, space, others)
    if (kind.back or kind.is_for("work") or kind.place in ("wall", "top")) and walls.n:
        return walls
    parts = [candidates.about(item.center, item.size, yaw)]
    if walls.n:
        lean = STANDS_FLUSH if kind.stands.lean is None else kind.stands.lean
        near = np.linalg.norm(walls.center[:, :2] - item.center[:2], axis=1) < (9.0 if wide else lean)
        turned = np.cos(walls.yaw - yaw) > 0.7
        walls = walls.take(near & (turned | wide | (lean > 1)))
        # With its back to a wall is where such a thing stands by habit.
        parts = [walls] if walls.n and kind.stands.lean is not None and not wide else [*parts, walls]
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
            if tall < kind.stands.eyes:  # what is taller reaches to the floor
                middle = max(middle, kind.stands.eyes)
            return min(middle, space.height - 0.02 - tall / 2)


def _at_window(item: Item, space: Space) -> Item:
    """A curtain hangs at the window nearest to it, a little wider."""
    spans = space.spans[space.window]
    if not len(spans):
        return item
    span = spans[np.argmin(np.linalg.norm(spans.mean(1) - item.center[:2], axis=1))]
    kind = TABLE[item.category]
    width = np.clip(np.linalg.norm(span[1] - span[0]) + 2 * WINDOW_MARGIN, kind.min[1], kind.max[1])
    mid = span.mean(0)
    return replace(item, center=np.array([*mid, item.center[2]]), size=np.array([item.size[0], width, item.size[2]]))

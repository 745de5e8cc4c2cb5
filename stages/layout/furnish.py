"""From sampled objects to the boxes of an artifact: projection, and what to do with what fits nowhere."""

import logging
from collections import Counter

import numpy as np

from schemas.layout import Box
from schemas.plan import Plan, Room
from stages.categories import TABLE
from stages.layout.config import LayoutConfig
from stages.layout.features import Objects
from stages.layout.projection import Item, project
from stages.layout.projection.costs import BROKEN
from stages.layout.projection.space import Space, space_of
from stages.layout.rooms import Rooms
from stages.layout.sense import essentials

log = logging.getLogger("apartgen")
STAND_INS = ("wall_shelf", "wall_lamp", "plant", "bin", "ceiling_lamp")
"""Small things that take the place of an object that fits nowhere when the count was asked for."""


def furnish(plan: Plan, rooms: Rooms, objects: Objects, config: LayoutConfig) -> list[Box]:
    """All objects of an apartment; `rooms` and `objects` are its rows of the batch."""
    out: list[Box] = []
    for i, room in enumerate(plan.rooms):
        filled = np.flatnonzero(objects.category[i].numpy() >= 0)
        items = [_item(objects, i, int(j)) for j in filled]
        if config.projection and items:
            wishes = Counter({w.category: w.count for w in plan.program.objects if w.room == room.id})
            items, kept = settled(items, space_of(rooms, i), room, room.id in plan.program.counts, wishes)
            filled = filled[kept]
        latents = objects.latent[i].numpy()[filled]
        out += _boxes(room, items, latents, rooms.origin[i])
    return out


def _item(objects: Objects, room: int, slot: int) -> Item:
    from stages.categories import CATEGORIES

    return Item(
        CATEGORIES[int(objects.category[room, slot])],
        objects.center[room, slot].double().numpy(),
        objects.size[room, slot].double().numpy(),
        float(objects.yaw[room, slot]),
    )


def settled(
    items: list[Item], space: Space, room: Room, asked: bool, wishes: Counter[str]
) -> tuple[list[Item], list[int]]:
    """Projected items and which of the given ones they are.

    What still breaks a requirement is left out, the worst first; where the number was asked for, something small
    that fits takes its place. What the room is for, and what was wished for by category, stays as long as leaving
    out something else helps.
    """
    kept = list(range(len(items)))
    needed = essentials([item.category for item in items], room.type, wishes)
    done = project(items, space, needed)
    for _ in range(len(items)):
        broken = [k for k, item in enumerate(done) if item.cost >= BROKEN]
        if not broken:
            break
        worst = max(broken, key=lambda k: (k not in needed, done[k].cost))
        if asked:
            done = _stand_in(done, worst, space, room)
            if done[worst].cost >= BROKEN:
                break
            continue
        if worst in needed:
            worst = _in_its_way(worst, done, needed)
        log.info("%s: no place for the %s; left out", room.id, done[worst].category)
        kept.pop(worst)
        rest = [items[k] for k in kept]
        needed = essentials([item.category for item in rest], room.type, wishes)
        done = project(rest, space, needed)
        if not done:
            break
    return done, kept


def _in_its_way(needed_one: int, items: list[Item], needed: frozenset[int]) -> int:
    """The nearest thing on the floor that is not needed, or the object itself where there is none."""
    spare = [
        k
        for k, item in enumerate(items)
        if k not in needed and TABLE[item.category].place == "floor" and not TABLE[item.category].soft
    ]
    return min(spare, key=lambda k: _apart(items[k], items[needed_one]), default=needed_one)


def _apart(a: Item, b: Item) -> float:
    return float(np.linalg.norm(a.center[:2] - b.center[:2]))


def _stand_in(items: list[Item], worst: int, space: Space, room: Room) -> list[Item]:
    best = items
    for category in STAND_INS:
        if room.type not in TABLE[category].rooms:
            continue
        swap = Item(category, items[worst].center, np.array(TABLE[category].size), items[worst].yaw)
        tried = project([swap if k == worst else item for k, item in enumerate(items)], space)
        if tried[worst].cost < BROKEN:
            log.info("%s: no place for the %s; a %s instead", room.id, items[worst].category, category)
            return tried
        if sum(o.cost for o in tried) < sum(o.cost for o in best):
            best = tried
    return best


def _boxes(room: Room, items: list[Item], latents: np.ndarray, origin: np.ndarray) -> list[Box]:
    seen: dict[str, int] = {}
    out = []
    for item, latent in zip(items, latents, strict=True):
        seen[item.category] = seen.get(item.category, 0) + 1
        x, y = item.center[:2] + origin
        turn = (item.yaw + np.pi) % (2 * np.pi) - np.pi
        out.append(
            Box(
                id=f"{room.id}_{item.category}_{seen[item.category]}",
                room=room.id,
                category=item.category,
                center=(round(float(x), 4), round(float(y), 4), round(float(item.center[2]), 4)),
                size=tuple(round(float(s), 4) for s in item.size),
                yaw=round(float(turn), 5),
                latent=[round(float(v), 3) for v in latent],
            )
        )
    return out

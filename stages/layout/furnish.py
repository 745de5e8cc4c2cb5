"""From sampled objects to the boxes of an artifact: projection, and what to do with what fits nowhere."""

import logging

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
            items, kept = settled(items, space_of(rooms, i), room, asked=room.id in plan.program.counts)
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


def settled(items: list[Item], space: Space, room: Room, asked: bool) -> tuple[list[Item], list[int]]:
    """Projected items and which of the given ones they are.

    What still breaks a requirement is left out, the worst first; where the number was asked for, something small
    that fits takes its place.
    """
    kept, done = list(range(len(items))), project(items, space)
    for _ in range(len(items)):
        worst = max(range(len(done)), key=lambda k: done[k].cost)
        if done[worst].cost < BROKEN:
            break
        rest = [item for k, item in enumerate(done) if k != worst]
        if asked:
            done = _stand_in(done, worst, space, room)
            if done[worst].cost >= BROKEN:
                break
            continue
        log.info("%s: no place for the %s; left out", room.id, done[worst].category)
        kept.pop(worst)
        done = project(rest, space)
        if not done:
            break
    return done, kept


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

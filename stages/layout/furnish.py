"""From sampled objects to the boxes of an artifact: each room's own task, which workers may share."""

from collections import Counter
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan, Room
from apartgen.stages.layout.features import Objects
from apartgen.stages.layout.newcomers import as_known, chosen
from apartgen.stages.layout.projection.settle import Settled, Task
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.layout.rooms import Rooms
from apartgen.stages.layout.wishes import of_room
from apartgen.stages.things.categories import CATEGORIES, TABLE

Latents = NDArray[np.float32]


def of_plan(plan: Plan, room: Room, rooms: Rooms, objects: Objects, row: int) -> tuple[Task, Latents]:
    """What is to be placed in a room of a plan, row `row` of the batch, and the shape latents of its objects."""
    wished = of_room(plan.program, room.id)
    work, latents = task(rooms, objects, row, as_known(wished), room.id in plan.program.counts)
    return replace(work, items=_sized(work.items, wished)), latents


def task(
    rooms: Rooms, objects: Objects, row: int, wishes: Counter[str] | None = None, asked: bool = True
) -> tuple[Task, Latents]:
    """What is to be placed in the room of row `row`, and the shape latents (n, 32) of its objects.

    `asked`: the number of objects is to be kept.
    """
    filled = np.flatnonzero(objects.category[row].numpy() >= 0)
    items = [
        Item(
            CATEGORIES[int(objects.category[row, j])],
            objects.center[row, j].double().numpy(),
            objects.size[row, j].double().numpy(),
            float(objects.yaw[row, j]),
        )
        for j in map(int, filled)
    ]
    work = Task(items, space_of(rooms, row), ROOM_TYPES[rooms.type[row]], asked, wishes or Counter())
    return work, objects.latent[row].numpy()[filled]


def _sized(items: list[Item], wished: Counter[str]) -> list[Item]:
    """The items, those that are to be newcomers in sizes that these come in, their undersides where they were."""
    found = chosen([item.category for item in items], [item.size for item in items], wished)
    return [_in_range(item, found[i]) if i in found else item for i, item in enumerate(items)]


def _in_range(item: Item, newcomer: str) -> Item:
    size = np.clip(item.size, TABLE[newcomer].min, TABLE[newcomer].max)
    return replace(item, size=size, center=item.center + [0.0, 0.0, (size[2] - item.size[2]) / 2])


def as_sampled(work: Task) -> Settled:
    """A room without projection."""
    return Settled(work.items, list(range(len(work.items))), [])


def boxes(room: Room, done: Settled, latents: Latents, origin: NDArray[np.float32]) -> list[Box]:
    """A room's objects in the world, `origin` (2,) its frame's."""
    seen: dict[str, int] = {}
    out = []
    for item, latent in zip(done.items, latents[done.kept], strict=True):
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

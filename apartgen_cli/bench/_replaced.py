"""Sampled rooms put in their places by the projection: as they were sampled, or from random places instead."""

from collections.abc import Callable

import numpy as np
from shapely.geometry import Point

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan, Room
from apartgen.stages.layout.projection.standing import Item
from apartgen.stages.space import polygons

Placing = Callable[[Room, list[Item]], list[Item]]
"""Where the projection starts from, in a room's own coordinates of the world."""


def projected(sampled: Layout, place: Placing | None = None) -> tuple[Layout, dict[str, list[float]]]:
    """An apartment with the objects of `sampled` settled, and how far each that stays went, m, by room.

    The same as the layout stage does after sampling; `place` first puts the objects elsewhere.
    """
    from apartgen.stages.layout import furnish, wishes
    from apartgen.stages.layout import rooms as room_arrays
    from apartgen.stages.layout.projection.settle import Task, settle
    from apartgen.stages.layout.projection.space import space_of

    rooms, boxes, moves = room_arrays.of_plan(sampled), list[Box](), dict[str, list[float]]()
    for i, room in enumerate(sampled.rooms):
        inside = [o for o in sampled.objects if o.room == room.id]
        items = [Item(o.category, np.array(o.center), np.array(o.size), o.yaw) for o in inside]
        items = place(room, items) if place else items
        origin = np.array([*rooms.origin[i], 0.0], float)
        local = [Item(item.category, item.center - origin, item.size, item.yaw) for item in items]
        asked = room.id in sampled.program.counts
        done = settle(Task(local, space_of(rooms, i), room.base, asked, wishes.of_room(sampled.program, room.id)))
        latents = np.array([o.latent for o in inside], np.float32).reshape(len(inside), -1)
        boxes += furnish.boxes(room, done, latents, rooms.origin[i])
        moves[room.id] = [float(np.hypot(*(item.center - local[k].center)[:2]))
                          for item, k in zip(done.items, done.kept, strict=True)]
    return sampled.model_copy(update={"objects": boxes}), moves


def anywhere(rng: np.random.Generator) -> Placing:
    """Places drawn evenly over a room's floor, with any of four headings; heights are kept."""

    def place(room: Room, items: list[Item]) -> list[Item]:
        floor = polygons.floor(room)
        x0, y0, x1, y1 = floor.bounds
        out = []
        for item in items:
            at = rng.uniform((x0, y0), (x1, y1))
            while not floor.contains(Point(at)):
                at = rng.uniform((x0, y0), (x1, y1))
            turn = float(rng.integers(4)) * np.pi / 2
            out.append(Item(item.category, np.array([*at, item.center[2]]), item.size, turn))
        return out

    return place


def chosen(candidates: list[Layout]) -> Layout:
    """Of every room the best of several furnishings of one plan."""
    from apartgen.stages.layout import choice

    first = candidates[0]
    plan, boxes = Plan(**{name: getattr(first, name) for name in Plan.model_fields}), list[Box]()
    for room in first.rooms:
        rooms = [[o for o in home.objects if o.room == room.id] for home in candidates]
        boxes += rooms[choice.best(plan, room.id, rooms)]
    return first.model_copy(update={"objects": boxes})

"""Kitchen runs: units side by side along a wall, round its corner where one wall is too short."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.candidates import GAP
from apartgen.stages.layout.projection.costs import BROKEN, cost
from apartgen.stages.layout.projection.partners import HUNG, LOW_RUN, UNITS
from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.projection.standing import Item, Standing
from apartgen.stages.space.boxes import Boxes, penetration
from apartgen.stages.things.categories import TABLE, those, used_for

Array = NDArray[np.float64]
WAY, PER_UNIT = 0.25, 3.0
"""What a metre from where the model put a unit counts against a unit placed."""
COOKERS = used_for("cook")
COOKERS_AT_WINDOW = 2.0
LEGS = 3
TALL = 1.2
LOW_OVEN = 0.9
SEAM = 0.001
"""Between units, m."""


def alike(items: list[Item]) -> list[Item]:
    """Low units of one worktop share its depth and height, those on the wall theirs; the only oven has a hob on top."""
    out = list(items)
    ovens = [i for i, o in enumerate(items) if o.category in used_for("bake") and o.size[2] >= LOW_OVEN]
    if ovens and not any(o.category in used_for("fry") for o in items):
        for i in ovens:
            out[i] = replace(out[i], size=np.array([*out[i].size[:2], LOW_OVEN]))
    items = list(out)
    for group in (UNITS, those(lambda kind: kind.run == "hung" and kind.articulated)):
        members = [i for i, o in enumerate(items) if o.category in group and (o.category in HUNG or o.size[2] < TALL)]
        if len(members) < 2:
            continue
        depth, height = (float(np.median([items[i].size[k] for i in members])) for k in (0, 2))
        for i in members:
            kind = TABLE[items[i].category]
            size = np.clip([depth, items[i].size[1], height], kind.min, kind.max)
            out[i] = replace(items[i], size=size)
    return out


def line(items: list[Item]) -> list[int]:
    """The units that stand on the floor, in the order in which they stand; none where there is no run.

    The tall one at the end, the wet together, a worktop between sink and heat.
    """
    units = [i for i, o in enumerate(items) if o.category in LOW_RUN]
    if len(units) < 2:
        return []
    spare = [i for i in units if TABLE[items[i].category].stands.spare]
    # One worktop beside the fridge, the others between sink and hob and after it.
    late = {i: 7.5 + 2.0 * (k % 2) for k, i in enumerate(spare[1:])}
    tall = {i: 0.5 for i in units if items[i].category in used_for("bake") and items[i].size[2] >= TALL}
    return sorted(units, key=lambda i: (tall | late).get(i, float(TABLE[items[i].category].stands.line)))


def place(units: list[int], room: Standing, space: Space) -> list[int]:
    """Put the units in runs, in place; returns those that found none."""
    rest = list(units)
    for _ in range(LEGS):
        if not rest:
            break
        best = max(
            (_leg(order, room, space) for order in (rest, rest[::-1])), key=lambda found: found[0], default=None
        )
        if best is None or not best[1]:
            break
        for i, item in best[1]:
            room.put(i, item)
        done = {i for i, _ in best[1]}
        rest = [i for i in rest if i not in done]
    return rest


def _leg(order: list[int], room: Standing, space: Space) -> tuple[float, list[tuple[int, Item]]]:
    """The worth of the best run of a first stretch of `order`, and its units at their places."""
    items = [room.items[i] for i in order]
    widths = np.array([item.size[1] for item in items])
    wall, start, way = _starts(space, room)
    if not len(wall):
        return 0.0, []
    middle = start[:, None] + way[:, None] * (np.cumsum(widths + SEAM) - widths / 2)
    along, normal = space.along[wall], space.normal[wall]
    yaw = np.arctan2(normal[:, 1], normal[:, 0])
    going, total = np.ones(len(wall), bool), np.zeros(len(wall))
    count = np.zeros(len(wall), int)
    places: list[Boxes] = []
    for k, (i, item) in enumerate(zip(order, items, strict=True)):
        at = space.start[wall] + along * middle[:, k, None] + normal * (item.size[0] / 2 + GAP)
        boxes = Boxes(
            np.column_stack([at, np.full(len(at), item.size[2] / 2)]), np.tile(item.size, (len(at), 1)), yaw
        )
        # The way there counts less than staying in line, so it is taken out of the cost of breaking nothing.
        price = cost(boxes, item.category, item.center, item.yaw, room.others(i, item), space)
        far = np.linalg.norm(at - item.center[:2], axis=1)
        going &= price < BROKEN
        total += going * (PER_UNIT * TABLE[item.category].stands.needed - WAY * far - _steamed(item, boxes, space))
        count += going
        places.append(boxes)
    best = int(total.argmax())
    found = [
        (i, replace(item, center=places[k].center[best].copy(), yaw=float(yaw[best])))
        for k, (i, item) in enumerate(zip(order[: count[best]], items, strict=False))
    ]
    return float(total[best]), found


def _steamed(item: Item, boxes: Boxes, space: Space) -> Array:
    """What it costs to cook before a window, where no hood can hang."""
    windows = space.zones.take(space.window)
    if item.category not in COOKERS or not windows.n:
        return np.zeros(boxes.n)
    tall = Boxes(boxes.center * [1, 1, 0] + [0, 0, 1.0], boxes.size * [1, 1, 0] + [0, 0, 2.0], boxes.yaw)
    return np.asarray(COOKERS_AT_WINDOW * (penetration(tall, windows) > 0.01).any(1))


def _starts(space: Space, room: Standing) -> tuple[NDArray[np.int64], Array, Array]:
    """Where a run may begin: wall, place along it, and which way it goes; at corners, doors and what stands there."""
    rows: list[tuple[int, float, float]] = []
    ends = space.zones.take(~space.window)
    standing = room.boxes.take(np.flatnonzero(room.there))
    for k, (origin, along, normal, length) in enumerate(
        zip(space.start, space.along, space.normal, space.length, strict=True)
    ):
        for others, near in ((ends, 0.9), (standing, 0.8)):
            offset = others.center[:, :2] - origin
            out, at = offset @ normal, offset @ along
            turned = np.abs(np.cos(others.yaw) * along[0] + np.sin(others.yaw) * along[1])
            half = (others.size[:, 0] * turned + others.size[:, 1] * np.sqrt(np.maximum(1 - turned**2, 0))) / 2
            beside = (out > 0) & (out < near) & (at + half > 0) & (at - half < length)
            for low, high in zip((at - half)[beside], (at + half)[beside], strict=True):
                rows += [(k, high + GAP, 1.0), (k, low - GAP, -1.0)]
        rows += [(k, GAP, 1.0), (k, length - GAP, -1.0)]
    rows = [(k, at, way) for k, at, way in rows if 0 < at < space.length[k]]
    table = np.array(rows, float).reshape(-1, 3)
    return table[:, 0].astype(int), table[:, 1], table[:, 2]

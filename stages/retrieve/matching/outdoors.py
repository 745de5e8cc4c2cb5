"""What hangs on a balcony's walls: on that of the house, beside the door, and not in the air above the railing."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from shapely import Geometry
from shapely.geometry import Point

from apartgen.schemas.carrying import WALL
from apartgen.schemas.plan import Plan, Room
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.space import boxes, polygons
from apartgen.stages.things.asset import Array

BESIDE = 0.25
"""From a door's edge to the middle of what hangs beside it, m."""
MARGIN = 0.05
"""Kept free about it, m."""
STEP = 0.05
BEHIND = 0.03
"""So far behind a balcony's edge is the wall, m."""


class _Span(NamedTuple):
    """What is in the way on an edge of the floor: from where to where along it, from which height to which."""

    first: float
    last: float
    low: float
    high: float


def hung(objects: Sequence[Furnishing], plan: Plan) -> list[Furnishing]:
    """The objects, with those that hang over a railing moved to the nearest free place beside a door; what finds none
    stays.
    """
    outdoors = {room.id: room for room in plan.rooms if room.base == "balcony"}
    house = polygons.shell(plan.model_copy(update={"rooms": [r for r in plan.rooms if r.id not in outdoors]}))
    result = list(objects)
    for i, o in enumerate(result):
        if o.on == WALL and o.room in outdoors and not house.intersects(Point(_behind(o))):
            others = [p for p in result if p.room == o.room and p is not o]
            result[i] = _moved(o, outdoors[o.room], plan, house, others)
    return result


def _behind(o: Furnishing) -> Array:
    front = np.array([np.cos(o.yaw), np.sin(o.yaw)])
    return np.asarray(o.center[:2] - (o.size[0] / 2 + BEHIND) * front)


def _moved(o: Furnishing, room: Room, plan: Plan, house: Geometry, others: Sequence[Furnishing]) -> Furnishing:
    places = list(_places(o, room, plan, house, others))
    if not places:
        return o
    _, x, y, yaw = min(places)
    return o.model_copy(update={"center": (round(x, 6), round(y, 6), o.center[2]), "yaw": round(yaw, 6)})


def _places(o: Furnishing, room: Room, plan: Plan, house: Geometry, others: Sequence[Furnishing],
            ) -> Iterator[tuple[float, float, float, float]]:
    """Middles and yaws on the house's wall where nothing else is, each after how far it is from beside a door."""
    corners = np.asarray(room.polygon, float)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        length = float(np.hypot(*(b - a)))
        along = (b - a) / length
        normal = np.array([-along[1], along[0]])
        taken, doors = list(_taken(a, along, normal, plan, others)), list(_doors(a, along, normal, room, plan))
        for s in np.arange(o.size[1] / 2 + MARGIN, length - o.size[1] / 2 - MARGIN, STEP).tolist():
            spot = a + s * along
            if house.intersects(Point(spot - BEHIND * normal)) and not any(_meets(o, s, span) for span in taken):
                off = min((abs(abs(s - edge) - BESIDE) for edge in doors), default=length)
                x, y = spot + o.size[0] / 2 * normal
                yield round(off, 6), float(x), float(y), float(np.arctan2(normal[1], normal[0]))


def _meets(o: Furnishing, s: float, span: _Span) -> bool:
    wide, tall = o.size[1] / 2 + MARGIN, o.size[2] / 2 + MARGIN
    return span.first < s + wide and span.last > s - wide and (
        span.low < o.center[2] + tall and span.high > o.center[2] - tall)


def _taken(a: Array, along: Array, normal: Array, plan: Plan, others: Sequence[Furnishing]) -> Iterator[_Span]:
    """Openings of any room in this wall, and what stands before it."""
    for opening in plan.openings:
        ends = np.asarray(opening.segment, float) - a
        if np.abs(ends @ normal).max() < 0.45:
            s = ends @ along
            yield _Span(float(s.min()), float(s.max()), opening.sill, opening.head)
    for p in others:
        points = boxes.corners(boxes.of([p]))[0] - a
        if (points @ normal).min() < 0.12:
            s, half = points @ along, p.size[2] / 2
            yield _Span(float(s.min()), float(s.max()), p.center[2] - half, p.center[2] + half)


def _doors(a: Array, along: Array, normal: Array, room: Room, plan: Plan) -> Iterator[float]:
    """Where the doors to a balcony in this wall begin and end."""
    for opening in plan.openings:
        ends = np.asarray(opening.segment, float) - a
        if opening.kind in polygons.PASSAGES and room.id in opening.rooms and np.abs(ends @ normal).max() < 0.45:
            yield from (ends @ along).tolist()

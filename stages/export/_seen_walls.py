"""Walls as one sees them from within a room: what stands or hangs with its back to each, and its openings."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from shapely.geometry.polygon import orient

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Room
from apartgen.schemas.populate import without_things
from apartgen.stages.space import polygons

BEHIND = 0.12
"""Farther from the wall a back does not belong to it, m."""
ALONG = np.cos(np.radians(4.0))
"""Cosine of what a thing is turned at most from square to its wall."""
SHORTEST = 0.3


@dataclass(frozen=True)
class Placed:
    """Something on a wall: from where to where along it from the left, and from what height to what."""

    left: float
    right: float
    low: float
    high: float


@dataclass(frozen=True)
class Seen:
    """One wall of a room, `length` m, its things and openings from the back to the front."""

    room: Room
    number: int
    length: float
    things: list[tuple[Box, Placed]]
    openings: list[tuple[Opening, Placed]]


def walls_seen(home: Layout, rooms: list[Room]) -> Iterator[Seen]:
    """The walls of rooms that have something before them, in order."""
    home = without_things(home)
    for room in rooms:
        ring = np.asarray(orient(polygons.floor(room)).exterior.coords)
        number = 0
        for end, start in zip(ring, ring[1:]):
            length = float(np.hypot(*(end - start)))
            if length < SHORTEST:
                continue
            right = (end - start) / length  # the room is to the left of start, seen from it to end: behind the viewer
            into = np.array([right[1], -right[0]])
            things = [(o, put) for o in home.objects if o.room == room.id
                      and (put := _thing(o, start, right, into, length))]
            if things:
                number += 1
                openings = [(o, put) for o in home.openings if room.id in o.rooms
                            and (put := _opening(o, start, right, into, length, home))]
                yield Seen(room, number, length, sorted(things, key=lambda one: -_far(one[0], start, into)), openings)


def _far(o: Box, start: NDArray[np.float64], into: NDArray[np.float64]) -> float:
    """How far a thing's back is from the wall."""
    return float((np.array(o.center[:2]) - start) @ into) - o.size[0] / 2


def _thing(o: Box, start: NDArray[np.float64], right: NDArray[np.float64], into: NDArray[np.float64], length: float,
           ) -> Placed | None:
    if np.array([np.cos(o.yaw), np.sin(o.yaw)]) @ into < ALONG or not -0.05 < _far(o, start, into) < BEHIND:
        return None
    at, half = float((np.array(o.center[:2]) - start) @ right), o.size[1] / 2
    if not 0 < at < length:
        return None
    return Placed(at - half, at + half, o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2)


def _opening(o: Opening, start: NDArray[np.float64], right: NDArray[np.float64], into: NDArray[np.float64],
             length: float, home: Layout) -> Placed | None:
    ends = np.asarray(o.segment, float) - start
    if np.abs(ends @ into).max() > home.walls.outer + 0.05:
        return None
    low, high = sorted((ends @ right).tolist())
    return Placed(low, high, o.sill, o.head) if 0 < (low + high) / 2 < length else None

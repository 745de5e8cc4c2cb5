"""A way through a home as somebody would tell it: room after room, turns, doors, what is passed."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from shapely.geometry import LineString, Point, Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.robot.reach import Space
from apartgen.stages.space import boxes, polygons
from apartgen.stages.space.boxes import Array

STEP = 0.025
"""Of the way, where it is asked which room it is in, m."""
COARSE, STRETCH = 0.4, 0.5
"""A way's corners are as of a line so near to it; stretches that are shorter are no stretches to be told of, m."""
ONE, MOST, TOLD = 1.5, np.radians(120.0), np.radians(45.0)
"""Turns so near to each other, m, are one that is no larger than that; later ones below the last are not told, rad."""
BESIDE, CLEAR, ENDS = 1.0, 0.25, 0.4
"""What is passed is so near, its nearest point and its middle so far aside, and so far from a stretch's ends, m."""


@dataclass(frozen=True)
class Turn:
    """A turn to the left by so much, rad, so far along a leg, m."""

    at: float
    angle: float


@dataclass(frozen=True)
class Passed:
    """A thing that is passed, so far along a leg, m, on the left or not."""

    at: float
    id: str
    left: bool


@dataclass(frozen=True)
class Leg:
    """A way (n, 2) through one room, from a place in it or `entry` to a place or the `way_out`.

    `side` is how far to the left the way out leads, as one comes up to it, rad.
    """

    room: str
    points: Array
    entry: Opening | None
    way_out: Opening | None
    turns: list[Turn]
    side: float


def legs(space: Space, way: Array) -> list[Leg]:
    """The legs of a way (n, 2)."""
    plan, points = space.plan, along(way, STEP)
    columns = ((points[:, 0] - space.grid.origin[0]) / space.grid.resolution).astype(int)
    rows = ((points[:, 1] - space.grid.origin[1]) / space.grid.resolution).astype(int)
    rooms = space.rooms[rows, columns]
    inside = np.flatnonzero(rooms >= 0)
    cuts = [(a, b) for a, b in zip(inside, inside[1:]) if rooms[a] != rooms[b]]
    ways_out = [_crossed(plan, plan.rooms[rooms[a]].id, plan.rooms[rooms[b]].id, points[(a + b) // 2]) for a, b in cuts]
    starts, ends = [0, *((a + b) // 2 for a, b in cuts)], [*((a + b) // 2 for a, b in cuts), len(points) - 1]
    entries, exits = [None, *ways_out], [*ways_out, None]
    return [_leg(plan, plan.rooms[rooms[inside[(inside >= a) & (inside <= b)][0]]].id, points[a : b + 1], entry, out)
            for a, b, entry, out in zip(starts, ends, entries, exits)]


def along(way: Array, step: float) -> Array:
    """The way's corners, and points between them no further than `step` apart."""
    parts = [way[:1]]
    for a, b in zip(way, way[1:]):
        n = max(1, int(np.ceil(np.linalg.norm(b - a) / step - 1e-9)))
        parts.append(a + (b - a) * np.arange(1, n + 1)[:, None] / n)
    return np.concatenate(parts)


def length(way: Array) -> float:
    """Length of a way (n, 2), m."""
    return float(np.linalg.norm(np.diff(way, axis=0), axis=1).sum())


def _crossed(plan: Plan, here: str, there: str, point: Array) -> Opening:
    """The opening between two rooms that a way goes through at a point."""
    some = [o for o in plan.openings if o.kind in polygons.PASSAGES and {here, there} == set(o.rooms)]
    return min(some, key=lambda o: LineString(o.segment).distance(Point(point)))


def _leg(plan: Plan, room: str, points: Array, entry: Opening | None, way_out: Opening | None) -> Leg:
    first = next(d for d in points - points[0] if np.linalg.norm(d) > 1e-6)
    began = polygons.face(entry, plan, room)[0] if entry else first
    ahead, turns = began, list[Turn]()
    for at, stretch in _stretches(points):
        turn = Turn(at, _angle(ahead, stretch))
        if turns and at - turns[-1].at < ONE and abs(turns[-1].angle + turn.angle) < MOST:
            turn = Turn(turns[-1].at, turns.pop().angle + turn.angle)
        turns.append(turn)
        ahead = stretch
    turns = [turn for turn in turns if turn.at == 0 or abs(turn.angle) > TOLD]
    side = _angle(ahead, -polygons.face(way_out, plan, room)[0]) if way_out else 0.0
    return Leg(room, points, entry, way_out, turns, side)


def _stretches(points: Array) -> Iterator[tuple[float, Array]]:
    """How far along the way each straight stretch of it begins, and its direction."""
    line = LineString(points)
    corners = np.array(line.simplify(COARSE).coords)
    for a, b in zip(corners, corners[1:]):
        if np.linalg.norm(b - a) >= STRETCH:
            yield float(line.project(Point(a))), b - a


def _angle(one: Array, other: Array) -> float:
    """From one direction to another, to the left, rad."""
    return float(np.arctan2(one[0] * other[1] - one[1] * other[0], one @ other))


def passed(home: Layout, leg: Leg, ids: Sequence[str]) -> list[Passed]:
    """Which of some things one passes close by, the nearest first."""
    line, known = LineString(leg.points), {o.id: o for o in home.objects}
    found = [(line.distance(_print(known[id])), one) for id in ids if (one := _beside(line, known[id]))]
    return [one for far, one in sorted(found, key=lambda pair: pair[0]) if far < BESIDE]


def _beside(line: LineString, o: Box) -> Passed | None:
    """Where a thing is passed, all of it on one side; None where it is not."""
    at = float(line.project(_print(o).centroid))
    if not ENDS < at < line.length - ENDS:
        return None
    here, before, after = (np.array(line.interpolate(at + d).coords[0]) for d in (0.0, -ENDS / 2, ENDS / 2))
    heading = (after - before) / max(float(np.linalg.norm(after - before)), 1e-9)
    aside = (np.array(_print(o).exterior.coords) - here) @ np.array([-heading[1], heading[0]])
    left = bool(aside.mean() > 0)
    return Passed(at, o.id, left) if (aside.min() if left else -aside.max()) > CLEAR else None


def _print(o: Box) -> Polygon:
    found: Polygon = boxes.footprints(boxes.of([o]))[0]
    return found

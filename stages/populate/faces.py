"""The walls of a room as what hangs there finds them: how long, and what of each is taken."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.plan import Plan, Room
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.stages.space import boxes, polygons, sweeps
from apartgen.stages.things import carrying
from apartgen.stages.things.small import Design

Array = NDArray[np.float64]
Rectangle = tuple[float, float, float, float]
"""Of a wall: first, last, lowest and highest, m."""

COVERS_WALL = 0.12
"""What is closer to a wall than this covers it, m."""
STOOD = 0.45
"""And what stands on something there, as a television does: it is at the height of what hangs."""


class Hung(NamedTuple):
    """A thing on a wall: where its middle is, and its yaw."""

    design: Design
    center: tuple[float, float, float]
    yaw: float


class Face(NamedTuple):
    """One wall of a room: its start, its direction, its normal into the room, its length, and what covers
    it, always and while a door opens.
    """

    start: Array
    along: Array
    normal: Array
    length: float
    covered: list[Rectangle]
    swept: tuple[Rectangle, ...] = ()

    def free(self, s: float, width: float, low: float, high: float, margin: float = 0.05) -> bool:
        """Whether a rectangle of the wall is clear."""
        first, last = s - width / 2 - margin, s + width / 2 + margin
        if first < 0 or last > self.length:
            return False
        return not any(a < last and b > first and z0 < high + margin and z1 > low - margin
                       for a, b, z0, z1 in (*self.covered, *self.swept))

    def hang(self, design: Design, s: float, z: float) -> Hung:
        """A thing with its middle at `s` along and at height `z`, which covers the wall from now on."""
        d, w, h = design.size
        self.covered.append((s - w / 2, s + w / 2, z - h / 2, z + h / 2))
        x, y = self.start + s * self.along + (d / 2 + 0.0005) * self.normal
        return Hung(design, (float(x), float(y), z), float(np.arctan2(self.normal[1], self.normal[0])))


def faces_of(home: Retrieve, room: Room, here: Sequence[Furnishing]) -> list[Face]:
    """Every wall of a room, with what covers it."""
    corners = np.asarray(room.polygon, float)
    swings = [(opening, polygons.swing(opening, home)) for opening in home.openings if room.id in opening.rooms]
    swept = [(np.asarray(swing.exterior.coords), o.head) for o, swing in swings if not swing.is_empty]
    faces = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        length = float(np.hypot(*(b - a)))
        along = (b - a) / length
        normal = np.array([-along[1], along[0]])
        face = Face(a, along, normal, length, [])
        face = face._replace(swept=tuple(strip for swing, head in swept for strip in _strip(face, swing, 0.0, head)))
        face.covered.extend(_covered(face, home, room, here))
        faces.append(face)
    return faces


def _covered(face: Face, home: Plan, room: Room, here: Sequence[Furnishing]) -> Iterator[Rectangle]:
    for opening in home.openings:
        if room.id in opening.rooms:
            s, off = seen(face, np.asarray(opening.segment, float))
            if np.abs(off).max() < 0.45:
                yield s.min() - 0.08, s.max() + 0.08, opening.sill, opening.head + 0.08
    for o in here:
        low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
        near = STOOD if carrying.by_another(o) else COVERS_WALL
        yield from _strip(face, boxes.corners(boxes.of([o]))[0], low, high, near)
        c, s = np.cos(o.yaw), np.sin(o.yaw)
        for joint in o.joints:
            (x0, y0, z0), (x1, y1, z1) = sweeps.swept(joint)
            local = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
            points = local @ np.array([[c, s], [-s, c]]) + o.center[:2]
            yield from _strip(face, points, z0 + o.center[2], z1 + o.center[2])


def seen(face: Face, points: Array) -> tuple[Array, Array]:
    """Points (n, 2) along a wall, and how far before it, m."""
    return (points - face.start) @ face.along, (points - face.start) @ face.normal


def _strip(face: Face, points: Array, low: float, high: float, near: float = COVERS_WALL) -> Iterator[Rectangle]:
    s, off = seen(face, points)
    if off.min() < near and off.max() > -0.05 and s.max() > 0 and s.min() < face.length:
        yield float(s.min()), float(s.max()), low, high

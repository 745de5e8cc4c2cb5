"""Between frames whose y is up and ours (z up, yaw counter-clockwise, front +x), and one-room plans from outlines."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from shapely import unary_union
from shapely.geometry import MultiPolygon, Polygon

from apartgen.schemas.base import Point, RoomType
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import AskedRoom, Opening, Program, Room

Vector = tuple[float, float, float]
SEAM = 1e-4
"""Triangles closer than twice this are joined, m."""


def turned(yaw: float) -> float:
    """The angle within [-π, π)."""
    return float((yaw + np.pi) % (2 * np.pi) - np.pi)


def counter_clockwise(points: Sequence[Point]) -> list[Point]:
    """The outline without repeats of its first point, turned so that the inside is on the left."""
    ring = [(float(x), float(y)) for x, y in points]
    if len(ring) > 1 and ring[0] == ring[-1]:
        ring = ring[:-1]
    x, y = np.array(ring).T
    area = (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()
    return ring if area > 0 else ring[::-1]


def outline(vertices: NDArray[np.float64], faces: NDArray[np.int64]) -> Polygon | None:
    """Outline in our plan of a floor mesh with y up, its largest part; None where it has no area."""
    corners = (vertices[:, [0, 2]] * [1, -1])[faces.reshape(-1, 3)]
    parts = [Polygon(t).buffer(SEAM, join_style="mitre") for t in corners if Polygon(t).area > 1e-6]
    whole = unary_union(parts).buffer(-SEAM, join_style="mitre").simplify(0.005)
    if isinstance(whole, MultiPolygon):
        whole = max(whole.geoms, key=lambda part: part.area)
    return whole if isinstance(whole, Polygon) and whole.area > 0.5 else None


def home(rooms: list[Room], openings: list[Opening], objects: list[Box], height: float) -> Layout:
    """A furnished home of rooms read from a file; the programme asks for just these rooms."""
    program = Program(rooms=[AskedRoom(id=room.id, type=room.type) for room in rooms])
    return Layout(program=program, rooms=rooms, openings=openings, height=height, objects=objects)


def room(type: RoomType, number: int, outline: Sequence[Point]) -> Room:
    """A room with our kind of id."""
    return Room(id=f"{type}_{number}", type=type, polygon=counter_clockwise(outline))


def box(id: str, room: str, category: str, center: Vector, size: Vector, yaw: float) -> Box:
    """A box at millimetre precision."""
    x, y, z = (round(float(v), 4) for v in center)
    d, w, h = (max(1e-3, round(float(v), 4)) for v in size)
    return Box(id=id, room=room, category=category, center=(x, y, z), size=(d, w, h), yaw=round(turned(yaw), 4))

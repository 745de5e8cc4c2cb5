"""Lines of a drawing that mean something together: outlines that are walls, strokes that are doors and windows."""

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import polygonize

Array = NDArray[np.float64]
THICK = 0.7
"""What is nowhere wider is a wall, not a room, m."""
TINY = 1e-3
JAMB = 0.1
"""A door has wall this far beyond its ends, m."""


def walls(lines: Sequence[LineString]) -> list[Polygon]:
    """What lines enclose that is as thin as a wall."""
    if not lines:
        return []
    noded = shapely.unary_union(shapely.set_precision(shapely.multilinestrings([*lines]), 1e-4))
    faces = [face for face in polygonize(noded) if face.area > TINY]
    return [face for face in faces if face.buffer(-THICK / 2).is_empty]


def thickness(wall: Polygon) -> float:
    """Of a rectangle of the same area and circumference, m."""
    half = wall.length / 2
    return float(half - np.sqrt(max(half**2 - 4 * wall.area, 0.0))) / 2


def spans(shapes: Sequence[LineString]) -> list[tuple[Array, Array]]:
    """The middle line of each group of lines that touch, along the longer side of its box."""
    grown = shapely.unary_union([shape.buffer(0.01) for shape in shapes])
    out = []
    for part in shapely.get_parts(grown):
        box = part.minimum_rotated_rectangle
        if not isinstance(box, Polygon):
            continue
        a, b, c, d, _ = np.asarray(box.exterior.coords)
        if np.hypot(*(b - a)) < np.hypot(*(c - b)):
            a, b, c, d = b, c, d, a
        out.append((0.5 * (a + d), 0.5 * (b + c)))
    return out


def shut(hinge: Array, ends: Sequence[Array], floors: Sequence[Polygon], stand: Sequence[Polygon]) -> int:
    """Which of the two ends of a door's arc lies in the wall: where no room is, then between two jambs."""

    def amiss(end: Array) -> tuple[int, int, float]:
        along = (end - hinge) / max(float(np.hypot(*(end - hinge))), 1e-9)
        within = sum(floor.buffer(-0.02).contains(Point(0.5 * (hinge + end))) for floor in floors)
        beyond = [Point(hinge - JAMB * along), Point(end + JAMB * along)]
        held = sum(any(wall.distance(jamb) < 0.02 for wall in stand) for jamb in beyond)
        return within, -held, min((wall.distance(Point(end)) for wall in stand), default=0.0)

    return 0 if amiss(ends[0]) <= amiss(ends[1]) else 1

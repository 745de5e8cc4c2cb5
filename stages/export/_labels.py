"""Where names of rooms are written on a plan: on free floor, else a number that the list beside the plan explains."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import shapely
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath
from shapely import Geometry
from shapely.ops import unary_union

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan, Room
from apartgen.stages.space import boxes, polygons

SMALLEST, LARGEST = 5.5, 12.0
"""Sizes of names, points."""
AREA = 0.85
"""Size of the area below a name, of the name's."""
LEADING = 1.25
PAD = 0.05
"""Free floor about a label, m."""
GRID = 0.08
"""Places are tried so far apart, m."""
DISC = 5.5
"""Size of a number that stands alone, points."""
_SLACK = 1.06  # fonts differ a little in width


@dataclass(frozen=True)
class Label:
    """What is written about (x, y): lines with their sizes in points, upright or turned by a right angle."""

    room: str
    x: float
    y: float
    lines: tuple[tuple[str, float], ...]
    turned: bool = False
    alone: bool = False


def title(room: Room) -> str:
    """A room's type as a name."""
    return room.type.replace("_", " ").title()


def size_of(room: Room) -> str:
    """A room's area as it is written."""
    return f"{polygons.floor(room).area:.1f} m²"


def measures(room: Room) -> str:
    """Width and depth of a room's clear floor as they are written, m; of one that is no rectangle the largest."""
    x0, y0, x1, y1 = polygons.floor(room).bounds
    return f"{x1 - x0:.2f} × {y1 - y0:.2f}"


def labels(home: Plan, objects: Sequence[Box], moving: Geometry, inch: float) -> list[Label]:
    """A label for every room, numbered in the plan's order; `moving` is the floor that open parts take, `inch` the
    inches of paper to a metre.
    """
    prints = unary_union(list(boxes.footprints(boxes.of(objects)))) if objects else shapely.Polygon()
    swings = unary_union([polygons.swing(o, home) for o in home.openings])
    taken = unary_union([prints, swings, moving])
    return [_label(room, k, taken, unary_union([prints, *_leaves(home)]), inch) for k, room in enumerate(home.rooms, 1)]


def _leaves(home: Plan) -> list[Geometry]:
    """What is drawn of doors: leaf and arc."""
    swings = [polygons.swing(o, home) for o in home.openings]
    return [swing.exterior.buffer(0.02) for swing in swings if not swing.is_empty]


def _label(room: Room, number: int, taken: Geometry, drawn: Geometry, inch: float) -> Label:
    floor = polygons.floor(room)
    free = floor.buffer(-PAD).difference(taken.buffer(PAD))
    for lines, turned in _forms(room, number, inch):
        width, height = extent(lines, inch)
        place = _place(floor, free, *((height, width) if turned else (width, height)))
        if place is not None:
            return Label(room.id, *place, lines, turned)
    alone = ((str(number), DISC),)
    wide = 2 * radius(inch)
    for area in (free, floor.buffer(-0.02).difference(drawn)):
        place = _place(floor, area, wide, wide)
        if place is not None:
            return Label(room.id, *place, alone, alone=True)
    at = floor.representative_point()
    return Label(room.id, at.x, at.y, alone, alone=True)


def _forms(room: Room, number: int, inch: float) -> Iterator[tuple[tuple[tuple[str, float], ...], bool]]:
    """Ways to write a name, the best first: on one line or its words below each other, upright or turned, smaller."""
    name, area = f"{number}  {title(room)}", size_of(room)
    words = name.replace("  ", "\u2002").split(" ")
    usual = min(LARGEST, max(6.5, 2.4 * np.sqrt(polygons.floor(room).area) * inch))
    for size in (usual, 0.8 * usual, 0.65 * usual, SMALLEST):
        if size < SMALLEST:
            continue
        for rows in dict.fromkeys([(name,), tuple(words)]):
            lines = (*((row, size) for row in rows), (area, AREA * size))
            yield lines, False
            yield lines, True


@cache
def _width(text: str, size: float) -> float:
    return float(TextPath((0, 0), text, size=size, prop=FontProperties()).get_extents().width)


def extent(lines: Sequence[tuple[str, float]], inch: float) -> tuple[float, float]:
    """Width and height of lines below each other, m."""
    width = max(_width(text, size) for text, size in lines) * _SLACK
    return width / 72 / inch, LEADING * sum(size for _, size in lines) / 72 / inch


def radius(inch: float) -> float:
    """Of the disc about a number that stands alone, m."""
    return DISC * 0.95 / 72 / inch


def _place(floor: Geometry, free: Geometry, width: float, height: float) -> tuple[float, float] | None:
    """Where a rectangle lies on free floor, near the room's middle; None where it does nowhere."""
    x0, y0, x1, y1 = floor.bounds
    columns = np.arange(x0 + width / 2, x1 - width / 2 + 1e-9, GRID)
    rows = np.arange(y0 + height / 2, y1 - height / 2 + 1e-9, GRID)
    if not len(columns) or not len(rows) or free.is_empty:
        return None
    xs, ys = (a.ravel() for a in np.meshgrid(columns, rows))
    shapely.prepare(free)
    fits = shapely.contains(free, shapely.box(xs - width / 2, ys - height / 2, xs + width / 2, ys + height / 2))
    if not fits.any():
        return None
    middle = floor.centroid
    cost = np.where(fits, np.hypot(xs - middle.x, ys - middle.y), np.inf)
    k = int(np.argmin(cost))
    return float(xs[k]), float(ys[k])

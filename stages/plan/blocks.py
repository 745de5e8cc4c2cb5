"""Outlines taken apart into rectangles and straight walls for the solver.

Solver outlines are "gross": half an inner wall outside the clear floor, so that every room is inset alike.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from apartgen.schemas.plan import Envelope, Side

Array = NDArray[np.float64]
STEP = 4.0
"""A wall that slants further is straightened in steps, m; lower ones would be too low for doors and windows beside."""
LOST = 0.06
"""Share of its area by which an outline may change when its walls are straightened."""
SIDES: tuple[Side, ...] = ("south", "east", "north", "west")
OPPOSITE: dict[Side, Side] = {"south": "north", "north": "south", "east": "west", "west": "east"}


class Outline(NamedTuple):
    """A gross outline for the solver; see `kernel.Problem` for the arrays."""

    blocks: Array
    edges: Array
    stretch: tuple[float, float]


def facing(dx: float, dy: float) -> Side:
    """Side of the flat that a wall lies on whose floor is to the left of direction (dx, dy)."""
    if abs(dx) >= abs(dy):
        return "south" if dx > 0 else "north"
    return "east" if dy > 0 else "west"


def entrance_sides(envelope: Envelope) -> list[Side]:
    """Where the entrance may be: the side asked for; of a flat the sides without façade; else a façade.

    Where party walls are named, the neighbours stand behind them: then a façade, or opposite the only one.
    """
    if envelope.entrance:
        return [envelope.entrance]
    if envelope.facades is not None and envelope.dwelling != "house" and envelope.party_walls:
        return list(envelope.party_walls)
    facades = [side for side in SIDES if side not in envelope.party_walls]
    if len(facades) == 1:
        return [OPPOSITE[facades[0]]]
    return facades or list(SIDES)


def given(envelope: Envelope, inner: float) -> Outline:
    """The outline that the envelope gives as clear floor, straightened."""
    return taken_apart(gross(envelope, inner), envelope, (1.0, 1.0))


def gross(envelope: Envelope, inner: float) -> Polygon:
    """The given outline between wall centre lines."""
    return Polygon(envelope.outline or []).buffer(inner / 2, join_style="mitre")


def taken_apart(polygon: Polygon, envelope: Envelope, stretch: tuple[float, float]) -> Outline:
    """Blocks and edges of a gross outline that may be stretched between two factors."""
    upright = polygon if _upright(polygon) else straightened(polygon)
    entrances = entrance_sides(envelope)
    edges = [_edge(a, b, envelope, entrances) for a, b in pairwise(_ring(upright))]
    return Outline(blocks(upright), np.array(edges, float).reshape(-1, 6), stretch)


def straightened(polygon: Polygon) -> Polygon:
    """The outline with slanting walls at their mean place, in steps where they slant far; the same where none does."""
    ring = np.array(_ring(polygon))
    walls = [wall for a, b in pairwise(ring) for wall in _steps(a, b)]
    corners: list[tuple[float, float]] = []
    for before, after in zip([walls[-1], *walls[:-1]], walls):
        if before.level == after.level:
            turn = after.start[0] if after.level else after.start[1]
            corners += [_corner(before.at, turn, before.level), _corner(after.at, turn, before.level)]
        else:
            level, upright = (before, after) if before.level else (after, before)
            corners.append((upright.at, level.at))
    out = Polygon(corners).simplify(1e-9)
    kept = isinstance(out, Polygon) and out.is_valid and abs(out.area / polygon.area - 1) < LOST
    return shapely.geometry.polygon.orient(out if kept else polygon)


def _ring(polygon: Polygon) -> list[list[float]]:
    """The corners around, counter-clockwise, the first once more at the end."""
    around = polygon.exterior
    ring: list[list[float]] = shapely.get_coordinates(around).tolist()
    return ring if shapely.is_ccw(around) else ring[::-1]


def _upright(polygon: Polygon) -> bool:
    """Whether an outline without courts runs along one axis and the other in turn."""
    if shapely.get_num_interior_rings(polygon):
        return False
    ring = shapely.get_coordinates(polygon).tolist()
    level = [a[1] == b[1] for a, b in pairwise(ring)]
    turns = all(one != other for one, other in zip(level, [level[-1], *level]))
    return turns and all((a[0] == b[0]) != (a[1] == b[1]) for a, b in pairwise(ring))


class _Wall(NamedTuple):
    """A straightened wall: whether it runs along x, where across, and where it begins."""

    level: bool
    at: float
    start: tuple[float, float]


def _steps(a: Array, b: Array) -> list[_Wall]:
    level = bool(abs(b[0] - a[0]) >= abs(b[1] - a[1]))
    across = 1 if level else 0
    many = max(1, int(np.ceil(abs(b[across] - a[across]) / STEP)))
    starts = [a + k / many * (b - a) for k in range(many)]
    half = 0.5 * (b - a) / many
    return [_Wall(level, float(start[across] + half[across]), (float(start[0]), float(start[1]))) for start in starts]


def _corner(at: float, turn: float, level: bool) -> tuple[float, float]:
    return (turn, at) if level else (at, turn)


def _edge(
    a: Sequence[float], b: Sequence[float], envelope: Envelope, entrances: list[Side]
) -> tuple[float, float, float, float, float, float]:
    side = facing(b[0] - a[0], b[1] - a[1])
    axis = 1 if side in ("south", "north") else 0
    lo, hi = sorted((a[1 - axis], b[1 - axis]))
    return axis, 0.5 * (a[axis] + b[axis]), lo, hi, side not in envelope.party_walls, side in entrances


def blocks(polygon: Polygon) -> Array:
    """Disjoint rectangles (k, 4) of a polygon's area, and its very shape where it is rectilinear."""
    ring, upright = _ring(polygon), _upright(polygon)
    lines = sorted({round(y, 9) for _, y in ring})
    out: list[list[float]] = []
    for lo, hi in pairwise(lines):
        level = 0.5 * (lo + hi)
        for a, b in _crossed(ring, level) if upright else _cut(polygon, level):
            below = next((r for r in out if abs(r[0] - a) + abs(r[2] - b) + abs(r[3] - lo) < 1e-6), None)
            if below is not None:
                below[3] = hi
            else:
                out.append([a, lo, b, hi])
    return np.array(out, float)


def _cut(polygon: Polygon, y: float) -> list[tuple[float, float]]:
    """Where a level line is in a polygon, from x to x."""
    x0, _, x1, _ = polygon.bounds
    cut = polygon.intersection(shapely.LineString([(x0 - 1, y), (x1 + 1, y)]))
    return [(part.bounds[0], part.bounds[2]) for part in shapely.get_parts(cut)]


def _crossed(ring: list[list[float]], y: float) -> list[tuple[float, float]]:
    """The same of an upright ring, between the walls that the line crosses."""
    walls = sorted(a[0] for a, b in pairwise(ring) if min(a[1], b[1]) < y < max(a[1], b[1]))
    return list(zip(walls[::2], walls[1::2], strict=True))

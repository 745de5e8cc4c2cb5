"""Outlines taken apart into rectangles and straight walls for the solver.

Solver outlines are "gross": half an inner wall outside the clear floor, so that every room is inset alike.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from apartgen.schemas.plan import Envelope, Side

Array = NDArray[np.float64]
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
    """The outline that the envelope gives as clear floor. Slanting walls become steps of equal area."""
    return taken_apart(gross(envelope, inner), envelope, (1.0, 1.0))


def gross(envelope: Envelope, inner: float) -> Polygon:
    """The given outline between wall centre lines."""
    return Polygon(envelope.outline or []).buffer(inner / 2, join_style="mitre")


def taken_apart(polygon: Polygon, envelope: Envelope, stretch: tuple[float, float]) -> Outline:
    """Blocks and edges of a gross outline that may be stretched between two factors."""
    ring = [(x, y) for x, y in shapely.geometry.polygon.orient(polygon).exterior.coords]
    slants = [np.abs(np.subtract(b, a)) for a, b in pairwise(ring) if min(np.abs(np.subtract(b, a))) > 1e-6]
    flat = sum(d[0] for d in slants) > sum(d[1] for d in slants)  # slabs across the steeper slants
    rows = blocks(shapely.transform(polygon, lambda xy: xy[:, ::-1]) if flat else polygon)
    rows = rows[:, [1, 0, 3, 2]] if flat else rows
    entrances = entrance_sides(envelope)
    cuts = [_split(start, end, ring, flat) for start, end in pairwise(ring)]
    edges = [_edge(a, b, envelope, entrances) for points in cuts for a, b in pairwise(points)]
    return Outline(rows, np.array(edges, float).reshape(-1, 6), stretch)


def _split(
    a: tuple[float, float], b: tuple[float, float], ring: list[tuple[float, float]], flat: bool
) -> list[tuple[float, float]]:
    """A slanting edge cut where the slabs meet; others whole."""
    if min(abs(b[0] - a[0]), abs(b[1] - a[1])) < 1e-6:
        return [a, b]
    axis = 0 if flat else 1
    lines = {p[axis] for p in ring if min(a[axis], b[axis]) < p[axis] - 1e-6 and p[axis] + 1e-6 < max(a[axis], b[axis])}
    shares = sorted((line - a[axis]) / (b[axis] - a[axis]) for line in lines)
    return [a, *((a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])) for s in shares), b]


def _edge(
    a: tuple[float, float], b: tuple[float, float], envelope: Envelope, entrances: list[Side]
) -> tuple[float, float, float, float, float, float]:
    side = facing(b[0] - a[0], b[1] - a[1])
    axis = 1 if side in ("south", "north") else 0
    lo, hi = sorted((a[1 - axis], b[1 - axis]))
    return axis, 0.5 * (a[axis] + b[axis]), lo, hi, side not in envelope.party_walls, side in entrances


def blocks(polygon: Polygon) -> Array:
    """Disjoint rectangles (k, 4) of a polygon's area, and its very shape where it is rectilinear."""
    x0, _, x1, _ = polygon.bounds
    lines = sorted({round(y, 9) for _, y in polygon.exterior.coords})
    out: list[list[float]] = []
    for lo, hi in pairwise(lines):
        cut = polygon.intersection(shapely.LineString([(x0 - 1, 0.5 * (lo + hi)), (x1 + 1, 0.5 * (lo + hi))]))
        for part in shapely.get_parts(cut):
            a, _, b, _ = part.bounds
            below = next((r for r in out if abs(r[0] - a) + abs(r[2] - b) + abs(r[3] - lo) < 1e-6), None)
            if below is not None:
                below[3] = hi
            else:
                out.append([a, lo, b, hi])
    return np.array(out, float)

"""Outlines of flats: drawn from a shape or given, and taken apart into blocks for the solver.

Solver outlines are "gross": half an inner wall outside the clear floor, so that every room is inset alike.
"""

from typing import NamedTuple

import numpy as np
import shapely
from numpy.random import Generator
from numpy.typing import NDArray
from shapely.geometry import Polygon, box

from schemas.plan import Envelope, Side

Array = NDArray[np.float64]
SIDES: tuple[Side, ...] = ("south", "east", "north", "west")
OPPOSITE: dict[Side, Side] = {"south": "north", "north": "south", "east": "west", "west": "east"}
GREATEST_ASPECT = 1.8
"""Longest side of a free outline's bounding box over the other."""
PLAY = 1.2
"""Factor by which annealing may change the aspect that was drawn, either way."""


class Outline(NamedTuple):
    """A gross outline for the solver; see `kernel.Problem` for the arrays."""

    shape: str
    blocks: Array
    edges: Array
    stretch: tuple[float, float]


def facing(dx: float, dy: float) -> Side:
    """Side of the flat that a wall lies on whose floor is to the left of direction (dx, dy)."""
    if abs(dx) >= abs(dy):
        return "south" if dx > 0 else "north"
    return "east" if dy > 0 else "west"


def entrance_sides(envelope: Envelope) -> list[Side]:
    """Where the entrance may be: the side asked for, else a façade, or opposite the only façade."""
    if envelope.entrance:
        return [envelope.entrance]
    facades = [side for side in SIDES if side not in envelope.party_walls]
    if len(facades) == 1:
        return [OPPOSITE[facades[0]]]
    return facades or list(SIDES)


def ring(shape: Polygon) -> list[tuple[float, float]]:
    """Counter-clockwise corners, the first not repeated, without points on straight edges."""
    clean = shapely.geometry.polygon.orient(shape.simplify(1e-6))
    return [(round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in clean.exterior.coords[:-1]]


def wish(envelope: Envelope, regularity: float, rng: Generator) -> tuple[str, float]:
    """A shape and an aspect of the bounding box; irregular flats have more corners."""
    shape: str = envelope.shape
    if shape == "auto":
        odds = 0.8 * (1 - regularity) ** 1.5
        shape = str(rng.choice(["rectangle", "L", "notched"], p=[1 - odds, 0.6 * odds, 0.4 * odds]))
    return shape, float(np.exp(rng.uniform(-1, 1) * np.log(GREATEST_ASPECT / PLAY)))


def draw(envelope: Envelope, gross: float, shape: str, aspect: float, rng: Generator) -> Outline:
    """A free outline of area `gross` near an aspect, or the given one."""
    if envelope.outline is not None:
        return taken_apart(Polygon(envelope.outline), envelope, "outline", (1.0, 1.0))
    unit = _shape(shape, aspect, rng)
    scale = float(np.sqrt(gross / unit.area))
    polygon = shapely.transform(unit, lambda xy: xy * scale)
    # A stretch s makes the bounding box s² times as long.
    return taken_apart(polygon, envelope, shape, (float(PLAY**-0.5), float(PLAY**0.5)))


def _shape(shape: str, aspect: float, rng: Generator) -> Polygon:
    whole = box(0, 0, aspect, 1)
    if shape == "rectangle":
        return whole
    if shape == "L":
        return _less(whole, _corner(aspect, rng.uniform(0.3, 0.5), rng.uniform(0.3, 0.5), int(rng.integers(4))))
    if rng.random() < 0.5:
        first = int(rng.integers(4))
        corners = (first, (first + 1 + int(rng.integers(2))) % 4)
        cuts = [_corner(aspect, rng.uniform(0.18, 0.32), rng.uniform(0.18, 0.32), corner) for corner in corners]
        return _less(whole, shapely.union_all(cuts))
    at, wide, deep = rng.uniform(0.25, 0.45), rng.uniform(0.25, 0.35), rng.uniform(0.18, 0.3)
    notch = box(at * aspect, -1, (at + wide) * aspect, deep)
    return _less(whole, notch if rng.random() < 0.5 else shapely.affinity.scale(notch, 1, -1, origin=(0, 0.5)))


def _corner(aspect: float, wide: float, deep: float, corner: int) -> Polygon:
    x, y = (corner & 1) * aspect, float(corner >> 1)
    return box(x - wide * aspect, y - deep, x + wide * aspect, y + deep)


def _less(whole: Polygon, cut: Polygon) -> Polygon:
    rest: Polygon = whole.difference(cut)
    return rest


def taken_apart(polygon: Polygon, envelope: Envelope, shape: str, stretch: tuple[float, float]) -> Outline:
    """Blocks and edges of a rectilinear gross outline."""
    entrances = entrance_sides(envelope)
    ring = shapely.geometry.polygon.orient(polygon).exterior.coords
    edges = [_edge(a, b, envelope, entrances) for a, b in zip(ring[:-1], ring[1:], strict=True)]
    return Outline(shape, blocks(polygon), np.array(edges, float).reshape(-1, 6), stretch)


def _edge(
    a: tuple[float, ...], b: tuple[float, ...], envelope: Envelope, entrances: list[Side]
) -> tuple[float, float, float, float, float, float]:
    side = facing(b[0] - a[0], b[1] - a[1])
    axis = 1 if side in ("south", "north") else 0
    lo, hi = sorted((a[1 - axis], b[1 - axis]))
    return axis, 0.5 * (a[axis] + b[axis]), lo, hi, side not in envelope.party_walls, side in entrances


def blocks(polygon: Polygon) -> Array:
    """Disjoint rectangles (k, 4) that together make a rectilinear polygon; full-width slabs first."""
    x0, _, x1, _ = polygon.bounds
    lines = sorted({round(y, 9) for _, y in polygon.exterior.coords})
    out: list[list[float]] = []
    for lo, hi in zip(lines[:-1], lines[1:], strict=True):
        cut = polygon.intersection(shapely.LineString([(x0 - 1, 0.5 * (lo + hi)), (x1 + 1, 0.5 * (lo + hi))]))
        for part in shapely.get_parts(cut):
            a, _, b, _ = part.bounds
            below = next((r for r in out if abs(r[0] - a) + abs(r[2] - b) + abs(r[3] - lo) < 1e-6), None)
            if below is not None:
                below[3] = hi
            else:
                out.append([a, lo, b, hi])
    return np.array(out, float)

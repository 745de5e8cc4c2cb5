"""Outlines of flats, drawn from a shape and an aspect."""

import numpy as np
import shapely
from numpy.random import Generator
from shapely.geometry import Polygon, box

from apartgen.schemas.plan import Envelope
from apartgen.stages.plan.blocks import Outline, taken_apart

GREATEST_ASPECT = 1.8
"""Longest side of a free outline's bounding box over the other."""
DEEP_NOTCH = 75.0
"""Gross area, m², from which an outline may have a notch in the middle of a side."""
ODD, MOST_ODD = ((7, 10), (2.0, 0.7)), 0.9
"""Share of free outlines that are no rectangles where nothing need be regular, by rooms, and at most."""
PLAY = 1.2
"""Factor by which annealing may change the aspect that was drawn, either way."""


def ring(shape: Polygon) -> list[tuple[float, float]]:
    """Counter-clockwise corners, the first not repeated, without points on straight edges."""
    clean = shapely.geometry.polygon.orient(shape.simplify(1e-6))
    return [(round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in clean.exterior.coords[:-1]]


def wish(envelope: Envelope, regularity: float, rooms: int, rng: Generator) -> tuple[str, float]:
    """A shape and an aspect of the bounding box; irregular flats have more corners, those of many rooms fewer."""
    shape: str = envelope.shape
    if shape == "auto":
        odds = min(MOST_ODD, float(np.interp(rooms, *ODD)) * (1 - regularity))
        shape = str(rng.choice(["rectangle", "L", "notched"], p=[1 - odds, 0.7 * odds, 0.3 * odds]))
    return shape, float(np.exp(rng.uniform(-1, 1) * np.log(GREATEST_ASPECT / PLAY)))


def draw(envelope: Envelope, gross: float, shape: str, aspect: float, rng: Generator) -> Outline:
    """A free outline of area `gross` near an aspect."""
    unit = _shape(shape, aspect, gross >= DEEP_NOTCH, rng)
    scale = float(np.sqrt(gross / unit.area))
    polygon = shapely.transform(unit, lambda xy: xy * scale)
    # A stretch s makes the bounding box s² times as long.
    return taken_apart(polygon, envelope, (float(PLAY**-0.5), float(PLAY**0.5)))


def _shape(shape: str, aspect: float, large: bool, rng: Generator) -> Polygon:
    whole = box(0, 0, aspect, 1)
    if shape == "rectangle":
        return whole
    if shape == "L":
        return _less(whole, _corner(aspect, rng.uniform(0.3, 0.5), rng.uniform(0.3, 0.5), int(rng.integers(4))))
    if not large or rng.random() < 0.5:
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

"""Straight wall faces: where two floors face each other across a wall, and where a floor faces the open air."""

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

Array = NDArray[np.float64]
THICKEST = 0.65
"""Floors further apart than this do not share a wall, m."""


OPEN_AIR = 3.0
"""Free depth before a window or an entrance, m."""
ASIDE = 0.02
"""Floors are taken so much larger where they stand before an edge, the edge's own so much smaller, m."""


class Face(NamedTuple):
    """A straight stretch of wall: `start` and unit direction of a floor's edge (floor on the left), its length, and
    the distance `gap` to the other floor, or None towards the open air."""

    start: Array
    along: Array
    length: float
    gap: float | None

    @property
    def inward(self) -> Array:
        """Unit normal into the floor."""
        return np.array([-self.along[1], self.along[0]])

    def part(self, lo: float, hi: float) -> "Face":
        """The stretch between two distances from the start."""
        return Face(self.start + lo * self.along, self.along, hi - lo, self.gap)

    def segment(self, lo: float, hi: float, depth: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Ends of a line `depth` into the wall."""
        a = self.start + lo * self.along - depth * self.inward
        b = self.start + hi * self.along - depth * self.inward
        return _point(a), _point(b)


def _point(p: Array) -> tuple[float, float]:
    return round(float(p[0]), 4) + 0.0, round(float(p[1]), 4) + 0.0


def edges(polygon: Polygon) -> list[Face]:
    """Edges of a counter-clockwise floor as faces of unknown gap."""
    ring = np.asarray(shapely.geometry.polygon.orient(polygon).exterior.coords)
    steps = np.diff(ring, axis=0)
    lengths = np.hypot(*steps.T)
    return [Face(a, d / n, float(n), None) for a, d, n in zip(ring[:-1], steps, lengths, strict=True) if n > 1e-6]


def between(a: Polygon, b: Polygon) -> list[Face]:
    """Stretches of a's edges that face b across a wall of even thickness, longest first."""
    out = []
    for mine in edges(a):
        for other in edges(b):
            if np.dot(mine.along, other.along) > -0.999:
                continue
            gap = float(np.dot(other.start - mine.start, -mine.inward))
            if not -1e-6 <= gap <= THICKEST:
                continue
            ends = np.dot(np.array([other.start, other.start + other.length * other.along]) - mine.start, mine.along)
            lo, hi = max(0.0, ends.min()), min(mine.length, ends.max())
            if hi - lo > 0.05:
                out.append(mine.part(lo, hi)._replace(gap=gap))
    return sorted(out, key=lambda face: (-face.length, *face.start))


def outside(room: Polygon, others: list[Polygon]) -> list[Face]:
    """Stretches of a room's edges with no floor within `OPEN_AIR` before them, its own neither, longest first."""
    out = []
    around = np.array([room, *others], dtype=object)
    extents, grown = shapely.bounds(around) + np.array([-ASIDE, -ASIDE, ASIDE, ASIDE]), dict[int, Polygon]()
    for edge in edges(room):
        strip, spans = _ahead(edge), [(0.0, edge.length)]
        x0, y0, x1, y1 = strip.bounds
        apart = (extents[:, 0] > x1) | (extents[:, 1] > y1) | (extents[:, 2] < x0) | (extents[:, 3] < y0)
        reached = np.flatnonzero(~apart).tolist()
        for which in reached:
            if which not in grown:
                grown[which] = around[which].buffer(ASIDE if which else -ASIDE, join_style="mitre")
        parts = shapely.get_parts(shapely.intersection(strip, shapely.union_all([grown[which] for which in reached])))
        for part in parts[shapely.area(parts) > 1e-6]:
            at = np.dot(shapely.get_coordinates(part) - edge.start, edge.along)
            spans = _without(spans, float(at.min()), float(at.max()))
        out += [edge.part(lo, hi) for lo, hi in spans if hi - lo > 0.05]
    return sorted(out, key=lambda face: (-face.length, *face.start))


def _ahead(edge: Face) -> Polygon:
    """The open air before an edge."""
    end, deep = edge.start + edge.length * edge.along, OPEN_AIR * edge.inward
    strip: Polygon = shapely.polygons(np.array([edge.start, end, end - deep, edge.start - deep]))
    return strip


def _without(spans: list[tuple[float, float]], lo: float, hi: float) -> list[tuple[float, float]]:
    out = []
    for a, b in spans:
        out += [(a, min(b, lo)), (max(a, hi), b)]
    return [(a, b) for a, b in out if b - a > 1e-6]

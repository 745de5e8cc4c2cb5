"""Upright boxes and openings in walls, worked out for this judge alone; metres, radians."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry
from shapely.geometry import LineString, Point, Polygon

from apartgen.schemas.base import Vector
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Opening

Array = NDArray[np.float64]
TOUCH = 0.01
"""What goes no further is contact, m."""
LEAF = 0.04
"""Thickness of a room door, m."""


class Boxes(NamedTuple):
    """Corners in plan (n, 4, 2) in their order around, least and greatest height (n,)."""

    corners: Array
    low: Array
    high: Array

    def marks(self) -> NDArray[np.object_]:
        """What they cover of the floor."""
        return np.asarray(shapely.polygons(self.corners), object)


def joined(parts: Sequence[Boxes]) -> Boxes:
    """All of some boxes."""
    return Boxes(*(np.concatenate(field) for field in zip(*parts)))


def turned(points: Array, yaw: Array) -> Array:
    """Plan points (n, k, 2), each row about the origin by its own angle (n,)."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.asarray(points @ np.array([[c, s], [-s, c]]).transpose(2, 0, 1))


def boxes(objects: Sequence[Box], lo: Vector = (-0.5, -0.5, -0.5), hi: Vector = (0.5, 0.5, 0.5)) -> Boxes:
    """The boxes of objects, or the part of each between two corners given as shares of its size."""
    center, size = (np.array([getattr(o, name) for o in objects], float).reshape(-1, 3) for name in ("center", "size"))
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    ring = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]) * size[:, None, :2]
    corners = turned(ring, np.array([o.yaw for o in objects], float)) + center[:, None, :2]
    return Boxes(corners, center[:, 2] + z0 * size[:, 2], center[:, 2] + z1 * size[:, 2])


def depth(a: Boxes, b: Boxes) -> Array:
    """The least shift that parts each box of `a` from each of `b`, (n, m), m; negative where they are apart."""
    heights = np.minimum(a.high[:, None] - b.low, b.high - a.low[:, None])
    return np.minimum(heights, np.minimum(_along(a, b), _along(b, a).T))


def _along(a: Boxes, b: Boxes) -> Array:
    """The same in plan, along the sides of the boxes of `a` alone."""
    axes = a.corners[:, 1:3] - a.corners[:, :2]
    axes = axes / np.maximum(np.linalg.norm(axes, axis=-1, keepdims=True), 1e-12)
    p, q = np.einsum("nkc,nsc->nsk", a.corners, axes)[:, None], np.einsum("mkc,nsc->nmsk", b.corners, axes)
    return np.asarray(np.minimum(p.max(-1) - q.min(-1), q.max(-1) - p.min(-1)).min(-1))


def meeting(shapes: Sequence[Geometry] | NDArray[np.object_]) -> list[tuple[int, int]]:
    """Pairs of shapes that touch, each once."""
    every = np.asarray(shapes, object)  # of none, too
    return sorted((i, j) for i, j in shapely.STRtree(every).query(every, "intersects").T.tolist() if i < j)


def common(a: Boxes, i: int, b: Boxes, j: int) -> tuple[float, ...]:
    """The middle of what two boxes that overlap have in common."""
    at = shapely.intersection(Polygon(a.corners[i]), Polygon(b.corners[j])).centroid
    return at.x, at.y, float(max(a.low[i], b.low[j]) + min(a.high[i], b.high[j])) / 2


class Gate(NamedTuple):
    """An opening: its ends, the unit normal, and by room which side it is on (1 left, -1 right) and how far off."""

    ends: Array
    middle: tuple[float, float]
    normal: Array
    sides: dict[str, tuple[int, float]]

    def line(self) -> LineString:
        """The middle of the wall that it cuts."""
        return LineString(self.ends)

    def cut(self, more: float = 1e-3) -> Polygon:
        """The way through the wall, a hair longer; towards the open air as long as inwards."""
        reach = dict(self.sides.values())
        out = max(reach.values(), default=0.0)
        return self.strip(-reach.get(-1, out) - more, reach.get(1, out) + more)

    def strip(self, lo: float, hi: float) -> Polygon:
        """What lies between two distances from it, on its left."""
        (a, b), n = self.ends, self.normal
        return Polygon([a + lo * n, b + lo * n, b + hi * n, a + hi * n])

    def leaf(self, o: Opening, angles: Array) -> Boxes:
        """Where its leaf stands when turned by some angles (k,) from shut; it must open into one of its sides."""
        side, off = self.sides[o.into or ""]
        pivot, shut = self.ends[o.hinge] + side * off * self.normal, self.ends[1 - o.hinge] - self.ends[o.hinge]
        width = float(np.hypot(*shut))
        frame = np.array([shut / width, side * self.normal])
        c, s = np.cos(angles), np.sin(angles)
        out, back = np.stack([c, s], -1) @ frame, np.stack([s, -c], -1) @ frame
        ring = np.stack([0 * out, width * out, width * out + LEAF * back, LEAF * back], 1) + pivot
        return Boxes(ring, np.full(len(angles), o.sill), np.full(len(angles), o.head))


def gate(o: Opening, rooms: Mapping[str, Polygon], thick: float) -> Gate:
    """An opening; rooms have a side where all along it their floor is no further off than `thick`, there alone."""
    ends = np.array(o.segment, float)
    (x, y), at = ends[1] - ends[0], np.linspace(0.02, 0.98, 9)[:, None] * (ends[1] - ends[0]) + ends[0]
    normal = np.array([-y, x]) / max(float(np.hypot(x, y)), 1e-9)
    found = Gate(ends, (float(at[4, 0]), float(at[4, 1])), normal, {})
    for name in o.rooms:
        rays = {side: shapely.linestrings(np.stack([at, at + side * thick * normal], 1)) for side in (1, -1)}
        floor = {side: shapely.intersection(ray, rooms[name]) for side, ray in rays.items()}
        beside = [side for side in (1, -1) if shapely.length(floor[side]).any()]
        if len(beside) == 1 and shapely.length(floor[beside[0]]).all():
            found.sides[name] = beside[0], float(floor[beside[0]][4].distance(Point(at[4])))
    return found

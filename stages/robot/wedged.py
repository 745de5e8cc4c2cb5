"""Which loose things stand inside others, as a chair's back under a table's edge, so that engines would throw them."""

from collections.abc import Mapping, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from apartgen.stages.things.body import Array, Body
from apartgen.stages.things.solids import corners

DEPTH = 0.001
"""Overlap out of which an engine pushes a loose thing without a jolt, m."""

Shapes = tuple[NDArray[np.object_], Array]


def wedged(bodies: Sequence[Body]) -> dict[str, list[str]]:
    """Names of loose bodies, each with the names of all bodies that it stands in.

    Colliders are taken as upright prisms over their shadows, which is exact for boxes and cylinders that stand.
    """
    solid = [body for body in bodies if any(link.colliders for link in body.links)]
    points = {body.name: _points(body) for body in solid}
    lo, hi = np.array([_bounds(points[body.name]) for body in solid]).reshape(-1, 2, 3).transpose(1, 0, 2)
    shapes: dict[str, Shapes] = {}
    found: dict[str, list[str]] = {}
    for k, body in enumerate(solid):
        near = np.flatnonzero((lo[k] < hi).all(1) & (lo < hi[k]).all(1)) if body.free else ()
        for other in (solid[int(j)] for j in near if j != k):
            if overlap(_of(body, points, shapes), _of(other, points, shapes)):
                found.setdefault(body.name, []).append(other.name)
    return found


def _points(body: Body) -> list[Array]:
    turn = body.pose()[:3, :3]
    local = [corners(c) for link in body.links for c in link.colliders]
    placed = np.concatenate(local) @ turn.T + body.position
    return np.split(placed, np.cumsum([len(own) for own in local[:-1]]))


def _bounds(points: Sequence[Array]) -> tuple[Array, Array]:
    every = np.concatenate(points)
    return every.min(0) + DEPTH / 2, every.max(0) - DEPTH / 2


def _of(body: Body, points: Mapping[str, Sequence[Array]], known: dict[str, Shapes]) -> Shapes:
    if body.name not in known:
        known[body.name] = prisms(points[body.name])
    return known[body.name]


def prisms(points: Sequence[Array]) -> Shapes:
    """Shadows of solids given by their corners, thinner by half the depth all about, and least and greatest heights."""
    every, count = np.concatenate(points), [len(p) for p in points]
    # Lines through the corners have their hulls, and are quicker to make than many points.
    hulls = shapely.convex_hull(shapely.linestrings(every[:, :2], indices=np.repeat(np.arange(len(points)), count)))
    starts = np.cumsum([0, *count[:-1]])
    heights = [end.reduceat(every[:, 2], starts) for end in (np.minimum, np.maximum)]
    return (shapely.buffer(hulls, -DEPTH / 2, join_style="mitre"),
            np.column_stack([heights[0] + DEPTH / 2, heights[1] - DEPTH / 2]))


def overlap(a: Shapes, b: Shapes) -> bool:
    """Whether any prism of one stands in one of the other."""
    one, two = shapely.STRtree(a[0]).query(b[0], predicate="intersects")[::-1]
    return bool(((a[1][one, 0] < b[1][two, 1]) & (b[1][two, 0] < a[1][one, 1])).any())

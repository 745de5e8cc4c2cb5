"""What colliders cover, seen from above, between two heights."""

from collections.abc import Iterable

import numpy as np
import shapely
from shapely import Geometry
from shapely.ops import unary_union

from stages.asset import Array, Collider
from stages.body import Body

_RING = np.linspace(0, 2 * np.pi, 16, endpoint=False)
_CORNERS = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T


def section(bodies: Iterable[Body], low: float, high: float) -> Geometry:
    """Union of the shadows of all colliders that reach between the heights `low` and `high`, m."""
    shadows = []
    for body in bodies:
        turn, shift = body.pose()[:3, :3], body.position
        for collider in (c for link in body.links for c in link.colliders):
            points = (_points(collider) @ collider.rotation.T + collider.center) @ turn.T + shift
            if points[:, 2].min() <= high and points[:, 2].max() >= low:
                shadows.append(shapely.MultiPoint(points[:, :2]).convex_hull)
    return unary_union(shadows)


def _points(c: Collider) -> Array:
    """Points whose hull is the collider, closely, about its centre."""
    if c.kind == "hull":
        assert c.vertices is not None
        return c.vertices
    if c.kind == "box":
        return np.asarray(_CORNERS * c.size)
    ring = np.stack([np.cos(_RING), np.sin(_RING), 0 * _RING], -1) * c.size[0]
    height = [0, 0, c.size[2] / 2 if c.kind == "cylinder" else c.size[0]]
    return np.concatenate([ring + height, ring - height])

"""What colliders cover, seen from above, between two heights."""

from collections.abc import Iterable

import shapely
from shapely import Geometry
from shapely.ops import unary_union

from apartgen.stages.things.body import Body
from apartgen.stages.things.solids import corners


def section(bodies: Iterable[Body], low: float, high: float) -> Geometry:
    """Union of the shadows of all colliders that reach between the heights `low` and `high`, m."""
    shadows = []
    for body in bodies:
        turn, shift = body.pose()[:3, :3], body.position
        for collider in (c for link in body.links for c in link.colliders):
            points = corners(collider) @ turn.T + shift
            if points[:, 2].min() <= high and points[:, 2].max() >= low:
                shadows.append(shapely.MultiPoint(points[:, :2]).convex_hull)
    return unary_union(shadows)

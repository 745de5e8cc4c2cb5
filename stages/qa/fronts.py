"""What is straight ahead of a thing's front."""

import numpy as np
from numpy.typing import NDArray
from shapely import get_coordinates
from shapely.geometry import Polygon

from apartgen.stages.qa.facts import Facts
from apartgen.stages.space import boxes, polygons

FARTHEST = 12.0
"""How far ahead is looked, m."""
THIN = 0.1
"""What is lower lies on the floor and is in nobody's way, m."""
_SKIN = 0.02  # m, by which what only touches the side of the way is left out


def before(facts: Facts, id: str) -> tuple[float, str]:
    """How far it is to the first thing or the wall over the thing's whole width, m, and which thing; empty for a wall.

    Things are met that reach into the thing's own height.
    """
    o = facts.objects[id]
    strip = boxes.spread(boxes.of([o]), [[o.size[0] / 2, -o.size[1] / 2 + _SKIN, 0]],
                         [[FARTHEST, o.size[1] / 2 - _SKIN, 1]])
    way: Polygon = boxes.footprints(strip)[0]
    heading = np.array([np.cos(o.yaw), np.sin(o.yaw)])
    face = float(np.array(o.center[:2]) @ heading) + o.size[0] / 2
    best, met = _nearest(way.difference(polygons.floor(facts.rooms[o.room])), heading, face), ""
    low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
    for other in facts.home.objects:
        bottom, top = other.center[2] - other.size[2] / 2, other.center[2] + other.size[2] / 2
        if other.id == id or other.room != o.room or top <= max(low, THIN) or bottom >= high:
            continue
        far = _nearest(facts.print(other.id).intersection(way), heading, face)
        if far < best:
            best, met = far, other.id
    return best, met


def _nearest(area: Polygon, heading: NDArray[np.float64], face: float) -> float:
    """Least distance of an area's points ahead of the face; inf for an empty one."""
    points = get_coordinates(area)
    return float((points @ heading).min() - face) if len(points) else float("inf")

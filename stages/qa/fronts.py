"""What is straight ahead of a thing's front."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from shapely import get_coordinates
from shapely.geometry import LineString, Polygon

from apartgen.stages.qa.facts import Facts
from apartgen.stages.space import boxes, polygons

FARTHEST = 12.0
"""How far ahead is looked, m."""
THIRDS, SAME = (-2 / 3, 0.0, 2 / 3), 0.15
"""Middles of the thirds of a thing's width, as shares of half of it, and how much further it may be ahead of one, m."""
THIN = 0.1
"""What is lower lies on the floor and is in nobody's way, m."""
WALL = 0.2
"""A door is no farther behind the face of its wall, m."""
DOUBT = 0.05
"""What comes first is nearer than all else by more than this, m."""
_SKIN = 0.02  # m, by which what only touches the side of the way is left out


def before(facts: Facts, id: str, thirds: Sequence[float] = THIRDS) -> tuple[float, str] | None:
    """How far it is to the first thing or the wall, m, and which thing; empty for a wall. None where what comes first
    is not the same before all of these thirds of its width, or something else is as near.

    Things are met that reach into the thing's own height.
    """
    half = facts.objects[id].size[1] / 2
    whole, then = _met(facts, id, 0.0, half - _SKIN)[:2]
    each = [_met(facts, id, middle * half, half / 3 - _SKIN)[0] for middle in thirds]
    sure = then[0] - whole[0] > DOUBT and all(met == whole[1] and far - whole[0] < SAME for far, met in each)
    return whole if sure else None


def parted(facts: Facts, id: str, far: float) -> bool:
    """Whether there is a door or a passage so far ahead, or on the way there one that stands open."""
    o, room = facts.objects[id], facts.objects[id].room
    half = o.size[1] / 2
    way: Polygon = boxes.footprints(boxes.spread(boxes.of([o]), [[o.size[0] / 2, -half, 0]],
                                                 [[o.size[0] / 2 + far + WALL, half, 1]]))[0]
    holes = [hole for hole in facts.home.openings if hole.kind != "window" and room in hole.rooms]
    leaves = [polygons.swing(hole, facts.home) for hole in holes if hole.into == room]
    return any(way.intersects(shape) for shape in (*(LineString(hole.segment) for hole in holes), *leaves))


def _met(facts: Facts, id: str, middle: float, half: float) -> list[tuple[float, str]]:
    """The wall and what comes so far to both sides of a line ahead, which is `middle` to the left of the thing's own,
    by how far it is; two at least.
    """
    o = facts.objects[id]
    strip = boxes.spread(boxes.of([o]), [[o.size[0] / 2, middle - half, 0]], [[FARTHEST, middle + half, 1]])
    way: Polygon = boxes.footprints(strip)[0]
    heading = np.array([np.cos(o.yaw), np.sin(o.yaw)])
    face = float(np.array(o.center[:2]) @ heading) + o.size[0] / 2
    found = [(_nearest(way.difference(polygons.floor(facts.rooms[o.room])), heading, face), ""), (np.inf, "")]
    low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
    for other in facts.home.objects:
        bottom, top = other.center[2] - other.size[2] / 2, other.center[2] + other.size[2] / 2
        if other.id != id and other.room == o.room and top > max(low, THIN) and bottom < high:
            found.append((_nearest(facts.print(other.id).intersection(way), heading, face), other.id))
    return sorted(found)


def _nearest(area: Polygon, heading: NDArray[np.float64], face: float) -> float:
    """Least distance of an area's points ahead of the face; inf for an empty one."""
    points = get_coordinates(area)
    return float((points @ heading).min() - face) if len(points) else float("inf")

"""The walls of a plan one by one: straight pieces that together are all that stands between the rooms and outside."""

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.space import polygons

SPECK = 1e-4
"""What is smaller is no piece of a wall, m²."""


def pieces(plan: Plan) -> list[Polygon]:
    """Walls along the rooms' sides, each as thick as it is there; corners belong to a wall that they lengthen."""
    rest = polygons.shell(plan).difference(shapely.union_all(list(polygons.floors(plan).values())))
    reach = max(plan.walls.outer, 2 * plan.walls.inner) + 0.01
    found: list[Polygon] = []
    for room in plan.rooms:
        ring = np.asarray(orient(polygons.floor(room)).exterior.coords)
        for a, b in zip(ring, ring[1:]):
            before = _before(a, b, reach).intersection(rest)
            edge = shapely.LineString([a, b]).buffer(1e-3, cap_style="flat")
            mine = [part for part in _parts(before) if part.intersection(edge).area > 1e-5]
            found += mine
            rest = rest.difference(shapely.union_all(mine)) if mine else rest
    for corner in _parts(rest):
        shared = [corner.buffer(1e-4).intersection(wall).area for wall in found]
        k = int(np.argmax(shared))
        joined = shapely.union_all([found[k], corner.buffer(1e-5, join_style="mitre")])
        found[k] = joined if isinstance(joined, Polygon) else found[k]
    return [orient(wall.simplify(1e-4)) for wall in found]


def _before(a: NDArray[np.float64], b: NDArray[np.float64], reach: float) -> Polygon:
    """What lies before a room's side, outside the room."""
    unit = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    out = reach * np.array([unit[1], -unit[0]])
    return Polygon([a, a + out, b + out, b])


def _parts(shape: Geometry) -> list[Polygon]:
    return [part for part in shapely.get_parts(shape) if isinstance(part, Polygon) and part.area > SPECK]


def hole(opening: Opening, plan: Plan) -> Polygon:
    """What an opening takes out of the floor plan of its wall, from face to face."""
    reaches = [polygons.face(opening, plan, room)[1] for room in opening.rooms]
    normal, ahead = polygons.face(opening, plan, opening.rooms[0])
    back = reaches[1] if len(reaches) > 1 else plan.walls.outer - ahead
    a, b = np.asarray(opening.segment, float)
    return Polygon([a - back * normal, b - back * normal, b + ahead * normal, a + ahead * normal])

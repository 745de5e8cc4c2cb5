"""R_out: objects whose footprint leaves their room's floor."""

import numpy as np
import shapely
from shapely import Geometry
from shapely.geometry import Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._shares import objects, shares
from apartgen.stages.space import boxes, polygons
from apartgen.stages.space.boxes import TOLERANCE, Array, Boxes

NEEDS = Layout
SHARE = 0.01
"""Share of a footprint that may lie outside."""
PIXELS = 256
"""Side of the picture PhyScene draws a room into."""
MARGIN = 0.2
"""By which the picture reaches beyond the room, m."""


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions: ours = more than 1 % of the footprint or 1 cm outside · published = any pixel of PhyScene's picture,
    whose rounding forgives some centimetres.
    """
    things = objects(home)
    floors = polygons.floors(home)
    areas = boxes.footprints(boxes.of(things))
    ours = [is_outside(area, floors[o.room]) for o, area in zip(things, areas)]
    drawn = [_is_drawn_outside(o, floors[o.room]) for o in things]
    return [
        *shares(home, "R_out", "ours", np.array(ours, bool), things),
        *shares(home, "R_out", "published", np.array(drawn, bool), things),
    ]


def is_outside(area: Geometry, floor: Geometry) -> bool:
    """Whether more than 1 % of a footprint, or any of it by more than 1 cm, lies off the floor."""
    if shapely.difference(area, floor).area > SHARE * area.area:
        return True
    return not floor.buffer(TOLERANCE, join_style="mitre").covers(area)


def _is_drawn_outside(o: Box, floor: Polygon) -> bool:
    """The same in pixels: centre, half sizes and all corners rounded towards zero, edges drawn with their pixels."""
    x0, y0, x1, y1 = floor.bounds
    middle = np.array([x0 + x1, y0 + y1]) / 2
    scale = PIXELS / 2 / (max(x1 - x0, y1 - y0) / 2 + MARGIN)
    room = Polygon(np.trunc((shapely.get_coordinates(floor.exterior) - middle) * scale)).buffer(0.5)
    center = np.trunc((np.array(o.center[:2]) - middle) * scale)
    size = 2 * np.trunc(np.array(o.size[:2]) / 2 * scale)
    pixels = _pixel_corners(center, size, o.yaw)
    outside = not room.covers(shapely.multipoints(pixels))
    return bool(outside or shapely.difference(Polygon(pixels).buffer(0), room).area > 1)


def _pixel_corners(center: Array, size: Array, yaw: float) -> Array:
    box = Boxes(np.array([[*center, 0.0]]), np.array([[*size, 1.0]]), np.array([yaw]))
    # Pixels count from the picture's corner, so that rounding goes down everywhere.
    return np.asarray(np.floor(boxes.corners(box)[0] + PIXELS / 2 + 1e-9) - PIXELS / 2)

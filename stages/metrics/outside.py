"""R_out: objects whose footprint leaves their room's floor."""

import numpy as np
import shapely
from shapely import Geometry

from schemas.layout import Layout
from schemas.metrics import Value
from schemas.plan import Plan, Program
from stages import boxes, grid, polygons
from stages.boxes import TOLERANCE
from stages.grid import Grid
from stages.metrics._shares import objects, shares

NEEDS = Layout
SHARE = 0.01
"""Share of a footprint that may lie outside."""
PIXELS = 256


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions: ours = more than 1 % of the footprint or 1 cm outside · published = any pixel of PhyScene's raster."""
    things = objects(home)
    floors = polygons.floors(home)
    areas = boxes.footprints(boxes.of(things))
    ours = [is_outside(area, floors[o.room]) for o, area in zip(things, areas, strict=True)]
    rasters = {room: _raster(floor) for room, floor in floors.items()}
    pixels = [(grid.raster(area, rasters[o.room][0]) & ~rasters[o.room][1]).any()
              for o, area in zip(things, areas, strict=True)]
    return [
        *shares(home, "R_out", "ours", np.array(ours, bool), things),
        *shares(home, "R_out", "published", np.array(pixels, bool), things),
    ]


def is_outside(area: Geometry, floor: Geometry) -> bool:
    """Whether more than 1 % of a footprint, or any of it by more than 1 cm, lies off the floor."""
    if shapely.difference(area, floor).area > SHARE * area.area:
        return True
    return not floor.buffer(TOLERANCE, join_style="mitre").covers(area)


def _raster(floor: Geometry) -> tuple[Grid, boxes.Mask]:
    """A room in 256 × 256 pixels that reach 0.2 m beyond its farthest corner, as PhyScene draws it."""
    x0, y0, x1, y1 = floor.bounds
    scale = max(x1 - x0, y1 - y0) / 2 + 0.2
    origin = ((x0 + x1) / 2 - scale, (y0 + y1) / 2 - scale)
    cells = Grid(origin, (PIXELS, PIXELS), 2 * scale / PIXELS)
    return cells, grid.raster(floor, cells)

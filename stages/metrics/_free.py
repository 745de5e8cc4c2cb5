"""PhyScene's free floor: a room eroded by a 0.3 m wide robot, less furniture grown by as much."""

from collections.abc import Sequence

import numpy as np
from shapely import Geometry

from schemas.layout import Box
from stages import boxes, grid
from stages.boxes import Mask
from stages.grid import Grid

ROBOT = 0.3
"""Width of PhyScene's robot, m."""
HEIGHT = 1.5
"""What hangs with its centre above does not hinder it, m."""
RESOLUTION = 0.025


def low(objects: Sequence[Box]) -> list[Box]:
    """Objects whose centre is below 1.5 m and that rise above the floor."""
    return [o for o in objects if o.center[2] < HEIGHT and o.center[2] + o.size[2] / 2 > 0.03]


def free(floor: Geometry, objects: Sequence[Box]) -> tuple[Grid, Mask]:
    """Cells of a room where the robot's centre may be."""
    cells = grid.over(floor, RESOLUTION)
    eroded = floor.buffer(-ROBOT / 2, join_style="mitre")
    return cells, grid.raster(eroded, cells) & (grid.near(boxes.of(objects), cells, ROBOT / 2) == 0)


def largest_share(floor: Geometry, objects: Sequence[Box]) -> float:
    """Area of the largest connected part over the free area; 0 without any."""
    sizes = grid.connected(free(floor, low(objects))[1])[1]
    return float(sizes.max() / sizes.sum()) if sizes.sum() else 0.0


def reached_share(floor: Geometry, objects: Sequence[Box], low_only: bool) -> float | None:
    """Mean over the free parts, weighted by area, of the share of objects that each part touches.

    None of a room without objects; 0 of one without free floor.
    """
    things = low(objects) if low_only else list(objects)
    if not things:
        return None
    cells, open_cells = free(floor, things)
    labels, sizes = grid.connected(open_cells)
    if not sizes.sum():
        return 0.0
    # A part touches an object when one of its cells is next to where the object keeps the robot off.
    touched = np.zeros(len(sizes))
    for i in range(len(things)):
        beside = grid.near(boxes.of([things[i]]), cells, ROBOT / 2 + 1.5 * RESOLUTION) > 0
        touched[np.unique(labels[beside])] += 1
    return float((touched[1:] / len(things) * sizes[1:]).sum() / sizes.sum())

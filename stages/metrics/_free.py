"""PhyScene's free floor: a room eroded by a 0.3 m wide robot, less furniture grown by as much."""

from collections.abc import Sequence

import numpy as np
from shapely import Geometry

from apartgen.schemas.layout import Box
from apartgen.stages.space import boxes, grid
from apartgen.stages.space.boxes import Mask
from apartgen.stages.space.grid import Grid

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
    near = grid.near(boxes.of(objects), cells, ROBOT / 2)
    return cells, grid.open_to(floor, cells, ROBOT / 2, "mitre") & (near == 0)


def largest_share(floor: Geometry, objects: Sequence[Box]) -> float:
    """Area of the largest connected part over the free area; 0 without any."""
    sizes = grid.connected(free(floor, low(objects))[1])[1]
    return float(sizes.max() / sizes.sum()) if sizes.sum() else 0.0


def reached_share(floor: Geometry, things: Sequence[Box], wanted: Sequence[Box] | None = None) -> float | None:
    """Mean over the parts of the floor free of `things`, weighted by area, of the share of objects each part touches.

    The objects are `wanted`, all things by default. None of a room without any; 0 of one without free floor.
    """
    asked = things if wanted is None else wanted
    if not asked:
        return None
    cells, open_cells = free(floor, things)
    labels, sizes = grid.connected(open_cells)
    if not sizes.sum():
        return 0.0
    # A part touches an object when one of its cells is next to where the object keeps the robot off.
    touched = np.zeros(len(sizes))
    for o in asked:
        beside = grid.near(boxes.of([o]), cells, ROBOT / 2 + 1.5 * RESOLUTION) > 0
        touched[np.unique(labels[beside])] += 1
    return float((touched[1:] / len(asked) * sizes[1:]).sum() / sizes.sum())

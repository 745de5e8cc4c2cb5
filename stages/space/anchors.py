"""A box in another size: its ends at walls, and its underside, stay where they were."""

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Geometry

from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes

AT_WALL = 0.12
"""A side this close to a wall stays at that distance from it, m."""


def anchors(box: Boxes, floor: Geometry) -> tuple[int, int]:
    """Which end of one box (1) stays where it is, along depth and width: -1 back or right, 1 front or left, 0 neither.

    The end at a wall does; the back comes before the front, and between two walls the middle stays.
    """
    front, left = boxes.axes(box)[0]
    d, w = box.size[0, :2] / 2 + AT_WALL
    beyond = box.center[0, :2] + np.array([-d * front, d * front, -w * left, w * left])
    back, ahead, right, beside = (~shapely.intersects_xy(floor, beyond)).astype(int).tolist()
    return -1 if back else ahead, beside - right


def resized(box: Boxes, size: Sequence[float], floor: Geometry) -> Boxes:
    """One box (1) in another size."""
    lost = (box.size[0] - size) / 2
    shift = np.array(anchors(box, floor)) * lost[:2] @ boxes.axes(box)[0]
    return Boxes(box.center + np.array([[*shift, -lost[2]]]), np.asarray([size], float), box.yaw)

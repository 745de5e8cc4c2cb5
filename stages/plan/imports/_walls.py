"""Walls from their axes: how far they reach at corners."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import LineString, Point, Polygon

Array = NDArray[np.float64]
JOINED = 0.05
"""Walls that end this near another one meet it, m."""


class Axis(NamedTuple):
    """A wall's corners along its middle, (n, 2), and its thickness."""

    points: Array
    thickness: float


def bodies(axes: Sequence[Axis]) -> list[Polygon]:
    """What the walls stand on; where they meet, each reaches through half of the other."""
    lines = [LineString(axis.points) for axis in axes]
    tree = shapely.STRtree(lines)
    out = []
    for k, axis in enumerate(axes):
        points = np.array(axis.points, float)
        for end, before in ((0, 1), (-1, -2)):
            near = tree.query(Point(points[end]).buffer(JOINED), "intersects")
            reach = max((axes[i].thickness / 2 for i in near.tolist() if i != k), default=0.0)
            step = points[end] - points[before]
            points[end] = points[end] + reach * step / max(float(np.hypot(*step)), 1e-9)
        out.append(LineString(points).buffer(axis.thickness / 2, cap_style="flat", join_style="mitre"))
    return out

"""Where a mobile manipulator stands to open a part: within its arm's reach of the handle, out of the part's way.

Where exactly a handle is the artifact does not say; it is taken to be in the middle of a front that slides, and at the
edge of a leaf or lid that is furthest from its hinge.
"""

from collections.abc import Iterator

import numpy as np

from schemas.layout import Box
from schemas.retrieve import Furnishing, Joint
from stages import grid, sweeps
from stages.boxes import Array, Boxes, Mask
from stages.grid import Grid

ARM = 0.9
"""From the middle of its base the robot gets hold of what is no further away, m."""
NEAREST = 0.3
"""Nor nearer, m."""
OPEN = 0.8
"""Share of its range to which a part must be opened."""
_SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)  # of that, at which the part must not come upon the robot


def joints(o: Box) -> list[Joint]:
    """Joints of an object whose parts' extents are known."""
    return [joint for joint in o.joints if joint.extent is not None] if isinstance(o, Furnishing) else []


def handle(joint: Joint) -> Array:
    """Where a hand takes hold of the shut part, object's frame, (3,)."""
    lo, hi = np.array(joint.extent, float)
    point = np.array([hi[0], (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2])
    if joint.type == "hinge":
        across = 2 if abs(joint.axis[1]) > abs(joint.axis[2]) else 1
        point[across] = max(lo[across], hi[across], key=lambda end: abs(end - joint.origin[across]))
    return point


def standing(o: Box, joint: Joint, cells: Grid, radius: float, free: Mask) -> bool:
    """Whether on any of the free cells a robot reaches a part's handle, shut and open, and stays out of its way."""
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    turn, middle = np.array([[c, s], [-s, c]]), np.array(o.center[:2])
    travel = OPEN * max(joint.range, key=abs)
    shut, ajar = (sweeps.at(joint, handle(joint), value)[:2] @ turn + middle for value in (0.0, travel))
    window = cells.around(np.maximum(shut, ajar) - ARM, np.minimum(shut, ajar) + ARM)
    x, y = cells.x[window[1]][None, :], cells.y[window[0]][:, None]
    far = [(x - at[0]) ** 2 + (y - at[1]) ** 2 for at in (shut, ajar)]
    able = free[window] & (np.maximum(*far) <= ARM**2) & (far[0] >= NEAREST**2)
    for box in _passed(o, joint, travel) if able.any() else ():
        able &= grid.near(box, cells.part(window), radius) == 0
        if not able.any():
            return False
    return bool(able.any())


def _passed(o: Box, joint: Joint, travel: float) -> Iterator[Boxes]:
    """Where the part stands on its way, one box each."""
    lo, hi = np.array(joint.extent, float)
    upright = joint.type == "hinge" and abs(joint.axis[2]) > 0.99
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    for share in _SHARES[::-1]:
        value = share * travel
        if upright:
            middle, size, yaw = sweeps.at(joint, (lo + hi) / 2, value), hi - lo, o.yaw + value * np.sign(joint.axis[2])
        else:
            low, high = sweeps.moved(joint, value)
            middle, size, yaw = (low + high) / 2, high - low, o.yaw
        x, y, z = middle
        center = np.array(o.center) + [c * x - s * y, s * x + c * y, z]
        yield Boxes(center[None], size[None], np.array([yaw]))

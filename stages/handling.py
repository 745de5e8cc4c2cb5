"""Where a mobile manipulator stands to open a part: within its arm's reach of the handle, out of the part's way.

Where exactly a handle is the artifact does not say; it is taken to be in the middle of a front that slides, and at the
edge of a leaf or lid that is furthest from its hinge.
"""

from collections.abc import Iterator
from functools import lru_cache
from typing import Literal

import numpy as np

from schemas.base import Vector
from schemas.layout import Box
from schemas.retrieve import Furnishing, Joint
from stages import sweeps
from stages.boxes import Array, Mask
from stages.grid import Grid, Window

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
    pose = (o.center[0], o.center[1], o.yaw)
    window, able = _places(pose, joint.type, joint.axis, joint.origin, joint.range, joint.extent, cells, radius)
    return bool((free[window] & able).any())


@lru_cache(maxsize=8192)
def _places(
    pose: Vector, type: Literal["hinge", "slide"], axis: Vector, origin: Vector, range: tuple[float, float],
    extent: tuple[Vector, Vector] | None, cells: Grid, radius: float,
) -> tuple[Window, Mask]:
    """A window of the raster and the cells in it; kept, because repairs ask for the same again and again."""
    c, s = np.cos(pose[2]), np.sin(pose[2])
    turn = np.array([[c, s], [-s, c]])
    held, passed = _way(type, axis, origin, range, extent)
    shut, ajar = (point @ turn + pose[:2] for point in held)
    window = cells.around(np.maximum(shut, ajar) - ARM, np.minimum(shut, ajar) + ARM)
    x, y = cells.x[window[1]][None, :], cells.y[window[0]][:, None]
    far = [(x - at[0]) ** 2 + (y - at[1]) ** 2 for at in (shut, ajar)]
    able: Mask = (np.maximum(*far) <= ARM**2) & (far[0] >= NEAREST**2)
    for middle, size, yaw in passed:
        along, aside = x - pose[0], y - pose[1]
        across, up = along * c + aside * s - middle[0], aside * c - along * s - middle[1]
        c_part, s_part = np.cos(yaw), np.sin(yaw)
        ahead = np.maximum(np.abs(across * c_part + up * s_part) - size[0] / 2, 0)
        beside = np.maximum(np.abs(up * c_part - across * s_part) - size[1] / 2, 0)
        able &= ahead**2 + beside**2 >= radius**2
    return window, able


@lru_cache(maxsize=4096)
def _way(
    type: Literal["hinge", "slide"], axis: Vector, origin: Vector, range: tuple[float, float],
    extent: tuple[Vector, Vector] | None,
) -> tuple[list[Array], list[tuple[Array, Array, float]]]:
    """In the object's frame: where the handle is, shut and open, (2,) each, and where the part stands on its way."""
    joint = Joint(name="", type=type, axis=axis, origin=origin, range=range, part="", extent=extent)
    travel = OPEN * max(range, key=abs)
    return [sweeps.at(joint, handle(joint), value)[:2] for value in (0.0, travel)], list(_passed(joint, travel))


def _passed(joint: Joint, travel: float) -> Iterator[tuple[Array, Array, float]]:
    """Where the part stands on its way: middle (3,), size (3,) and yaw in the object's frame."""
    lo, hi = np.array(joint.extent, float)
    upright = joint.type == "hinge" and abs(joint.axis[2]) > 0.99
    for value in np.array(_SHARES) * travel:
        if upright:
            yield sweeps.at(joint, (lo + hi) / 2, value), hi - lo, float(value * np.sign(joint.axis[2]))
        else:
            low, high = sweeps.moved(joint, float(value))
            yield (low + high) / 2, high - low, 0.0

"""Where a mobile manipulator stands to open a part: within its arm's reach of the handle, out of the part's way.

Where exactly a handle is the artifact does not say; it is taken to be in the middle of a front that slides, and at the
edge of a leaf or lid that is furthest from its hinge.
"""

from functools import lru_cache
from typing import Literal

import numpy as np

from apartgen.schemas.base import Vector
from apartgen.schemas.layout import Box
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.space import sweeps
from apartgen.stages.space.boxes import Array, Boxes, Mask
from apartgen.stages.space.grid import Grid, Window

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
    # All that the part passes at once, (k, rows, columns).
    middle, size, yaw = passed
    along, aside = (x - pose[0])[None], (y - pose[1])[None]
    across = along * c + aside * s - middle[:, 0, None, None]
    up = aside * c - along * s - middle[:, 1, None, None]
    c, s = np.cos(yaw)[:, None, None], np.sin(yaw)[:, None, None]
    ahead = np.maximum(np.abs(across * c + up * s) - size[:, 0, None, None] / 2, 0)
    beside = np.maximum(np.abs(up * c - across * s) - size[:, 1, None, None] / 2, 0)
    able &= (ahead**2 + beside**2 >= radius**2).all(0)
    return window, able


@lru_cache(maxsize=4096)
def _way(
    type: Literal["hinge", "slide"], axis: Vector, origin: Vector, range: tuple[float, float],
    extent: tuple[Vector, Vector] | None,
) -> tuple[list[Array], Boxes]:
    """In the object's frame: where the handle is, shut and open, (2,) each, and where the part stands on its way."""
    joint = Joint.model_construct(name="", type=type, axis=axis, origin=origin, range=range, part="", extent=extent)
    travel = OPEN * max(range, key=abs)
    return [sweeps.at(joint, handle(joint), value)[:2] for value in (0.0, travel)], _passed(joint, travel)


def _passed(joint: Joint, travel: float) -> Boxes:
    """Where the part stands on its way, in the object's frame."""
    lo, hi = np.array(joint.extent, float)
    values = np.array(_SHARES) * travel
    if joint.type == "hinge" and abs(joint.axis[2]) > 0.99:
        middle = sweeps.at(joint, (lo + hi) / 2, values[:, None])
        return Boxes(middle, np.tile(hi - lo, (len(values), 1)), values * np.sign(joint.axis[2]))
    bounds = np.array([sweeps.moved(joint, value) for value in values.tolist()])
    return Boxes(bounds.mean(1), bounds[:, 1] - bounds[:, 0], np.zeros(len(values)))

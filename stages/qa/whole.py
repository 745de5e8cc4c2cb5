"""Whether a view shows all of a thing that a question about it takes."""

from itertools import product

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.schemas.render import View
from apartgen.schemas.retrieve import Furnishing

WHOLE = 0.85
"""Share of its width and height of which a thing shows at least where it is seen whole."""
NEAREST = 0.05
"""Things that come nearer to the camera are not seen whole, m."""
BEFORE = 0.45
"""Cosine of the angle to the way ahead of a front within which one sees what opens there."""


def whole(view: View, o: Box, rectangle: tuple[int, int, int, int], share: float = WHOLE) -> bool:
    """Whether what is seen of an object, within a rectangle [x, y, width, height], goes nearly, or over this share,
    from side to side and from end to end of its box.
    """
    across, along = _extent(view, o)
    return across > 0 and rectangle[2] > share * across and rectangle[3] > share * along


def _extent(view: View, o: Box) -> tuple[float, float]:
    """Pixels from side to side and from end to end of an object's box, were the view larger and the object alone; zeros
    where some of it lies behind the camera or there is no lens.
    """
    if view.intrinsics is None:
        return 0.0, 0.0
    signs = np.array(list(product((-0.5, 0.5), repeat=3))) * o.size
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    corners = signs @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + o.center
    pose = np.array(view.pose)
    seen = (corners - pose[:3, 3]) @ pose[:3, :3]
    if seen[:, 2].min() < NEAREST:
        return 0.0, 0.0
    wide, high = np.ptp(seen[:, :2] / seen[:, 2:], axis=0) * view.intrinsics[:2]
    return float(wide), float(high)


def before_front(view: View, o: Box) -> bool:
    """Whether a camera is well before the front of an object, if it has parts that open."""
    if not (isinstance(o, Furnishing) and o.joints):
        return True
    ahead = np.array([np.cos(o.yaw), np.sin(o.yaw)])
    way = np.array(view.eye[:2]) - o.center[:2] - ahead * o.size[0] / 2
    return float(way @ ahead) > BEFORE * float(np.linalg.norm(way))

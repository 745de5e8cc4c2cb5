"""Rotations about an axis in space."""

from collections.abc import Sequence
from math import cos, hypot, sin

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def rotation(axis: Sequence[float] | Array, angle: float) -> Array:
    """The turn about an axis of any length by the right hand (Rodrigues), (3, 3)."""
    x, y, z = (float(v) for v in axis)
    length = max(hypot(x, y, z), 1e-12)
    x, y, z, c, s = x / length, y / length, z / length, cos(angle), sin(angle)
    d = 1 - c
    return np.array([
        [c + d * x * x, d * x * y - s * z, d * x * z + s * y],
        [d * x * y + s * z, c + d * y * y, d * y * z - s * x],
        [d * x * z - s * y, d * y * z + s * x, c + d * z * z],
    ])

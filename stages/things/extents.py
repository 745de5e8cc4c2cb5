"""Volumes and bounds of shapes, compiled."""

import numpy as np

from apartgen.stages.compiling import compiled
from apartgen.stages.things.welding import Floats, Integers


@compiled("float64(float64[:,:],int64[:,:])")
def volume(vertices: Floats, faces: Integers) -> float:
    """Of a closed surface (n, 3), (m, 3), by the divergence theorem."""
    found = 0.0
    for i in range(len(faces)):
        p, q, r = faces[i, 0], faces[i, 1], faces[i, 2]
        for k in range(3):
            x, y, z = k, (k + 1) % 3, (k + 2) % 3
            found += (vertices[q, x] * vertices[r, y] - vertices[r, x] * vertices[q, y]) * vertices[p, z]
    return found / 6


@compiled("Tuple((float64[:],float64[:],float64[:,:]))(float64[:,:])")
def centred(points: Floats) -> tuple[Floats, Floats, Floats]:
    """Middle (3,) and sides (3,) of the bounds of points (n, 3), and the points seen from there."""
    middle, sides, local = np.empty(3), np.empty(3), np.empty((len(points), 3))
    for k in range(3):
        low, high = points[0, k], points[0, k]
        for i in range(1, len(points)):
            low, high = min(low, points[i, k]), max(high, points[i, k])
        middle[k], sides[k] = (low + high) / 2, high - low
        for i in range(len(points)):
            local[i, k] = points[i, k] - middle[k]
    return middle, sides, local

# mypy: disable-error-code="no-untyped-def,no-untyped-call"
"""Light of few pixels spread over all, compiled.

Nothing here is imported from the project: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numba import njit

_LIKE = 12.0  # how much less a neighbour counts that is turned another way
_FEW = 0.15  # weight of the nearest four below which more are asked
_OFF = 0.04  # share of the distance from the eye by which a neighbour may be off the surface


@njit("float32(float32[:],float32[:],float32[:],float32[:],float32)", cache=True, error_model="numpy", fastmath=False)
def _alike(point, normal, other, turned, distance):
    """How far two points with normals are of one surface, in (0, 1]."""
    turn, off = np.float32(0.0), np.float32(0.0)
    for k in range(3):
        turn += (normal[k] - turned[k]) ** 2
        off += normal[k] * (other[k] - point[k])
    off /= _OFF * distance + np.float32(0.01)
    return np.float32(np.exp(-_LIKE * turn - off * off) + 1e-6)


@njit("float32[:,:,:](float32[:,:,:],float32[:,:,:],float32[:,:,:],float32[:,:],int64)", cache=True,
      error_model="numpy")
def smoothed(light, point, normal, distance, reach):
    """Light (r, c, 3) averaged over neighbours up to `reach` away that lie on the same surface."""
    rows, columns = distance.shape
    found = np.empty_like(light)
    for i in range(rows):
        for j in range(columns):
            total = np.zeros(3, np.float32)
            weight = np.float32(0.0)
            for y in range(max(0, i - reach), min(rows, i + reach + 1)):
                for x in range(max(0, j - reach), min(columns, j + reach + 1)):
                    w = _alike(point[i, j], normal[i, j], point[y, x], normal[y, x], distance[i, j])
                    weight += w
                    for k in range(3):
                        total[k] += w * light[y, x, k]
            for k in range(3):
                found[i, j, k] = total[k] / weight
    return found


@njit("float32[:,:](float32[:,:,:],float32[:,:,:],float32[:,:,:],int64,int64,float32[:,:],float32[:,:],float32[:,:],"
      "float32[:])", cache=True, error_model="numpy")
def spread(light, point, normal, step, start, where, points, normals, distance):
    """Light at pixels `where` (n, 2: row, column), from that of every `step`-th pixel that lies on the same surface; in
    the last of four columns, how far any did.
    """
    rows, columns = light.shape[:2]
    found = np.empty((len(where), 4), np.float32)
    for n in range(len(where)):
        y, x = (where[n, 0] - start) / step, (where[n, 1] - start) / step
        i, j = min(max(int(np.floor(y)), 0), rows - 2), min(max(int(np.floor(x)), 0), columns - 2)
        total = np.zeros(3, np.float32)
        weight = np.float32(0.0)
        for wide in range(2):
            if weight > _FEW:
                break
            for a in range(max(0, i - wide), min(rows, i + 2 + wide)):
                for b in range(max(0, j - wide), min(columns, j + 2 + wide)):
                    near = max(0.02, 1.0 - abs(a - y)) * max(0.02, 1.0 - abs(b - x))
                    w = np.float32(near * _alike(points[n], normals[n], point[a, b], normal[a, b], distance[n]))
                    weight += w
                    for k in range(3):
                        total[k] += w * light[a, b, k]
        for k in range(3):
            found[n, k] = total[k] / weight
        found[n, 3] = weight
    return found

"""Ways from points to windows and lamps, and the light that comes along them, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]


@compiled("Tuple((float32[:,:],float32[:]))(float32[:,:],float32[:,:],float32[:,:],int64[:],float32[:,:],float32[:],"
          "float32[:],float32[:],float32[:],float32)")
def through_pane(
    start: Floats, normal: Floats, noise: Floats, rows: Ints, shifts: Floats, corner: Floats, across: Floats,
    up: Floats, inward: Floats, area: float
) -> tuple[Floats, Floats]:
    """From those of points (n, 3) in `rows` to places of a window, k for each, (k × rows, 3), and the share of a sky's
    radiance that comes from there. Where on the window, `noise` says, in [0, 1), shifted by each of `shifts` (k, 2).
    """
    to = np.empty((len(shifts) * len(rows), 3), np.float32)
    flux = np.empty(len(to), np.float32)
    for s in range(len(shifts)):
        for r in range(len(rows)):
            i, at = rows[r], s * len(rows) + r
            a, b = noise[i, 0] + shifts[s, 0], noise[i, 1] + shifts[s, 1]
            a, b = a - np.floor(a), b - np.floor(b)
            square, falls, comes = np.float32(0.0), np.float32(0.0), np.float32(0.0)
            for k in range(3):
                to[at, k] = corner[k] + a * across[k] + b * up[k] - start[i, k]
                square += to[at, k] * to[at, k]
                falls += to[at, k] * normal[i, k]
                comes -= to[at, k] * inward[k]
            square = max(square, np.float32(0.04))
            share = area / (square * square * len(shifts))
            flux[at] = max(falls, np.float32(0.0)) * max(comes, np.float32(0.0)) * share
    return to, flux


@compiled("Tuple((float32[:,:],float32[:]))(float32[:,:],float32[:,:],float32[:,:],int64[:],float32[:,:],float32[:],"
          "float32)")
def from_ball(
    start: Floats, normal: Floats, noise: Floats, rows: Ints, shifts: Floats, middle: Floats, radius: float
) -> tuple[Floats, Floats]:
    """The same to places on a ball, all of whose light would fall squarely on a point 1 m away as 1."""
    to = np.empty((len(shifts) * len(rows), 3), np.float32)
    flux = np.empty(len(to), np.float32)
    off = np.empty(3, np.float32)
    for s in range(len(shifts)):
        for r in range(len(rows)):
            i, at = rows[r], s * len(rows) + r
            a, b = noise[i, 0] + shifts[s, 0], noise[i, 1] + shifts[s, 1]
            off[2] = np.float32(1.0) - np.float32(2.0) * (a - np.floor(a))
            ring, turn = np.sqrt(max(np.float32(1.0) - off[2] * off[2], np.float32(0.0))), np.float32(2.0 * np.pi) * b
            off[0], off[1] = ring * np.cos(turn), ring * np.sin(turn)
            square, falls = np.float32(0.0), np.float32(0.0)
            for k in range(3):
                to[at, k] = middle[k] + off[k] * radius - start[i, k]
                square += to[at, k] * to[at, k]
                falls += to[at, k] * normal[i, k]
            square = max(square, np.float32(0.4))
            flux[at] = max(falls, np.float32(0.0)) / (np.sqrt(square) * square * len(shifts))
    return to, flux

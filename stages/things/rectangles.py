"""Rectangles of cells of a grid, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Cells = tuple[int, int, int, int]


@compiled("Tuple((float64,int64,int64))(boolean[:],float64[:])")
def widest(run: Flags, ys: Floats) -> tuple[float, int, int]:
    """How wide the first of the widest stretches of marked columns is, and from which column to which, half open."""
    most, first, last, start = -1.0, 0, 0, 0
    for k in range(len(run)):
        if not run[k]:
            start = k + 1
        elif (k + 1 == len(run) or not run[k + 1]) and ys[k + 1] - ys[start] > most:
            most, first, last = ys[k + 1] - ys[start], start, k + 1
    return most, first, last


@compiled("UniTuple(int64,4)(boolean[:,:],float64[:],float64[:])")
def largest(free: Flags, xs: Floats, ys: Floats) -> Cells:
    """The largest rectangle of free cells: rows and columns, half open; what can't be larger is not looked at."""
    best, found = -1.0, (0, 1, 0, 1)
    for r0 in range(len(free)):
        if (ys[-1] - ys[0]) * (xs[-1] - xs[r0]) <= best:
            break
        run = np.ones(free.shape[1], np.bool_)
        for r1 in range(r0 + 1, len(free) + 1):
            run &= free[r1 - 1]
            wide, first, last = widest(run, ys)
            if wide < 0 or wide * (xs[-1] - xs[r0]) <= best:
                break
            if wide * (xs[r1] - xs[r0]) > best:
                best, found = wide * (xs[r1] - xs[r0]), (r0, r1, first, last)
    return found

"""Rectangles of cells of a grid, compiled.

Nothing here is imported from the project: the cache of compiled code sees changes of this file alone.
"""

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np
from numba import njit
from numpy.typing import NDArray

F = TypeVar("F", bound=Callable[..., Any])
Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Cells = tuple[int, int, int, int]


def compiled(signature: str) -> Callable[[F], F]:
    """Compiled when first imported, and kept in numba's cache."""
    return cast(Callable[[F], F], njit(signature, cache=True, error_model="numpy"))


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

"""Candidates and what stands there in one another's frames, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float64]


@compiled("UniTuple(float64[:,:,::1],4)(float64[:,:],float64[:,:])")
def mutual(one: Floats, two: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Of boxes (n, 7) and (m, 7): middles of the second in the frames of the first, middles of the first in those of
    the second, half extents of the second along the axes of the first and of the first along those of the second,
    (n, m, 2) each."""
    n, m = len(one), len(two)
    there, here, extent, own = np.empty((n, m, 2)), np.empty((n, m, 2)), np.empty((n, m, 2)), np.empty((n, m, 2))
    for i in range(n):
        c, s, half_x, half_y = np.cos(one[i, 2]), np.sin(one[i, 2]), one[i, 3] / 2, one[i, 4] / 2
        for k in range(m):
            host_c, host_s, host_x, host_y = np.cos(two[k, 2]), np.sin(two[k, 2]), two[k, 3] / 2, two[k, 4] / 2
            x, y, turn = two[k, 0] - one[i, 0], two[k, 1] - one[i, 1], two[k, 2] - one[i, 2]
            across, along = abs(np.cos(turn)), abs(np.sin(turn))
            there[i, k, 0], there[i, k, 1] = x * c + y * s, y * c - x * s
            here[i, k, 0], here[i, k, 1] = -x * host_c - y * host_s, x * host_s - y * host_c
            extent[i, k, 0], extent[i, k, 1] = across * host_x + along * host_y, along * host_x + across * host_y
            own[i, k, 0], own[i, k, 1] = across * half_x + along * half_y, along * half_x + across * half_y
    return there, here, extent, own

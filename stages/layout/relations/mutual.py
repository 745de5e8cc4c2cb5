"""Token boxes as upright ones, and candidates and what stands there in one another's frames, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


@compiled(["void(float32[:,:],float64[:,::1],float64[:,::1],float64[::1])",
           "void(float64[:,:],float64[:,::1],float64[:,::1],float64[::1])"])
def stood(boxes: NDArray[Any], center: Floats, size: Floats, yaw: Floats) -> None:
    """Middles (n, 3), sizes (n, 3) and yaws (n,) of token boxes (n, 7), filled in."""
    for i in range(len(boxes)):
        low, high = np.float64(boxes[i, 5]), np.float64(boxes[i, 6])
        center[i, 0], center[i, 1], center[i, 2] = boxes[i, 0], boxes[i, 1], (low + high) / 2
        size[i, 0], size[i, 1], size[i, 2] = boxes[i, 3], boxes[i, 4], high - low
        yaw[i] = boxes[i, 2]


@compiled("void(float64[:,::1],float64[:,::1],float64[::1],float64[::1],float64[::1],float64[:,::1],float64[:,::1])")
def grown(center: Floats, size: Floats, cos: Floats, sin: Floats, far: Floats, at: Floats, extent: Floats) -> None:
    """Middles `at` (n, 3) and extents (n, 3) of boxes turned so as they grow so `far` (n,) in front, filled in."""
    for i in range(len(center)):
        at[i, 0], at[i, 1] = center[i, 0] + cos[i] * far[i] / 2, center[i, 1] + sin[i] * far[i] / 2
        at[i, 2], extent[i, 0], extent[i, 1], extent[i, 2] = center[i, 2], size[i, 0] + far[i], size[i, 1], size[i, 2]


@compiled("Tuple((float64[:,:,::1],float64[:,:,::1],float64[:,:,::1],float64[:,:,::1],float64[:,::1]))"
          "(float64[:,:],float64[:,:])")
def mutual(one: Floats, two: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Of boxes (n, 7) and (m, 7): middles of the second in the frames of the first, middles of the first in those of
    the second, half extents of the second along the axes of the first and of the first along those of the second,
    (n, m, 2) each; and between them, as the second see it, (n, m)."""
    n, m = len(one), len(two)
    there, here, extent, own = np.empty((n, m, 2)), np.empty((n, m, 2)), np.empty((n, m, 2)), np.empty((n, m, 2))
    gap = np.empty((n, m))
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
            past, aside = abs(here[i, k, 0]) - host_x - own[i, k, 0], abs(here[i, k, 1]) - host_y - own[i, k, 1]
            gap[i, k] = np.hypot(max(past, 0.0), max(aside, 0.0))
    return there, here, extent, own, gap


@compiled("float64[::1](float64[:,:],float64[:,:],float64[:,:],float64[::1],float64[:,:],float64[:,::1],float64[:,::1],"
          "float64[:,::1],float64[::1])")
def free(center: Floats, size: Floats, heading: Floats, aside: Floats, towards: Floats, start: Floats, along: Floats,
         normal: Floats, length: Floats) -> Floats:
    """Free length (n,) from the fronts of boxes, which look to `heading` (n, 2), `aside` (n,) of their middles, to
    the wall across; walls (E, 2) begin at `start`, run `along`, look inwards along `normal`, `towards` (n, E) the
    cosines of the headings with these."""
    found = np.full(len(center), np.inf)
    for i in range(len(center)):
        c, s = heading[i]
        x, y = center[i, 0] + c * size[i, 0] / 2 + aside[i] * -s, center[i, 1] + s * size[i, 0] / 2 + aside[i] * c
        for k in range(len(length)):
            approach, u, v = -towards[i, k], x - start[k, 0], y - start[k, 1]
            off = u * normal[k, 0] + v * normal[k, 1]
            if approach > 1e-6 and off > 0:
                far = off / approach
                at = (x + far * c - start[k, 0]) * along[k, 0] + (y + far * s - start[k, 1]) * along[k, 1]
                if 0 <= at <= length[k]:
                    found[i] = min(found[i], far)
    return found


@compiled("boolean[::1](float64[:,:],float64[::1],float64[::1],float64[:],float64[:],float64,float64,float64)")
def askew(center: Floats, cos: Floats, sin: Floats, at: Floats, size: Floats, c: float, s: float, most: float) -> Flags:
    """Which seats (n, 3) look not within the cosine `most` at a table, square to its nearest side or to its middle,
    that stands `at` a place, of some size (3,) each, turned by `c` and `s`; they are turned so (n,) against it."""
    found = np.empty(len(center), np.bool_)
    for i in range(len(center)):
        u, v = center[i, 0] - at[0], center[i, 1] - at[1]
        x, y, across, along = u * c + v * s, v * c - u * s, cos[i], sin[i]
        end = abs(x) - size[0] / 2 > abs(y) - size[1] / 2
        ahead = -(np.sign(x) * across if end else np.sign(y) * along)
        inward = -(x * across + y * along) / max(np.hypot(x, y), 1e-9)
        found[i] = max(ahead, inward) < most
    return found

"""How deep an object would stand in others, walls and ways at every offset it may have, and draws, compiled.

Nothing here is imported from the project: the cache of compiled code sees changes of this file alone.
"""

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np
from numba import njit
from numpy.typing import NDArray

F = TypeVar("F", bound=Callable[..., Any])
Floats = NDArray[np.float32]
Ints = NDArray[np.int64]
SORTS = 4
"""Objects, walls, ways through doors, light of windows; 0 is what is in nobody's way."""
DEEPEST = 0.3
"""Standing deeper in something is no worse, m."""


def compiled(signature: str) -> Callable[[F], F]:
    """Compiled when first imported, and kept in numba's cache."""
    return cast(Callable[[F], F], njit(signature, cache=True))


@compiled("float32[:,:,:](float32[:,:,:],int64[:,:],int64[:],float32[:,:],float32[:,:],int64,float64,float64)")
def depths(
    seen: Floats, sort: Ints, axis: Ints, place: Floats, half: Floats, bins: int, step: float, slack: float
) -> Floats:
    """Depths (R, bins, SORTS) in units of `DEEPEST`, of the deepest of each sort.

    seen (R, T, 9) solids in the frames of the references, sort (R, T), axis (R,) along which the offset runs (0 front,
    1 left); place (R, 3): [other coordinate, low, high], half (R, 2) half extents along the axis and across it.
    """
    rows, tokens = sort.shape
    found = np.zeros((rows, bins, SORTS), np.float32)
    for r in range(rows):
        a = axis[r]
        for t in range(tokens):
            s = sort[r, t]
            if s == 0:
                continue
            aside = half[r, 1] + seen[r, t, 4 - a] - abs(place[r, 0] - seen[r, t, 1 - a])
            tall = min(place[r, 2], seen[r, t, 6]) - max(place[r, 1], seen[r, t, 5])
            least = min(aside, tall) - slack
            if least <= 0:
                continue
            reach = half[r, 0] + seen[r, t, 3 + a] - slack
            middle = seen[r, t, a]
            first = max(0, int(np.ceil((middle - reach) / step)) + bins // 2)
            last = min(bins - 1, int(np.floor((middle + reach) / step)) + bins // 2)
            for k in range(first, last + 1):
                deep = min(least, reach - abs((k - bins // 2) * step - middle)) / DEEPEST
                if deep > found[r, k, s - 1]:
                    found[r, k, s - 1] = min(deep, 1.0)
    return found


@compiled("int64[:,:](float32[:,:],float64[:,:],float64,float64)")
def picked(logits: Floats, chance: NDArray[np.float64], sharp: float, least: float) -> Ints:
    """An index of each row of logits (R, N) for every number in [0, 1) of `chance` (R, times); what is below a share
    `least` of the likeliest is never picked."""
    rows, n = logits.shape
    found = np.empty(chance.shape, np.int64)
    total = np.empty(n)
    for r in range(rows):
        most = logits[r].max()
        so_far = 0.0
        for k in range(n):
            x = sharp * (logits[r, k] - most)
            if x > np.log(least):
                so_far += np.exp(x)
            total[k] = so_far
        for i in range(chance.shape[1]):
            found[r, i] = min(np.searchsorted(total, chance[r, i] * so_far, side="right"), n - 1)
    return found

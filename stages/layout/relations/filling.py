"""What may come next of a room's contents, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Flags = NDArray[np.bool_]
Ints = NDArray[np.int64]


@compiled("boolean[:,::1](int64[:,::1],int64[:,::1],int64[::1],int64[::1],int64[::1],boolean[::1],int64[:,::1],int64)")
def allowed(so_far: Ints, wanted: Ints, left: Ints, last: Ints, rank: Ints, known: Flags, least: Ints,
            most: int) -> Flags:
    """Which categories may come next in rooms, and at last whether a room may end here, (n, C + 1).

    so_far (n, C), wanted (n, C) still to come by category or -1, left (n,) objects or -1, last (n,) rank drawn; rank
    (C,) of categories, known (C,) ones that may be drawn at all, `least` (G, M) groups of which one is needed, filled
    up with -1; `most` objects are in a room."""
    rooms, c = so_far.shape
    may = np.zeros((rooms, c + 1), np.bool_)
    needed = np.empty(c, np.bool_)
    for i in range(rooms):
        bound, due, there = -1, 0, 0
        for k in range(c):
            there += so_far[i, k]
            needed[k] = wanted[i, k] > 0
            if needed[k]:
                due += wanted[i, k]
                bound = rank[k] if bound < 0 else min(bound, rank[k])
            may[i, k] = rank[k] >= last[i] and (needed[k] or wanted[i, k] < 0 and known[k])
        for group in least:
            met, asked, still = False, False, -1
            for k in group:
                if k < 0:
                    continue
                met |= so_far[i, k] > 0
                asked |= wanted[i, k] > 0
                if rank[k] >= last[i] and wanted[i, k] != 0:
                    still = max(still, rank[k])
            if met:
                continue
            if still >= 0:
                bound = still if bound < 0 else min(bound, still)
            if not asked:
                due += 1
                for k in group:
                    if k >= 0:
                        needed[k] = True
        room_for = most - there if left[i] < 0 else min(left[i], most - there)
        first = False
        for k in range(c):
            may[i, k] &= bound < 0 or rank[k] <= bound
            first |= may[i, k] and needed[k]
        some = False
        for k in range(c):
            if left[i] == 0 or room_for <= due and first and not needed[k]:
                may[i, k] = False
            some |= may[i, k]
        may[i, c] = bound < 0 and left[i] <= 0 and not (left[i] < 0 and there == 0) or not some
    return may

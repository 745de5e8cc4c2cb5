"""How deep an object would stand in others, walls and ways at every offset it may have, how far off it would be from
them, and draws, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]
SORTS = 4
"""Objects, walls, ways through doors, light of windows; 0 is what is in nobody's way."""
DEEPEST = 0.3
"""Standing deeper in something is no worse, m."""


@compiled("void(float32[:,:],int64[:],int64,float32[:],float32[:],float64,float64,float32[:,:])")
def _add_depths(
    seen: Floats, sort: Ints, a: int, place: Floats, half: Floats, step: float, slack: float, found: Floats
) -> None:
    """Of one object, as `depths` has them, into `found` (bins, SORTS)."""
    bins = len(found)
    for t in range(len(sort)):
        s = sort[t]
        if s == 0:
            continue
        aside = half[1] + seen[t, 4 - a] - abs(place[0] - seen[t, 1 - a])
        tall = min(place[2], seen[t, 6]) - max(place[1], seen[t, 5])
        least = min(aside, tall) - slack
        if least <= 0:
            continue
        reach = half[0] + seen[t, 3 + a] - slack
        middle = seen[t, a]
        first = max(0, int(np.ceil((middle - reach) / step)) + bins // 2)
        last = min(bins - 1, int(np.floor((middle + reach) / step)) + bins // 2)
        for k in range(first, last + 1):
            deep = min(least, reach - abs((k - bins // 2) * step - middle)) / DEEPEST
            if deep > found[k, s - 1]:
                found[k, s - 1] = min(deep, 1.0)


@compiled("float32[:,:,:](float32[:,:,:],int64[:,:],int64[:],float32[:,:],float32[:,:],int64,float64,float64)")
def depths(
    seen: Floats, sort: Ints, axis: Ints, place: Floats, half: Floats, bins: int, step: float, slack: float
) -> Floats:
    """Depths (R, bins, SORTS) in units of `DEEPEST`, of the deepest of each sort.

    seen (R, T, 9) solids in the frames of the references, sort (R, T), axis (R,) along which the offset runs (0 front,
    1 left); place (R, 3): [other coordinate, low, high], half (R, 2) half extents along the axis and across it.
    """
    found = np.zeros((len(sort), bins, SORTS), np.float32)
    for r in range(len(sort)):
        _add_depths(seen[r], sort[r], axis[r], place[r], half[r], step, slack, found[r])
    return found


FAR = 1.0
"""What is farther off counts as so far off, m."""
NEEDS = np.array([0.15, 0.3, 0.5, 0.7, 0.95], np.float32)
"""Free room that may be needed beside an object, by what comes after it or who uses it, m."""
MEETS = SORTS + 4 * len(NEEDS)
"""Numbers that tell what an object meets at an offset: depths, and what it lacks of each free room on each side."""


@compiled("void(float32[:,:],int64[:],int64,float32[:],float32[:],float64,float64,float32[:,:])")
def _take_rooms(
    seen: Floats, sort: Ints, a: int, place: Floats, half: Floats, step: float, slack: float, found: Floats
) -> None:
    """Of one object, as `rooms` has them, out of `found` (bins, 4)."""
    bins = len(found)
    for t in range(len(sort)):
        if sort[t] == 0 or sort[t] == SORTS:
            continue
        if min(place[2], seen[t, 6]) - max(place[1], seen[t, 5]) <= slack:
            continue
        middle, reach = seen[t, a], seen[t, 3 + a]
        off = abs(place[0] - seen[t, 1 - a]) - half[1] - seen[t, 4 - a]
        if off < FAR:
            # Beside it: it is as far off across the axis as it is.
            way = 2 if seen[t, 1 - a] > place[0] else 3
            wide = half[0] + reach - slack
            first = max(0, int(np.ceil((middle - wide) / step)) + bins // 2)
            last = min(bins - 1, int(np.floor((middle + wide) / step)) + bins // 2)
            for k in range(first, last + 1):
                found[k, way] = min(found[k, way], max(off, 0.0))
        if off < -slack:
            # On its way: how far off hangs on the offset.
            wide = half[0] + reach + FAR
            first = max(0, int(np.ceil((middle - wide) / step)) + bins // 2)
            last = min(bins - 1, int(np.floor((middle + wide) / step)) + bins // 2)
            for k in range(first, last + 1):
                at = (k - bins // 2) * step
                way = 0 if middle > at else 1
                found[k, way] = min(found[k, way], max(abs(at - middle) - half[0] - reach, 0.0))


@compiled("float32[:,:,:](float32[:,:,:],int64[:,:],int64[:],float32[:,:],float32[:,:],int64,float64,float64)")
def rooms(
    seen: Floats, sort: Ints, axis: Ints, place: Floats, half: Floats, bins: int, step: float, slack: float
) -> Floats:
    """Free room (R, bins, 4), m, at most `FAR`: farther along the axis, back along it, outwards and inwards from it;
    what it is to objects, walls and ways, arguments as of `depths`."""
    found = np.full((len(sort), bins, 4), np.float32(FAR))
    for r in range(len(sort)):
        _take_rooms(seen[r], sort[r], axis[r], place[r], half[r], step, slack, found[r])
    return found


@compiled("float32[:,:](float32[:,:],int64[:],int64[:,:],int64[:],float32[:,:],float32[:,:],float32[:,:],int64,float64,"
          "float64)")
def met(
    seen: Floats, sort: Ints, parts: Ints, axis: Ints, place: Floats, half: Floats, counts: Floats, bins: int,
    step: float, slack: float
) -> Floats:
    """What objects meet at every offset, (R, bins): the depths and what is lacking of `NEEDS`, each as far as it
    `counts` (R, MEETS); the solids (N, 9) of row r are those from and to `parts` (R, 2), none where these are equal."""
    found = np.zeros((len(axis), bins), np.float32)
    deep, free = np.empty((bins, SORTS), np.float32), np.empty((bins, 4), np.float32)
    for r in range(len(axis)):
        a, b = parts[r]
        if a == b:
            continue
        deep[:] = 0
        free[:] = FAR
        _add_depths(seen[a:b], sort[a:b], axis[r], place[r], half[r], step, slack, deep)
        _take_rooms(seen[a:b], sort[a:b], axis[r], place[r], half[r], step, slack, free)
        for k in range(bins):
            total = np.float32(0)
            for s in range(SORTS):
                total += deep[k, s] * counts[r, s]
            for way in range(4):
                if free[k, way] < NEEDS[-1]:
                    for i in range(len(NEEDS)):
                        lacking = np.float32(1) - free[k, way] / NEEDS[i]
                        if lacking > 0:
                            total += lacking * counts[r, SORTS + way * len(NEEDS) + i]
            found[r, k] = total
    return found


DEEP = np.array([0.35, 0.7, 1.2, 2.2], np.float32)
"""How deep things are that stand at walls, m."""
LONG = np.array([0.6, 1.0, 1.5, 2.1, 2.8], np.float32)
"""How long stretches of wall are that things or groups need, m."""
FITS = len(DEEP) * len(LONG)
"""Numbers that tell what a wall lacks of free stretches."""
MOST = 64
"""More things than so many are not looked at."""


@compiled("float32[:,:,:,:](float32[:,:,:],boolean[:,:],float32[:,:,:],int64[:,:],int64[:,:],float32[:])")
def stretches(
    boxes: Floats, wall: NDArray[np.bool_], solid: Floats, sort: Ints, there: Ints, deep: Floats
) -> Floats:
    """The longest free stretch (B, Q, T, D), m, of walls (B, T), for things of each depth, among the first `there`
    (B, Q) of solids (B, T, 7) of some sort (B, T); 0 of what is no wall. Boxes (B, T, 7) of a wall have no depth."""
    b, t = sort.shape
    found = np.zeros((b, there.shape[1], t, len(deep)), np.float32)
    low, high, near = np.zeros(MOST), np.zeros(MOST), np.zeros(MOST)
    row = np.zeros(MOST, np.int64)
    for i in range(b):
        for w in range(t):
            if not wall[i, w]:
                continue
            c, s, half = np.cos(boxes[i, w, 2]), np.sin(boxes[i, w, 2]), boxes[i, w, 4] / 2
            n = 0
            for u in range(t):
                if sort[i, u] == 0 or sort[i, u] == SORTS or solid[i, u, 5] > 1.5 or n == MOST:
                    continue
                x, y = solid[i, u, 0] - boxes[i, w, 0], solid[i, u, 1] - boxes[i, w, 1]
                x, y = x * c + y * s, y * c - x * s
                turn = solid[i, u, 2] - boxes[i, w, 2]
                across, along = abs(np.cos(turn)), abs(np.sin(turn))
                ex = (solid[i, u, 3] * across + solid[i, u, 4] * along) / 2
                ey = (solid[i, u, 3] * along + solid[i, u, 4] * across) / 2
                if x + ex < 0.05 or x - ex > deep[-1] or y - ey > half or y + ey < -half:
                    continue
                k = n
                while k > 0 and low[k - 1] > y - ey:
                    low[k], high[k], near[k], row[k] = low[k - 1], high[k - 1], near[k - 1], row[k - 1]
                    k -= 1
                low[k], high[k], near[k], row[k] = y - ey, y + ey, x - ex, u
                n += 1
            for q in range(there.shape[1]):
                for d in range(len(deep)):
                    at, best = -half, 0.0
                    for k in range(n):
                        if row[k] < there[i, q] and near[k] < deep[d] - 0.02:
                            best = max(best, low[k] - at)
                            at = max(at, high[k])
                    found[i, q, w, d] = max(best, half - at)
    return found


@compiled("Tuple((int64[::1],float64[::1]))(float64[::1],int64[::1],float64[:])")
def summed(key: NDArray[np.float64], order: Ints, weight: NDArray[np.float64]) -> tuple[Ints, NDArray[np.float64]]:
    """Of things (n,) in the `order` of their keys the first of each key, and the weight of all of it, (k,)."""
    first, total, k = np.empty(len(key), np.int64), np.zeros(len(key)), -1
    for i in range(len(order)):
        if i == 0 or key[order[i]] != key[order[i - 1]]:
            k += 1
            first[k] = order[i]
        total[k] += weight[order[i]]
    return first[: k + 1].copy(), total[: k + 1].copy()


@compiled("int64[:,:](float32[:,:],float64[:,:],float64,float64)")
def picked(logits: Floats, chance: NDArray[np.float64], sharp: float, least: float) -> Ints:
    """An index of each row of logits (R, N) for every number in [0, 1) of `chance` (R, times); what is below a share
    `least` of the likeliest is never picked."""
    rows, n = logits.shape
    found = np.empty(chance.shape, np.int64)
    total = np.empty(n)
    for r in range(rows):
        most = logits[r, 0]
        for k in range(n):
            most = max(most, logits[r, k])
        so_far = 0.0
        for k in range(n):
            x = sharp * (logits[r, k] - most)
            if x > np.log(least):
                so_far += np.exp(x)
            total[k] = so_far
        for i in range(chance.shape[1]):
            found[r, i] = min(np.searchsorted(total, chance[r, i] * so_far, side="right"), n - 1)
    return found

"""From what an object is described, and which number it has, one's own or that of another token: compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]
FAST = {"contract", "reassoc"}
"""Sums may be taken in the order that is fastest."""


@compiled("float32[::1](float32[::1],float32[::1],float32[:,::1],float32[:,::1],float32[:,:,::1],int64)", fastmath=FAST)
def referring(query: Floats, asks: Floats, referred: Floats, tells: Floats, lies: Floats, shell: int) -> Floats:
    """Logits (n,) of the tokens that may be referred to: a query (W,) of each, `referred` (n, W), and what objects,
    which come after the shell, tell (n, K) of how tokens lie to them (J, T, K), as far as it `asks` (K,)."""
    n, k = tells.shape
    found = np.zeros(n, np.float32)
    share = np.empty(k, np.float32)
    for t in range(n):
        total = np.float32(0)
        for c in range(len(query)):
            total += query[c] * referred[t, c]
        found[t] = total
    for j in range(shell, n):
        for c in range(k):
            share[c] = asks[c] * tells[j, c]
        for t in range(n):
            total = np.float32(0)
            for c in range(k):
                total += share[c] * lies[j - shell, t, c]
            found[t] += total
    return found


@compiled("float32[::1](float32[:,::1],int64[::1],int64,float64)", fastmath=FAST)
def alike(boxes: Floats, category: Ints, asked: int, near: float) -> Floats:
    """How near to each token (n, 7) others of a category are, (n,): 1 at it, 0 far off."""
    found = np.zeros(len(boxes), np.float32)
    for j in range(len(boxes)):
        if category[j] != asked:
            continue
        for t in range(len(boxes)):
            x, y = boxes[j, 0] - boxes[t, 0], boxes[j, 1] - boxes[t, 1]
            c, s = np.cos(boxes[t, 2]), np.sin(boxes[t, 2])
            past = max(abs(x * c + y * s) - boxes[t, 3] / 2, 0.0)
            aside = max(abs(y * c - x * s) - boxes[t, 4] / 2, 0.0)
            found[t] = max(found[t], np.exp(-np.sqrt(past * past + aside * aside) / near))
    return found


@compiled("float32[:,::1](float32[:,::1],float32[::1],float32[:,::1],int64[::1],int64[::1],int64)", fastmath=FAST)
def scores(query: Floats, more: Floats, keys: Floats, which: Ints, starts: Ints, ways: int) -> Floats:
    """Of rows (R, ways * K) that point, and as much `more` (R,), the scores (P, ways) of the tokens (N, K) that they
    may point at: those of row r are `which` from `starts` r on."""
    k = keys.shape[1]
    found = np.empty((len(which), ways), np.float32)
    for r in range(len(query)):
        for p in range(starts[r], starts[r + 1]):
            for a in range(ways):
                total = np.float32(0)
                for c in range(k):
                    total += query[r, a * k + c] * keys[which[p], c]
                found[p, a] = total + more[r]
    return found


@compiled("int64[:,::1](float32[:,::1],float32[:,::1],float32[:,::1],float64,int64[:,::1],float32[:,::1],boolean[::1],"
          "int64[::1],float64[:,::1],float64,float64)", fastmath=FAST)
def picked(logits: Floats, met: Floats, points: Floats, share: float, at: Ints, more: Floats,
           there: NDArray[np.bool_], starts: Ints, chance: NDArray[np.float64], sharp: float, least: float) -> Ints:
    """For every number in [0, 1) of `chance` (R, times) a bin of row r, or beyond these a token and way, P · ways more.

    logits (R, bins), of which `met` (R, bins or 0) is part, points (P, ways) beside a share of the logit of the bin
    `at` (P, ways) and `more` (P, 1 or 0), of tokens that are `there` (P,); what is below a share `least` of the
    likeliest is never picked."""
    rows, bins = logits.shape
    ways = points.shape[1]
    found = np.empty(chance.shape, np.int64)
    most_tokens = 0
    for r in range(rows):
        most_tokens = max(most_tokens, starts[r + 1] - starts[r])
    row, total = np.empty(bins + most_tokens * ways, np.float32), np.empty(bins + most_tokens * ways)
    low = np.log(least)
    for r in range(rows):
        for k in range(bins):
            row[k] = logits[r, k]
        n = bins
        for p in range(starts[r], starts[r + 1]):
            for a in range(ways):
                if there[p]:
                    row[n] = points[p, a] + np.float32(share) * row[at[p, a]]
                    if met.shape[1]:
                        row[n] += met[r, at[p, a]]
                    if more.shape[1]:
                        row[n] += more[p, 0]
                else:
                    row[n] = -1e9
                n += 1
        most, last, so_far = row[0], 0, 0.0
        for k in range(n):
            most = max(most, row[k])
        for k in range(n):
            x = sharp * (row[k] - most)
            if x > low:
                so_far += np.exp(x)
                last = k
            total[k] = so_far
        for i in range(chance.shape[1]):
            k = min(np.searchsorted(total[:n], chance[r, i] * so_far, side="right"), last)
            found[r, i] = k if k < bins else k - bins + starts[r] * ways + bins
    return found

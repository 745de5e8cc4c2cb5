"""What networks are made of, compiled: products with weights, norms, the gate, attention.

A row is computed in the same order of sums whatever rows it comes with, so that what is said of a room hangs neither on
the others nor on the number of threads. Of the project only what compiles is imported: the cache of compiled code sees
changes of this file alone.
"""


import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]
LANES = 16
"""Sums over a row are of so many sums, which one instruction adds to."""
EPSILON = np.float32(1e-5)
FAST = {"contract"}
"""Products may be added without rounding between."""

within = compiled(fastmath=FAST, inline="always")
"""Compiled as part of others."""


@compiled("void(float32[:,::1],float32[:,::1],float32[:,::1],int64)", fastmath=FAST)
def _eight_rows(x: Floats, weight: Floats, out: Floats, i: int) -> None:
    """Add the products of eight rows from `i` on, four inputs at a time."""
    k = x.shape[1]
    o0, o1, o2, o3, o4, o5, o6, o7 = (
        out[i], out[i + 1], out[i + 2], out[i + 3], out[i + 4], out[i + 5], out[i + 6], out[i + 7])
    for p in range(0, k - 3, 4):
        v, w, y, z = weight[p], weight[p + 1], weight[p + 2], weight[p + 3]
        a0, b0, c0, d0 = x[i, p], x[i, p + 1], x[i, p + 2], x[i, p + 3]
        a1, b1, c1, d1 = x[i + 1, p], x[i + 1, p + 1], x[i + 1, p + 2], x[i + 1, p + 3]
        a2, b2, c2, d2 = x[i + 2, p], x[i + 2, p + 1], x[i + 2, p + 2], x[i + 2, p + 3]
        a3, b3, c3, d3 = x[i + 3, p], x[i + 3, p + 1], x[i + 3, p + 2], x[i + 3, p + 3]
        a4, b4, c4, d4 = x[i + 4, p], x[i + 4, p + 1], x[i + 4, p + 2], x[i + 4, p + 3]
        a5, b5, c5, d5 = x[i + 5, p], x[i + 5, p + 1], x[i + 5, p + 2], x[i + 5, p + 3]
        a6, b6, c6, d6 = x[i + 6, p], x[i + 6, p + 1], x[i + 6, p + 2], x[i + 6, p + 3]
        a7, b7, c7, d7 = x[i + 7, p], x[i + 7, p + 1], x[i + 7, p + 2], x[i + 7, p + 3]
        for j in range(weight.shape[1]):
            s, t, u, r = v[j], w[j], y[j], z[j]
            o0[j] = o0[j] + a0 * s + b0 * t + c0 * u + d0 * r
            o1[j] = o1[j] + a1 * s + b1 * t + c1 * u + d1 * r
            o2[j] = o2[j] + a2 * s + b2 * t + c2 * u + d2 * r
            o3[j] = o3[j] + a3 * s + b3 * t + c3 * u + d3 * r
            o4[j] = o4[j] + a4 * s + b4 * t + c4 * u + d4 * r
            o5[j] = o5[j] + a5 * s + b5 * t + c5 * u + d5 * r
            o6[j] = o6[j] + a6 * s + b6 * t + c6 * u + d6 * r
            o7[j] = o7[j] + a7 * s + b7 * t + c7 * u + d7 * r


@compiled("void(float32[:,::1],float32[:,::1],float32[:,::1],int64)", fastmath=FAST)
def _one_row(x: Floats, weight: Floats, out: Floats, i: int) -> None:
    o = out[i]
    for p in range(0, x.shape[1] - 3, 4):
        v, w, y, z = weight[p], weight[p + 1], weight[p + 2], weight[p + 3]
        a, b, c, d = x[i, p], x[i, p + 1], x[i, p + 2], x[i, p + 3]
        for j in range(weight.shape[1]):
            o[j] = o[j] + a * v[j] + b * w[j] + c * y[j] + d * z[j]


@compiled("void(float32[:,::1],float32[:,::1],float32[::1],float32[:,::1])", fastmath=FAST)
def add_product(x: Floats, weight: Floats, bias: Floats, out: Floats) -> None:
    """Add x (N, K) @ weight (K, M) + bias (M,) to `out` (N, M)."""
    n, k = x.shape
    for i in range(n):
        for j in range(len(bias)):
            out[i, j] += bias[j]
    whole = n - n % 8
    for i in range(0, whole, 8):
        _eight_rows(x, weight, out, i)
    for i in range(whole, n):
        _one_row(x, weight, out, i)
    for p in range(k - k % 4, k):
        for i in range(n):
            a = x[i, p]
            for j in range(len(bias)):
                out[i, j] += a * weight[p, j]


@compiled("float32[:,::1](float32[:,::1],float32[:,::1],float32[::1])", fastmath=FAST)
def product(x: Floats, weight: Floats, bias: Floats) -> Floats:
    """x (N, K) @ weight (K, M) + bias (M,)."""
    out = np.zeros((len(x), len(bias)), np.float32)
    add_product(x, weight, bias, out)
    return out


@compiled("float32[:,::1](float32[:,::1],float32[::1],float32[::1])", fastmath=FAST)
def normed(x: Floats, gain: Floats, bias: Floats) -> Floats:
    """Rows (N, W) less their mean, over their deviation, times a gain, plus a bias."""
    n, w = x.shape
    out = np.empty((n, w), np.float32)
    sums = np.empty(LANES, np.float32)
    for i in range(n):
        sums[:] = 0
        for p in range(0, w - LANES + 1, LANES):
            for j in range(LANES):
                sums[j] += x[i, p + j]
        for j in range(w - w % LANES, w):
            sums[0] += x[i, j]
        mean = np.float32(0)
        for j in range(LANES):
            mean += sums[j]
        mean /= np.float32(w)
        sums[:] = 0
        for j in range(w - w % LANES, w):
            sums[0] += (x[i, j] - mean) * (x[i, j] - mean)
        for p in range(0, w - LANES + 1, LANES):
            for j in range(LANES):
                off = x[i, p + j] - mean
                sums[j] += off * off
        spread = np.float32(0)
        for j in range(LANES):
            spread += sums[j]
        scale = np.float32(1) / np.sqrt(spread / np.float32(w) + EPSILON)
        for j in range(w):
            out[i, j] = (x[i, j] - mean) * scale * gain[j] + bias[j]
    return out


@within
def _exp(x: np.float32) -> np.float32:
    """e^x to some 2e-7 of it, in a form that is done for many numbers at once; Cephes' polynomial."""
    x = min(max(x, np.float32(-87)), np.float32(88))
    n = np.floor(x * np.float32(1.44269504) + np.float32(0.5))
    r = x - n * np.float32(0.693359375) + n * np.float32(2.12194440e-4)
    p = np.float32(1.9875691500e-4)
    p = p * r + np.float32(1.3981999507e-3)
    p = p * r + np.float32(8.3334519073e-3)
    p = p * r + np.float32(4.1665795894e-2)
    p = p * r + np.float32(1.6666665459e-1)
    p = p * r + np.float32(5.0000001201e-1)
    p = p * r * r + r + np.float32(1)
    found: np.float32 = p * np.int32((np.int32(n) + np.int32(127)) << np.int32(23)).view(np.float32)
    return found


@compiled("void(float32[:,::1])", fastmath=FAST)
def gate(x: Floats) -> None:
    """GELU by its tanh form, in place: x · σ(2u), u = √(2/π) (x + 0.044715 x³)."""
    n, w = x.shape
    for i in range(n):
        row = x[i]
        for j in range(w):
            v = row[j]
            u = np.float32(-1.5957691216057308) * (v + np.float32(0.044715) * v * v * v)
            row[j] = v / (np.float32(1) + _exp(u))


@within
def _shares(x: Floats, n: int) -> None:
    """Softmax of the first n numbers, in place."""
    most = x[0]
    for j in range(1, n):
        most = max(most, x[j])
    for j in range(len(x)):
        x[j] = _exp(x[j] - most)
    total = np.float32(0)
    for j in range(n):
        total += x[j]
    share = np.float32(1) / total
    for j in range(len(x)):
        x[j] *= share


@compiled("void(float32[:,::1],float32[:,::1],float32[:,::1],int64,boolean,int64,float32[:,::1])", fastmath=FAST)
def attend(asks: Floats, keys: Floats, values: Floats, first: int, causal: bool, heads: int, out: Floats) -> None:
    """What rows (n, 3 W), of which the first W ask, gather from `values` (T, W) by `keys` (T, W), (n, W): row i sees
    all or, where causal, those up to `first` + i."""
    n, w = out.shape
    t, d = len(keys), w // heads
    scale = np.float32(np.sqrt(1.0 / d))
    # Whole lanes, of which what is past the last token counts nothing.
    turned = np.zeros((d, t + LANES), np.float32)
    scores = np.empty(t + LANES, np.float32)
    for h in range(heads):
        for j in range(t):
            for c in range(d):
                turned[c, j] = keys[j, h * d + c] * scale
        for i in range(n):
            m = min(first + i + 1, t) if causal else t
            likely = scores[: (m + LANES - 1) // LANES * LANES]
            likely[:] = 0
            for c in range(d - d % 4, d):
                for j in range(len(likely)):
                    likely[j] = likely[j] + asks[i, h * d + c] * turned[c, j]
            for c in range(0, d - 3, 4):
                q0, q1 = asks[i, h * d + c], asks[i, h * d + c + 1]
                q2, q3 = asks[i, h * d + c + 2], asks[i, h * d + c + 3]
                k0, k1, k2, k3 = turned[c], turned[c + 1], turned[c + 2], turned[c + 3]
                for j in range(len(likely)):
                    likely[j] = likely[j] + q0 * k0[j] + q1 * k1[j] + q2 * k2[j] + q3 * k3[j]
            _shares(likely, m)
            row = out[i, h * d : h * d + d]
            row[:] = 0
            whole = m - m % 4
            for j in range(0, whole, 4):
                p0, p1, p2, p3 = likely[j], likely[j + 1], likely[j + 2], likely[j + 3]
                for c in range(d):
                    v = h * d + c
                    row[c] = row[c] + p0 * values[j, v] + p1 * values[j + 1, v] + p2 * values[j + 2, v] + (
                        p3 * values[j + 3, v])
            for j in range(whole, m):
                for c in range(d):
                    row[c] += likely[j] * values[j, h * d + c]


@compiled("float32[:,::1](float32[:,::1],int64[::1],int64)", fastmath=FAST)
def attend_within(mixed: Floats, starts: Ints, heads: int) -> Floats:
    """Attention of tokens (N, 3 W), which ask, have keys and values, within parts that begin and end at `starts`."""
    w = mixed.shape[1] // 3
    out = np.empty((len(mixed), w), np.float32)
    for s in range(len(starts) - 1):
        a, b = starts[s], starts[s + 1]
        part = np.ascontiguousarray(mixed[a:b])
        attend(part, np.ascontiguousarray(part[:, w : 2 * w]), np.ascontiguousarray(part[:, 2 * w :]), 0, False, heads,
               out[a:b])
    return out

"""Rows of numbers as text, compiled: what Python's `%.6g` and `%d` write, to the letter.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled
from apartgen.stages.things.welding import Floats, Integers

Bytes = NDArray[np.uint8]
LARGEST = 999_999.0
"""Numbers below this have no positive exponent."""
LEAST = 5e-7
"""Smaller numbers are written as zero."""
WIDEST = 13
"""Letters of a number at most, and the blank behind it."""
POWERS = 10.0 ** np.arange(13)
SPLIT = 134217729.0
"""Cuts a number of 53 bits into two of 26 (Dekker 1971)."""


@compiled("int64(float64,int64)")
def digits(value: float, power: int) -> int:
    """The whole number nearest to value · 10^power, the even one of two: the product's rounding is made good."""
    factor = POWERS[power]
    product = value * factor
    cut, other = SPLIT * value, SPLIT * factor
    a, c = cut - (cut - value), other - (other - factor)
    b, d = value - a, factor - c
    lost = b * d - (((product - a * c) - b * c) - a * d)
    whole = np.floor(product)
    over = (product - whole - 0.5) + lost
    found = int(whole)
    return found + 1 if over > 0 or (over == 0 and found % 2 == 1) else found


@compiled("int64(uint8[:],int64,int64)")
def put_whole(out: Bytes, at: int, value: int) -> int:
    """A whole number, not negative; where it ends."""
    length, rest = 1, value // 10
    while rest > 0:
        length, rest = length + 1, rest // 10
    for k in range(at + length - 1, at - 1, -1):
        out[k] = 48 + value % 10
        value //= 10
    return at + length


@compiled("int64(uint8[:],int64,float64)")
def put(out: Bytes, at: int, value: float) -> int:
    """A number to six digits; where it ends."""
    size = abs(value)
    if size < LEAST:
        out[at] = 48
        return at + 1
    if value < 0:
        out[at] = 45
        at += 1
    exponent = -7
    while exponent < 5 and size * 1e7 >= POWERS[exponent + 8]:
        exponent += 1
    found = digits(size, 5 - exponent)
    if found >= 1_000_000:
        found, exponent = 100_000, exponent + 1
    count = 6
    while found % 10 == 0:
        found, count = found // 10, count - 1
    if exponent >= 0:
        ahead = exponent + 1
        if count <= ahead:
            return put_whole(out, at, found * int(POWERS[ahead - count]))
        end = put_whole(out, at + 1, found)
        for k in range(at, at + ahead):
            out[k] = out[k + 1]
        out[at + ahead] = 46
        return end
    if exponent >= -4:
        out[at], out[at + 1] = 48, 46
        for k in range(-exponent - 1):
            out[at + 2 + k] = 48
        return put_whole(out, at + 1 - exponent, found)
    end = put_whole(out, at + 1, found)
    out[at] = out[at + 1]
    out[at + 1] = 46
    end = end if count > 1 else at + 1
    out[end], out[end + 1], out[end + 2], out[end + 3] = 101, 45, 48, 48 - exponent
    return end + 4


@compiled("uint8[:](uint8[:],float64[:,:])")
def rows(tag: Bytes, values: Floats) -> Bytes:
    """Lines of a word and the numbers of a row (n, k), all smaller than `LARGEST`."""
    out = np.empty(len(values) * (len(tag) + 1 + WIDEST * values.shape[1]), np.uint8)
    at = 0
    for i in range(len(values)):
        out[at:at + len(tag)] = tag
        at += len(tag)
        for k in range(values.shape[1]):
            out[at] = 32
            at = put(out, at + 1, values[i, k])
        out[at] = 10
        at += 1
    return out[:at]


@compiled("uint8[:](int64[:,:],boolean)")
def triangles(faces: Integers, textured: bool) -> Bytes:
    """Lines of faces (m, 3) whose corners have a normal each, and texture coordinates where they are textured."""
    out = np.empty(len(faces) * (3 + 3 * 3 * 20), np.uint8)
    at = 0
    for i in range(len(faces)):
        out[at] = 102
        at += 1
        for k in range(3):
            out[at] = 32
            at = put_whole(out, at + 1, faces[i, k] + 1)
            out[at] = 47
            at += 1
            if textured:
                at = put_whole(out, at, faces[i, k] + 1)
            out[at] = 47
            at = put_whole(out, at + 1, faces[i, k] + 1)
        out[at] = 10
        at += 1
    return out[:at]

"""What an object is in the frame of its reference: heading, size, side, gap, offsets, and back again.

Numbers are bins; a number may also be that of another token: an edge or the middle of it (`aligned`), its size, its
height. Values carry floats beside their bins, so that what is exact stays exact.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.tokens import OBJECT, ROOM, Array, Ints

HEADINGS = 72
FRONT, BACK, LEFT, RIGHT, OVER = range(5)
"""Sides of a reference; what shares its footprint is `OVER` it, above or below."""
SIDES = 5
GAPS = np.concatenate([np.arange(-30, 31) * 0.02, 0.625 + np.arange(24) * 0.05, 1.875 + np.arange(40) * 0.15])
"""Middles of the bins of the distance between faces: 2 cm near, 15 cm far."""
_GAP_EDGES = (GAPS[1:] + GAPS[:-1]) / 2
OFFSET, OFFSETS = 0.03, 401
"""Width and number of the bins along a face, the middle one at the reference's middle."""
SIZE, SIZES = 0.02, 201
LEVEL, LEVELS = 0.05, 61
"""Bins of the underside's height."""
ALIGNMENTS = 5
"""Middle at middle, low at low edge, high at high, low at high (beside it), high at low."""
LEVELLINGS = 3
"""Underside at underside, underside at top, top at top."""
CLOSE = 0.008
"""What differs by no more is the same, m."""
INSIDE = -0.75
"""What overlaps by a larger share of the smaller extent is over its reference, not at its side."""
BEHIND = -0.3
"""Nothing stands farther behind a wall that it is described from, m."""


class Attributes(NamedTuple):
    """Objects (...,) in their references' frames: bins of heading, side, gap; size (..., 3), along (...,) and across
    (...,) as metres (`across` where side is OVER), low: underside's height; `fit`: whether the frame can say it."""

    heading: Ints
    size: Array
    side: Ints
    gap: Ints
    along: Array
    across: Array
    low: Array
    fit: NDArray[np.bool_]

    def take(self, which: Ints) -> "Attributes":
        """Those of some objects (n,)."""
        return Attributes(self.heading[which], self.size[which], self.side[which], self.gap[which], self.along[which],
                          self.across[which], self.low[which], self.fit[which])


def gap_bin(gap: NDArray[np.floating]) -> Ints:
    """The bin of a distance between faces."""
    return np.asarray(np.searchsorted(_GAP_EDGES, gap), np.int64)


def offset_bin(value: NDArray[np.floating]) -> Ints:
    """The bin of an offset."""
    return np.asarray(np.minimum(np.maximum(np.rint(value / OFFSET) + OFFSETS // 2, 0), OFFSETS - 1), np.int64)


def size_bin(value: NDArray[np.floating]) -> Ints:
    """The bin of a length."""
    return np.asarray(np.minimum(np.maximum(np.rint(value / SIZE), 0), SIZES - 1), np.int64)


def level_bin(value: NDArray[np.floating]) -> Ints:
    """The bin of a height."""
    return np.asarray(np.minimum(np.maximum(np.rint(value / LEVEL), 0), LEVELS - 1), np.int64)


def describe(seen: Array, half: Array, kind: Ints) -> Attributes:
    """Objects (..., 9), as `tokens.seen` sees them from their references, whose half extents are (..., 2) and kinds
    (...,)."""
    x, y, yaw = (seen[..., k] for k in range(3))
    is_box = (kind == OBJECT) | (kind == ROOM)
    side, gap, over = sides(seen, half, is_box)
    along = np.where((side == LEFT) | (side == RIGHT), x, y)
    fit = over | ((gap > np.where(is_box, GAPS[0] - 0.01, BEHIND)) & (gap < GAPS[-1]))
    fit &= np.abs(along) < OFFSET * (OFFSETS // 2)
    size = np.stack([seen[..., 7], seen[..., 8], seen[..., 6] - seen[..., 5]], -1)
    heading = np.rint(yaw / (2 * np.pi / HEADINGS)).astype(np.int64) % HEADINGS
    return Attributes(heading, size, side.astype(np.int64), gap_bin(gap), along, np.where(over, x, 0.0), seen[..., 5],
                      fit)


def sides(seen: Array, half: Array, is_box: NDArray[np.bool_] | bool) -> tuple[Ints, Array, NDArray[np.bool_]]:
    """The side of its reference on which each of (..., 9) stands, how far off its face, and whether it is over it; what
    is no box has a front alone."""
    x, y, ex, ey = seen[..., 0], seen[..., 1], seen[..., 3], seen[..., 4]
    a, b = half[..., 0], half[..., 1]
    gaps = np.stack([x - ex - a, -x - ex - a, y - ey - b, -y - ey - b], -1)
    side = np.where(is_box, gaps.argmax(-1), FRONT)
    gap = np.where(is_box, gaps.max(-1), gaps[..., FRONT])
    less = np.where(side < LEFT, np.minimum(ex, a), np.minimum(ey, b))
    over = is_box & (gap < INSIDE * 2 * less - 1e-6)
    return np.where(over, OVER, side), gap, over


def extents(heading: Ints, size: Array) -> tuple[Array, Array]:
    """Half extents of the box about a footprint, along the reference's front and left."""
    yaw = heading * (2 * np.pi / HEADINGS)
    c, s = np.abs(np.cos(yaw)), np.abs(np.sin(yaw))
    return (size[..., 0] * c + size[..., 1] * s) / 2, (size[..., 0] * s + size[..., 1] * c) / 2


def placed(reference: Array, made: Attributes) -> Array:
    """The boxes (..., 7) that attributes stand for, from references (..., 7)."""
    ex, ey = extents(made.heading, made.size)
    a, b, gap = reference[..., 3] / 2, reference[..., 4] / 2, GAPS[made.gap]
    sign = np.where((made.side == BACK) | (made.side == RIGHT), -1.0, 1.0)
    aside = (made.side == LEFT) | (made.side == RIGHT)
    x = np.where(aside, made.along, sign * (a + gap + ex))
    y = np.where(aside, sign * (b + gap + ey), made.along)
    x = np.where(made.side == OVER, made.across, x)
    c, s = np.cos(reference[..., 2]), np.sin(reference[..., 2])
    yaw = reference[..., 2] + made.heading * (2 * np.pi / HEADINGS)
    yaw = (yaw + np.pi) % (2 * np.pi) - np.pi
    return np.stack([reference[..., 0] + x * c - y * s, reference[..., 1] + x * s + y * c, yaw, made.size[..., 0],
                     made.size[..., 1], made.low, made.low + made.size[..., 2]], -1)


def along_y(side: Ints) -> NDArray[np.bool_]:
    """Whether the offset along a side runs with the reference's left."""
    return np.asarray((side != LEFT) & (side != RIGHT))


def aligned(seen: Array, axis: Ints, half: Array) -> Array:
    """Where the middle of an object with half extent (...,) along axis (...,) (0 front, 1 left) lies, aligned with
    tokens (..., T, 9) in each of five ways, (..., T, 5)."""
    left = axis[..., None] == 1
    middle, reach = np.where(left, seen[..., 1], seen[..., 0]), np.where(left, seen[..., 4], seen[..., 3])
    e = half[..., None]
    low, high = middle - reach, middle + reach
    return np.stack([middle, low + e, high - e, high + e, low - e], -1)


def levelled(seen: Array, height: Array) -> Array:
    """Where the underside of an object of a height (...,) lies, level with tokens (..., T, 9), (..., T, 3)."""
    low, high = seen[..., 5], seen[..., 6]
    return np.stack([low, high, high - height[..., None]], -1)

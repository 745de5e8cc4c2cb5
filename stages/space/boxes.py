"""Oriented boxes standing upright, as arrays: overlap, distance, footprints.

Shapes: `n` and `m` boxes, any leading batch dimensions `...`. Pairwise functions take `a` of (..., n) and `b` of
(..., m) boxes and return (..., n, m). Metres and radians; yaw turns counter-clockwise about z.
"""

from collections.abc import Iterator, Sequence
from math import prod
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from apartgen.schemas.layout import Box

TOLERANCE = 0.01
"""Contact no deeper than this is no collision, m."""
_SKIN = 1e-9  # keeps coincident edges apart in `overlap_area`, far below any size and far above rounding
_CANDIDATES = 1_000_000
_SIGNS = np.array([[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]])  # counter-clockwise, front right first

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Indices = NDArray[np.int64]


class Boxes(NamedTuple):
    """`center` (..., n, 3), `size` (..., n, 3) along the boxes' own axes, `yaw` (..., n)."""

    center: Array
    size: Array
    yaw: Array

    @property
    def n(self) -> int:
        """How many boxes there are."""
        return int(self.yaw.shape[-1])

    def take(self, index: ArrayLike) -> "Boxes":
        """The boxes at `index` (indices or mask) of the last box dimension."""
        where = np.asarray(index)
        if self.yaw.ndim == 1:
            return Boxes(self.center[where], self.size[where], self.yaw[where])
        return Boxes(self.center[..., where, :], self.size[..., where, :], self.yaw[..., where])


def of(objects: Sequence[Box]) -> Boxes:
    """The boxes of artifact objects, in their order."""
    center = np.array([o.center for o in objects], float).reshape(-1, 3)
    size = np.array([o.size for o in objects], float).reshape(-1, 3)
    return Boxes(center, size, np.array([o.yaw for o in objects], float))


def axes(boxes: Boxes) -> Array:
    """Unit vectors to the front and to the left in plan, (..., n, 2 axes, 2)."""
    c, s = np.cos(boxes.yaw), np.sin(boxes.yaw)
    turn = np.empty((*boxes.yaw.shape, 2, 2))
    turn[..., 0, 0], turn[..., 0, 1], turn[..., 1, 0], turn[..., 1, 1] = c, s, -s, c
    return turn


def corners(boxes: Boxes) -> Array:
    """Footprint corners, counter-clockwise from the front right one, (..., n, 4, 2)."""
    half = boxes.size[..., None, :2] / 2 * _SIGNS
    turned: Array = half @ axes(boxes) + boxes.center[..., None, :2]
    return turned


def footprints(boxes: Boxes) -> NDArray[np.object_]:
    """Shapely polygons of the footprints, (..., n)."""
    polygons: NDArray[np.object_] = shapely.polygons(corners(boxes))
    return polygons


def local(points: ArrayLike, boxes: Boxes) -> Array:
    """Plan points (..., p, 2) seen from every box (front, left), (..., n, p, 2)."""
    offset = np.asarray(points, float)[..., None, :, :] - boxes.center[..., None, :2]
    return np.asarray(offset @ np.swapaxes(axes(boxes), -1, -2))


def spread(boxes: Boxes, lo: ArrayLike, hi: ArrayLike) -> Boxes:
    """Boxes that reach from `lo` to `hi` (..., n, 3) about the old centres, in the boxes' own axes."""
    lo, hi = np.asarray(lo, float), np.asarray(hi, float)
    middle = (lo + hi) / 2
    shift = (middle[..., None, :2] @ axes(boxes))[..., 0, :]
    center = boxes.center + np.concatenate([shift, middle[..., 2:]], -1)
    return Boxes(center, hi - lo, boxes.yaw)


def penetration(a: Boxes, b: Boxes | None = None) -> Array:
    """How deep boxes stand in one another, m: the least shift that parts them; negative where they are apart.

    Separating axes in plan (the two of each box) and z. The diagonal of `penetration(a)` is -inf.
    """
    from apartgen.stages.space.depths import depths  # numba takes a third of a second, and not everyone asks

    other = a if b is None else b
    batch = np.broadcast_shapes(a.yaw.shape[:-1], other.yaw.shape[:-1])
    depth = np.empty((*batch, a.n, other.n))
    depths(*_batched(a, batch), *_batched(other, batch), depth.reshape(prod(batch), a.n, other.n))
    if b is None:
        depth[..., np.arange(a.n), np.arange(a.n)] = -np.inf
    return depth


def stand_in(a: Boxes, b: Boxes, deep: float) -> Mask:
    """Which boxes `a` (n,) stand deeper than that, m, in any of `b` (m,)."""
    from apartgen.stages.space.depths import deeper

    found = np.empty(a.n, bool)
    deeper(*a, *b, deep, found)
    return found


def _batched(boxes: Boxes, batch: tuple[int, ...]) -> tuple[Array, Array, Array]:
    """Centres, sizes (B, n, 3) and yaws (B, n) with one leading dimension for all of `batch`."""
    center, size, yaw = boxes
    if not batch:
        return np.array(center[None], float), np.array(size[None], float), np.array(yaw[None], float)
    if yaw.shape[:-1] != batch:
        center, size = (np.broadcast_to(some, (*batch, boxes.n, 3)) for some in (center, size))
        yaw = np.broadcast_to(yaw, (*batch, boxes.n))
    flat = (prod(batch), boxes.n)  # compiled code takes neither whole numbers nor what is not to be written
    return np.array(center, float).reshape(*flat, 3), np.array(size, float).reshape(*flat, 3), np.array(
        yaw, float).reshape(flat)


def meeting(a: Boxes) -> Iterator[tuple[Indices, Indices, Array]]:
    """Every two of the boxes (n,) that stand in one another, i, j and how deep, m, a million candidates at a time: a
    sweep along x finds them, so that many boxes that are apart cost little.
    """
    if not a.n:
        return
    flat = corners(a)
    lo = np.column_stack([flat.min(1), a.center[:, 2] - a.size[:, 2] / 2])
    hi = np.column_stack([flat.max(1), a.center[:, 2] + a.size[:, 2] / 2])
    order = np.argsort(lo[:, 0], kind="stable")
    after = np.arange(1, a.n + 1)
    counts = np.maximum(np.searchsorted(lo[order, 0], hi[order, 0], "right") - after, 0)
    batch = (np.cumsum(counts) - counts) // _CANDIDATES
    for rows in np.split(np.arange(a.n), np.flatnonzero(np.diff(batch)) + 1):
        first = np.repeat(rows, counts[rows])
        within = np.arange(len(first)) - np.repeat(np.cumsum(counts[rows]) - counts[rows], counts[rows])
        i, j = order[first], order[first + 1 + within]
        near = ((lo[i] <= hi[j]) & (lo[j] <= hi[i])).all(1)
        i, j = i[near], j[near]
        depth = penetration(*(Boxes(a.center[k, None], a.size[k, None], a.yaw[k, None]) for k in (i, j)))[:, 0, 0]
        yield i[depth > 0], j[depth > 0], depth[depth > 0]


def _share(start: Array, end: Array, half: Array) -> Array:
    """Share of each segment (..., 2) that lies inside |x| <= half_x, |y| <= half_y (Liang-Barsky)."""
    step = end - start
    with np.errstate(divide="ignore", invalid="ignore"):
        t = np.sort(np.stack([(-half - start) / step, (half - start) / step]), axis=0)
    # A segment parallel to a side is on its inner side wholly or not at all.
    inside = np.abs(start) <= half
    enter = np.where(step == 0, np.where(inside, 0.0, 1.0), t[0]).max(-1)
    leave = np.where(step == 0, np.where(inside, 1.0, 0.0), t[1]).min(-1)
    return np.asarray((leave.clip(0, 1) - enter.clip(0, 1)).clip(0))


def _seen(a: Boxes, b: Boxes) -> Array:
    """Footprint corners of `a` in the frame of `b`, (..., 4, 2)."""
    return np.asarray(np.einsum("...ck,...ik->...ci", corners(a) - b.center[..., None, :2], axes(b)))


def overlap_area(a: Boxes, b: Boxes) -> Array:
    """Exact area common to the footprints, m².

    Green's theorem in the frame of `b`: the common part is bounded by what of each outline lies in the other.
    """
    a = Boxes(a.center[..., :, None, :], a.size[..., :, None, :], a.yaw[..., :, None])
    b = Boxes(b.center[..., None, :, :], b.size[..., None, :, :] + 2 * _SKIN, b.yaw[..., None, :])
    half_a, half_b = a.size[..., None, :2] / 2, b.size[..., None, :2] / 2
    start = _seen(a, b)
    end = np.roll(start, -1, -2)
    swept = start[..., 0] * end[..., 1] - start[..., 1] * end[..., 0]
    twice = (swept * _share(start, end, half_b)).sum(-1)
    # About its own centre, each side of `b` sweeps twice a quarter of its area.
    start = _seen(b, a)
    share = _share(start, np.roll(start, -1, -2), half_a)
    twice += share.sum(-1) * b.size[..., 0] * b.size[..., 1] / 2
    return np.asarray((twice / 2).clip(0))


def iou(a: Boxes, b: Boxes | None = None) -> Array:
    """Exact intersection over union of the upright boxes' volumes; the diagonal of `iou(a)` is 0."""
    other = a if b is None else b
    reach = (a.size[..., :, None, 2] + other.size[..., None, :, 2]) / 2
    apart = np.abs(a.center[..., :, None, 2] - other.center[..., None, :, 2])
    tall = np.minimum(reach - apart, np.minimum(a.size[..., :, None, 2], other.size[..., None, :, 2])).clip(0)
    common = overlap_area(a, other) * tall
    volume_a, volume_b = a.size.prod(-1)[..., :, None], other.size.prod(-1)[..., None, :]
    result = common / np.maximum(volume_a + volume_b - common, 1e-12)
    if b is None:
        result[..., np.arange(a.n), np.arange(a.n)] = 0.0
    return np.asarray(result)


def distance(points: ArrayLike, boxes: Boxes) -> Array:
    """Signed plan distance from points (..., p, 2) to the footprints, negative inside, (..., p, n)."""
    beyond = np.abs(local(points, boxes)) - boxes.size[..., None, :2] / 2
    outside = np.hypot(*np.moveaxis(beyond.clip(0), -1, 0))
    return np.swapaxes(outside + beyond.max(-1).clip(None, 0), -1, -2)


def gap(a: Boxes, b: Boxes | None = None) -> Array:
    """Plan distance between footprints, 0 where they overlap; the diagonal of `gap(a)` is inf."""
    other = a if b is None else b
    n, m = a.n, other.n
    from_a = distance(_flat(corners(a)), other).reshape(*a.yaw.shape, 4, m).min(-2)
    from_b = distance(_flat(corners(other)), a).reshape(*other.yaw.shape, 4, n).min(-2)
    apart: Array = np.minimum(from_a, np.swapaxes(from_b, -1, -2)).clip(0)
    tall = Boxes(a.center * [1, 1, 0], a.size, a.yaw), Boxes(other.center * [1, 1, 0], other.size, other.yaw)
    # Crossing footprints may have no corner in one another.
    apart[penetration(*tall) > 0] = 0.0
    if b is None:
        apart[..., np.arange(n), np.arange(n)] = np.inf
    return apart


def _flat(points: Array) -> Array:
    """(..., n, 4, 2) as (..., 4n, 2)."""
    return points.reshape(*points.shape[:-3], -1, 2)

"""Convex solids, many at once: whether they meet, and what they sweep when a joint moves them.

A sweep is cut into steps. In each, the solid stays within the hull of both ends, but for the bulge of a circle over
its chord.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.retrieve import Joint
from apartgen.stages.space.turns import rotation
from apartgen.stages.things.asset import Array, Collider
from apartgen.stages.things.solids import corners

STEPS = 18
"""Steps of a quarter turn: a leaf 0.9 m wide bulges by 0.9 mm in each."""
_ROUND = 1 / np.cos(np.pi / 16)  # corners about a circle lie outside it by this
_REFINED = 24  # directions tried where no face parts two solids
_FIRST, _AT_ONCE = 12, 512  # pairs looked at together: the likeliest to meet alone, then few enough for small arrays


class Hulls(NamedTuple):
    """k solids: `points` (k, n, 3) whose hull each is, `axes` (k, f, 3) of their frames, `bulge` (k,) beyond it, m.

    Rows of fewer points repeat their first.
    """

    points: Array
    axes: Array
    bulge: Array

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Least and greatest corners, bulges included, (k, 3) each."""
        out = self.bulge[:, None]
        return self.points.min(1) - out, self.points.max(1) + out

    def take(self, index: NDArray[np.int64]) -> "Hulls":
        """Some of the solids."""
        return Hulls(*(field[index] for field in self))

    def placed(self, center: Sequence[float], yaw: float) -> "Hulls":
        """The solids turned about z, then shifted."""
        c, s = np.cos(yaw), np.sin(yaw)
        turn = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        return Hulls(self.points @ turn + np.asarray(center, float), self.axes @ turn, self.bulge)


def of(colliders: Sequence[Collider]) -> Hulls:
    """Colliders as solids; round ones are enclosed by prisms."""
    axes = np.array([c.rotation.T for c in colliders], float).reshape(-1, 3, 3)
    return Hulls(_padded([_points(c) for c in colliders]), axes, np.zeros(len(colliders)))


def _points(c: Collider) -> Array:
    if c.kind in ("cylinder", "sphere"):
        wide = c.size * [_ROUND, _ROUND, 1.0 if c.kind == "cylinder" else _ROUND]
        return corners(Collider(c.kind, c.center, wide, c.rotation))
    return corners(c)


def _padded(rows: Sequence[Array]) -> Array:
    most = max((len(row) for row in rows), default=0)
    return np.array([np.concatenate([row, np.repeat(row[:1], most - len(row), 0)]) for row in rows]).reshape(
        len(rows), most, 3
    )


def swept(solids: Hulls, joint: Joint) -> Hulls:
    """What solids pass through while their joint moves over its range; a slide needs one step."""
    lo, hi = joint.range
    if joint.type == "slide":
        way = np.asarray(joint.axis, float) / np.linalg.norm(joint.axis)
        ends = np.concatenate([solids.points + lo * way, solids.points + hi * way], 1)
        return solids._replace(points=ends)
    steps = max(1, round(STEPS * (hi - lo) / (np.pi / 2)))
    turns = [rotation(joint.axis, t) for t in np.linspace(lo, hi, steps + 1)]
    origin = np.asarray(joint.origin, float)
    arm = solids.points - origin
    points = [arm @ turn.T + origin for turn in turns]
    axes = [solids.axes @ turn.T for turn in turns]
    axis = np.asarray(joint.axis, float) / np.linalg.norm(joint.axis)
    radius = np.linalg.norm(np.cross(arm, axis), axis=-1).max(1, initial=0.0)
    bulge = radius * (1 - np.cos((hi - lo) / steps / 2))
    return Hulls(
        np.concatenate([np.concatenate(pair, 1) for pair in zip(points, points[1:])]),
        np.concatenate([np.concatenate(pair, 1) for pair in zip(axes, axes[1:])]),
        np.tile(bulge, steps),
    )


def moved(solids: Hulls, joint: Joint, value: float) -> Hulls:
    """The solids at one position of their joint."""
    if joint.type == "slide":
        way = np.asarray(joint.axis, float) / np.linalg.norm(joint.axis)
        return solids._replace(points=solids.points + value * way)
    turn, origin = rotation(joint.axis, value), np.asarray(joint.origin, float)
    return solids._replace(points=(solids.points - origin) @ turn.T + origin, axes=solids.axes @ turn.T)


def meet(a: Hulls, b: Hulls, clear: float) -> bool:
    """Whether any solid of `a` comes closer than `clear` to one of `b`.

    Directions that part two solids are looked for among their axes, then by Gilbert's algorithm, then among the
    normals of their faces. Edges that pass each other even closer than rounding may count as meeting.
    """
    if not len(a.points) or not len(b.points):
        return False
    (low, high), (lo, hi) = a.bounds, b.bounds
    close = (low[:, None] < hi[None] + clear).all(-1) & (lo[None] < high[:, None] + clear).all(-1)
    i, j = np.nonzero(close)
    common = np.minimum(high[i], hi[j]) - np.maximum(low[i], lo[j])
    order = np.argsort(-common.min(1), kind="stable")
    for some in np.split(order, np.arange(_FIRST, len(order), _AT_ONCE)):
        one, two = a.take(i[some]), b.take(j[some])
        apart, way = _along(one, two, np.concatenate([one.axes, two.axes], 1))
        open_ = np.flatnonzero(apart < clear)
        one, two = one.take(open_), two.take(open_)
        shown, most = _refined(one, two, way[open_], clear)
        if (most < clear).any():
            return True
        apart = np.maximum(apart[open_], shown)
        # The deepest first: one that meets is enough.
        for row in np.argsort(apart, kind="stable")[: int((apart < clear).sum())].tolist():
            pair = one.take(np.array([row])), two.take(np.array([row]))
            faces = np.concatenate([_faces(hull.points[0]) for hull in pair])[None]
            if not faces.size or float(_along(*pair, faces)[0][0]) < clear:
                return True
    return False


def _faces(points: Array) -> Array:
    """Unit normals (f, 3) of a hull's faces; none of a flat one."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return np.asarray(ConvexHull(points).equations[:, :3])
    except QhullError:
        return np.zeros((0, 3))


def _along(a: Hulls, b: Hulls, ways: Array) -> tuple[Array, Array]:
    """How far apart pairs are (k,) in the best of directions (k, f, 3), and that direction, from a to b, (k, 3)."""
    own, other = a.points @ ways.swapaxes(1, 2), b.points @ ways.swapaxes(1, 2)
    ahead, behind = other.min(1) - own.max(1), own.min(1) - other.max(1)
    apart = np.maximum(ahead, behind)
    rows, best = np.arange(len(apart)), apart.argmax(1)
    sign = np.where(ahead[rows, best] >= behind[rows, best], 1.0, -1.0)
    return apart[rows, best] - a.bulge - b.bulge, ways[rows, best] * sign[:, None]


def _refined(a: Hulls, b: Hulls, way: Array, clear: float) -> tuple[Array, Array]:
    """The least and greatest that distances can be (k,), by Gilbert's algorithm from the directions `way` (k, 3).

    It ends when one pair is known to be closer than `clear`, or all are known not to be.
    """
    bulge = a.bulge + b.bulge
    rows = np.arange(len(way))
    found, nearest, length = np.full(len(way), -np.inf), np.zeros_like(way), np.zeros((len(way), 1))
    for step in range(_REFINED):
        ends = (b.points[rows, (b.points @ way[..., None])[..., 0].argmin(1)]
                - a.points[rows, (a.points @ way[..., None])[..., 0].argmax(1)])
        found = np.maximum(found, (ends * way).sum(1))
        towards = ends - nearest
        share = -(nearest * towards).sum(1) / np.maximum((towards * towards).sum(1), 1e-18)
        nearest = nearest + np.clip(share if step else 1.0, 0, 1).reshape(-1, 1) * towards
        length = np.linalg.norm(nearest, axis=1)[:, None]
        way = np.where(length > 1e-9, nearest / np.maximum(length, 1e-9), way)
        if (length[:, 0] - bulge < clear).any() or (found - bulge >= clear).all():
            break
    return np.asarray(found - bulge), np.asarray(length[:, 0] - bulge)

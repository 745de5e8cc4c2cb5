"""What moving parts sweep: b' of the articulated collision constraint (Eq. 4, 11), opened parts, room doors.

Before assets are chosen, `categories.reach` bounds how far any design opens; with assets, their joints say it.
Bounds are least and greatest corners (lo, hi), each (3,), in the object's frame (origin at the box's centre).
"""

from collections.abc import Sequence
from functools import lru_cache
from math import sqrt
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import Polygon

from apartgen.schemas.base import Vector
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.space import boxes, polygons
from apartgen.stages.space.boxes import Array, Boxes, Mask
from apartgen.stages.things import categories

PUBLISHED_SHARE = 1 / 3
"""PhyScene opens whatever is articulated by this share of its depth, at the front."""

Bounds = tuple[Array, Array]
_LOW = np.indices((2, 2, 2)).reshape(3, -1).T == 0


def articulated(objects: Sequence[Box]) -> Mask:
    """Which objects have moving parts: by their asset's joints, else by category; (n,)."""
    return np.array([_moves(o) for o in objects], bool)


def _moves(o: Box) -> bool:
    if isinstance(o, Furnishing):
        return bool(o.joints)
    return o.category in categories.TABLE and categories.TABLE[o.category].articulated


def _turned(points: Array, joint: Joint, angle: NDArray[np.float64] | float) -> Array:
    """Points (..., 3) turned about the hinge."""
    c, u, v = _orbit(points, joint)
    return np.asarray(c + u * np.cos(angle) + v * np.sin(angle))


def _orbit(points: Array, joint: Joint) -> tuple[Array, Array, Array]:
    """Centre and the two radii of each point's circle: p(t) = c + u cos t + v sin t (Rodrigues)."""
    origin, axis = np.asarray(joint.origin, float), np.asarray(joint.axis, float)
    axis = axis / sqrt(axis @ axis)
    x, y, z = axis.tolist()
    arm = points - origin
    along = (arm @ axis)[..., None] * axis
    return origin + along, arm - along, arm @ np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])


def _corners(bounds: Bounds) -> Array:
    """The eight corners of a box, (8, 3)."""
    return np.where(_LOW, bounds[0], bounds[1])


def at(joint: Joint, point: Array, value: NDArray[np.float64] | float) -> Array:
    """Where a point (3,) of the shut part is at a joint position (or some, (k, 1)), object's frame."""
    if joint.type == "slide":
        return np.asarray(point + value * np.asarray(joint.axis, float) / np.linalg.norm(joint.axis))
    return _turned(point, joint, value)


def moved(joint: Joint, value: float) -> Bounds:
    """Bounds of the joint's part at one joint position; the joint must have its extent."""
    lo, hi = _moved(joint.type, joint.axis, joint.origin, joint.extent, value)
    return np.array(lo), np.array(hi)


@lru_cache(maxsize=8192)
def _moved(
    type: Literal["hinge", "slide"], axis: Vector, origin: Vector, extent: tuple[Vector, Vector] | None, value: float
) -> tuple[Vector, Vector]:
    """The same by value, because the same assets are asked for again and again."""
    assert extent is not None
    points = _corners((np.array(extent[0]), np.array(extent[1])))
    if type == "slide":
        points = points + value * np.asarray(axis, float) / np.linalg.norm(axis)
    else:
        joint = Joint.model_construct(
            name="", type=type, axis=axis, origin=origin, range=(value, value), part="", extent=extent)
        points = _turned(points, joint, value)
    (x0, y0, z0), (x1, y1, z1) = points.min(0).tolist(), points.max(0).tolist()
    return (x0, y0, z0), (x1, y1, z1)


def swept(joint: Joint) -> Bounds:
    """Bounds of everything the joint's part passes through over its whole range, exactly."""
    lo, hi = _swept(joint.type, joint.axis, joint.origin, joint.range, joint.extent)
    return np.array(lo), np.array(hi)


@lru_cache(maxsize=8192)
def _swept(
    type: Literal["hinge", "slide"], axis: Vector, origin: Vector, range: tuple[float, float],
    extent: tuple[Vector, Vector] | None,
) -> tuple[Vector, Vector]:
    """The same by value, because the same assets are asked for again and again."""
    joint = Joint.model_construct(name="", type=type, axis=axis, origin=origin, range=range, part="", extent=extent)
    ends = [moved(joint, value) for value in joint.range]
    lo, hi = np.minimum(ends[0][0], ends[1][0]), np.maximum(ends[0][1], ends[1][1])
    if joint.type == "hinge":
        assert joint.extent is not None
        c, u, v = _orbit(_corners((np.array(joint.extent[0]), np.array(joint.extent[1]))), joint)
        # Each coordinate of each corner has one extreme in every half turn.
        first = np.arctan2(v, u)
        for turn in np.arange(-2, 3) * np.pi:
            angle = first + turn
            passed = (angle >= joint.range[0]) & (angle <= joint.range[1])
            at = c + u * np.cos(angle) + v * np.sin(angle)
            lo = np.minimum(lo, np.where(passed, at, np.inf).min(0))
            hi = np.maximum(hi, np.where(passed, at, -np.inf).max(0))
    return (float(lo[0]), float(lo[1]), float(lo[2])), (float(hi[0]), float(hi[1]), float(hi[2]))


def _front(o: Box) -> float:
    return float(categories.reach(o.category, o.size)) if o.category in categories.TABLE else 0.0


def bounds(o: Box) -> Bounds:
    """Bounds of an object with all that its parts sweep; the box itself when nothing moves."""
    half = np.asarray(o.size, float) / 2
    lo, hi = -half, half.copy()
    joints = o.joints if isinstance(o, Furnishing) else []
    for joint in joints:
        if joint.extent is not None:
            low, high = swept(joint)
            lo, hi = np.minimum(lo, low), np.maximum(hi, high)
    unknown = any(joint.extent is None for joint in joints) or not isinstance(o, Furnishing)
    if _moves(o) and unknown:
        hi[0] = max(hi[0], half[0] + _front(o))
    return lo, hi


def extended(objects: Sequence[Box]) -> Boxes:
    """b': every object's box grown to cover the swept volume of its joints; static boxes as they are."""
    every = [bounds(o) for o in objects]
    lo, hi = (np.array([b[k] for b in every], float).reshape(-1, 3) for k in (0, 1))
    return boxes.spread(boxes.of(objects), lo, hi)


def published(objects: Sequence[Box]) -> Boxes:
    """PhyScene's b': articulated boxes grown at the front by a third of their depth, whatever the asset."""
    half = np.array([o.size for o in objects], float).reshape(-1, 3) / 2
    hi = half.copy()
    hi[:, 0] += np.where(articulated(objects), 2 * half[:, 0] * PUBLISHED_SHARE, 0.0)
    return boxes.spread(boxes.of(objects), -half, hi)


def opened(objects: Sequence[Box]) -> tuple[Boxes, NDArray[np.int64]]:
    """Where fully open parts stand, one box a part (k), and the index of the object each belongs to, (k,).

    An object whose parts' extents are not known opens into all of the room that b' keeps for it.
    """
    base = boxes.of(objects)
    owner: list[int] = []
    found: list[Bounds] = []
    for i, o in enumerate(objects):
        parts = _open_parts(o)
        owner += [i] * len(parts)
        found += parts
    index = np.array(owner, np.int64)
    lo, hi = (np.array([f[k] for f in found], float).reshape(-1, 3) for k in (0, 1))
    return boxes.spread(base.take(index), lo, hi), index


def _open_parts(o: Box) -> list[Bounds]:
    if not _moves(o):
        return []
    joints = o.joints if isinstance(o, Furnishing) else []
    if joints and all(joint.extent is not None for joint in joints):
        return [moved(joint, max(joint.range, key=abs)) for joint in joints]
    lo, hi = bounds(o)
    ahead = lo.copy()
    ahead[0] = o.size[0] / 2
    return [(ahead, hi)] if hi[0] > ahead[0] else []


def door_swings(plan: Plan) -> dict[str, Polygon]:
    """Floor that each room door's leaf sweeps, by opening id; what has no leaf is left out."""
    every = {opening.id: polygons.swing(opening, plan) for opening in plan.openings}
    return {name: area for name, area in every.items() if not area.is_empty}

"""Colliders as boxes, cylinders and spheres alone, for engines that are slow with convex hulls.

A hull becomes the one of least volume that holds it, then so much slimmer that it is as large as the hull. It begins
and ends at the hull's heights and reaches no further across: nothing sinks into it, nor it into what is about it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from apartgen.stages.things.asset import Array, Collider, Link
from apartgen.stages.things.body import Body

THIN = 0.001
"""No side of a box is shorter, m."""
ROUND = 1.1
"""Only what has sides so little different is a sphere."""
LEAST = 0.5
"""What leans and would lose more of its volume becomes a box that stands upright."""
ROUNDS = 6
"""A collider is made to fit height and width by turns so many times."""


def primitive(bodies: Sequence[Body]) -> list[Body]:
    """The bodies, none of which collides as a hull."""
    return [replace(body, links=[_plain(link) for link in body.links]) for body in bodies]


def _plain(link: Link) -> Link:
    return replace(link, colliders=[simple(c) if c.kind == "hull" else c for c in link.colliders])


def simple(c: Collider) -> Collider:
    """A hull as a box, a cylinder or a sphere."""
    assert c.vertices is not None
    found = _fitted(c.vertices.astype(float).tobytes())
    return replace(found, center=c.center + c.rotation @ found.center, rotation=c.rotation @ found.rotation)


@lru_cache(maxsize=8192)
def _fitted(data: bytes) -> Collider:
    """For the bytes of points (n, 3) of a hull, in their frame."""
    points = np.frombuffer(data, float).reshape(-1, 3)
    volume, normals = _surface(points)
    turns = [np.eye(3), *_turned_about(normals)]
    around = [shape(points, turn) for turn in turns for shape in (_box, _cylinder)]
    around += [_sphere(points)] if np.ptp(points, axis=0).max() < ROUND * np.ptp(points, axis=0).min() else []
    low, high = points.min(0), points.max(0)
    best = min(around, key=lambda c: round(_volume(c), 12))
    found, upright = (_within(_slim(c, volume), low, high) for c in (best, around[0]))
    return found if _volume(found) > LEAST * volume else upright


def _surface(points: Array) -> tuple[float, Array]:
    """Volume of a hull, and the normals of its faces (k, 3)."""
    try:
        found = ConvexHull(points)
    except QhullError:  # flat
        return 0.0, np.zeros((0, 3))
    return float(found.volume), np.unique(found.equations[:, :3].round(6), axis=0)


def _turned_about(normals: Array) -> Iterator[Array]:
    """Rotations whose last axis is along a face's normal and whose first is level."""
    for normal in normals:
        z = normal / np.linalg.norm(normal)
        level = np.cross([0.0, 0.0, 1.0] if abs(z[2]) < 0.999 else [0.0, 1.0, 0.0], z)
        x = level / np.linalg.norm(level)
        yield np.stack([x, np.cross(z, x), z], 1)


def _box(points: Array, turn: Array) -> Collider:
    local = points @ turn
    return Collider("box", turn @ (local.min(0) + local.max(0)) / 2, np.ptp(local, axis=0), turn)


def _cylinder(points: Array, turn: Array) -> Collider:
    box = _box(points, turn)
    radius = float(np.linalg.norm(((points - box.center) @ turn)[:, :2], axis=1).max())
    return Collider("cylinder", box.center, np.array([radius, radius, box.size[2]]), turn)


def _sphere(points: Array) -> Collider:
    middle = (points.min(0) + points.max(0)) / 2
    radius = float(np.linalg.norm(points - middle, axis=1).max())
    return Collider("sphere", middle, np.full(3, radius))


def _volume(c: Collider) -> float:
    whole = float(np.prod(c.size))
    return whole * {"box": 1.0, "cylinder": np.pi, "sphere": np.pi * 4 / 3}[c.kind]


def _slim(c: Collider, volume: float) -> Collider:
    """No larger than this, m³, and no shorter along its length, which of a box is the side nearest to the vertical."""
    share = min(1.0, volume / max(_volume(c), 1e-12))
    if c.kind == "sphere":
        return replace(c, size=c.size * share ** (1 / 3))
    kept = np.arange(3) == (2 if c.kind == "cylinder" else int(np.abs(c.rotation[2]).argmax()))
    return replace(c, size=np.where(kept, c.size, c.size * np.sqrt(share)))


def _within(c: Collider, low: Array, high: Array) -> Collider:
    """As high as the hull, whose bounds these are, where the hull is, and no further across."""
    per_metre, sides, size = _reach(c), high - low, c.size.copy()
    upright = int((per_metre[2] * size).argmax())
    for _ in range(ROUNDS):
        across = np.where(np.arange(3) == upright, 1.0, min(1.0, *(sides[:2] / np.maximum(per_metre @ size, THIN)[:2])))
        size = size * across
        rest = float(per_metre[2] @ size - per_metre[2, upright] * size[upright])
        if sides[2] <= rest:
            size = size * sides[2] / max(float(per_metre[2] @ size), THIN)
        elif per_metre[2, upright] > 0:
            size[upright] = (sides[2] - rest) / per_metre[2, upright]
    size = np.maximum(size, THIN)
    if c.kind != "box":
        size[1:] = size[0], size[0] if c.kind == "sphere" else size[2]
    free = np.maximum((sides - per_metre @ size) / 2, 0.0)
    return replace(c, size=size, center=np.clip(c.center, (low + high) / 2 - free, (low + high) / 2 + free))


def _reach(c: Collider) -> Array:
    """How much longer, wider and higher its bounds are for each metre of its sizes, (3, 3)."""
    along = np.abs(c.rotation)
    if c.kind == "box":
        return along
    found = np.zeros((3, 3))
    found[:, 0] = 2.0 if c.kind == "sphere" else 2 * np.sqrt(np.maximum(1 - along[:, 2] ** 2, 0.0))
    found[:, 2] = 0.0 if c.kind == "sphere" else along[:, 2]
    return found

"""Places where something may stand, exactly: along walls, all over a room, about another thing."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.runs import distinct
from apartgen.stages.layout.relations.tokens import Array

OFF = 0.01
"""From the wall to a thing's back, m."""
STEP = 0.3
"""From one place along a wall to the next, m."""
Size = tuple[float, float, float]
Place = tuple[float, float, float]


def all_over(space: Space, size: Size) -> Array:
    """Boxes (n, 7) of a size on a grid over the room, along its first wall and across; nobody changes them."""
    what = "all over", size
    if what not in space.known:
        space.known[what] = _all_over(space, size)
    return np.asarray(space.known[what])


def _all_over(space: Space, size: Size) -> Array:
    low, high = space.start.min(0) + size[0] / 2, space.start.max(0) - size[0] / 2
    x, y = (np.arange(a, b + STEP / 2, STEP) for a, b in zip(low, high, strict=True))
    at = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    turn = float(np.arctan2(*space.normal[0, ::-1]))
    return np.concatenate([
        np.column_stack([at, np.broadcast_to([yaw, *size[:2], 0.0, size[2]], (len(at), 5))])
        for yaw in (turn, turn + np.pi / 2)]).astype(np.float32)


def along(space: Space, size: Size) -> Array:
    """Boxes (n, 7) of a size along all walls; nobody changes them."""
    what = "along", size
    if what not in space.known:
        space.known[what] = _along(space, size)
    return np.asarray(space.known[what])


def _along(space: Space, size: Size) -> Array:
    out = [np.zeros((0, 7))]
    for start, way, normal, length in zip(space.start, space.along, space.normal, space.length, strict=True):
        if (room := length - size[1] - 2 * OFF) >= 0:
            t = OFF + size[1] / 2 + np.linspace(0.0, room, int(np.ceil(room / STEP)) + 1)
            middle = start + t[:, None] * way + (OFF + size[0] / 2) * normal
            rest = np.broadcast_to([np.arctan2(normal[1], normal[0]), *size[:2], 0.0, size[2]], (len(t), 5))
            out.append(np.column_stack([middle, rest]))
    return np.concatenate(out).astype(np.float32)


def at_walls(boxes: Array, space: Space) -> Array:
    """Boxes (m, 7) along all walls in the likeliest size and height of candidates (n, 7)."""
    found = along(space, likeliest(boxes)).copy()
    found[:, 5:] += np.median(boxes[:, 5])
    return found


def likeliest(boxes: Array) -> Size:
    """The size of most candidates (n, 7)."""
    sizes, counts = distinct(np.round(boxes[:, 3:].astype(float), 3))
    depth, width, low, high = sizes[counts.argmax()].tolist()
    return depth, width, high - low


def resized(box: Array, deep: float, wide: float, side: float) -> Array:
    """A box (7,) that grows or shrinks at its front, and at both sides (0), its left (1) or its right one (-1)."""
    out, c, s = box.copy(), np.cos(box[2]), np.sin(box[2])
    out[:2] += side * (wide - float(box[4])) / 2 * np.array([-s, c]) + (deep - float(box[3])) / 2 * np.array([c, s])
    out[3:5] = deep, wide
    return out


def about(leader: Array, places: Sequence[Place], size: Size) -> Array:
    """Boxes (n, 7) at places (x, y, yaw) in a leader's frame."""
    x, y, turn = np.array(places).T
    c, s = np.cos(leader[2]), np.sin(leader[2])
    low, n = float(leader[5]), len(x)
    rest = np.broadcast_to([*size[:2], low, low + size[2]], (n, 4))
    return np.column_stack([leader[0] + c * x - s * y, leader[1] + s * x + c * y, leader[2] + turn, rest]).astype(
        np.float32)

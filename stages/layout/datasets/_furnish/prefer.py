"""Which of the possible poses people choose: features of poses (m,), larger where liked."""

from collections.abc import Callable

import numpy as np

from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.layout.datasets._furnish.step import Step
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Boxes


def _sides(space: Space, at: Boxes) -> tuple[Array, Array]:
    """Distance (m, E) of the centres from every wall's line, and position along it."""
    offset = at.center[:, None, :2] - space.shape.start
    return (offset * space.shape.normal).sum(-1), (offset * space.shape.along).sum(-1)


def _behind(space: Space, at: Boxes) -> tuple[Array, Array]:
    """Position along the wall behind each box and that wall's length."""
    away, along = _sides(space, at)
    facing = boxes.axes(at)[:, 0] @ space.shape.normal.T
    off = np.abs(away - at.size[:, :1] / 2) + 10 * (facing < 0.9) + np.abs(along - along.clip(0, space.shape.length))
    side = off.argmin(1)
    return np.take_along_axis(along, side[:, None], 1)[:, 0], space.shape.length[side]


def corner(space: Space, at: Boxes, step: Step) -> Array:
    """Close to the end of its wall."""
    along, length = _behind(space, at)
    return -np.minimum(along, length - along).clip(0, 2.0)


def centre(space: Space, at: Boxes, step: Step) -> Array:
    """At the middle of its wall."""
    along, length = _behind(space, at)
    return -np.abs(along - length / 2).clip(0, 2.0)


def long(space: Space, at: Boxes, step: Step) -> Array:
    """At a long wall."""
    return _behind(space, at)[1].clip(0, 6.0) / 2


def back(space: Space, at: Boxes, step: Step) -> Array:
    """Back to a wall."""
    away, along = _sides(space, at)
    facing = boxes.axes(at)[:, 0] @ space.shape.normal.T
    beside = (along > 0) & (along < space.shape.length) & (facing > 0.9)
    return np.asarray((beside & (np.abs(away - at.size[:, :1] / 2) < 0.1)).any(1), float)


def _nearest(points: Array, at: Boxes) -> Array:
    if not len(points):
        return np.zeros(at.n)
    offset = at.center[:, None, :2] - points
    return np.asarray(np.hypot(offset[..., 0], offset[..., 1]).min(1).clip(0, 4.0))


def window(space: Space, at: Boxes, step: Step) -> Array:
    """Near a window."""
    return -_nearest(space.shape.windows[:, :2], at)


def door(space: Space, at: Boxes, step: Step) -> Array:
    """Away from doors."""
    return _nearest(space.shape.doors[:, :2], at)


def near(space: Space, at: Boxes, step: Step) -> Array:
    """Near objects of the categories `near`."""
    return -_nearest(space.body.center[space.find(step.near), :2], at)


def faced(space: Space, at: Boxes, step: Step) -> Array:
    """Opposite the objects of the categories `near`: in front of them and turned to them."""
    found = space.find(step.near)
    if not found:
        return np.zeros(at.n)
    others = space.body.take(found)
    offset = others.center[None, :, :2] - at.center[:, None, :2]
    unit = offset / np.maximum(np.hypot(offset[..., 0], offset[..., 1]), 1e-6)[..., None]
    seen = (boxes.axes(at)[:, None, 0] * unit).sum(-1) - (boxes.axes(others)[None, :, 0] * unit).sum(-1)
    return np.asarray(seen.max(1) / 2)


def retreat(space: Space, at: Boxes, step: Step) -> Array:
    """A wall some way in front, so that who sits there has it at the back and looks into the room."""
    away, along = _sides(space, at)
    facing = boxes.axes(at)[:, 0] @ space.shape.normal.T
    ahead = np.where((facing < -0.9) & (along > 0) & (along < space.shape.length), away - at.size[:, :1] / 2, 9.0)
    return np.asarray(-np.abs(ahead.min(1) - 1.2).clip(0, 2.0))


def middle(space: Space, at: Boxes, step: Step) -> Array:
    """Far from all walls and from what stands there."""
    cell = ((at.center[:, None, :2] - space.flat_grid) ** 2).sum(-1).argmin(1)
    return np.asarray(space.clear.ravel()[cell].clip(0, 2.0))


FEATURES: dict[str, Callable[[Space, Boxes, Step], Array]] = {
    f.__name__: f for f in (corner, centre, long, back, window, door, near, faced, retreat, middle)
}

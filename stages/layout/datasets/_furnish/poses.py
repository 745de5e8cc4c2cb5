"""Poses worth trying, by kind of place; each function returns boxes (m,) and the index of the object it may touch."""

import numpy as np
from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish import relations
from apartgen.stages.layout.datasets._furnish.pose import Place, Poses, anchor_of, boxed, gap_of, height_of, nowhere
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.layout.datasets._furnish.step import Step
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things.categories import TABLE

ALONG = 0.1
"""Spacing of candidates along a wall, m."""


def wall(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Back to a wall, anywhere along it, its ends exactly."""
    shape, gap, xy, yaw = space.shape, gap_of(step, rng), [], []
    for start, along, normal, length in zip(shape.start, shape.along, shape.normal, shape.length, strict=True):
        lo, hi = size[1] / 2 + max(gap, 0.005), length - size[1] / 2 - max(gap, 0.005)
        if hi < lo:
            continue
        s = np.unique(np.r_[np.arange(lo, hi, ALONG), hi, (lo + hi) / 2])
        xy.append(start + s[:, None] * along + normal * (size[0] / 2 + gap))
        yaw.append(np.full(len(s), np.arctan2(normal[1], normal[0])))
    if not xy:
        return nowhere(name, size, space)
    return boxed(np.concatenate(xy), np.concatenate(yaw), size, name, space), -1


def corner(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """In a convex corner of the room, facing along either wall."""
    shape, gap, xy, yaw = space.shape, gap_of(step, rng), [], []
    for i in range(len(shape.start)):
        before, after = shape.along[i - 1], shape.along[i]
        if before[0] * after[1] - before[1] * after[0] < 0.5:
            continue
        for facing, side in ((shape.normal[i], shape.along[i]), (shape.normal[i - 1], -shape.along[i - 1])):
            at = shape.start[i] + facing * (size[0] / 2 + gap) + side * (size[1] / 2 + gap)
            xy.append(at)
            yaw.append(np.arctan2(facing[1], facing[0]))
    if not xy:
        return nowhere(name, size, space)
    return boxed(np.array(xy), np.array(yaw) + rng.normal(0, step.turn, len(xy)), size, name, space), -1


def window(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """At a window: curtains over it, whatever is low below it."""
    shape, rows = space.shape, []
    for x, y, nx, ny, half, sill, head, side in shape.windows:
        if name == "curtain":
            size = np.array([size[0], *_drape(2 * half, sill, head, shape.height, size)])
        aside = 0.0 if name in ("curtain", "radiator") else rng.uniform(-0.3, 0.3)
        offset = size[0] / 2 + (0.005 if name == "curtain" else gap_of(step, rng))
        along = shape.along[int(side)] * aside
        z = height_of(name, size, shape.height)
        if name == "curtain":
            z = min(head + 0.15, shape.height - 0.02) - size[2] / 2
        elif name == "radiator" and size[2] + 0.16 > sill:
            continue
        rows.append([x + nx * offset + along[0], y + ny * offset + along[1], z, *size, np.arctan2(ny, nx)])
    table = np.array(rows).reshape(-1, 7)
    return Boxes(table[:, :3], table[:, 3:6], table[:, 6]), -1


def _drape(wide: float, sill: float, head: float, ceiling: float, size: Array) -> tuple[float, float]:
    """Width and height of a curtain: to the floor where the drawn height is more than usual, else to the sill."""
    least, most = TABLE["curtain"].min, TABLE["curtain"].max
    top = min(head + 0.15, ceiling - 0.02)
    bottom = 0.06 if size[2] > TABLE["curtain"].size[2] else sill - 0.12
    return min(max(wide + 0.24, least[1]), most[1]), float(np.clip(top - bottom, least[2], most[2]))


def middle(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Anywhere on the floor, along the walls' directions."""
    points = space.flat_grid[space.shape.clear.ravel() > min(size[0], size[1]) / 2]
    if not len(points):
        return nowhere(name, size, space)
    points = points[rng.integers(0, len(points), 120)]
    base = float(np.arctan2(*space.shape.along[int(space.shape.length.argmax())][::-1]))
    yaw = base + np.pi / 2 * rng.integers(0, 4, 120) + rng.normal(0, step.turn, 120)
    return boxed(points, yaw, size, name, space), -1


def overhead(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """From the ceiling: over the anchor, else over the middle of the room."""
    i = anchor_of(space, step, rng)
    if i >= 0:
        return boxed(space.body.center[[i], :2], space.body.yaw[[i]], size, name, space), i
    clear = space.shape.clear.ravel()
    inner = space.flat_grid[clear >= min(clear.max(), max(0.6 * clear.max(), 0.3)) - 1e-9]
    centre = inner.mean(0) if clear.max() > 0 else space.shape.start.mean(0)
    xy = np.vstack([centre, inner[np.argsort(((inner - centre) ** 2).sum(1))[:40:8]]])
    yaw = float(np.arctan2(*space.shape.along[0][::-1]))
    return boxed(xy + rng.normal(0, step.loose, xy.shape), np.full(len(xy), yaw), size, name, space), -1


BY_ROOM: tuple[Place, ...] = (wall, corner, window, middle, overhead)
BY_OBJECT: tuple[Place, ...] = (
    relations.beside, relations.front, relations.seat, relations.across, relations.around, relations.gather,
    relations.on, relations.above, relations.under,
)
PLACES: dict[str, Place] = {place.__name__: place for place in BY_ROOM + BY_OBJECT}

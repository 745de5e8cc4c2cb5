"""What the functions that find poses share."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from apartgen.stages.layout.datasets._furnish.shape import within
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.layout.datasets._furnish.step import Step
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things.categories import TABLE

Poses = tuple[Boxes, int]
"""Boxes (m,) worth trying, and the index of the object that they may touch, -1 for none."""
Place = Callable[[Space, str, Array, Step, Generator], Poses]
"""Poses for a category of a size, by what a step says."""
HANG = 0.03
"""Farthest that the back of what hangs on a wall is from it, m."""
LAMPS_APART = 1.3


def boxed(xy: Array, yaw: Array, size: Array, name: str, space: Space, z: float | None = None) -> Boxes:
    """Upright boxes at plan positions (m, 2), at the category's height unless `z` (of the centre) is given."""
    if z is None:
        z = height_of(name, size, space.shape.height)
    center = np.column_stack([xy, np.full(len(xy), z)])
    return Boxes(center, np.broadcast_to(size, (len(xy), 3)).copy(), np.asarray(yaw, float).copy())


def height_of(name: str, size: Array, ceiling: float) -> float:
    """Height of the centre of what stands on the floor, hangs on the wall or from the ceiling."""
    kind = TABLE[name]
    if kind.place == "ceiling":
        return float(ceiling - size[2] / 2)
    if kind.place == "wall":
        return float(min(kind.z, ceiling - size[2] - 0.02) + size[2] / 2)
    return float(size[2] / 2)


def gap_of(step: Step, rng: Generator) -> float:
    return float(rng.uniform(*step.gap))


def nowhere(name: str, size: Array, space: Space) -> Poses:
    return boxed(np.zeros((0, 2)), np.zeros(0), size, name, space), -1


def relative(space: Space, i: int, offset: Array) -> tuple[Array, float]:
    """Plan points (m, 2) of offsets (front, left) in the frame of object `i`, and its yaw."""
    box = space.body.take([i])
    return box.center[0, :2] + offset @ boxes.axes(box)[0], float(box.yaw[0])


def anchor_of(space: Space, step: Step, rng: Generator, but: Sequence[int] = ()) -> int:
    """What a step relates to: its own anchor, or one of the categories `of`; -1 for none. Not one of `but`."""
    found = [step.anchor] if step.anchor >= 0 else space.find(step.of)
    found = [i for i in found if i not in but]
    return int(rng.choice(found)) if found else -1


def hangs(name: str, at: Boxes, space: Space) -> NDArray[np.bool_]:
    """Which boxes have a wall right behind them, for what hangs on one; ceiling lamps keep apart."""
    ok = np.ones(at.n, bool)
    if (TABLE[name].place == "wall" or name == "tv_stand") and at.n:
        behind = at.center[:, :2] - boxes.axes(at)[:, 0] * (at.size[:, :1] / 2 + HANG + 0.02 * (name == "tv_stand"))
        ok &= ~within(behind, space.shape.start)
    others = space.find(("ceiling_lamp",))
    if name == "ceiling_lamp" and others:
        offset = at.center[:, None, :2] - space.body.center[others, :2]
        ok &= np.hypot(offset[..., 0], offset[..., 1]).min(1) > LAMPS_APART
    return ok


def prior(step: Step, n: int) -> Array:
    """Seats are filled in the order given: opposite one another, ends last."""
    return np.arange(n, dtype=np.float64) * (-0.6 if step.at == "around" else 0.0)

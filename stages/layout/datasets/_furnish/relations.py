"""Poses by what already stands in the room: beside, in front, around, on, above, below an anchor."""

from collections.abc import Callable
from functools import wraps

import numpy as np
from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish.pose import Place, Poses, anchor_of, boxed, gap_of, nowhere, relative
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.layout.datasets._furnish.step import Step
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things.categories import TABLE

UNDER = 0.2
"""How far a chair may be pushed under its desk, m."""
ByAnchor = Callable[[Space, int, str, Array, Step, Generator], Boxes]


def _anchored(boxes_at: ByAnchor) -> Place:
    """Poses at one of the step's anchors, object `i` of the space; none without an anchor."""

    @wraps(boxes_at)
    def place(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
        i = anchor_of(space, step, rng)
        return (boxes_at(space, i, name, size, step, rng), i) if i >= 0 else nowhere(name, size, space)

    return place


@_anchored
def beside(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """Left or right of the anchor, backs in line, facing the same way."""
    d, w, _ = space.body.size[i]
    gap = gap_of(step, rng)
    back = -d / 2 + size[0] / 2 + max(-space.gap[i], -0.0) + rng.uniform(0, 0.02) + step.loose * rng.random()
    side = (w + size[1]) / 2 + gap
    xy, yaw = relative(space, i, np.array([[back, side], [back, -side]]))
    return boxed(xy, np.full(2, yaw) + rng.normal(0, step.turn, 2), size, name, space)


@_anchored
def front(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """Close in front of the anchor, turned the same way (a coffee table, a bench at the foot of the bed)."""
    reach = (space.body.size[i, 0] + size[0]) / 2 + gap_of(step, rng)
    aside = np.r_[0.0, rng.normal(0, max(step.loose, 1e-6), 5)]
    xy, yaw = relative(space, i, np.column_stack([np.full(6, reach), aside]))
    return boxed(xy, np.full(6, yaw) + rng.normal(0, step.turn, 6), size, name, space)


@_anchored
def seat(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """In front of the anchor and facing it, pushed under or drawn back (a chair at a desk)."""
    under = rng.uniform(-0.15, UNDER, 6)
    half = max(0.0, space.body.size[i, 1] / 2 - size[1] / 2 - 0.05)
    aside = np.r_[0.0, rng.uniform(-half, half, 5) * 0.5]
    xy, yaw = relative(space, i, np.column_stack([(space.body.size[i, 0] + size[0]) / 2 - under, aside]))
    return boxed(xy, np.full(6, yaw + np.pi) + rng.normal(0, step.turn, 6), size, name, space)


@_anchored
def across(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """Facing the anchor from a distance; among the poses one with its back to the wall behind."""
    ahead = _ahead(space, i) - 0.02 - size[0]
    far = np.arange(*step.distance, 0.15)
    far = far[far <= ahead]
    if step.distance[0] <= ahead <= step.distance[1] + 0.5:
        far = np.r_[far, np.full(4, ahead)]
    aside = rng.uniform(-1, 1, (4, 1)) * np.array([[0.0], [0.15], [0.35], [0.6]])
    reach, aside = (np.ravel(v) for v in np.broadcast_arrays(space.body.size[i, 0] / 2 + far + size[0] / 2, aside))
    xy, yaw = relative(space, i, np.column_stack([reach, aside]))
    return boxed(xy, np.full(len(xy), yaw + np.pi) + step.turn * rng.normal(size=len(xy)), size, name, space)


def _ahead(space: Space, i: int, sign: float = 1.0) -> float:
    """Distance from the front of object `i` straight to the wall; from its back with `sign` -1."""
    origin, yaw = relative(space, i, np.array([[sign * space.body.size[i, 0] / 2, 0.0]]))
    d = sign * np.array([np.cos(yaw), np.sin(yaw)])
    shape = space.shape
    facing = shape.normal @ d
    with np.errstate(divide="ignore", invalid="ignore"):
        t = ((shape.start - origin) * shape.normal).sum(1) / facing
        along = ((origin + t[:, None] * d - shape.start) * shape.along).sum(1)
    hit = (facing < -1e-6) & (t > 0) & (along > -1e-6) & (along < shape.length + 1e-6)
    return float(t[hit].min()) if hit.any() else 0.0


@_anchored
def around(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """Seats round a table, facing it; a negative gap pushes them under."""
    d, w, _ = space.body.size[i]
    if space.category[i] == "round_table":
        first = (_seats(space, i) or [rng.uniform(0, 2 * np.pi)])[0]
        turns = np.array([0, 2, 1, 3]) * np.pi / 2 if d < 1.2 else np.array([0, 3, 1, 4, 2, 5]) * np.pi / 3
        angle = first + turns
        reach = d / 2 + size[0] / 2 + rng.uniform(*step.gap, len(angle))
        offset, turn = np.column_stack([np.cos(angle), np.sin(angle)]) * reach[:, None], angle + np.pi
    else:
        offset, turn = _rows(d, w, size, rng.uniform(*step.gap, 20))
    xy, yaw = relative(space, i, offset)
    return boxed(xy, yaw + turn + rng.normal(0, step.turn, len(xy)), size, name, space)


def _seats(space: Space, i: int) -> list[float]:
    """Angles at which seats already stand about table `i`, in its frame."""
    found = space.find(("chair", "stool"))
    if not found:
        return []
    seen = boxes.local(space.body.center[found, :2], space.body.take([i]))[0]
    close = np.hypot(*seen.T) < space.body.size[i, 0] + 0.6
    return [float(a) for a in np.arctan2(seen[close, 1], seen[close, 0])]


def _rows(d: float, w: float, size: Array, gap: Array) -> tuple[Array, Array]:
    """Offsets (front, left) and turns of seats along the sides of a table, long sides first."""
    rows = []
    n = max(1, int((w - 0.05) / max(0.55, size[1] + 0.06)))
    for k, s in enumerate((np.arange(n) + 0.5) / n * w - w / 2):
        rows.append(((d + size[0]) / 2 + gap[2 * k % 20], s, np.pi))
        rows.append((-(d + size[0]) / 2 - gap[(2 * k + 1) % 20], s, 0.0))
    rows += [(0.0, w / 2 + size[0] / 2 + gap[-1], -np.pi / 2), (0.0, -w / 2 - size[0] / 2 - gap[-2], np.pi / 2)]
    table = np.array(rows)
    return table[:, :2], table[:, 2]


@_anchored
def gather(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """Round the anchor at a little distance, facing it: an armchair by the coffee table."""
    d, w, _ = space.body.size[i]
    angle = rng.uniform(-np.pi, np.pi, 24)
    c, s = np.cos(angle), np.sin(angle)
    edge = np.minimum((d / 2) / np.maximum(np.abs(c), 1e-6), (w / 2) / np.maximum(np.abs(s), 1e-6))
    reach = edge + rng.uniform(*step.gap, 24) + size[0] / 2 * 1.1
    xy, yaw = relative(space, i, np.column_stack([c, s]) * reach[:, None])
    snapped = np.where(rng.random(24) < 0.75, np.round(angle / (np.pi / 2)) * np.pi / 2, angle)
    return boxed(xy, yaw + snapped + np.pi + rng.normal(0, step.turn, 24), size, name, space)


def on(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """On top of the anchor, towards its back."""
    i = anchor_of(space, step, rng, _laden(space))
    if i < 0:
        return nowhere(name, size, space)
    d, w, h = space.body.size[i]
    spare = max(0.0, (w - size[1]) / 2 - 0.02)
    aside = np.r_[0.0, spare, -spare, rng.uniform(-spare, spare, 3)]
    back = np.full(6, -max(0.0, (d - size[0]) / 2 - 0.02) * rng.uniform(0.5, 1.0))
    xy, yaw = relative(space, i, np.column_stack([back, aside]))
    z = float(space.body.center[i, 2] + h / 2 + size[2] / 2)
    if size[0] > d + 0.03 or size[1] > w + 0.1:
        return nowhere(name, size, space)
    return boxed(xy, np.full(6, yaw) + rng.normal(0, step.turn, 6), size, name, space, z), i


def _laden(space: Space) -> list[int]:
    """Small things that already carry something."""
    tops = [k for k, name in enumerate(space.category) if TABLE[name].place == "top"]
    small = space.find(("nightstand", "side_table", "chest"))
    if not tops or not small:
        return []
    over = boxes.distance(space.body.center[tops, :2], space.body.take(small)) < 0
    return [small[k] for k in np.flatnonzero(over.any(0))]


@_anchored
def above(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """On the wall behind the anchor, over it."""
    d, w, h = space.body.size[i]
    top = float(space.body.center[i, 2] + h / 2)
    back = -d / 2 - _ahead(space, i, -1.0) + size[0] / 2 + 0.005
    spare = max(0.0, (w - size[1]) / 2)
    aside = np.r_[0.0, rng.uniform(-spare, spare, 3)]
    xy, yaw = relative(space, i, np.column_stack([np.full(4, back), aside]))
    low = max(TABLE[name].z, top + 0.08)
    z = min(low, space.shape.height - size[2] - 0.03) + size[2] / 2
    return boxed(xy, np.full(4, yaw), size, name, space, z)


@_anchored
def under(space: Space, i: int, name: str, size: Array, step: Step, rng: Generator) -> Boxes:
    """Below the anchor, its long side across the anchor's front; shifted forward where the anchor is a bed or sofa."""
    d, w, _ = space.body.size[i]
    if space.category[i] == "single_bed":
        side = (w / 2 + size[0] * rng.uniform(0.1, 0.45)) * np.array([1, -1, 1, -1])
        xy, yaw = relative(space, i, np.column_stack([rng.uniform(-0.2, 0.5, 4), side]))
        return boxed(xy, np.full(4, yaw + np.pi / 2), size, name, space)
    ahead = 0.0
    if space.category[i] == "double_bed":
        ahead = rng.uniform(0.2, 0.6) * d
    elif "sofa" in space.category[i]:
        ahead = d / 2 + size[0] * rng.uniform(0.2, 0.4)
    xy, yaw = relative(space, i, np.array([[ahead + s, 0.0] for s in (0.0, -0.1, 0.15, -0.2)]))
    return boxed(xy, np.full(4, yaw) + rng.normal(0, step.turn, 4), size, name, space)

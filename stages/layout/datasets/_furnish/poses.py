"""Poses worth trying, by kind of place; each function returns boxes (m,) and the index of the object it may touch."""

from collections.abc import Callable

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from stages import boxes
from stages.boxes import Array, Boxes
from stages.categories import TABLE
from stages.layout.datasets._furnish.shape import within
from stages.layout.datasets._furnish.space import Space
from stages.layout.datasets._furnish.step import Step

Poses = tuple[Boxes, int]
ALONG = 0.1
"""Spacing of candidates along a wall, m."""
HANG = 0.03
"""Farthest that the back of what hangs on a wall is from it, m."""
LAMPS_APART = 1.3
UNDER = 0.2
"""How far a chair may be pushed under its table, m."""


def _boxes(xy: Array, yaw: Array, size: Array, name: str, space: Space, z: float | None = None) -> Boxes:
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
    return -0.6 * np.arange(n) if step.at == "around" else np.zeros(n)


def _gap(step: Step, rng: Generator) -> float:
    return float(rng.uniform(*step.gap))


def _none(name: str, size: Array, space: Space) -> Poses:
    return _boxes(np.zeros((0, 2)), np.zeros(0), size, name, space), -1


def wall(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Back to a wall, anywhere along it, its ends exactly."""
    shape, gap, xy, yaw = space.shape, _gap(step, rng), [], []
    for start, along, normal, length in zip(shape.start, shape.along, shape.normal, shape.length, strict=True):
        lo, hi = size[1] / 2 + max(gap, 0.005), length - size[1] / 2 - max(gap, 0.005)
        if hi < lo:
            continue
        s = np.unique(np.r_[np.arange(lo, hi, ALONG), hi, (lo + hi) / 2])
        xy.append(start + s[:, None] * along + normal * (size[0] / 2 + gap))
        yaw.append(np.full(len(s), np.arctan2(normal[1], normal[0])))
    if not xy:
        return _none(name, size, space)
    return _boxes(np.concatenate(xy), np.concatenate(yaw), size, name, space), -1


def corner(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """In a convex corner of the room, facing along either wall."""
    shape, gap, xy, yaw = space.shape, _gap(step, rng), [], []
    for i in range(len(shape.start)):
        before, after = shape.along[i - 1], shape.along[i]
        if before[0] * after[1] - before[1] * after[0] < 0.5:
            continue
        for facing, side in ((shape.normal[i], shape.along[i]), (shape.normal[i - 1], -shape.along[i - 1])):
            at = shape.start[i] + facing * (size[0] / 2 + gap) + side * (size[1] / 2 + gap)
            xy.append(at)
            yaw.append(np.arctan2(facing[1], facing[0]))
    if not xy:
        return _none(name, size, space)
    return _boxes(np.array(xy), np.array(yaw) + rng.normal(0, step.turn, len(xy)), size, name, space), -1


def _relative(space: Space, i: int, offset: Array) -> tuple[Array, float]:
    """Plan points (m, 2) of offsets (front, left) in the frame of object `i`, and its yaw."""
    box = space.body.take([i])
    return box.center[0, :2] + offset @ boxes.axes(box)[0], float(box.yaw[0])


def _anchor(space: Space, step: Step, rng: Generator) -> int:
    if step.anchor >= 0:
        return step.anchor
    found = space.find(step.of)
    return int(rng.choice(found)) if found else -1


def beside(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Left or right of the anchor, backs in line, facing the same way."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    d, w, _ = space.body.size[i]
    gap = _gap(step, rng)
    back = -d / 2 + size[0] / 2 + max(-space.gap[i], -0.0) + rng.uniform(0, 0.02) + step.loose * rng.random()
    side = (w + size[1]) / 2 + gap
    xy, yaw = _relative(space, i, np.array([[back, side], [back, -side]]))
    return _boxes(xy, np.full(2, yaw) + rng.normal(0, step.turn, 2), size, name, space), i


def front(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Close in front of the anchor, turned the same way (a coffee table, a bench at the foot of the bed)."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    reach = (space.body.size[i, 0] + size[0]) / 2 + _gap(step, rng)
    aside = np.r_[0.0, rng.normal(0, max(step.loose, 1e-6), 5)]
    xy, yaw = _relative(space, i, np.column_stack([np.full(6, reach), aside]))
    return _boxes(xy, np.full(6, yaw) + rng.normal(0, step.turn, 6), size, name, space), i


def seat(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """In front of the anchor and facing it, pushed under or drawn back (a chair at a desk)."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    under = rng.uniform(-0.15, UNDER, 6)
    half = max(0.0, space.body.size[i, 1] / 2 - size[1] / 2 - 0.05)
    aside = np.r_[0.0, rng.uniform(-half, half, 5) * 0.5]
    xy, yaw = _relative(space, i, np.column_stack([(space.body.size[i, 0] + size[0]) / 2 - under, aside]))
    return _boxes(xy, np.full(6, yaw + np.pi) + rng.normal(0, step.turn, 6), size, name, space), i


def across(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Facing the anchor from a distance; among the poses one with its back to the wall behind."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    ahead = _ahead(space, i) - 0.02 - size[0]
    far = np.arange(*step.distance, 0.15)
    far = far[far <= ahead]
    if step.distance[0] <= ahead <= step.distance[1] + 0.5:
        far = np.r_[far, np.full(4, ahead)]
    aside = rng.uniform(-1, 1, (4, 1)) * np.array([[0.0], [0.15], [0.35], [0.6]])
    reach, aside = (np.ravel(v) for v in np.broadcast_arrays(space.body.size[i, 0] / 2 + far + size[0] / 2, aside))
    xy, yaw = _relative(space, i, np.column_stack([reach, aside]))
    return _boxes(xy, np.full(len(xy), yaw + np.pi) + step.turn * rng.normal(size=len(xy)), size, name, space), i


def _ahead(space: Space, i: int, sign: float = 1.0) -> float:
    """Distance from the front of object `i` straight to the wall; from its back with `sign` -1."""
    origin, yaw = _relative(space, i, np.array([[sign * space.body.size[i, 0] / 2, 0.0]]))
    d = sign * np.array([np.cos(yaw), np.sin(yaw)])
    shape = space.shape
    facing = shape.normal @ d
    with np.errstate(divide="ignore", invalid="ignore"):
        t = ((shape.start - origin) * shape.normal).sum(1) / facing
        along = ((origin + t[:, None] * d - shape.start) * shape.along).sum(1)
    hit = (facing < -1e-6) & (t > 0) & (along > -1e-6) & (along < shape.length + 1e-6)
    return float(t[hit].min()) if hit.any() else 0.0


def around(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Seats round a table, facing it; a negative gap pushes them under."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    d, w, _ = space.body.size[i]
    if space.category[i] == "round_table":
        angle = rng.uniform(0, 2 * np.pi) if not _seats(space, i) else _seats(space, i)[0]
        turns = np.array([0, 2, 1, 3]) * np.pi / 2 if d < 1.2 else np.array([0, 3, 1, 4, 2, 5]) * np.pi / 3
        angle = angle + turns
        reach = d / 2 + size[0] / 2 + rng.uniform(*step.gap, len(angle))
        offset, turn = np.column_stack([np.cos(angle), np.sin(angle)]) * reach[:, None], angle + np.pi
    else:
        offset, turn = _rows(d, w, size, rng.uniform(*step.gap, 20))
    xy, yaw = _relative(space, i, offset)
    return _boxes(xy, yaw + turn + rng.normal(0, step.turn, len(xy)), size, name, space), i


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
        rows += [(d / 2 + size[0] / 2 + gap[2 * k % 20], s, np.pi), (-d / 2 - size[0] / 2 - gap[(2 * k + 1) % 20], s, 0.0)]
    rows += [(0.0, w / 2 + size[0] / 2 + gap[-1], -np.pi / 2), (0.0, -w / 2 - size[0] / 2 - gap[-2], np.pi / 2)]
    table = np.array(rows)
    return table[:, :2], table[:, 2]


def gather(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Round the anchor at a little distance, facing it: an armchair by the coffee table."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    d, w, _ = space.body.size[i]
    angle = rng.uniform(-np.pi, np.pi, 24)
    c, s = np.cos(angle), np.sin(angle)
    edge = np.minimum((d / 2) / np.maximum(np.abs(c), 1e-6), (w / 2) / np.maximum(np.abs(s), 1e-6))
    reach = edge + rng.uniform(*step.gap, 24) + size[0] / 2 * 1.1
    xy, yaw = _relative(space, i, np.column_stack([c, s]) * reach[:, None])
    snapped = np.where(rng.random(24) < 0.6, np.round(angle / (np.pi / 2)) * np.pi / 2, angle)
    return _boxes(xy, yaw + snapped + np.pi + rng.normal(0, step.turn, 24), size, name, space), i


def on(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """On top of the anchor, towards its back."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    d, w, h = space.body.size[i]
    spare = max(0.0, (w - size[1]) / 2 - 0.02)
    aside = np.r_[0.0, spare, -spare, rng.uniform(-spare, spare, 3)]
    back = np.full(6, -max(0.0, (d - size[0]) / 2 - 0.02) * rng.uniform(0.5, 1.0))
    xy, yaw = _relative(space, i, np.column_stack([back, aside]))
    z = float(space.body.center[i, 2] + h / 2 + size[2] / 2)
    if size[0] > d + 0.03 or size[1] > w + 0.1:
        return _none(name, size, space)
    return _boxes(xy, np.full(6, yaw) + rng.normal(0, step.turn, 6), size, name, space, z), i


def above(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """On the wall behind the anchor, over it."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    d, w, h = space.body.size[i]
    top = float(space.body.center[i, 2] + h / 2)
    back = -d / 2 - _ahead(space, i, -1.0) + size[0] / 2 + 0.005
    spare = max(0.0, (w - size[1]) / 2)
    aside = np.r_[0.0, rng.uniform(-spare, spare, 3)]
    xy, yaw = _relative(space, i, np.column_stack([np.full(4, back), aside]))
    low = max(TABLE[name].z, top + 0.08)
    z = min(low, space.shape.height - size[2] - 0.03) + size[2] / 2
    return _boxes(xy, np.full(4, yaw), size, name, space, z), i


def window(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """At a window: curtains over it, whatever is low below it."""
    shape, rows = space.shape, []
    for x, y, nx, ny, half, sill, head, side in shape.windows:
        if name == "curtain":
            size = np.array([size[0], *_drape(2 * half, sill, head, shape.height, size)])
        aside = 0.0 if name in ("curtain", "radiator") else rng.uniform(-0.3, 0.3)
        offset = size[0] / 2 + (0.005 if name == "curtain" else _gap(step, rng))
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


def under(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Below the anchor, its long side across the anchor's front; shifted forward where the anchor is a bed or sofa."""
    i = _anchor(space, step, rng)
    if i < 0:
        return _none(name, size, space)
    d, w, _ = space.body.size[i]
    if space.category[i] == "single_bed":
        side = (w / 2 + size[0] * rng.uniform(0.1, 0.45)) * np.array([1, -1, 1, -1])
        xy, yaw = _relative(space, i, np.column_stack([rng.uniform(-0.2, 0.5, 4), side]))
        return _boxes(xy, np.full(4, yaw + np.pi / 2), size, name, space), i
    ahead = 0.0
    if space.category[i] == "double_bed":
        ahead = rng.uniform(0.2, 0.6) * d
    elif "sofa" in space.category[i]:
        ahead = d / 2 + size[0] * rng.uniform(0.2, 0.4)
    xy, yaw = _relative(space, i, np.array([[ahead + s, 0.0] for s in (0.0, -0.1, 0.15, -0.2)]))
    return _boxes(xy, np.full(4, yaw) + rng.normal(0, step.turn, 4), size, name, space), i


def middle(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """Anywhere on the floor, along the walls' directions."""
    points = space.flat_grid[space.shape.clear.ravel() > min(size[0], size[1]) / 2]
    if not len(points):
        return _none(name, size, space)
    points = points[rng.integers(0, len(points), 120)]
    base = float(np.arctan2(*space.shape.along[int(space.shape.length.argmax())][::-1]))
    yaw = base + np.pi / 2 * rng.integers(0, 4, 120) + rng.normal(0, step.turn, 120)
    return _boxes(points, yaw, size, name, space), -1


def overhead(space: Space, name: str, size: Array, step: Step, rng: Generator) -> Poses:
    """From the ceiling: over the anchor, else over the middle of the room."""
    i = _anchor(space, step, rng)
    if i >= 0:
        return _boxes(space.body.center[[i], :2], space.body.yaw[[i]], size, name, space), i
    clear = space.shape.clear.ravel()
    inner = space.flat_grid[clear >= min(clear.max(), max(0.6 * clear.max(), 0.3)) - 1e-9]
    centre = inner.mean(0) if clear.max() > 0 else space.shape.start.mean(0)
    xy = np.vstack([centre, inner[np.argsort(((inner - centre) ** 2).sum(1))[:40:8]]])
    yaw = float(np.arctan2(*space.shape.along[0][::-1]))
    return _boxes(xy + rng.normal(0, step.loose, xy.shape), np.full(len(xy), yaw), size, name, space), -1


PLACES: dict[str, Callable[[Space, str, Array, Step, Generator], Poses]] = {
    f.__name__: f
    for f in (wall, corner, beside, front, seat, across, around, gather, on, above, window, under, middle, overhead)
}

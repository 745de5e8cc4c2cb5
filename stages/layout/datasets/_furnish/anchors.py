"""Where a group may be tried: along walls, in the middle, before something; and what is liked about such places."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import kernels
from apartgen.stages.layout.datasets._furnish.group import Group, Poses
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array, Mask

STEP = 0.2
"""Between places along a wall, m."""
OFF = 0.002
"""What touches a wall keeps off it, m."""
FARTHEST = 99.0
"""Where nothing lies ahead, as outside the room, m."""
BESIDE = 0.13
"""Off a wall with a radiator or a curtain, m."""


def walls(space: Space, group: Group, gaps: tuple[float, ...] = (OFF,), step: float = STEP) -> Poses:
    """Along every wall, the group's frame at the wall: at its ends, in its middle and between openings, and on a grid;
    both ways round where that makes a difference."""
    low, high = group.span()
    rows: list[tuple[int, float, float, float]] = []
    flips = (1.0,) if _alike(group) else (1.0, -1.0)
    for k, length in enumerate(space.shape.length):
        for flip in flips:
            lo, hi = (low, high) if flip > 0 else (-high, -low)
            first, last = hi + OFF, float(length) + lo - OFF
            if last < first - 1e-9:
                continue
            some = [first, last, *np.arange(first + step, last, step), *_stretches(space, k, lo, hi, first, last)]
            rows += [(k, s, flip, gap) for s in some for gap in gaps]
    return _at_walls(space, np.array(rows, float).reshape(-1, 4))


def _alike(group: Group) -> bool:
    """Whether a group is its own mirror image."""
    return all(bool(np.all(np.abs(v) < 1e-9)) for p in group.parts for v in (p.y, np.sin(p.yaw)))


def _stretches(space: Space, k: int, lo: float, hi: float, first: float, last: float) -> list[float]:
    """Middles and ends of the stretches of wall `k` between doors and windows."""
    shape, found = space.shape, []
    cuts = [(float((w[:2] - shape.start[k]) @ shape.along[k]), w[4]) for w in shape.windows if int(w[7]) == k]
    for d in shape.doors:
        if abs((d[:2] - shape.start[k]) @ shape.normal[k]) < 0.3 and d[2:4] @ shape.normal[k] > 0.9:
            cuts.append((float((d[:2] - shape.start[k]) @ shape.along[k]), d[4]))
    ends = sorted([(0.0, 0.0), (float(shape.length[k]), 0.0), *cuts])
    for (a, x), (b, y) in zip(ends[:-1], ends[1:], strict=True):
        left, right = a + x, b - y
        found += [(left + right) / 2 + (lo + hi) / 2, left + hi + 0.03, right + lo - 0.03]
    found += [a + (lo + hi) / 2 for a, _ in cuts]
    return [s for s in found if first <= s <= last]


def _at_walls(space: Space, table: Array) -> Poses:
    shape, side = space.shape, table[:, 0].astype(int)
    normal = shape.normal[side]
    xy = shape.start[side] + shape.along[side] * table[:, 1:2] + normal * table[:, 3:4]
    return Poses(xy, np.arctan2(normal[:, 1], normal[:, 0]), table[:, 2].copy(), side, table[:, 1].copy(),
                 table[:, 3].copy())


def middle(space: Space, step: float = 0.25) -> Poses:
    """Over the floor, turned along the sides of the room."""
    shape, rng = space.shape, space.rng
    lo, hi = shape.start.min(0), shape.start.max(0)
    x, y = (np.arange(lo[i] + rng.uniform(0.3, 0.3 + step), hi[i], step) for i in (0, 1))
    points = np.stack(np.meshgrid(x, y, indexing="ij"), -1).reshape(-1, 2)
    k = int(shape.length.argmax())
    base = float(np.arctan2(shape.along[k, 1], shape.along[k, 0]))
    yaws = base + np.array([0.0, np.pi / 2])
    xy, yaw = np.repeat(points, 2, 0), np.tile(yaws, len(points))
    return free(xy, yaw)


def free(xy: Array, yaw: Array) -> Poses:
    """Places at no wall."""
    m = len(yaw)
    return Poses(np.asarray(xy, float).reshape(m, 2), np.asarray(yaw, float), np.ones(m), np.full(m, -1),
                 np.zeros(m), np.zeros(m))


def of_object(space: Space, i: int) -> Poses:
    """The frame of an object: its middle, its heading; both ways round."""
    row = space.placed.row[i]
    at = free(np.tile(row[:2], (2, 1)), np.full(2, np.arctan2(row[7], row[6])))
    return Poses(at.xy, at.yaw, np.array([1.0, -1.0]), at.side, at.s, at.gap)


# --- what is liked ---------------------------------------------------------------------------------------------------

def facing(at: Poses, space: Space) -> Array:
    """Free length before each place to the wall across, (m,)."""
    heading = np.stack([np.cos(at.yaw), np.sin(at.yaw)], -1)
    far = kernels.ahead(np.ascontiguousarray(at.xy), np.ascontiguousarray(heading), space.shape.start)
    return np.asarray(np.minimum(far, FARTHEST))


def cornered(at: Poses, group: Group, space: Space) -> Array:
    """1 where an end of the group stands in a corner of the room, else 0."""
    lo, hi = _spans(at, group)
    length = space.shape.length[at.side]
    return np.asarray(((at.s - hi < 0.06) | (length - at.s + lo < 0.06)).astype(float))


def off_middle(at: Poses, group: Group, space: Space) -> Array:
    """How far the group's middle is from its wall's, m."""
    lo, hi = _spans(at, group)
    return np.asarray(np.abs(at.s - (lo + hi) / 2 - space.shape.length[at.side] / 2))


def _spans(at: Poses, group: Group) -> tuple[Array, Array]:
    low, high = group.span()
    return np.where(at.flip > 0, low, -high), np.where(at.flip > 0, high, -low)


def windowed(at: Poses, group: Group, space: Space) -> Mask:
    """Where the group stands before a window."""
    lo, hi = _spans(at, group)
    out = np.zeros(len(at), bool)
    for w in space.shape.windows:
        k = int(w[7])
        middle = float((w[:2] - space.shape.start[k]) @ space.shape.along[k])
        out |= (at.side == k) & (at.s - hi < middle + w[4]) & (at.s - lo > middle - w[4])
    return out


def to_doors(xy: Array, space: Space) -> Array:
    """Distance to the nearest door, m; 9 without any."""
    doors = space.shape.doors
    if not len(doors):
        return np.full(len(xy), 9.0)
    return np.asarray(np.hypot(*np.moveaxis(xy[:, None] - doors[:, :2], -1, 0)).min(1))


def to_windows(xy: Array, space: Space) -> Array:
    """Distance to the nearest window, m; 9 without any."""
    windows = space.shape.windows
    if not len(windows):
        return np.full(len(xy), 9.0)
    return np.asarray(np.hypot(*np.moveaxis(xy[:, None] - windows[:, :2], -1, 0)).min(1))


def to_things(xy: Array, space: Space, *names: str) -> Array:
    """Distance to the middle of the nearest of these categories, m; 9 without any."""
    some = space.find(*names)
    if not some:
        return np.full(len(xy), 9.0)
    there = np.array([space.placed.row[i][:2] for i in some])
    return np.asarray(np.hypot(*np.moveaxis(xy[:, None] - there, -1, 0)).min(1))


def seen_from_doors(at: Poses, x: float, space: Space) -> Array:
    """1 for places straight before a door's way, else 0."""
    doors = space.shape.doors
    if not len(doors):
        return np.zeros(len(at))
    to = at.point(x, 0.0)[:, None] - doors[:, :2]
    ahead = (to * doors[:, 2:4]).sum(-1)
    aside = np.abs((to * np.stack([-doors[:, 3], doors[:, 2]], -1)).sum(-1))
    return np.asarray(((ahead > 0) & (ahead < 3.0) & (aside < 0.8)).any(1).astype(float))



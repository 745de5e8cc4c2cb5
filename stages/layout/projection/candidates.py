"""Places an object could move to: along walls, beside neighbours, and about where it is."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE

Array = NDArray[np.float64]
GAP = 0.006
"""Between a back and its wall, m: below any tolerance, above rounding."""
SLIDES = np.concatenate(
    [[0], *([s, -s] for s in (0.04, 0.08, 0.13, 0.2, 0.28, 0.38, 0.5, 0.65, 0.85, 1.1, 1.4, 1.8, 2.3, 3.0))]
)
RINGS = (0.04, 0.08, 0.14, 0.22, 0.32, 0.45, 0.6, 0.8, 1.05, 1.4, 1.9)
CENTRAL = np.array([1.0, 1.0, 0.6, 0.6, 0.6, 0.6])
"""How much of what the middle is worth each place of `middle` has."""
SNAP = np.deg2rad(16)
"""Even what may stand at an angle is turned along a wall when this close to it."""


def snapped(category: str, yaw: float, space: Space) -> float:
    """The yaw, turned onto the nearest wall direction."""
    walls = np.arctan2(space.normal[:, 1], space.normal[:, 0])
    turn = (yaw - walls[:, None] + np.pi) % (2 * np.pi) - np.pi
    nearest = turn.flat[np.argmin(np.abs(turn))]
    return float(yaw - nearest) if abs(nearest) < SNAP or not TABLE[category].stands.askew else float(yaw)


def along_walls(center: Array, size: Array, space: Space, others: Boxes) -> Boxes:
    """Back to every wall, slid along it; flush with its corners and with what already stands at that wall."""
    depth, width = size[0], size[1]
    wide = np.flatnonzero(space.length >= width)
    start, along, normal, length = (v[wide] for v in (space.start, space.along, space.normal, space.length))
    base = ((center[:2] - start) * along).sum(1)
    ends = np.stack([np.full(len(wide), width / 2 + GAP), length - width / 2 - GAP], 1)
    at = np.concatenate([base[:, None] + SLIDES, ends, _beside(start, along, normal, width, others)], 1)
    most = (length - width / 2 - GAP / 2)[:, None]
    at = np.sort(np.minimum(np.maximum(at, width / 2 + GAP / 2), most).round(4), 1)
    # NaN, of what is not at that wall, comes last.
    wall, k = np.nonzero(np.diff(at, axis=1, prepend=-1.0) > 0)
    places = start[wall] + at[wall, k, None] * along[wall] + normal[wall] * (depth / 2 + GAP)
    return _boxes(places, np.arctan2(normal[:, 1], normal[:, 0])[wall], center[2], size)


def _beside(start: Array, along: Array, normal: Array, width: float, others: Boxes) -> Array:
    """Places beside what stands with its back to each wall, (walls, 2 m), NaN where something does not."""
    offset = others.center[None, :, :2] - start[:, None]
    behind = np.abs((offset * normal[:, None]).sum(-1) - others.size[:, 0] / 2) < 0.08
    turned = np.cos(others.yaw) * normal[:, :1] + np.sin(others.yaw) * normal[:, 1:]
    at = np.where(behind & (np.abs(turned - 1) < 1e-3), (offset * along[:, None]).sum(-1), np.nan)
    far = (others.size[:, 1] + width + GAP) / 2
    return np.concatenate([at - far, at + far], 1)


def about(center: Array, size: Array, yaw: float) -> Boxes:
    """Where it is, and rings about that."""
    angle = np.arange(12) * np.pi / 6
    ring = np.stack([np.cos(angle), np.sin(angle)], -1)
    at = np.concatenate([np.zeros((1, 2)), *(r * ring for r in RINGS)]) + center[:2]
    return _boxes(at, np.full(len(at), yaw), center[2], size)


def everywhere(center: Array, size: Array, yaw: float, space: Space, step: float = 0.2) -> Boxes:
    """A grid over the whole room, at four headings."""
    low, high = space.corners.min(0), space.corners.max(0)
    x, y = (np.arange(low[k] + step / 2, high[k], step) for k in (0, 1))
    at = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    yaws = yaw + np.arange(4) * np.pi / 2
    return _boxes(np.tile(at, (4, 1)), np.repeat(yaws, len(at)), center[2], size)


def middle(center: Array, size: Array, space: Space) -> Boxes:
    """In the middle of the widest part of the floor, along the room or across it; two share its length."""
    at, long = space.middle
    turns = np.array([0.0, np.pi / 2]) + np.arctan2(long[1], long[0])
    # What is wider than deep lies with its width along the room.
    turns += np.pi / 2
    spots = at + np.array([0.0, 1.0, -1.0])[:, None] * long
    return _boxes(np.repeat(spots, 2, 0), np.tile(turns, 3), center[2], size)


def across(center: Array, size: Array, space: Space, seats: Boxes) -> Boxes:
    """At the wall that each seat looks at, in the middle of its view."""
    at, yaw = [], []
    for seat, turn in zip(seats.center[:, :2], seats.yaw, strict=True):
        ahead = np.array([np.cos(turn), np.sin(turn)])
        facing = space.normal @ ahead
        with np.errstate(divide="ignore", invalid="ignore"):
            far = ((space.start - seat) * space.normal).sum(1) / facing
            along = ((seat + far[:, None] * ahead - space.start) * space.along).sum(1)
        met = (facing < -0.9) & (far > 0) & (along > 0) & (along < space.length) & (space.length > size[1] + GAP)
        if not met.any():
            continue
        k = int(np.argmin(np.where(met, far, np.inf)))
        slid = np.clip(along[k], (size[1] + GAP) / 2, space.length[k] - (size[1] + GAP) / 2)
        at.append(space.start[k] + slid * space.along[k] + space.normal[k] * (size[0] / 2 + GAP))
        yaw.append(np.arctan2(space.normal[k, 1], space.normal[k, 0]))
    return _boxes(np.array(at).reshape(-1, 2), np.array(yaw), center[2], size)


def under_windows(center: Array, size: Array, space: Space) -> Boxes:
    """At the wall, in the middle of every window."""
    spans = space.spans[space.window]
    yaw = space.zones.yaw[space.window]
    inward = np.stack([np.cos(yaw), np.sin(yaw)], -1)
    return _boxes(spans.mean(1) + inward * (size[0] / 2 + GAP), yaw, center[2], size)


def join(parts: list[Boxes]) -> Boxes:
    """All boxes in one."""
    return Boxes(*(np.concatenate(arrays) for arrays in zip(*parts, strict=True)))


def _boxes(at: Array, yaw: Array, z: float, size: Array) -> Boxes:
    return Boxes(np.column_stack([at, np.full(len(at), z)]), np.broadcast_to(size, (len(at), 3)), yaw)

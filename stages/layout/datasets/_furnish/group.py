"""Groups: things that are used together, placed as one in a frame of their own.

A group's frame has its origin where the group begins (a point of a wall, say), x into the room, y to the left.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import TABLE, reach

Along = float | Array
"""A place in the group's frame, the same for all poses or one for each, m."""


@dataclass(frozen=True)
class Part:
    """One object of a group: middle of its box, turn, [depth, width, height], bottom above the floor; `at` is the part
    (its index in the group) by which it stands, -1 what the whole group stands at."""

    name: str
    x: Along
    y: Along
    size: Array
    yaw: Along = 0.0
    z: float = 0.0
    at: int = -1

    @property
    def opens(self) -> float:
        """How far its open parts stand out in front, m."""
        return _opens(self.name, *(float(v) for v in self.size))


@lru_cache(maxsize=4096)
def _opens(name: str, d: float, w: float, h: float) -> float:
    return float(reach(name, (d, w, h))) if TABLE[name].articulated else 0.0


@dataclass(frozen=True)
class Zone:
    """Floor that stays free for use, from (x0, y0) to (x1, y1), but for `friends`."""

    x0: Along
    x1: Along
    y0: Along
    y1: Along
    friends: Collection[str] = ()
    inside: bool = True
    """Whether it must lie in the room."""


@dataclass(frozen=True)
class Group:
    """Parts and zones of one frame."""

    parts: tuple[Part, ...]
    zones: tuple[Zone, ...] = ()

    def span(self) -> tuple[float, float]:
        """Least and greatest y of what stands in it."""
        low, high = [], []
        for p in self.parts:
            half = turned(p.size, p.yaw)[1]
            low.append(float(np.min(p.y - half)))
            high.append(float(np.max(p.y + half)))
        return min(low), max(high)

    def with_part(self, *parts: Part) -> "Group":
        """The group with more parts."""
        return replace(self, parts=(*self.parts, *parts))


@dataclass(frozen=True)
class Poses:
    """Places (m,) for a group: origin, turn, mirrored (-1) or not; the side of the room (-1 none), where along it, and
    how far off it."""

    xy: Array
    yaw: Array
    flip: Array
    side: NDArray[np.int64]
    s: Array
    gap: Array

    def __len__(self) -> int:
        return len(self.yaw)

    def take(self, index: NDArray[np.int64] | NDArray[np.bool_]) -> "Poses":
        """Some of the places."""
        return Poses(self.xy[index], self.yaw[index], self.flip[index], self.side[index], self.s[index],
                     self.gap[index])

    def point(self, x: Along, y: Along) -> Array:
        """World points (m, 2) of a point of the frame."""
        c, s, y = np.cos(self.yaw), np.sin(self.yaw), y * self.flip
        return np.asarray(self.xy + np.stack([c * x - s * y, s * x + c * y], -1))


def joined(*some: Poses) -> Poses:
    """All places of several sets."""
    return Poses(*(np.concatenate([getattr(one, name) for one in some])
                   for name in ("xy", "yaw", "flip", "side", "s", "gap")))


class Rows(NamedTuple):
    """A group at its poses: bodies, what open parts sweep, zones, each (m, k, 8)."""

    body: Array
    sweep: Array
    zone: Array


LOW, HIGH = 0.05, 1.7
"""Height of zones, m."""
NOTHING = np.array([0.0, 0.0, -50.0, 0.01, 0.01, 0.01, 1.0, 0.0])


def rows(group: Group, at: Poses) -> Rows:
    """The group's boxes in the world, as the kernels want them."""
    bodies = [(p.x, p.y, p.yaw, p.z + p.size[2] / 2, *p.size) for p in group.parts]
    zones = [((z.x0 + z.x1) / 2, (z.y0 + z.y1) / 2, 0.0, (LOW + HIGH) / 2, z.x1 - z.x0, z.y1 - z.y0, HIGH - LOW)
             for z in group.zones]
    return Rows(_rows(bodies, at), _rows([_sweep(p) for p in group.parts], at), _rows(zones, at))


def _sweep(p: Part) -> tuple[Along, ...]:
    out = p.opens
    if out <= 0:
        return 0.0, 0.0, 0.0, float(NOTHING[2]), 0.01, 0.01, 0.01
    by = (p.size[0] + out) / 2
    return p.x + by * np.cos(p.yaw), p.y + by * np.sin(p.yaw), p.yaw, p.z + p.size[2] / 2, out, *p.size[1:]


def _rows(some: Sequence[tuple[Along, ...]], at: Poses) -> Array:
    """Boxes (x, y, turn, z, depth, width, height) of the frame as rows (m, k, 8) in the world."""
    m, k = len(at), len(some)
    if any(isinstance(v, np.ndarray) and v.ndim for one in some for v in one):
        local = np.empty((7, m, k))
        for i, one in enumerate(some):
            for j, v in enumerate(one):
                local[j, :, i] = v
    else:
        local = np.array(some, float).reshape(k, 7).T[:, None]
    c, s, flip = np.cos(at.yaw)[:, None], np.sin(at.yaw)[:, None], at.flip[:, None]
    y, heading = local[1] * flip, at.yaw[:, None] + local[2] * flip
    out = np.empty((m, k, 8))
    out[..., 0], out[..., 1] = at.xy[:, :1] + c * local[0] - s * y, at.xy[:, 1:] + s * local[0] + c * y
    for j in range(4):
        out[..., 2 + j] = local[3 + j]
    out[..., 6], out[..., 7] = np.cos(heading), np.sin(heading)
    return out


def turned(size: Array, yaw: Along) -> tuple[Along, Along]:
    """Half of what a turned box takes along x and along y, m."""
    c, s = np.abs(np.cos(yaw)), np.abs(np.sin(yaw))
    return (size[0] * c + size[1] * s) / 2, (size[1] * c + size[0] * s) / 2


@dataclass
class Placed:
    """What stands in a room: objects as rows (8,), categories, what each stands at (`wall k`, an index, or `free`)."""

    name: list[str] = field(default_factory=list)
    row: list[Array] = field(default_factory=list)
    at: list[str | int] = field(default_factory=list)
    friends: list[Collection[str]] = field(default_factory=list)
    zone: list[Array] = field(default_factory=list)
    sweep: list[Array] = field(default_factory=list)


def floor(name: str) -> bool:
    """Whether it stands on the floor."""
    return TABLE[name].place == "floor"

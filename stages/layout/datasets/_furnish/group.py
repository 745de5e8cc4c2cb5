"""Groups: things that are used together, placed as one in a frame of their own.

A group's frame has its origin where the group begins (a point of a wall, say), x into the room, y to the left.
"""

from collections.abc import Collection
from dataclasses import dataclass, field, replace
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
        return float(reach(self.name, self.size))


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
    bodies = [_row(at, p.x, p.y, p.yaw, p.z + p.size[2] / 2, *p.size) for p in group.parts]
    sweeps = [_sweep(p, at) for p in group.parts]
    zones = [_row(at, (z.x0 + z.x1) / 2, (z.y0 + z.y1) / 2, 0.0, (LOW + HIGH) / 2, z.x1 - z.x0, z.y1 - z.y0, HIGH - LOW)
             for z in group.zones]
    return Rows(*(np.ascontiguousarray(np.stack(some, 1)) if some else np.empty((len(at), 0, 8))
                  for some in (bodies, sweeps, zones)))


def _sweep(p: Part, at: Poses) -> Array:
    out = p.opens
    if out <= 0:
        return np.tile(NOTHING, (len(at), 1))
    by = (p.size[0] + out) / 2
    return _row(at, p.x + by * np.cos(p.yaw), p.y + by * np.sin(p.yaw), p.yaw, p.z + p.size[2] / 2, out, *p.size[1:])


def _row(at: Poses, x: Along, y: Along, yaw: Along, z: float, d: Along, w: Along, h: float) -> Array:
    facing = at.yaw + yaw * at.flip
    row = np.empty((len(at), 8))
    row[:, :2] = at.point(x, y)
    for k, value in enumerate((z, d, w, h, np.cos(facing), np.sin(facing)), 2):
        row[:, k] = value
    return row


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

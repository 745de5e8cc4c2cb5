"""A room as the projection sees it: wall frames, slabs behind the walls, zones to keep clear."""

from collections.abc import Hashable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection import kernels
from apartgen.stages.layout.projection.kernels import writable
from apartgen.stages.layout.rooms import DOOR_CLEARANCE, KINDS, WINDOW_CLEARANCE, Rooms
from apartgen.stages.space.boxes import Boxes

Array = NDArray[np.float64]
SLAB = 0.30
DOOR_HEAD = 2.1
SILL = 1.0
LEAF = 0.14
"""Thickness of a door with its levers, m."""
NOTHING, CUT, SQUARE = 1e-6, 0.02, 1 - 1e-6
"""What is nothing, and more than a little, m; the cosine from which on a side is along a wall."""


@dataclass
class Space:
    """One room, metres, in its own frame.

    start, along, normal (E, 2) and length (E,) of walls, normals inward · slabs: wall bodies · zones: boxes to keep
    clear, `window` (Z,) tells which are before windows · spans (Z, 2, 2) the openings' own segments · entrances (n, 2)
    their middles · leaves: doors that stand open in the room, with their levers.
    """

    corners: Array
    start: Array
    along: Array
    normal: Array
    length: Array
    slabs: Boxes
    zones: Boxes
    window: NDArray[np.bool_]
    spans: Array
    height: float
    entrances: Array = field(default_factory=lambda: np.zeros((0, 2)))
    leaves: Boxes = field(default_factory=lambda: Boxes(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0)))

    @cached_property
    def reentrant(self) -> Boxes:
        """Bodies of the walls that meet at corners which stand out into the room."""
        before = np.roll(self.along, 1, 0)
        out = before[:, 0] * self.along[:, 1] - before[:, 1] * self.along[:, 0] < -1e-9
        return self.slabs.take(out | np.roll(out, -1))

    @cached_property
    def doors(self) -> Boxes:
        """The zones that are not before windows."""
        return self.zones.take(~self.window)

    @cached_property
    def known(self) -> dict[Hashable, Any]:
        """What was worked out of the room before and hangs on nothing else, by what it is; nobody changes it."""
        return {}

    @cached_property
    def end(self) -> Array:
        """Where the walls end, (E, 2)."""
        return np.roll(self.start, -1, 0)

    @cached_property
    def lines(self) -> Array:
        """How far from the origin the walls' lines lie inwards, (E,)."""
        return np.asarray((self.start * self.normal).sum(1))

    @cached_property
    def walls(self) -> kernels.Walls:
        """The walls as `kernels` takes them."""
        start, along, normal, length = map(np.ascontiguousarray, (self.start, self.along, self.normal, self.length))
        lines = kernels.Lines(start, along, normal, length, not self.reentrant.n)
        return kernels.Walls(lines, writable(self.reentrant))

    @cached_property
    def kept_clear(self) -> kernels.Zones:
        """The zones as `kernels` takes them."""
        return kernels.Zones(writable(self.zones), np.ascontiguousarray(self.window))

    @cached_property
    def middle(self) -> tuple[Array, Array]:
        """The point farthest from the walls, the one nearest to the centre among equals, and a quarter of the free
        length through it, (2,) each."""
        low, high = self.corners.min(0), self.corners.max(0)
        x, y = (np.linspace(low[k], high[k], 2 * int((high[k] - low[k]) / 0.2) + 3)[1:-1] for k in (0, 1))
        points = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
        away = self.away(points)
        centre = (self.corners.mean(0) + (low + high) / 2) / 2
        best = points[np.argmax(away - 0.15 * np.linalg.norm(points - centre, axis=1))]
        steps = np.arange(1, 60)[:, None] * 0.1
        ahead = self.along[0]
        ways = [ahead, np.array([-ahead[1], ahead[0]])]
        free = [
            sum(int(np.cumprod(self.away(best + sign * steps * way) > 0.05).sum()) for sign in (1, -1)) for way in ways
        ]
        k = int(np.argmax(free))
        return best, ways[k] * free[k] * 0.1 / 4

    def away(self, points: Array) -> Array:
        """Distance to the nearest wall, m, 0 beyond the walls, (n,)."""
        within, far = _within(points, self)
        return np.where(within, far, 0.0)

    def behind(self, found: Boxes, aside: Array | float = 0.0) -> Array:
        """Distance of each back, `aside` of its middle, from the nearest wall, m, (n,)."""
        return kernels.behind(writable(found), np.full(found.n, aside, float), self.walls)

    def from_entrance(self, points: Array) -> Array:
        """Distance to the middle of the nearest entrance of a room that has one, m, (n,)."""
        return np.asarray(np.linalg.norm(points[:, None] - self.entrances, axis=-1).min(1))

    def cut(self, box: NDArray[np.floating[Any]]) -> NDArray[np.floating[Any]]:
        """A box (7,) without the little that lies beyond walls: less deep or wide where it stands square to one, else
        moved away from it."""
        out = np.array(box, float)
        turned = np.abs(self.normal @ [[np.cos(out[2]), -np.sin(out[2])], [np.sin(out[2]), np.cos(out[2])]])
        over = turned @ out[3:5] / 2 - (self.normal * (out[:2] - self.start)).sum(1)
        if not ((over > NOTHING) & (over < CUT)).any():
            return box
        for start, along, normal, length in zip(self.start, self.along, self.normal, self.length, strict=True):
            ways = np.array([[np.cos(out[2]), np.sin(out[2])], [-np.sin(out[2]), np.cos(out[2])]])
            half = np.abs(ways @ normal) @ out[3:5] / 2
            ahead, at = (out[:2] - start) @ normal, (out[:2] - start) @ along
            over = half - ahead
            if not NOTHING < over < CUT or not -CUT < at < length + CUT:
                continue
            square = np.abs(ways @ normal) > SQUARE
            out[:2] += normal * over / (1 + square.any())
            out[3:5] -= square * over
        return out.astype(np.asarray(box).dtype)


def space_of(rooms: Rooms, index: int) -> Space:
    """The space of one room of a batch."""
    polygon = rooms.polygon[index].astype(float)
    corners = polygon[~np.isnan(polygon[:, 0])]
    side = np.roll(corners, -1, 0) - corners
    length = np.linalg.norm(side, axis=1)
    along = side / length[:, None]
    normal = np.stack([-along[:, 1], along[:, 0]], -1)
    height = float(rooms.height[index])
    mid = (corners + np.roll(corners, -1, 0)) / 2 - normal * SLAB / 2
    slabs = Boxes(
        np.column_stack([mid, np.full(len(mid), height / 2)]),
        np.column_stack([np.full(len(mid), SLAB), length, np.full(len(mid), height)]),
        np.arctan2(normal[:, 1], normal[:, 0]),
    )
    rows = rooms.openings[index].astype(float)
    rows = rows[~np.isnan(rows[:, 0])]
    zones, window, spans = _zones(rows, height)
    entrances = spans[rows[:, 4] == KINDS["entrance"]].mean(1)
    return Space(corners, corners, along, normal, length, slabs, zones, window, spans, height, entrances, _leaves(rows))


def _leaves(rows: Array) -> Boxes:
    """Inner doors that open into the room, at a right angle."""
    rows = rows[(rows[:, 4] == KINDS["door"]) & (rows[:, 5] > 0)]
    spans = rows[:, :4].reshape(-1, 2, 2)
    side = spans[:, 1] - spans[:, 0]
    wide = np.linalg.norm(side, axis=1)
    inward = np.stack([-side[:, 1], side[:, 0]], -1) / np.maximum(wide, 1e-9)[:, None]
    pivot = spans[np.arange(len(rows)), rows[:, 6].astype(int)]
    center, size = np.full((len(rows), 3), DOOR_HEAD / 2), np.full((len(rows), 3), DOOR_HEAD)
    center[:, :2] = pivot + inward * wide[:, None] / 2
    size[:, 0], size[:, 1] = wide, LEAF
    return Boxes(center, size, np.arctan2(inward[:, 1], inward[:, 0]))


def _zones(rows: Array, height: float) -> tuple[Boxes, NDArray[np.bool_], Array]:
    spans = rows[:, :4].reshape(-1, 2, 2)
    side = spans[:, 1] - spans[:, 0]
    wide = np.linalg.norm(side, axis=1)
    inward = np.stack([-side[:, 1], side[:, 0]], -1) / np.maximum(wide, 1e-9)[:, None]
    window = rows[:, 4] == KINDS["window"]
    leaf = np.where(rows[:, 5] > 0, np.maximum(wide + 0.03, DOOR_CLEARANCE), DOOR_CLEARANCE)
    depth = np.where(window, WINDOW_CLEARANCE, leaf)
    low, high = np.where(window, SILL, 0.03), np.where(window, height, DOOR_HEAD)
    center = spans.mean(1) + inward * depth[:, None] / 2
    zones = Boxes(
        np.column_stack([center, (low + high) / 2]).reshape(-1, 3),
        np.column_stack([depth, wide, high - low]).reshape(-1, 3),
        np.arctan2(inward[:, 1], inward[:, 0]),
    )
    return zones, window, spans


def outside(found: Boxes, space: Space) -> Array:
    """How far each box stands beyond the walls, m, 0 when inside, (n,)."""
    return kernels.beyond(writable(found), space.walls)


def _within(points: Array, space: Space) -> tuple[NDArray[np.bool_], Array]:
    """Which points lie on the floor, and the distance of each to the nearest wall, (n,)."""
    if not space.reentrant.n:
        # In a convex room the signed distances from the walls' lines tell all about what lies inside.
        signed = np.asarray((points @ space.normal.T - space.lines).min(1))
        within = signed > 0
        if within.all():
            return within, signed
        _, past = _measured(points[~within], space)
        signed[~within] = past
        return within, signed
    return _measured(points, space)


def _measured(points: Array, space: Space) -> tuple[NDArray[np.bool_], Array]:
    offset = points[:, None] - space.start
    share = np.clip((offset * space.along).sum(-1), 0, space.length)
    away = np.linalg.norm(offset - share[..., None] * space.along, axis=-1).min(1)
    end = space.end
    spans = (space.start[:, 1] > points[:, 1, None]) != (end[:, 1] > points[:, 1, None])
    turn = space.along[:, 0] * offset[..., 1] - space.along[:, 1] * offset[..., 0]
    right = np.where(end[:, 1] > space.start[:, 1], turn > 0, turn < 0)
    return (spans & right).sum(1) % 2 == 1, away

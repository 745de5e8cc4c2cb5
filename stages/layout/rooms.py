"""Rooms as padded arrays: what the layout model is conditioned on.

A room's frame has its origin at the centre of its polygon's bounding box, at floor level, axes as the world's.
"""

from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import Plan, Room
from apartgen.stages.layout.meals import TABLES, table_of, without_table
from apartgen.stages.layout.newcomers import as_known
from apartgen.stages.layout.wishes import of_room
from apartgen.stages.things.categories import CATEGORIES

MAX_CORNERS = 32
MAX_OPENINGS = 20
KINDS = {"door": 0, "opening": 1, "entrance": 2, "window": 3}
UNKNOWN = -1
DOOR_CLEARANCE = 0.75
"""Depth kept free in front of a door, m."""
WINDOW_CLEARANCE = 0.20
"""Depth kept free of tall things in front of a window, m."""

Floats = NDArray[np.float32]
Ints = NDArray[np.int64]


@dataclass
class Rooms:
    """A batch of rooms.

    polygon (B, P, 2) NaN-padded corners, counter-clockwise · openings (B, 20, 7) NaN-padded rows of
    [x0, y0, x1, y1, kind, leaf swings in here, hinge] · type (B,) · height (B,) · count (B,), -1 unknown ·
    wanted (B, C) objects asked for by category, -1 unknown · origin (B, 2) of the frame in the world.
    """

    polygon: Floats
    openings: Floats
    type: Ints
    height: Floats
    count: Ints
    wanted: Ints
    origin: Floats

    def __len__(self) -> int:
        return len(self.type)

    def __getitem__(self, index: NDArray[np.int64] | slice) -> "Rooms":
        return Rooms(**{f.name: getattr(self, f.name)[index] for f in fields(self)})

    @property
    def area(self) -> Floats:
        """Floor areas in m², (B,)."""
        a, b = edges(self.polygon)
        cross = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
        return np.asarray(np.nansum(cross, axis=1) / 2, np.float32)

    @property
    def tokens(self) -> Ints:
        """Sides and openings of each room, (B,)."""
        return np.asarray((~np.isnan(self.polygon[..., 0])).sum(1) + (~np.isnan(self.openings[..., 0])).sum(1))


def edges(polygon: Floats) -> tuple[Floats, Floats]:
    """Start and end points (B, P, 2) of the sides of NaN-padded polygons; NaN past the last side."""
    following = np.concatenate([polygon[:, 1:], np.full_like(polygon[:, :1], np.nan)], axis=1)
    last = np.isnan(following[..., :1]) & ~np.isnan(polygon[..., :1])
    return polygon, np.where(last, polygon[:, :1], following)


def oriented(rooms: Rooms) -> Rooms:
    """The same rooms, every opening's segment running along the boundary counter-clockwise, inside on its left."""
    a, b = edges(rooms.polygon)
    start, end = rooms.openings[:, :, 0:2], rooms.openings[:, :, 2:4]
    along = (b - a)[:, None]
    length2 = np.maximum((along**2).sum(-1), 1e-12)
    offset = ((start + end) / 2)[:, :, None] - a[:, None]
    share = np.clip((offset * along).sum(-1) / length2, 0, 1)
    distance = ((offset - share[..., None] * along) ** 2).sum(-1)
    side = np.argmin(np.nan_to_num(distance, nan=np.inf), -1)
    direction = np.take_along_axis(along[:, 0], side[..., None], 1)
    backward = ((end - start) * direction).sum(-1) < 0
    turned = rooms.openings[:, :, [2, 3, 0, 1, 4, 5, 6]]
    turned[..., 6] = 1 - turned[..., 6]
    return replace(rooms, openings=np.where(backward[..., None], turned, rooms.openings))


def of_plan(plan: Plan, chance: float = 1.0) -> Rooms:
    """All rooms of a plan in its order, with the counts and objects the programme asks for, and the home's table,
    which `chance` in [0, 1) picks."""
    n = len(plan.rooms)
    out = Rooms(
        polygon=np.full((n, MAX_CORNERS, 2), np.nan, np.float32),
        openings=np.full((n, MAX_OPENINGS, 7), np.nan, np.float32),
        type=np.array([ROOM_TYPES.index(room.base) for room in plan.rooms], np.int64),
        height=np.full(n, plan.height, np.float32),
        count=np.array([plan.program.counts.get(room.id, UNKNOWN) for room in plan.rooms], np.int64),
        wanted=np.full((n, len(CATEGORIES)), UNKNOWN, np.int64),
        origin=np.zeros((n, 2), np.float32),
    )
    for i, room in enumerate(plan.rooms):
        corners = np.array(room.polygon)
        if len(corners) > MAX_CORNERS:
            raise BadInput(f"{room.id} has {len(corners)} corners, more than {MAX_CORNERS}; simplify it")
        origin = (corners.min(0) + corners.max(0)) / 2
        out.origin[i] = origin
        out.polygon[i, : len(corners)] = corners - origin
        rows = opening_rows(plan, room, origin)
        out.openings[i, : len(rows)] = rows
        for category, count in as_known(of_room(plan.program, room.id)).items():
            if category in CATEGORIES:
                out.wanted[i, CATEGORIES.index(category)] = count
    place, kind = table_of(plan, chance) or ("", "")
    bare = without_table(plan)
    for row, room in zip(out.wanted, plan.rooms, strict=True):
        if room.id == place or room.id in bare:
            row[[CATEGORIES.index(category) for category in TABLES]] = [category == kind for category in TABLES]
    return oriented(out)


def opening_rows(plan: Plan, room: Room, origin: NDArray[np.float64]) -> NDArray[np.float64]:
    """The room's openings (k, 7), their segments moved onto the room's own boundary."""
    rows = []
    for opening in plan.openings:
        if room.id not in opening.rooms:
            continue
        a, b = (_on_boundary(np.array(p), np.array(room.polygon)) - origin for p in opening.segment)
        swings = float(opening.into == room.id)
        rows.append([*a, *b, KINDS[opening.kind], swings, float(opening.hinge)])
    # A window blocks less than a door does, so it is what goes when there are too many.
    rows.sort(key=lambda row: row[4] == KINDS["window"])
    return np.array(rows[:MAX_OPENINGS]).reshape(-1, 7)


def _on_boundary(point: NDArray[np.float64], corners: NDArray[np.float64]) -> NDArray[np.float64]:
    along = np.roll(corners, -1, 0) - corners
    share = np.clip(((point - corners) * along).sum(1) / (along**2).sum(1), 0, 1)
    nearest = corners + share[:, None] * along
    return np.asarray(nearest[np.argmin(((nearest - point) ** 2).sum(1))])

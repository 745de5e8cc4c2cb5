"""A room as tokens: itself, its walls and openings, its objects; every one a box, and its kind.

Boxes are rows [x, y, yaw, depth, width, low, high], metres and radians: front is where yaw points, low and high are
heights above the floor. A wall or an opening is a box without depth whose front looks into the room.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.mutual import stood
from apartgen.stages.layout.rooms import DOOR_CLEARANCE, KINDS, WINDOW_CLEARANCE, Rooms
from apartgen.stages.space.boxes import Boxes

ROOM, WALL, DOOR, OPENING, ENTRANCE, WINDOW, OBJECT, ASKING = range(8)
"""Kinds of token; `ASKING` stands for the object that is to be placed."""
N_KINDS = 8
HOLES = {KINDS["door"]: DOOR, KINDS["opening"]: OPENING, KINDS["entrance"]: ENTRANCE, KINDS["window"]: WINDOW}
HEADS = {DOOR: (0.0, 2.05), OPENING: (0.0, 2.05), ENTRANCE: (0.0, 2.05), WINDOW: (0.9, 2.2)}
"""Heights of sill and head that the model is told, as corpora do not say them."""
BOX = 7
BODY = 6.0
"""All is solid behind a wall for so far, unless the room itself goes on there, m."""
Array = NDArray[np.floating[Any]]
Ints = NDArray[np.int64]


class Shell(NamedTuple):
    """A room without objects: boxes (S, 7), kind (S,), swing (S, 2) of doors: opens into the room, hinge; deep (S,) how
    far it is solid behind walls, m. The room itself is the first token."""

    boxes: Array
    kind: Ints
    swing: Array
    deep: Array


def shell(rooms: Rooms, index: int) -> Shell:
    """The tokens of one room of a batch, in the room's frame."""
    polygon = rooms.polygon[index].astype(float)
    corners = polygon[~np.isnan(polygon[:, 0])]
    rows = rooms.openings[index].astype(float)
    rows = rows[~np.isnan(rows[:, 0])]
    height = float(rooms.height[index])
    low, high = corners.min(0), corners.max(0)
    room = np.array([[*(low + high) / 2, 0.0, *(high - low), 0.0, height]])
    walls = _upright(corners, np.roll(corners, -1, 0), np.zeros(len(corners)), np.full(len(corners), height))
    kind = np.array([HOLES[int(row[4])] for row in rows], np.int64)
    sills, heads = np.array([HEADS[k] for k in kind.tolist()]).reshape(-1, 2).T
    holes = _upright(rows[:, 0:2], rows[:, 2:4], sills, np.minimum(heads, height))
    swing = np.zeros((1 + len(walls) + len(holes), 2), np.float32)
    swing[1 + len(walls):] = rows[:, 5:7]
    boxes = np.concatenate([room, walls, holes]).astype(np.float32)
    deep = np.concatenate([[0.0], _behind(corners), np.zeros(len(holes))]).astype(np.float32)
    return Shell(boxes, np.concatenate([[ROOM], np.full(len(walls), WALL), kind]).astype(np.int64), swing, deep)


def _behind(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far it is to other parts of the room behind each wall, m."""
    side = np.roll(corners, -1, 0) - corners
    length = np.hypot(*side.T)
    along = side / length[:, None]
    offset = corners[None] - corners[:, None]
    past = (offset * along[:, None]).sum(-1)
    out = offset[..., 0] * along[:, None, 1] - offset[..., 1] * along[:, None, 0]
    there = (out > 0.05) & (past > 0.05) & (past < length[:, None] - 0.05)
    return np.asarray(np.where(there, out, BODY).min(1))


def _upright(start: NDArray[np.float64], end: NDArray[np.float64], low: NDArray[np.float64],
             high: NDArray[np.float64]) -> NDArray[np.float64]:
    """Boxes without depth over segments that run with the room on their left, (n, 7)."""
    side = end - start
    middle = (start + end) / 2
    yaw = np.arctan2(side[:, 0], -side[:, 1])
    return np.column_stack([middle, yaw, np.zeros(len(side)), np.hypot(*side.T), low, high]).reshape(-1, BOX)


def solids(
    boxes: Array, kind: Ints, swing: Array, behind: Array, soft: NDArray[np.bool_]
) -> tuple[Array, Ints]:
    """What tokens (..., T) keep others from: boxes (..., T, 7), walls as bodies, solid for so far `behind` them, doors
    and windows as the floor before them, and their sorts as `clear.depths` counts them; `soft` objects keep nobody
    away."""
    out = boxes.copy()
    door, window, wall = (kind > WALL) & (kind < WINDOW), kind == WINDOW, kind == WALL
    leaf = np.where(swing[..., 0] > 0, np.maximum(boxes[..., 4], DOOR_CLEARANCE), DOOR_CLEARANCE)
    deep = np.select([wall, door, window], [behind, leaf, WINDOW_CLEARANCE], 0.0)
    ahead = np.where(wall, -deep / 2, deep / 2)
    out[..., 0] += np.cos(boxes[..., 2]) * ahead
    out[..., 1] += np.sin(boxes[..., 2]) * ahead
    out[..., 3] = np.where(deep > 0, deep, boxes[..., 3])
    sort = np.select([(kind == OBJECT) & ~soft, wall, door, window], [1, 2, 3, 4], 0)
    return out, sort.astype(np.int64)


def mirrored(boxes: Array) -> Array:
    """Boxes (..., 7) with y negated."""
    return np.asarray(boxes * np.array([1, -1, -1, 1, 1, 1, 1], np.float32))


def turned(boxes: Array, quarter: int) -> Array:
    """Boxes (..., 7) turned by `quarter` right angles about the origin."""
    c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter % 4]
    out = boxes.copy()
    out[..., 0], out[..., 1] = c * boxes[..., 0] - s * boxes[..., 1], s * boxes[..., 0] + c * boxes[..., 1]
    out[..., 2] += quarter * np.pi / 2
    return out


def seen(boxes: Array, viewer: Array) -> Array:
    """Boxes (..., T, 7) in the frame of a viewer (..., 7): rows [x, y, yaw, half extent along x, along y, low, high,
    depth, width] (..., T, 9); the extents are those of the box about the turned footprint."""
    at = viewer[..., None, :]
    x, y = boxes[..., 0] - at[..., 0], boxes[..., 1] - at[..., 1]
    c, s = np.cos(at[..., 2]), np.sin(at[..., 2])
    yaw = boxes[..., 2] - at[..., 2]
    across, along = np.abs(np.cos(yaw)), np.abs(np.sin(yaw))
    depth, width = boxes[..., 3], boxes[..., 4]
    return np.stack(np.broadcast_arrays(
        x * c + y * s, y * c - x * s, yaw, (depth * across + width * along) / 2, (depth * along + width * across) / 2,
        boxes[..., 5], boxes[..., 6], depth, width,
    ), -1)


def upright(boxes: Array) -> Boxes:
    """Token boxes (n, 7) as the geometry of the floor below the stages has them."""
    n = len(boxes)
    found = Boxes(np.empty((n, 3)), np.empty((n, 3)), np.empty(n))
    stood(boxes, *found)
    return found

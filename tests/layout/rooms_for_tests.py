"""Small rooms that several tests share."""

import numpy as np

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.rooms import MAX_CORNERS, MAX_OPENINGS, Rooms, oriented
from apartgen.stages.things.categories import CATEGORIES


def some_rooms(n: int, seed: int = 0) -> Rooms:
    """Rectangles of 3-5 m with a door in the south wall and a window in the north wall."""
    rng = np.random.default_rng(seed)
    half = rng.uniform(1.5, 2.5, (n, 2)).astype(np.float32)
    polygon = np.full((n, MAX_CORNERS, 2), np.nan, np.float32)
    polygon[:, :4] = half[:, None] * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], np.float32)
    openings = np.full((n, MAX_OPENINGS, 7), np.nan, np.float32)
    for i, (_, y) in enumerate(half):
        openings[i, 0] = [-0.4, -y, 0.5, -y, 0, 1, 0]
        openings[i, 1] = [0.6, y, -0.6, y, 3, 0, 0]
    return oriented(
        Rooms(
            polygon,
            openings,
            rng.integers(len(ROOM_TYPES), size=n),
            np.full(n, 2.6, np.float32),
            np.full(n, 6),
            np.full((n, len(CATEGORIES)), -1),
            np.zeros((n, 2), np.float32),
        )
    )


def one_room(width: float = 4.0, depth: float = 4.0) -> Rooms:
    """A room about the origin with a door in its south wall."""
    rooms = some_rooms(1)
    x, y = width / 2, depth / 2
    rooms.polygon[0, :4] = np.array([[-x, -y], [x, -y], [x, y], [-x, y]], np.float32)
    rooms.openings[0] = np.nan
    rooms.openings[0, 0] = [-0.4, -y, 0.4, -y, 0, -1, 0]
    return rooms


def room(width: float = 4.0, depth: float = 4.0) -> Furniture:
    """The same, as it is to be furnished."""
    return Furniture(space_of(one_room(width, depth), 0))


def box(size: tuple[float, float, float], x: float, y: float, yaw: float = 0.0) -> np.ndarray:
    return np.array([x, y, yaw, *size[:2], 0, size[2]], np.float32)

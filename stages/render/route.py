"""The robot's way from the entrance through every room, and where it looks on it."""

import numpy as np

from apartgen.stages.render.stands import Stand, free_floor
from apartgen.stages.robot.way import through_rooms
from apartgen.stages.scene.soup import Array
from apartgen.stages.scene.world import HomeWorld
from apartgen.stages.space import grid

AHEAD = 0.8
"""How far along its way the robot looks ahead, m."""


def along(world: HomeWorld, frames: int, height: float, back: bool = False) -> list[Stand]:
    """So many stands evenly along the way, or `back` to the entrance; none where the robot gets nowhere."""
    way = _through(world)[::-1] if back else _through(world)
    if len(way) < 2:
        return []
    length = _lengths(way)
    at = np.linspace(0, length[-1], frames)
    place, ahead = _at(way, length, at), _at(way, length, np.minimum(at + AHEAD, length[-1]))
    behind = _at(way, length, np.maximum(at - AHEAD, 0))
    look = np.where((np.linalg.norm(ahead - place, axis=1) > 0.1)[:, None], ahead - place, place - behind)
    room = world.room_at(place)
    return [Stand(int(i), np.array([*p, height]), float(np.arctan2(d[1], d[0]))) for i, p, d in zip(room, place, look)]


def _at(way: Array, length: Array, at: Array) -> Array:
    return np.stack([np.interp(at, length, way[:, k]) for k in (0, 1)], -1)


def length(world: HomeWorld) -> float:
    """How long the way is, m."""
    way = _through(world)
    return float(_lengths(way)[-1]) if len(way) else 0.0


def _through(world: HomeWorld) -> Array:
    space, cells = free_floor(world)
    return through_rooms(space, grid.from_seeds(cells, space.entry & cells))


def _lengths(way: Array) -> Array:
    """How far along the way each of its points is."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))])

"""The robot's way from the entrance through every room, and where it looks on it."""

from collections.abc import Callable
from typing import cast

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.render.stands import Stand, free_floor, spread_places
from apartgen.stages.render.world import World
from apartgen.stages.robot import reach
from apartgen.stages.scene.soup import Array
from apartgen.stages.space import grid

AHEAD = 0.8
"""How far along its way the robot looks ahead, m."""

Cells = NDArray[np.int64]


def along(world: World, frames: int, height: float) -> list[Stand]:
    """So many stands evenly along the way; none where the robot gets nowhere."""
    space, cells = free_floor(world)
    way = _way(space, grid.from_seeds(cells, space.entry & cells))
    if len(way) < 2:
        return []
    steps = np.linalg.norm(np.diff(way, axis=0), axis=1)
    length = np.concatenate([[0.0], np.cumsum(steps)])
    at = np.linspace(0, length[-1], frames)
    place, ahead = _at(way, length, at), _at(way, length, np.minimum(at + AHEAD, length[-1]))
    back = _at(way, length, np.maximum(at - AHEAD, 0))
    look = np.where((np.linalg.norm(ahead - place, axis=1) > 0.1)[:, None], ahead - place, place - back)
    room = world.room_at(place)
    return [Stand(int(i), np.array([*p, height]), float(np.arctan2(d[1], d[0]))) for i, p, d in zip(room, place, look)]


def _at(way: Array, length: Array, at: Array) -> Array:
    return np.stack([np.interp(at, length, way[:, k]) for k in (0, 1)], -1)


def _way(space: reach.Space, cells: NDArray[np.bool_]) -> Array:
    """Points (n, 2) of shortest ways between places of the rooms, the nearest one next each time, from the entrance."""
    stops = [places[0] for i in range(len(space.plan.rooms)) if len(places := spread_places(space, cells, i, 1))]
    starts = np.argwhere(space.entry & cells)
    if not stops or not len(starts):
        return np.zeros((0, 2))
    y, x = starts[len(starts) // 2].tolist()
    here = (y, x)
    left = [_cell(space, stop) for stop in stops]
    way = [np.array([here])]
    while left:
        steps = _steps(cells, here)
        nearest = min(left, key=lambda cell: steps[cell])
        left.remove(nearest)
        if np.isfinite(steps[nearest]):
            way.append(_back(steps, nearest)[::-1])
            here = nearest
    path = np.concatenate(way)
    return _smooth(np.stack([space.grid.x[path[:, 1]], space.grid.y[path[:, 0]]], -1))


def _cell(space: reach.Space, point: Array) -> tuple[int, int]:
    return int(np.argmin(np.abs(space.grid.y - point[1]))), int(np.argmin(np.abs(space.grid.x - point[0])))


def _steps(cells: NDArray[np.bool_], start: tuple[int, int]) -> Array:
    """Length of the shortest way from a cell to every other, in cells; ways keep off walls where there is room."""
    from scipy import ndimage
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    dear = 1 + 3 / (1 + ndimage.distance_transform_edt(cells))
    number = np.where(cells, np.cumsum(cells).reshape(cells.shape) - 1, -1)
    rows, columns, costs = [], [], []
    for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
        a = np.s_[: cells.shape[0] - dy, max(0, -dx) : cells.shape[1] - max(0, dx)]
        b = np.s_[dy:, max(0, dx) : cells.shape[1] + min(0, dx)]
        both = (number[a] >= 0) & (number[b] >= 0)
        rows.append(number[a][both])
        columns.append(number[b][both])
        costs.append(np.hypot(dy, dx) * (dear[a][both] + dear[b][both]) / 2)
    n = int(cells.sum())
    joined = coo_array((np.concatenate(costs), (np.concatenate(rows), np.concatenate(columns))), (n, n)).tocsr()
    found, solve = np.full(cells.shape, np.inf), cast(Callable[..., Array], dijkstra)
    found[cells] = solve(joined, directed=False, indices=int(number[start]))
    return found


def _back(steps: Array, end: tuple[int, int]) -> Cells:
    """Cells from `end` back to where the steps begin, each the neighbour that is nearest to the beginning."""
    padded = np.pad(steps, 1, constant_values=np.inf)
    way, here = [end], end
    while steps[here] > 0:
        around = padded[here[0] : here[0] + 3, here[1] : here[1] + 3]
        dy, dx = divmod(int(np.argmin(around)), 3)
        here = (here[0] + dy - 1, here[1] + dx - 1)
        way.append(here)
    return np.array(way)


def _smooth(way: Array, by: int = 3) -> Array:
    """The way with its corners cut, ends left."""
    padded = np.pad(way, ((by, by), (0, 0)), mode="edge")
    kernel = np.ones(2 * by + 1) / (2 * by + 1)
    found = np.stack([np.convolve(padded[:, k], kernel, "valid") for k in (0, 1)], -1)
    found[0], found[-1] = way[0], way[-1]
    return found

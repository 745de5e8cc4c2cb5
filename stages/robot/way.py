"""The robot's way from the entrance through every room that it gets to."""

from collections.abc import Callable
from typing import cast

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Box
from apartgen.stages.robot.reach import REACH, Space, standing
from apartgen.stages.space.boxes import Array, Mask

Cells = NDArray[np.int64]
SHARES = np.linspace(0, 1, 200)
"""Of a straight line over cells, where it is looked at."""


def spread_places(space: Space, cells: Mask, room: int, most: int) -> Array:
    """Places (n, 2) of a room far from one another, the first near the middle of where one can stand."""
    rows, columns = np.nonzero(cells & (space.rooms == room))
    points = np.stack([space.grid.x[columns], space.grid.y[rows]], -1)
    if not len(points):
        return points
    middle = points.mean(0)
    chosen = [int(np.argmin(np.linalg.norm(points - middle, axis=1)))]
    apart = np.linalg.norm(points - points[chosen[0]], axis=1)
    while len(chosen) < most and apart.max() > 0.35:
        chosen.append(int(np.argmax(apart)))
        apart = np.minimum(apart, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return points[chosen]


def before(space: Space, o: Box, cells: Mask) -> Mask:
    """Those of some cells from which an object is used, from in front of it."""
    found = np.zeros_like(cells)
    window, zone = standing(o, space.grid, REACH, space.radius)
    found[window] = zone & cells[window]
    return found


def shortest(space: Space, cells: Mask, start: Array, end: Array) -> Array:
    """Corners (n, 2) of the shortest way from one place to another; none where there is no way."""
    steps, here = _steps(cells, _cell(space, end), dear=0.0), _cell(space, start)
    way = _pulled(cells, _back(steps, here)) if np.isfinite(steps[here]) else np.zeros((0, 2), np.int64)
    return np.stack([space.grid.x[way[:, 1]], space.grid.y[way[:, 0]]], -1)


def through_rooms(space: Space, cells: Mask) -> Array:
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


def _cell(space: Space, point: Array) -> tuple[int, int]:
    return int(np.argmin(np.abs(space.grid.y - point[1]))), int(np.argmin(np.abs(space.grid.x - point[0])))


def _steps(cells: Mask, start: tuple[int, int], dear: float = 3.0) -> Array:
    """Length of the shortest way from a cell to every other, in cells; ways keep off walls where there is room, the
    more so the dearer it is to be near them.
    """
    from scipy import ndimage
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    worth = 1 + dear / (1 + ndimage.distance_transform_edt(cells))
    number = np.where(cells, np.cumsum(cells).reshape(cells.shape) - 1, -1)
    rows, columns, costs = [], [], []
    for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
        a = np.s_[: cells.shape[0] - dy, max(0, -dx) : cells.shape[1] - max(0, dx)]
        b = np.s_[dy:, max(0, dx) : cells.shape[1] + min(0, dx)]
        both = (number[a] >= 0) & (number[b] >= 0)
        rows.append(number[a][both])
        columns.append(number[b][both])
        costs.append(np.hypot(dy, dx) * (worth[a][both] + worth[b][both]) / 2)
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


def _pulled(cells: Mask, way: Cells) -> Cells:
    """The corners of a way of cells once it is pulled tight: straight ahead to the last cell that is seen, and on."""
    at, found = 0, [0]
    while at < len(way) - 1:
        lines = way[at] + SHARES[:, None, None] * (way[at + 1 :] - way[at])
        rows, columns = np.round(lines).astype(np.int64).transpose(2, 0, 1)
        at += 1 + int(np.flatnonzero(cells[rows, columns].all(0))[-1])
        found.append(at)
    return way[found]


def _smooth(way: Array, by: int = 3) -> Array:
    """The way with its corners cut, ends left."""
    padded = np.pad(way, ((by, by), (0, 0)), mode="edge")
    kernel = np.ones(2 * by + 1) / (2 * by + 1)
    found = np.stack([np.convolve(padded[:, k], kernel, "valid") for k in (0, 1)], -1)
    found[0], found[-1] = way[0], way[-1]
    return found

"""Global planner as in Nav2's defaults: an inflated costmap, Dijkstra over it, a straightened and smoothed path.

Costs are those of Nav2's inflation layer (cost_scaling_factor 3.0, inflation_radius 0.55 m), weighed as NavFn does
(neutral cost 50, factor 0.8). Nothing in the apartment moves, so that planning again on the way would change nothing.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled
from apartgen.stages.embodied.floor import Field, Floor, clearance_at
from apartgen.stages.space.boxes import Array, Mask

INFLATION, SCALING = 0.55, 3.0
NEUTRAL, FACTOR, INSCRIBED = 50.0, 0.8, 252.0
PADDING, PADDED = 0.06, 20.0
"""Closer than this to touching, m, a metre costs up to so much more: ways keep to the middle of narrow gaps."""
SPACING = 0.05
"""Distance between points of a path, m."""
W_DATA, W_SMOOTH = 0.2, 0.3
"""Weights of Nav2's simple smoother."""
AWAY = 0.03
"""Straightening and smoothing take ways no closer than this to touching, m, but where they are closer already."""
_PASSES, _HOLDS = 3, 6
_STEPS = [(0, 1), (1, 0), (1, 1), (1, -1), (1, 2), (2, 1), (1, -2), (2, -1)]
_SHARES = np.linspace(0, 1, 96)  # of a straight line, where it is looked at
_SAGITTA = 0.0005  # m that a straight between two cells comes closer to a corner than either


@dataclass(frozen=True)
class Roadmap:
    """Cheapest and shortest ways from a start to every cell that the robot gets to.

    `weight` is the cost of a metre at each cell; `cost`, `length` and their predecessors are by flat cell index, inf
    and -1 where there is no way.
    """

    floor: Floor
    start: tuple[int, int]
    weight: Array
    cost: Array
    before: NDArray[np.int32]
    length: Array
    before_shortest: NDArray[np.int32]

    @property
    def reached(self) -> Mask:
        """Cells the robot gets to."""
        found: Mask = np.isfinite(self.cost).reshape(self.floor.grid.shape)
        return found

    def path(self, goal: tuple[int, int]) -> Array:
        """Points (n, 2) from the start to the goal, `SPACING` apart, smooth, every one of them free."""
        cells = self._back(self.before, goal)
        straight = _straightened(self.floor, cells, self.weight, self._along(cells), AWAY)
        return _smoothed(self.floor, _resampled(self._points(straight)))

    def shortest(self, goal: tuple[int, int]) -> float:
        """Length of the shortest way for the robot's disc, m."""
        cells = self._back(self.before_shortest, goal)
        free = np.where(self.floor.free, 1.0, np.inf)
        points = self._points(_straightened(self.floor, cells, free, self._along(cells, shortest=True)))
        return float(np.hypot(*np.diff(points, axis=0).T).sum())

    def _back(self, before: NDArray[np.int32], goal: tuple[int, int]) -> NDArray[np.int64]:
        at, columns = goal[0] * self.floor.grid.shape[1] + goal[1], self.floor.grid.shape[1]
        found = [at]
        while (at := int(before[at])) >= 0:
            found.append(at)
        return np.stack(np.divmod(np.array(found[::-1]), columns), -1)

    def _along(self, cells: NDArray[np.int64], shortest: bool = False) -> Array:
        """Cost to every cell of a way, in cells."""
        flat = cells[:, 0] * self.floor.grid.shape[1] + cells[:, 1]
        return np.asarray((self.length if shortest else self.cost)[flat])

    def _points(self, cells: NDArray[np.int64]) -> Array:
        return np.stack([self.floor.grid.x[cells[:, 1]], self.floor.grid.y[cells[:, 0]]], -1)


def roadmap(floor: Floor, start: tuple[int, int]) -> Roadmap:
    """Dijkstra from a free cell (row, column) to all others."""
    weight = costs(floor)
    cost, before = _dijkstra(weight, start)
    length, shortest = _dijkstra(np.where(np.isfinite(weight), 1.0, np.inf), start)
    return Roadmap(floor, start, weight, cost, before, length, shortest)


def costs(floor: Floor) -> Array:
    """Cost of a metre at each cell: 1 far from everything, inf where the robot touches something."""
    away = (floor.clearance - floor.radius).clip(0)
    inflated = INSCRIBED * np.exp(-SCALING * away)
    inflated[floor.clearance > INFLATION] = 0.0
    padding = PADDED * (1 - away / PADDING).clip(0)
    return np.where(floor.free, 1.0 + FACTOR * inflated / NEUTRAL + padding, np.inf)


def _dijkstra(weight: Array, start: tuple[int, int]) -> tuple[Array, NDArray[np.int32]]:
    """Costs in cells and predecessors over steps to sixteen neighbours."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    free = np.isfinite(weight)
    number = np.cumsum(free.ravel()).reshape(free.shape) - 1
    rows, columns, values = [], [], []
    for down, right in _STEPS:
        here, there = _shifted(free.shape, down, right)
        both = free[here] & free[there] & _between(free, down, right)
        length = np.hypot(down, right)
        rows.append(number[here][both])
        columns.append(number[there][both])
        values.append((length * (weight[here] + weight[there]) / 2)[both])
    n = int(free.sum())
    graph = coo_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (n, n)).tocsr()
    found, before = dijkstra(graph, directed=False, indices=number[start], return_predecessors=True)
    cells = np.flatnonzero(free)
    cost, back = np.full(weight.size, np.inf), np.full(weight.size, -1, np.int32)
    cost[cells] = found
    back[cells] = np.where(before >= 0, cells[before.clip(0)], -1)
    return cost, back


def _shifted(shape: tuple[int, ...], down: int, right: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """Windows of all cells that have a neighbour so many cells down and right, and of these neighbours."""
    rows, columns = shape
    left = max(0, -right)
    here = slice(0, rows - down), slice(left, columns - max(0, right))
    return here, (slice(down, rows), slice(left + right, columns - max(0, right) + right))


def _between(free: Mask, down: int, right: int) -> Mask:
    """Whether the two cells that a long step passes are free, for the windows of `_shifted`."""
    here, _ = _shifted(free.shape, down, right)
    found = np.ones(free[here].shape, bool)
    if max(down, abs(right)) < 2:
        return found
    sign = 1 if right > 0 else -1
    for d, r in ((1, sign), (1, 0) if down == 2 else (0, sign)):
        rows, columns = (slice(w.start + k, w.stop + k) for w, k in zip(here, (d, r)))
        found &= free[rows, columns]
    return found


def _straightened(
    floor: Floor, cells: NDArray[np.int64], weight: Array, cost: Array, away: float = 0.0
) -> NDArray[np.int64]:
    """The corners left when a way along cells is replaced by straight lines wherever these cost no more.

    A line stays so far `away` from touching, or as far as the cells that it replaces.
    """
    corners, at = [0], 0
    room = floor.clearance[cells[:, 0], cells[:, 1]]
    while at < len(cells) - 1:
        least = np.minimum(floor.radius + away, np.minimum.accumulate(room[at:]))
        at += _furthest(cells[at:], cost[at:], least - _SAGITTA, weight, floor.field)
        corners.append(at)
    return cells[corners]


@compiled()
def _furthest(cells: NDArray[np.int64], cost: Array, least: Array, weight: Array, field: Field) -> int:
    """The last cell of a way to which a straight line from its first costs no more and has the `least` clearance."""
    for k in range(len(cells) - 1, 1, -1):
        down, right = cells[k] - cells[0]
        total = 0.0
        for share in _SHARES:
            row, column = np.rint(cells[0, 0] + share * down), np.rint(cells[0, 1] + share * right)
            total += weight[int(row), int(column)]
        if total / len(_SHARES) * np.hypot(down, right) <= cost[k] - cost[0] + 1e-6:
            x, y = field.left + (cells[0, 1] + 0.5) * field.size, field.below + (cells[0, 0] + 0.5) * field.size
            away = np.inf
            for share in _SHARES:
                here = clearance_at(field, x + share * right * field.size, y + share * down * field.size)
                away = min(away, here)
            if away >= least[k]:
                return k
    return 1


def _resampled(points: Array) -> Array:
    """Points along the same line, `SPACING` apart."""
    run = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    at = np.linspace(0, run[-1], max(2, int(np.ceil(run[-1] / SPACING)) + 1))
    return np.stack([np.interp(at, run, points[:, k]) for k in (0, 1)], -1)


def _smoothed(floor: Floor, points: Array) -> Array:
    """Where Nav2's simple smoother ends, some passes of it; points hold on to places that it would take too close."""
    from scipy.linalg import solveh_banded

    n = len(points) - 2
    if n < 2:
        return points
    hold = np.full(n, W_DATA)
    for _ in range(_PASSES):
        least = np.minimum(floor.beside(points), floor.radius + AWAY)[1:-1] - _SAGITTA
        for _ in range(_HOLDS):
            right = hold[:, None] * points[1:-1]
            right[0] += W_SMOOTH * points[0]
            right[-1] += W_SMOOTH * points[-1]
            inner = solveh_banded(np.stack([np.full(n, -W_SMOOTH), hold + 2 * W_SMOOTH]), right)
            close = floor.beside(inner) < least
            if not close.any():
                points = np.vstack([points[:1], inner, points[-1:]])
                break
            hold = np.where(close, 10 * hold, hold)
    return points


def cell(floor: Floor, points: Array) -> NDArray[np.int64]:
    """Rows and columns (n, 2) of the cells that hold points (n, 2), held to the raster."""
    found = ((points - floor.grid.origin) / floor.grid.resolution).astype(np.int64)[..., ::-1]
    return np.minimum(np.maximum(found, 0), (floor.grid.shape[0] - 1, floor.grid.shape[1] - 1))

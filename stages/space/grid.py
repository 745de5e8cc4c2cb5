"""Occupancy rasters: where the centre of a round robot can be, which parts of that hang together.

Cells are squares of `resolution` metres addressed [row, column] = [y, x]; a cell stands for its centre.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Literal

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry

from apartgen.stages.space.boxes import Array, Boxes, Mask

RESOLUTION = 0.05
"""Default cell size, m."""
_BY_EDGES = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]])

Count = NDArray[np.int16]
"""Obstacles that keep the robot off each cell."""
Labels = NDArray[np.int32]
Window = tuple[slice, slice]
Corners = Literal["round", "mitre"]


@dataclass(frozen=True)
class Grid:
    """A raster over a part of the plan: lower left corner (x, y), cell size, (rows, columns)."""

    origin: tuple[float, float]
    shape: tuple[int, int]
    resolution: float = RESOLUTION

    @cached_property
    def x(self) -> Array:
        """Centres of the columns, (columns,)."""
        return np.asarray(self.origin[0] + (np.arange(self.shape[1]) + 0.5) * self.resolution, float)

    @cached_property
    def y(self) -> Array:
        """Centres of the rows, (rows,)."""
        return np.asarray(self.origin[1] + (np.arange(self.shape[0]) + 0.5) * self.resolution, float)

    @property
    def cell(self) -> float:
        """Area of a cell, m²."""
        return self.resolution**2

    def centers(self, window: Window = (slice(None), slice(None))) -> Array:
        """Centres of the window's cells, (rows, columns, 2)."""
        x, y = np.meshgrid(self.x[window[1]], self.y[window[0]])
        return np.stack([x, y], -1)

    def around(self, lo: Array, hi: Array) -> Window:
        """The cells whose centres may lie between two corners."""
        first = np.floor((lo - self.origin) / self.resolution).astype(int)
        last = np.ceil((hi - self.origin) / self.resolution).astype(int) + 1
        (left, below), (right, above) = np.maximum(first, 0), np.maximum(last, 0)
        return slice(below, above), slice(left, right)

    def part(self, window: Window) -> "Grid":
        """The grid of a window's cells alone."""
        rows, columns = (w.indices(n) for w, n in zip(window, self.shape))
        x, y = self.origin[0] + columns[0] * self.resolution, self.origin[1] + rows[0] * self.resolution
        return Grid((x, y), (max(rows[1] - rows[0], 0), max(columns[1] - columns[0], 0)), self.resolution)


def over(area: Geometry, resolution: float = RESOLUTION) -> Grid:
    """A grid that covers a geometry, with one free cell about it."""
    x0, y0, x1, y1 = area.bounds
    columns, rows = (int(np.ceil(span / resolution - 1e-9)) + 2 for span in (x1 - x0, y1 - y0))
    return Grid((x0 - resolution, y0 - resolution), (rows, columns), resolution)


def finer(grid: Grid, factor: int, area: Geometry) -> Grid:
    """A grid of smaller cells that covers an area, the centres of the old ones among the new.

    So no way that is found on the coarser one is missed.
    """
    x0, y0, x1, y1 = area.bounds
    size = grid.resolution / factor
    left, below = (float(first) - (np.ceil((first - low) / size) + 1.5) * size
                   for first, low in ((grid.x[0], x0), (grid.y[0], y0)))
    columns, rows = (int(np.ceil(span / size)) + 1 for span in (x1 - left, y1 - below))
    return Grid((left, below), (rows, columns), size)


def raster(area: Geometry | Sequence[Geometry], grid: Grid) -> Mask:
    """Cells whose centre lies within a polygonal geometry, or any of some, (rows, columns); by scan lines."""
    inside = np.zeros(grid.shape, bool)
    parts = shapely.get_parts(area)
    parts = parts[(shapely.get_dimensions(parts) == 2) & ~shapely.is_empty(parts)]
    if not len(parts):
        return inside
    x0, y0, x1, y1 = shapely.total_bounds(parts)
    window = grid.around(np.array([x0, y0]), np.array([x1, y1]))
    rows, columns = (range(*w.indices(n)) for w, n in zip(window, grid.shape))
    y, depth = grid.y[window[0]], np.zeros((len(rows), len(columns) + 1), np.int32)
    start, end, way = _edges(parts)
    (x0, y0), (x1, y1) = start.T[:, :, None], end.T[:, :, None]
    edge, row = np.nonzero((y0 <= y) != (y1 <= y))
    slope = (x1 - x0)[edge, 0] / (y1 - y0)[edge, 0]
    crossing = x0[edge, 0] + (y[row] - y0[edge, 0]) * slope
    column = np.ceil((crossing - grid.origin[0]) / grid.resolution - 0.5).astype(int) - columns.start
    # Left edges of what is counter-clockwise go down and right edges up.
    turns = np.where((y1 > y0)[edge, 0], -way[edge], way[edge])
    np.add.at(depth, (row, column.clip(0, len(columns))), turns)
    inside[window] = np.cumsum(depth[:, :-1], axis=1) > 0
    return inside


def _edges(parts: NDArray[np.object_]) -> tuple[Array, Array, NDArray[np.int32]]:
    """Starts and ends (n, 2) of all edges, and 1 where they go counter-clockwise about their polygon, -1 elsewhere."""
    rings, polygon = shapely.get_rings(parts, return_index=True)
    outer = np.diff(polygon, prepend=-1) != 0
    points, ring = shapely.get_coordinates(rings, return_index=True)
    along = ring[1:] == ring[:-1]
    way = np.where(shapely.is_ccw(rings) == outer, 1, -1).astype(np.int32)
    return points[:-1][along], points[1:][along], way[ring[1:][along]]


def open_to(floor: Geometry, grid: Grid, radius: float, corners: Corners = "round") -> Mask:
    """Where a robot's centre may be on an empty floor: `radius` from its edges, or from each of them (mitre)."""
    return raster(floor.buffer(-radius, join_style=corners), grid)


def near(boxes: Boxes, grid: Grid, radius: float) -> Count:
    """How many of the footprints come closer than `radius` to each cell's centre, (rows, columns)."""
    count = np.zeros(grid.shape, np.int16)
    change(count, boxes, grid, radius, 1)
    return count


def change(count: Count, boxes: Boxes, grid: Grid, radius: float, by: int) -> None:
    """Add (`by` = 1) or take away (-1) some boxes in the result of `near`, in place."""
    for window, hit in shades(boxes, grid, radius):
        if by == 1:
            count[window] += hit
        else:
            count[window] -= hit


def shade(box: Boxes, grid: Grid, radius: float) -> tuple[Window, Count]:
    """A window of the raster, and which of its cells (1) are closer than `radius` to one footprint (n = 1)."""
    return next(shades(box, grid, radius))


def shades(boxes: Boxes, grid: Grid, radius: float) -> Iterator[tuple[Window, Count]]:
    """The `shade` of each box."""
    for (x, y, _), (d, w, _), yaw in zip(boxes.center.tolist(), boxes.size.tolist(), boxes.yaw.tolist()):
        yield _shade(x, y, d, w, yaw, grid, radius)


@lru_cache(maxsize=4096)
def _shade(x: float, y: float, d: float, w: float, yaw: float, grid: Grid, radius: float) -> tuple[Window, Count]:
    """The cells closer than `radius` to one footprint; kept, because repairs ask for the same again and again."""
    c, s = np.cos(yaw), np.sin(yaw)
    reach = np.array([abs(c) * d + abs(s) * w, abs(s) * d + abs(c) * w]) / 2 + radius
    window = grid.around(np.array([x, y]) - reach, np.array([x, y]) + reach)
    across, up = grid.x[window[1]][None, :] - x, grid.y[window[0]][:, None] - y
    ahead = np.maximum(np.abs(across * c + up * s) - d / 2, 0)
    aside = np.maximum(np.abs(up * c - across * s) - w / 2, 0)
    hit: Count = (ahead**2 + aside**2 < (radius - 1e-9) ** 2 if radius > 0 else ahead + aside <= 0).astype(np.int16)
    return window, hit


def connected(free: Mask) -> tuple[Labels, NDArray[np.int64]]:
    """Labels of the parts joined by cell edges (0 = not free), and their cell counts with [0] = 0."""
    from scipy import ndimage

    labels = np.empty(free.shape, np.int32)
    count = ndimage.label(free, _BY_EDGES, output=labels)
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    sizes[0] = 0
    return labels, sizes


def largest(free: Mask) -> Mask:
    """The largest connected part; the first found among equals."""
    labels, sizes = connected(free)
    found: Mask = (labels == int(sizes.argmax())) & (labels > 0)
    return found


def from_seeds(free: Mask, seeds: Mask) -> Mask:
    """All free cells connected to any free cell among the seeds."""
    from scipy import ndimage

    labels = np.empty(free.shape, np.int32)
    count = ndimage.label(free, _BY_EDGES, output=labels)
    reached = np.zeros(count + 1, bool)
    reached[labels[seeds]] = True
    reached[0] = False
    if reached.sum() == 1:
        return np.asarray(labels == reached.argmax())
    found: Mask = reached[labels]
    return found

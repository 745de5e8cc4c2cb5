"""Occupancy rasters: where the centre of a round robot can be, which parts of that hang together.

Cells are squares of `resolution` metres addressed [row, column] = [y, x]; a cell stands for its centre.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry

from stages.boxes import Array, Boxes, Mask

RESOLUTION = 0.05
"""Default cell size, m."""
_BY_EDGES = np.array([[0, 1, 0], [1, 1, 1], [0, 1, 0]])

Count = NDArray[np.int16]
"""Obstacles that keep the robot off each cell."""
Labels = NDArray[np.int32]
Window = tuple[slice, slice]


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


def raster(area: Geometry, grid: Grid) -> Mask:
    """Cells whose centre lies within a polygonal geometry, (rows, columns); by scan lines, even-odd."""
    turns = np.zeros((grid.shape[0], grid.shape[1] + 1), np.int32)
    for ring in _rings(area):
        (x0, y0), (x1, y1) = ring[:-1].T[:, :, None], ring[1:].T[:, :, None]
        edge, row = np.nonzero((y0 <= grid.y) != (y1 <= grid.y))
        slope = (x1 - x0)[edge, 0] / (y1 - y0)[edge, 0]
        crossing = x0[edge, 0] + (grid.y[row] - y0[edge, 0]) * slope
        column = np.ceil((crossing - grid.origin[0]) / grid.resolution - 0.5).astype(int)
        np.add.at(turns, (row, column.clip(0, grid.shape[1])), 1)
    inside: Mask = np.cumsum(turns[:, :-1], axis=1) % 2 == 1
    return inside


def _rings(area: Geometry) -> list[Array]:
    polygons = shapely.get_parts(area)
    polygons = polygons[shapely.get_dimensions(polygons) == 2]
    rings = shapely.get_rings(polygons)
    return [shapely.get_coordinates(ring) for ring in rings]


def near(boxes: Boxes, grid: Grid, radius: float) -> Count:
    """How many of the footprints come closer than `radius` to each cell's centre, (rows, columns)."""
    count = np.zeros(grid.shape, np.int16)
    for i in range(boxes.n):
        change(count, boxes.take([i]), grid, radius, 1)
    return count


def change(count: Count, box: Boxes, grid: Grid, radius: float, by: int) -> None:
    """Add (`by` = 1) or take away (-1) one box (n = 1) in the result of `near`, in place."""
    window, hit = shade(box, grid, radius)
    count[window] += hit if by == 1 else np.int16(by) * hit


def shade(box: Boxes, grid: Grid, radius: float) -> tuple[Window, Count]:
    """A window of the raster, and which of its cells (1) are closer than `radius` to one footprint (n = 1)."""
    x, y = (float(v) for v in box.center[0, :2])
    d, w = (float(v) for v in box.size[0, :2])
    return _shade(x, y, d, w, float(box.yaw[0]), grid, radius)


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

    labels, count = ndimage.label(free)
    reached = np.zeros(count + 1, bool)
    reached[labels[seeds]] = True
    reached[0] = False
    found: Mask = reached[labels]
    return found

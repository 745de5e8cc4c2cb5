"""Rasters against shapely and hand-made free spaces."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from apartgen.stages.space import boxes, grid
from apartgen.stages.space.boxes import Boxes


def some_boxes(seed: int, n: int = 5) -> Boxes:
    rng = np.random.default_rng(seed)
    return Boxes(rng.uniform(0, 4, (n, 3)), rng.uniform(0.2, 2, (n, 3)), rng.uniform(-4, 4, n))


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10**6))
def test_raster_holds_the_cells_shapely_puts_inside(seed: int) -> None:
    shapes = boxes.footprints(some_boxes(seed))
    area = unary_union([shapes[0], shapes[1], shapes[2]]).difference(shapes[3])
    # The area reaches beyond the second grid, and may lie outside the third.
    for around in (box(-1, -1, 5, 5), box(1, 1.5, 3, 2), box(3, 3, 7, 7)):
        g = grid.over(around, 0.07)
        points = g.centers()
        exact = shapely.contains_xy(area, points[..., 0], points[..., 1])
        assert (grid.raster(area, g) == exact).all()


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 10**6), st.floats(0, 0.5))
def test_near_counts_boxes_within_the_radius(seed: int, radius: float) -> None:
    some = some_boxes(seed)
    g = grid.over(box(-2, -2, 6, 6), 0.11)
    points = shapely.points(g.centers())
    apart = shapely.distance(points[..., None], boxes.footprints(some))
    count = grid.near(some, g, radius)
    certain = np.abs(apart - radius).min(-1) > 1e-6
    assert (count == (apart < radius).sum(-1))[certain].all()
    grid.change(count, some.take([2]), g, radius, -1)
    assert (count == grid.near(some.take([0, 1, 3, 4]), g, radius)).all()


def test_raster_area_is_exact_on_the_grid() -> None:
    g = grid.over(box(0, 0, 4, 3), 0.05)
    hollow = Polygon(box(0, 0, 4, 3).exterior, [box(1, 1, 2, 2).exterior.coords])
    assert grid.raster(hollow, g).sum() * g.cell == pytest.approx(11)
    assert grid.raster(Polygon(), g).sum() == 0


def test_the_second_part_may_be_the_largest() -> None:
    free = np.zeros((5, 12), bool)
    free[1:4, 1:3] = True
    free[1:4, 5:11] = True
    sizes = grid.connected(free)[1]
    assert sizes.tolist() == [0, 6, 18]
    assert grid.largest(free).sum() == 18 and grid.largest(free)[2, 7]
    seeds = np.zeros_like(free)
    seeds[0, 0] = seeds[2, 2] = True
    assert grid.from_seeds(free, seeds).sum() == 6
    assert not grid.from_seeds(free, ~free).any()
    assert not grid.largest(np.zeros((3, 3), bool)).any()


def test_without_a_radius_the_shade_is_the_cells_whose_middles_lie_in_the_footprint() -> None:
    """Cells of half a metre: of a box of 1.1 by .6 m about the middle of a cell, three by one; turned, one by three."""
    cells = grid.Grid((0.0, 0.0), (8, 8), 0.5)
    for yaw, shape in ((0.0, (1, 3)), (np.pi / 2, (3, 1))):
        box = Boxes(np.array([[1.75, 1.75, 0.0]]), np.array([[1.1, 0.6, 1.0]]), np.array([yaw]))
        found = np.argwhere(grid.near(box, cells, 0.0) > 0)
        assert tuple(np.ptp(found, axis=0) + 1) == shape and len(found) == 3
        assert found.mean(0).tolist() == [3.0, 3.0]

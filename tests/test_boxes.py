"""Oriented boxes against shapely and against cases worked by hand."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes


def drawn(seed: int, n: int, *lead: int, snap: bool = False) -> Boxes:
    """Boxes in a 3 m room; snapped ones share centres, sizes and right angles, so that edges coincide."""
    rng = np.random.default_rng(seed)
    center, size = rng.uniform(0, 3, (*lead, n, 3)), rng.uniform(0.2, 2, (*lead, n, 3))
    yaw = rng.uniform(-4, 4, (*lead, n))
    if snap:
        center, size, yaw = np.round(center * 2) / 2, np.round(size) + 0.5, np.round(yaw) * np.pi / 2
    return Boxes(center, size, yaw)


def unit(x: float = 0.0, y: float = 0.0, yaw: float = 0.0, size: tuple[float, float, float] = (1, 1, 1)) -> Boxes:
    return Boxes(np.array([[x, y, size[2] / 2]]), np.array([size], float), np.array([yaw]))


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6), st.booleans())
def test_overlap_agrees_with_shapely(seed: int, snap: bool) -> None:
    a, b = drawn(seed, 6, snap=snap), drawn(seed + 1, 5, snap=snap)
    exact = shapely.area(shapely.intersection(boxes.footprints(a)[:, None], boxes.footprints(b)[None]))
    assert boxes.overlap_area(a, b) == pytest.approx(exact, abs=1e-7)


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6), st.booleans())
def test_gap_agrees_with_shapely(seed: int, snap: bool) -> None:
    a, b = drawn(seed, 6, snap=snap), drawn(seed + 1, 5, snap=snap)
    exact = shapely.distance(boxes.footprints(a)[:, None], boxes.footprints(b)[None])
    assert boxes.gap(a, b) == pytest.approx(exact, abs=1e-9)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10**6))
def test_distance_agrees_with_shapely(seed: int) -> None:
    some, points = drawn(seed, 4), np.random.default_rng(seed).uniform(-1, 4, (7, 2))
    shapes = boxes.footprints(some)
    inside = shapely.contains_xy(shapes[None], points[:, :1], points[:, 1:])
    exact = shapely.distance(shapely.points(points)[:, None], shapely.boundary(shapes)[None])
    assert boxes.distance(points, some) == pytest.approx(np.where(inside, -exact, exact), abs=1e-9)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10**6))
def test_moving_by_the_penetration_parts_two_boxes(seed: int) -> None:
    a, b = drawn(seed, 1), drawn(seed + 1, 1)
    depth = float(boxes.penetration(a, b)[0, 0])
    shared = boxes.iou(a, b)[0, 0]
    assert (depth > 0) == (shared > 0) or abs(depth) < 1e-6
    moves = [*boxes.axes(a)[0], *boxes.axes(b)[0]]
    shifts = [np.array([*(s * m), 0.0]) for m in moves for s in (1, -1)] + [np.array([0, 0, s]) for s in (1.0, -1.0)]
    if depth > 0:
        parted = [boxes.penetration(a, b._replace(center=b.center + (depth + 1e-9) * s))[0, 0] for s in shifts]
        assert min(parted) <= 1e-9
        assert all(
            boxes.penetration(a, b._replace(center=b.center + 0.99 * depth * s))[0, 0] > 0 for s in shifts
        )


def test_contact_by_hand() -> None:
    assert boxes.penetration(unit(), unit(x=0.98))[0, 0] == pytest.approx(0.02)
    assert boxes.penetration(unit(), unit(x=1.3))[0, 0] == pytest.approx(-0.3)
    assert boxes.penetration(unit(), unit(x=1.2, yaw=np.pi / 4))[0, 0] == pytest.approx(0.5 + np.sqrt(0.5) - 1.2)
    above = unit()._replace(center=np.array([[0, 0, 1.49]]))
    assert boxes.penetration(unit(), above)[0, 0] == pytest.approx(0.01)


def test_iou_by_hand() -> None:
    assert boxes.iou(unit(), unit(x=0.5))[0, 0] == pytest.approx(1 / 3)
    assert boxes.iou(unit(), unit())[0, 0] == pytest.approx(1.0, abs=1e-8)
    turned = boxes.iou(unit(), unit(yaw=np.pi / 4))[0, 0]
    octagon = 2 * (np.sqrt(2) - 1)
    assert turned == pytest.approx(octagon / (2 - octagon))
    assert boxes.iou(unit())[0, 0] == 0.0


def test_batches_equal_one_by_one() -> None:
    many = drawn(3, 5, 4)
    for pairwise in (boxes.penetration, boxes.iou, boxes.gap):
        whole = pairwise(many)
        assert whole.shape == (4, 5, 5)
        for i in range(4):
            assert whole[i] == pytest.approx(pairwise(Boxes(*(x[i] for x in many))))


def test_spread_moves_faces_along_the_boxes_own_axes() -> None:
    grown = boxes.spread(unit(yaw=np.pi / 2), [[-0.5, -0.5, -0.5]], [[1.5, 0.5, 0.5]])
    assert grown.center[0] == pytest.approx([0, 0.5, 0.5])
    assert grown.size[0] == pytest.approx([2, 1, 1])


def test_no_boxes_at_all() -> None:
    none = boxes.of([])
    assert boxes.iou(none, unit()).shape == (0, 1)
    assert boxes.penetration(none).shape == (0, 0)
    assert boxes.gap(none).shape == (0, 0)


@pytest.mark.parametrize("candidates", [1, 7, 1_000_000])
@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 10_000), n=st.integers(0, 30), snap=st.booleans())
def test_the_sweep_finds_just_the_pairs_that_stand_in_one_another(candidates: int, seed: int, n: int, snap: bool
                                                                  ) -> None:
    a = drawn(seed, n, snap=snap)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(boxes, "_CANDIDATES", candidates)
        found = [(frozenset((int(i), int(j))), d) for rows in boxes.meeting(a) for i, j, d in zip(*rows)]
    every = boxes.penetration(a)
    assert len(dict(found)) == len(found) == (every > 0).sum() / 2
    assert all(every[tuple(pair)] == depth for pair, depth in found)

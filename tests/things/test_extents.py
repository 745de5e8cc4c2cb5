"""Volumes and bounds of shapes as trimesh and numpy work them out."""

import numpy as np
import pytest
import trimesh

from apartgen.stages.things import extents


@pytest.mark.parametrize("seed", range(5))
def test_a_closed_surface_has_the_volume_that_trimesh_gives_it(seed):
    rng = np.random.default_rng(seed)
    shape = trimesh.convex.convex_hull(rng.normal(size=(40, 3)) + rng.uniform(-5, 5, 3))
    vertices, faces = np.array(shape.vertices, float), np.array(shape.faces, np.int64)
    assert extents.volume(vertices, faces) == pytest.approx(shape.volume, rel=1e-9)
    assert extents.volume(vertices, faces[:, ::-1]) == pytest.approx(-shape.volume, rel=1e-9)


@pytest.mark.parametrize("count", [1, 2, 50])
def test_points_are_seen_from_the_middle_of_their_bounds(count):
    points = np.random.default_rng(count).normal(size=(count, 3))
    middle, sides, local = extents.centred(points)
    assert (sides == points.max(0) - points.min(0)).all() and (middle == (points.max(0) + points.min(0)) / 2).all()
    assert (local == points - middle).all()

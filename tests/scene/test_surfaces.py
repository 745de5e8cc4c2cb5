"""Where rays cross triangles that they are known to meet."""

import numpy as np
import pytest

from apartgen.stages.scene.surfaces import crossed


def test_rays_cross_the_planes_of_their_triangles_where_they_do_by_hand() -> None:
    """From 2 m above a triangle in the floor: at its corner, at its middle, and what meets nothing."""
    corners = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 5], [3, 0, 5], [0, 3, 5]]], np.float32)
    ways = np.array([[0, 0, -1], [1, 1, 1], [0.25, 0.5, -2], [1 / 3, 1 / 3, -2], [1, 1, 3]], np.float32)
    known = np.array([True, False, True, True, True])
    distance, weights = crossed(np.array([0, 0, 2], np.float32), ways, np.array([0, 0, 0, 0, 1]), known, corners)
    assert distance[known] == pytest.approx([2, 1, 1, 1])
    third = [1 / 3] * 3
    assert weights[known] == pytest.approx(np.array([[1, 0, 0], [0.25, 0.25, 0.5], third, third]), abs=1e-6)

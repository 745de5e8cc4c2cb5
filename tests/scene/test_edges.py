"""Pixels at edges, by another library's morphology, and ends of rays, by hand."""

import numpy as np
import pytest
from scipy import ndimage

from apartgen.stages.scene import kernels, lens


@pytest.mark.parametrize("by", [1, 2, 3])
def test_what_is_widened_reaches_so_far_along_rows_and_columns(by):
    rng = np.random.default_rng(by)
    for _ in range(40):
        found = rng.random((7, 9)) < 0.06
        line = np.ones((1, 2 * by + 1), bool)
        expected = ndimage.binary_dilation(found, line) | ndimage.binary_dilation(found, line.T)
        np.testing.assert_array_equal(kernels.widened(found, by), expected)


def test_rays_end_where_they_meet_a_surface_whose_normal_looks_back():
    """Two metres along a ray, 100 m where it meets nothing; a normal that looks along the ray is turned round."""
    way = np.array([[0.6, 0.0, 0.8], [0.0, 0.0, -1.0]], np.float32)
    normal = np.array([[0.0, 0.6, 0.8], [0.0, 0.0, 0.0]], np.float32)
    found = lens.ended(np.array([[1.0, 2.0, 3.0]], np.float32), way, np.array([2.0, np.inf], np.float32), normal)
    assert found == pytest.approx(np.array([[2.2, 2.0, 4.6], [1.0, 2.0, -97.0]]), abs=1e-5)
    assert normal == pytest.approx(np.array([[0.0, -0.6, -0.8], [0.0, 0.0, 1.0]]))

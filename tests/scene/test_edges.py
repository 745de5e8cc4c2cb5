"""Pixels at edges, by another library's morphology."""

import numpy as np
import pytest
from scipy import ndimage

from apartgen.stages.scene import kernels


@pytest.mark.parametrize("by", [1, 2, 3])
def test_what_is_widened_reaches_so_far_along_rows_and_columns(by):
    rng = np.random.default_rng(by)
    for _ in range(40):
        found = rng.random((7, 9)) < 0.06
        line = np.ones((1, 2 * by + 1), bool)
        expected = ndimage.binary_dilation(found, line) | ndimage.binary_dilation(found, line.T)
        np.testing.assert_array_equal(kernels.widened(found, by), expected)

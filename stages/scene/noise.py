"""Numbers for rays that are spread evenly over pixels and over the rays of one, always the same."""

import numpy as np

from apartgen.stages.scene.soup import Array, Index

GOLDEN = np.array([0.7548776662466927, 0.5698402909980532])
"""Of the R2 low-discrepancy sequence."""


def noise_of(pixels: Index, columns: int) -> Array:
    """Two numbers in [0, 1) for each pixel, spread evenly over neighbours, always the same."""
    column, row = pixels % columns, pixels // columns
    here = 52.9829189 * ((0.06711056 * column + 0.00583715 * row) % 1)
    there = 52.9829189 * ((0.00583715 * column + 0.06711056 * (row + 71)) % 1)
    return (np.stack([here, there], -1) % 1).astype(np.float32)

"""Directions and shifts for rays that are spread evenly over pixels and over the rays of one, always the same."""

import numpy as np

from apartgen.stages.scene.soup import Array, Index, length

GOLDEN = np.array([0.7548776662466927, 0.5698402909980532])
"""Of the R2 low-discrepancy sequence."""


def about(normal: Array, noise: Array) -> Array:
    """A direction about each normal, as likely as its cosine."""
    height, turn = 1 - 2 * noise[:, 0], 2 * np.pi * noise[:, 1]
    ring = np.sqrt(1 - height**2)
    way = normal + np.stack([ring * np.cos(turn), ring * np.sin(turn), height], -1)
    return np.asarray(way / length(way))


def noise_of(pixels: Index, columns: int) -> Array:
    """Two numbers in [0, 1) for each pixel, spread evenly over neighbours, always the same."""
    column, row = pixels % columns, pixels // columns
    here = 52.9829189 * ((0.06711056 * column + 0.00583715 * row) % 1)
    there = 52.9829189 * ((0.00583715 * column + 0.06711056 * (row + 71)) % 1)
    return (np.stack([here, there], -1) % 1).astype(np.float32)


def shifted(noise: Array, n: int) -> Array:
    """The n-th of a sequence that fills the unit square evenly from each starting point."""
    moved: Array = noise + ((n + 1) * GOLDEN % 1).astype(np.float32)
    return np.where(moved >= 1, moved - 1, moved)

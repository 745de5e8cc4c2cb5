"""Numbers by which the network sees a token in a frame."""

import numpy as np

from apartgen.stages.layout.relations.tokens import Array

WAVES = (0.4, 0.9, 2.0, 4.5, 10.0)
"""Wavelengths by which places are told, m."""
PLACES = 6
WIDTH = PLACES * (2 * len(WAVES) + 1) + 8
SWING = 2


def numbers(seen: Array) -> Array:
    """Features (..., T, WIDTH) of boxes as `tokens.seen` has them, (..., T, 9)."""
    x, y, yaw, ex, ey, low, high, depth, width = np.moveaxis(seen, -1, 0)
    places = np.stack([x, x - ex, x + ex, y, y - ey, y + ey], -1)
    phase = (places[..., None] * np.asarray([2 * np.pi / w for w in WAVES], np.float32)).reshape(*places.shape[:-1], -1)
    rest = np.stack([np.cos(yaw), np.sin(yaw), np.cos(2 * yaw), np.sin(2 * yaw), low, high, depth, width], -1)
    return np.concatenate([places / 3, np.sin(phase), np.cos(phase), rest], -1).astype(np.float32)

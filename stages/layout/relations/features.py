"""Numbers by which the network sees a token in a frame."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations.tokens import Array

WAVES = (0.4, 0.9, 2.0, 4.5, 10.0)
"""Wavelengths by which places are told, m."""
TURNS = np.asarray([2 * np.pi / w for w in WAVES], np.float32)
PLACES = 6
WIDTH = PLACES * (2 * len(WAVES) + 1) + 8
SWING = 2
ROOM_FACTS = 3
"""log of floor area, ceiling height, sleepers in the home (0 unknown)."""
METRES = 3.0
"""What standing in something counts at first, so that little has to be learned."""
SHUT_OUT = -1e9
"""The logit of what cannot be."""


def numbers(seen: Array) -> Array:
    """Features (..., T, WIDTH) of boxes as `tokens.seen` has them, (..., T, 9)."""
    x, y, yaw, ex, ey, low, high, depth, width = np.moveaxis(seen, -1, 0)
    places = np.stack([x, x - ex, x + ex, y, y - ey, y + ey], -1)
    phase = (places[..., None] * TURNS).reshape(*places.shape[:-1], PLACES * len(WAVES))
    rest = np.stack([np.cos(yaw), np.sin(yaw), np.cos(2 * yaw), np.sin(2 * yaw), low, high, depth, width], -1)
    return np.concatenate([places / 3, np.sin(phase), np.cos(phase), rest], -1).astype(np.float32)


def room_facts(area: float, height: float, sleepers: int) -> NDArray[np.float32]:
    """What the room's token tells beside its box, (3,)."""
    return np.array([np.log(max(area, 0.5)), height - 2.5, max(sleepers, 0) / 3], np.float32)

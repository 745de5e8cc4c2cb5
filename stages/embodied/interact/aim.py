"""Which way the hand points while it acts on a part, and its axes."""

from itertools import product
from typing import NamedTuple

import numpy as np

from apartgen.stages.embodied.interact.parts import Hold, Part
from apartgen.stages.space.boxes import Array, Mask

YAWS = np.radians([0, 35, -35, 70, -70])
PITCHES = np.radians([0, 40, 75, -40])
_LIMIT = {"pinch": 0.7, "cup": 0.5, "push": 0.6}
"""Least cosine between hand and what it acts on: of the fingers' line to the pinch, of the hand to the face."""


class Option(NamedTuple):
    """A direction of the hand: straight at the object but for a turn to the left and one down, rad.

    `follows` says whether the hand turns with the part or keeps its direction.
    """

    yaw: float
    pitch: float
    follows: bool

    @property
    def cost(self) -> float:
        """What it costs beside one for every change."""
        return 0.3 * (abs(self.yaw) + abs(self.pitch)) + 0.1 * self.follows


OPTIONS = [Option(*angles, False) for angles in product(YAWS.tolist(), PITCHES.tolist())]
OPTIONS += [Option(yaw, pitch, True) for yaw, pitch in product(YAWS[:3].tolist(), PITCHES[:2].tolist())]
_YAW, _PITCH, _FOLLOWS = (np.array(column) for column in zip(*OPTIONS, strict=True))
ALIKE = float(np.cos(np.radians(46)))
"""Directions no further apart follow one another."""


def directions(part: Part, hold: Hold, turns: Array) -> Array:
    """Which way the hand points (unit) with every one of `OPTIONS`, the part turned so (m, 3, 3); (m, n, 3)."""
    left = cross(part.up, part.front)
    level = -np.cos(_YAW)[:, None] * part.front - np.sin(_YAW)[:, None] * left
    if hold.kind == "push":
        level = -level
    found = np.cos(_PITCH)[:, None] * level - np.sin(_PITCH)[:, None] * part.up
    return np.asarray(np.where(_FOLLOWS[:, None], found @ turns.transpose(0, 2, 1), found))


def grasps(part: Part, hold: Hold, turns: Array, ahead: Array) -> tuple[Array, Mask]:
    """The hand's axes (n, 3, 3) when it points `ahead` (n, 3), the part turned so (n, 3, 3).

    Also where they are any good: where the hand would grip, or not push out of the face.
    """
    if hold.kind == "pinch":
        able = np.ones(len(ahead), bool)
        across = turns @ hold.across
    else:
        facing = (ahead * (turns @ hold.out)).sum(1) * (1 if hold.kind == "push" else -1)
        able = facing >= _LIMIT[hold.kind]
        across = np.broadcast_to(cross(part.up, part.front), ahead.shape)
    across = across - (ahead * across).sum(1)[:, None] * ahead
    length = np.sqrt((across * across).sum(1))
    able &= length >= (_LIMIT["pinch"] if hold.kind == "pinch" else 0.1)
    across = across / np.maximum(length, 1e-9)[:, None]
    a, b = ahead.T, across.T
    up = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    return np.stack([ahead, across, np.stack(up, 1)], 2), able


def cross(a: Array, b: Array) -> Array:
    """Of two vectors; numpy's is slow for one pair."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])

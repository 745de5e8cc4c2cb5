"""Which way the hand points while it acts on a part, and its axes."""

from itertools import product
from typing import NamedTuple

import numpy as np

from stages.boxes import Array
from stages.embodied.interact.parts import Hold, Part

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
NEAR = float(np.cos(np.radians(46)))
"""Directions no further apart follow one another."""


def forward(part: Part, hold: Hold, value: float, option: Option) -> Array:
    """Which way the hand points (unit), the part at a position."""
    left = cross(part.up, part.front)
    level = -np.cos(option.yaw) * part.front - np.sin(option.yaw) * left
    if hold.kind == "push":
        level = -level
    found = np.cos(option.pitch) * level - np.sin(option.pitch) * part.up
    return np.asarray(part.moved(value)[0] @ found if option.follows else found)


def turned(part: Part, hold: Hold, value: float, ahead: Array) -> Array | None:
    """The hand's axes (3, 3) when it points `ahead`; None where it would not grip, or push out of the face."""
    turn, _ = part.moved(value)
    facing = float(ahead @ (turn @ hold.out)) * (1 if hold.kind == "push" else -1)
    if hold.kind != "pinch" and facing < _LIMIT[hold.kind]:
        return None
    across = turn @ hold.across if hold.kind == "pinch" else cross(part.up, part.front)
    across = across - (across @ ahead) * ahead
    length = float(np.linalg.norm(across))
    if length < (_LIMIT["pinch"] if hold.kind == "pinch" else 0.1):
        return None
    across = across / length
    return np.stack([ahead, across, cross(ahead, across)], 1)


def cross(a: Array, b: Array) -> Array:
    """Of two vectors; numpy's is slow for one pair."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])

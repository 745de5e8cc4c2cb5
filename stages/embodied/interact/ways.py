"""Free motion of the arm: out of the way, back from a hold, round a part."""

from collections.abc import Iterator

import numpy as np

from apartgen.stages.embodied.interact.aim import cross
from apartgen.stages.embodied.interact.robot import ARM, HAND, posture, tucked
from apartgen.stages.space.boxes import Array


def withdrawn(at: Array, by: float) -> Array | None:
    """The posture with the hand that much further back along its own direction."""
    bearing = at[2] + at[4]
    pitch, yaw = at[9], bearing + at[8]
    forward = np.array([np.cos(yaw) * np.cos(pitch), np.sin(yaw) * np.cos(pitch), -np.sin(pitch)])
    out = ARM[0] + at[5:8].sum()
    wrist = np.array([at[0] + out * np.cos(bearing), at[1] + out * np.sin(bearing), at[3]])
    roll = at[10]
    flat = np.array([-np.sin(yaw), np.cos(yaw), 0])
    up = cross(forward, flat)
    across = np.cos(roll) * flat + np.sin(roll) * up
    turn = np.stack([forward, across, cross(forward, across)], 1)
    return posture(at[:3], wrist + (HAND - by) * forward, turn, at[11], at)


def unfolding(base: Array, before: Array) -> Iterator[list[Array]]:
    """Ways from arm in to a posture: hand down first then out, both at once, out first then down."""
    start = tucked(base, before[3], before[4])
    folded = before.copy()
    folded[5:8] = 0.0
    upright = before.copy()
    upright[8:11] = start[8:11]
    start[11:] = folded[11:] = upright[11:] = before[11:]
    yield [start, folded]
    yield [start]
    yield [start, upright]


def turning(start: Array, end: Array) -> Iterator[list[Array]]:
    """Ways from one posture with the arm in to another: straight, or up or down on the side away from the part."""
    yield [start]
    for turn in (np.pi, -np.pi):
        low, high = start.copy(), end.copy()
        low[4] = high[4] = start[4] + turn
        yield [start, low, high]

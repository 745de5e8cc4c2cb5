"""Rigid transforms as 4 × 4 matrices."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.retrieve.reading.pieces import Array
from apartgen.stages.space.turns import rotation


def at(position: Sequence[float], turn: Array | None = None) -> Array:
    """A frame at a position, turned by a 3 × 3 rotation."""
    matrix = np.eye(4)
    matrix[:3, 3] = position
    if turn is not None:
        matrix[:3, :3] = turn
    return matrix


def rpy(angles: Sequence[float]) -> Array:
    """Roll, pitch, yaw about fixed x, y, z, as URDF and SDF have them."""
    roll, pitch, yaw = angles
    return rotation((0, 0, 1), yaw) @ rotation((0, 1, 0), pitch) @ rotation((1, 0, 0), roll)


def quaternion(wxyz: Sequence[float]) -> Array:
    """Rotation of a quaternion, scalar first, of any length."""
    w, x, y, z = np.asarray(wxyz, float) / max(float(np.linalg.norm(wxyz)), 1e-12)
    axis, sine = np.array([x, y, z]), float(np.linalg.norm([x, y, z]))
    return rotation(axis, 2 * np.arctan2(sine, w)) if sine > 1e-12 else np.eye(3)


def z_along(direction: Sequence[float] | Array) -> Array:
    """The least rotation taking z onto a direction."""
    d = np.asarray(direction, float) / max(float(np.linalg.norm(direction)), 1e-12)
    axis = np.cross((0, 0, 1), d)
    if np.linalg.norm(axis) < 1e-9:
        return np.eye(3) if d[2] > 0 else rotation((1, 0, 0), np.pi)
    return rotation(axis, float(np.arccos(np.clip(d[2], -1, 1))))

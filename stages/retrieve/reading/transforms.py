"""Rigid transforms as 4 × 4 matrices."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.retrieve.reading.pieces import Array


def at(position: Sequence[float], rotation: Array | None = None) -> Array:
    """A frame at a position, turned by a 3 × 3 rotation."""
    matrix = np.eye(4)
    matrix[:3, 3] = position
    if rotation is not None:
        matrix[:3, :3] = rotation
    return matrix


def about(axis: Sequence[float] | Array, angle: float) -> Array:
    """Rotation about an axis by the right hand (Rodrigues), 3 × 3."""
    x, y, z = np.asarray(axis, float) / max(float(np.linalg.norm(axis)), 1e-12)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k)


def rpy(angles: Sequence[float]) -> Array:
    """Roll, pitch, yaw about fixed x, y, z, as URDF and SDF have them."""
    roll, pitch, yaw = angles
    return about((0, 0, 1), yaw) @ about((0, 1, 0), pitch) @ about((1, 0, 0), roll)


def quaternion(wxyz: Sequence[float]) -> Array:
    """Rotation of a quaternion, scalar first, of any length."""
    w, x, y, z = np.asarray(wxyz, float) / max(float(np.linalg.norm(wxyz)), 1e-12)
    axis, sine = np.array([x, y, z]), float(np.linalg.norm([x, y, z]))
    return about(axis, 2 * np.arctan2(sine, w)) if sine > 1e-12 else np.eye(3)


def z_along(direction: Sequence[float] | Array) -> Array:
    """The least rotation taking z onto a direction."""
    d = np.asarray(direction, float) / max(float(np.linalg.norm(direction)), 1e-12)
    axis = np.cross((0, 0, 1), d)
    if np.linalg.norm(axis) < 1e-9:
        return np.eye(3) if d[2] > 0 else about((1, 0, 0), np.pi)
    return about(axis, float(np.arccos(np.clip(d[2], -1, 1))))

"""Rotations as formats write them."""

import numpy as np

from apartgen.stages.things.asset import UNTURNED, Array


def quaternion(rotation: Array) -> Array:
    """w, x, y, z of a rotation matrix, w not negative."""
    if rotation is UNTURNED or np.array_equal(rotation, UNTURNED):
        return np.array([1.0, 0.0, 0.0, 0.0])
    from scipy.spatial.transform import Rotation

    x, y, z, w = Rotation.from_matrix(rotation).as_quat(canonical=True)
    return np.array([w, x, y, z])


def about_z(yaw: float) -> Array:
    """w, x, y, z of a turn about z."""
    return np.array([np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)])


def y_up(point: Array) -> list[float]:
    """A point in a frame whose y is up and whose -z is this one's y, as Habitat's and glTF's are."""
    x, y, z = (float(v) for v in point)
    return [x, z, -y]


def from_x(axis: Array) -> Array:
    """w, x, y, z of the shortest turn of +x to an axis of any length."""
    axis = axis / np.linalg.norm(axis)
    if axis[0] < -1 + 1e-9:
        return np.array([0.0, 0.0, 0.0, 1.0])
    turn = np.array([1 + axis[0], 0.0, -axis[2], axis[1]])
    return np.asarray(turn / np.linalg.norm(turn))


def roll_pitch_yaw(rotation: Array) -> Array:
    """Angles about the fixed x, y, z axes, in that order."""
    from scipy.spatial.transform import Rotation

    return np.asarray(Rotation.from_matrix(rotation).as_euler("xyz"))

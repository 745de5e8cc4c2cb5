"""Boxes, cylinders, capsules and spheres as closed meshes and as colliders, about their own origin, axis z."""

import numpy as np

from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.pieces import Array, Piece
from apartgen.stages.things.asset import Collider, Material

SIDES = 24
RINGS = 6


def box(size: Array, material: Material) -> Piece:
    """Full extents `size`."""
    low = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]], float)
    vertices = np.concatenate([low, low * (1, 1, -1)]) * np.asarray(size, float) / 2
    faces = [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]]
    for i in range(4):
        j = (i + 1) % 4
        faces += [[i, j, j + 4], [i, j + 4, i + 4]]
    return Piece(vertices, np.array(faces), material)


def turned(profile: Array, material: Material) -> Piece:
    """The surface swept by a profile of (radius, z) from the lower pole to the upper, closed at both."""
    angles = np.arange(SIDES) * 2 * np.pi / SIDES
    rim = np.stack([np.cos(angles), np.sin(angles)], 1)
    rings = [np.c_[r * rim, np.full(SIDES, z)] for r, z in profile]
    vertices = np.concatenate([[[0, 0, profile[0][1]]], *rings, [[0, 0, profile[-1][1]]]])
    faces, last = [], len(vertices) - 1
    for i in range(SIDES):
        j = (i + 1) % SIDES
        faces += [[0, 1 + j, 1 + i], [last, last - SIDES + i, last - SIDES + j]]
        for ring in range(len(rings) - 1):
            a, b = 1 + ring * SIDES, 1 + (ring + 1) * SIDES
            faces += [[a + i, a + j, b + j], [a + i, b + j, b + i]]
    return Piece(vertices, np.array(faces), material)


def profile(kind: str, radius: float, half: float) -> Array:
    """Profile of a cylinder, capsule or sphere; `half` is the straight part's half length."""
    if kind == "cylinder":
        return np.array([[radius, -half], [radius, half]])
    t = np.linspace(-np.pi / 2, np.pi / 2, 2 * RINGS + 1)[1:-1]
    curve: Array = np.c_[radius * np.cos(t), radius * np.sin(t) + np.where(t > 1e-9, half, -half) * (kind == "capsule")]
    return curve


def shape(kind: str, size: Array, material: Material, frame: Array) -> tuple[Piece, Collider]:
    """Mesh and collider in the frame's parent; `size` is full extents of a box, else [radius, half length]."""
    center, rotation = frame[:3, 3], frame[:3, :3]
    if not np.isfinite(size).all() or (np.asarray(size) <= 0).any():
        raise Broken(f"a {kind} of size {np.asarray(size).tolist()}")
    if kind == "box":
        return box(size, material).moved(frame), Collider("box", center, np.asarray(size, float), rotation)
    radius, half = float(size[0]), float(size[1])
    piece = turned(profile(kind, radius, half), material).moved(frame)
    if kind == "sphere":
        return piece, Collider("sphere", center, np.full(3, radius), rotation)
    if kind == "cylinder":
        return piece, Collider("cylinder", center, np.array([radius, radius, 2 * half]), rotation)
    return piece, Collider("hull", center, np.ptp(piece.vertices, axis=0), vertices=piece.vertices - center)

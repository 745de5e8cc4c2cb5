"""Boxes, cylinders, capsules and spheres as closed meshes and as colliders, about their own origin, axis z."""

import numpy as np

from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.pieces import Array, Piece
from apartgen.stages.things.asset import Collider, Material

SIDES, RINGS = 24, 12


def shape(kind: str, size: Array, material: Material, frame: Array) -> tuple[Piece, Collider]:
    """Mesh and collider in the frame's parent; `size` is full extents of a box, else [radius, half length]."""
    center, rotation = frame[:3, 3], frame[:3, :3]
    if not np.isfinite(size).all() or (np.asarray(size) <= 0).any():
        raise Broken(f"a {kind} of size {np.asarray(size).tolist()}")
    piece = _mesh(kind, size, material).moved(frame)
    if kind == "box":
        return piece, Collider("box", center, np.asarray(size, float), rotation)
    radius, half = float(size[0]), float(size[1])
    if kind == "sphere":
        return piece, Collider("sphere", center, np.full(3, radius), rotation)
    if kind == "cylinder":
        return piece, Collider("cylinder", center, np.array([radius, radius, 2 * half]), rotation)
    return piece, Collider("hull", center, np.ptp(piece.vertices, axis=0), vertices=piece.vertices - center)


def _mesh(kind: str, size: Array, material: Material) -> Piece:
    from trimesh import creation

    if kind == "box":
        made = creation.box(np.asarray(size, float))
    elif kind == "cylinder":
        made = creation.cylinder(float(size[0]), 2 * float(size[1]), sections=SIDES)
    else:
        length = 2 * float(size[1]) if kind == "capsule" else 0.0
        made = creation.capsule(length, float(size[0]), count=[RINGS, SIDES])
    vertices = np.asarray(made.vertices - made.bounds.mean(0))
    return Piece(vertices, np.asarray(made.faces, np.int64), material)

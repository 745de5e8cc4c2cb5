"""Normals for shading triangles that meet smoothly or at an edge."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.things import welding
from apartgen.stages.things.asset import Array, Mesh

CREASE = np.cos(np.radians(42))
"""Faces that meet at less than this angle are shaded as one smooth surface."""


def distinct(rows: Array) -> tuple[Array, NDArray[np.int64]]:
    """The rows (n, k) that differ, in order, and which of them each of the given ones is."""
    return welding.distinct(np.ascontiguousarray(rows, float))


def crossed(a: Array, b: Array) -> Array:
    """Cross products of rows (n, 3), without what numpy's own does for any shape, which takes longer for few."""
    (ax, ay, az), (bx, by, bz) = a.T, b.T
    return np.stack([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], -1)


def corner_normals(mesh: Mesh) -> Array:
    """Normal at each corner of each face, (3 × m, 3): the mean over faces about the vertex that meet smoothly."""
    vertices, faces = np.ascontiguousarray(mesh.vertices, float), np.ascontiguousarray(mesh.faces, np.int64)
    total = welding.normals(vertices, vertices.round(5), faces, CREASE)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    if (length > 1e-15).all():
        return np.asarray(total / length)
    flat = welding.unit(welding.crossed(vertices, faces), 1e-15)
    return np.where(length > 1e-15, total / np.maximum(length, 1e-15), np.repeat(flat, 3, 0))


def tangents(vertices: Array, normals: Array, uv: Array, faces: NDArray[np.int64]) -> Array:
    """Where texture coordinates' u runs at each vertex, and on which side v does, (k, 4), v being counted upwards."""
    (a, b, c), (p, q, r) = vertices[faces].transpose(1, 0, 2), uv[faces].transpose(1, 0, 2)
    u, v = q - p, r - p
    turn = np.sign(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])[:, None]
    along = turn * ((b - a) * v[:, 1:] - (c - a) * u[:, 1:])
    corner = faces.ravel()
    total = np.stack([np.bincount(corner, np.repeat(column, 3), len(vertices)) for column in (*along.T, *turn.T)], 1)
    flat = total[:, :3] - (total[:, :3] * normals).sum(1, keepdims=True) * normals
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    other = np.cross(normals, np.eye(3)[np.abs(normals).argmin(1)])
    other /= np.maximum(np.linalg.norm(other, axis=1, keepdims=True), 1e-12)
    return np.column_stack([np.where(length > 1e-9, flat / np.maximum(length, 1e-12), other),
                            np.where(total[:, 3] < 0, -1.0, 1.0)])

"""A collider as a closed convex mesh."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.things import solids
from apartgen.stages.things.asset import Array, Collider

SIDES = 32
"""Of what is round: its mesh lies within 0.5 % of its radius."""


def hull(c: Collider) -> tuple[Array, NDArray[np.int64]]:
    """Corners (n, 3) in the body's frame and outward triangles (m, 3) of a collider."""
    from scipy.spatial import ConvexHull

    points = _points(c)
    found = ConvexHull(points)
    faces = found.simplices.astype(np.int64)
    a, b, d = (points[faces[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, d - a), found.equations[:, :3]) < 0
    faces[inward] = faces[inward][:, ::-1]
    used, index = np.unique(faces, return_inverse=True)
    return points[used], index.reshape(-1, 3).astype(np.int64)


def _points(c: Collider) -> Array:
    """Points (n, 3) in the body's frame whose convex hull is the collider."""
    if c.kind in ("box", "hull"):
        return solids.corners(c)
    radius, angles = c.size[0], np.linspace(0, 2 * np.pi, SIDES, endpoint=False)
    ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], -1)
    levels = [(1.0, -c.size[2] / 2), (1.0, c.size[2] / 2)]
    if c.kind == "sphere":
        tilts = np.linspace(-np.pi / 2, np.pi / 2, SIDES // 2 + 1)
        levels = [(float(np.cos(t)), radius * float(np.sin(t))) for t in tilts]
    local = np.concatenate([radius * share * ring + [0, 0, z] for share, z in levels])
    return np.asarray(local @ c.rotation.T + c.center)

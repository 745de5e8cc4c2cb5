"""The convex hull of a collider as a closed mesh."""

import numpy as np
from numpy.typing import NDArray

from stages.asset import Array, Collider


def hull(c: Collider) -> tuple[Array, NDArray[np.int64]]:
    """Corners (n, 3) in the body's frame and outward triangles (m, 3) of a hull collider."""
    from scipy.spatial import ConvexHull

    assert c.vertices is not None
    points = c.vertices @ c.rotation.T + c.center
    found = ConvexHull(points)
    faces = found.simplices.astype(np.int64)
    a, b, d = (points[faces[:, k]] for k in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, d - a), found.equations[:, :3]) < 0
    faces[inward] = faces[inward][:, ::-1]
    used, index = np.unique(faces, return_inverse=True)
    return points[used], index.reshape(-1, 3).astype(np.int64)

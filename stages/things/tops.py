"""Heights of an asset's surface as seen from above: what is put on it lands there."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.things.asset import Array, Asset

SLACK = 1e-6
"""What is so near to a triangle may be over it by rounding, m."""


def heights(asset: Asset, points: Array) -> Array:
    """Height of the highest visible surface over each point (p, 2), asset's frame, (p,), m; -inf where there is none.

    An asset that nothing is seen of is as high as its box.
    """
    corners = [mesh.vertices[mesh.faces] for link in asset.links for mesh in link.visuals]
    if not corners:
        return np.full(len(points), asset.size[2] / 2)
    triangles = np.concatenate(corners)
    a, b, c = triangles.transpose(1, 0, 2)
    u, v = (b - a)[:, :2], (c - a)[:, :2]
    twice = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    seen = np.flatnonzero(np.abs(twice) > 1e-9)
    point, which = _over(points, triangles[seen, :, :2])
    k = seen[which]
    a, b, c, u, v, twice = a[k], b[k], c[k], u[k], v[k], twice[k]
    to = points[point] - a[:, :2]
    s = (to[:, 0] * v[:, 1] - to[:, 1] * v[:, 0]) / twice
    t = (u[:, 0] * to[:, 1] - u[:, 1] * to[:, 0]) / twice
    z = a[:, 2] + s * (b - a)[:, 2] + t * (c - a)[:, 2]
    over = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
    found = np.full(len(points), -np.inf)
    np.maximum.at(found, point[over], z[over])
    return found


def _over(points: Array, triangles: Array) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Points (p, 2) and triangles (t, 3, 2) in whose bounds they are, in pairs."""
    lo, hi = triangles.min(1) - SLACK, triangles.max(1) + SLACK
    x, y = ((points[:, None, k] >= lo[:, k]) & (points[:, None, k] <= hi[:, k]) for k in (0, 1))
    point, which = np.nonzero(x & y)
    return point, which

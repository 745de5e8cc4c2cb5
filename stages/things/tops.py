"""Heights of an asset's surface as seen from above: what is put on it lands there."""

import numpy as np

from apartgen.stages.things.asset import Array, Asset


def heights(asset: Asset, points: Array) -> Array:
    """Height of the highest visible surface over each point (p, 2), asset's frame, (p,), m; -inf where there is none.

    An asset that nothing is seen of is as high as its box.
    """
    corners = [mesh.vertices[mesh.faces] for link in asset.links for mesh in link.visuals]
    if not corners:
        return np.full(len(points), asset.size[2] / 2)
    a, b, c = np.concatenate(corners).transpose(1, 0, 2)
    u, v = (b - a)[:, :2], (c - a)[:, :2]
    twice = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    flat = np.abs(twice) > 1e-9
    a, b, c, u, v, twice = a[flat], b[flat], c[flat], u[flat], v[flat], twice[flat]
    to = points[:, None] - a[None, :, :2]
    s = (to[..., 0] * v[:, 1] - to[..., 1] * v[:, 0]) / twice
    t = (u[:, 0] * to[..., 1] - u[:, 1] * to[..., 0]) / twice
    z = a[:, 2] + s * (b - a)[:, 2] + t * (c - a)[:, 2]
    over = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
    return np.asarray(np.where(over, z, -np.inf).max(1, initial=-np.inf))

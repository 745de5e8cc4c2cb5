"""What the autoencoder sees of an asset: closeness to its surface on a grid, and its colours on a coarser one.

Each axis of the box is stretched to [-1, 1], so that a design drawn at another size looks the same and the
latent says what the size does not.
"""

from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from apartgen.stages.things.asset import Asset

Array = NDArray[np.float64]
Field = NDArray[np.float32]

POINTS = 4096
GRID = 14
"""Closeness is sampled at GRID³ cell centres."""
REACH = 0.13
"""Closeness falls to 1/e at this distance, in half boxes; about one cell."""
COLOR_GRID = 4
NEIGHBOURS = 8
SHAPE = GRID**3
COLORS = 3 * COLOR_GRID**3
FEATURES = SHAPE + COLORS


def centres(cells: int) -> Array:
    """Cell centres of [-1, 1]³, (cells³, 3)."""
    axis = (np.arange(cells) + 0.5) * 2 / cells - 1
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)


@cache
def _spread(count: int) -> tuple[Array, Array]:
    # The R2 sequence (Roberts 2018) folded into a triangle: even cover without a random number.
    i = np.arange(1, count + 1)
    u, v = np.modf(i * 0.7548776662466927)[0], np.modf(i * 0.5698402909980532)[0]
    over = u + v > 1
    return np.where(over, 1 - u, u), np.where(over, 1 - v, v)


def triangles(asset: Asset) -> tuple[Array, Array]:
    """All visible triangles in box units (m, 3, 3) and their base colours (m, 3)."""
    half = np.maximum(np.asarray(asset.size, float), 1e-6) / 2
    meshes = [mesh for link in asset.links for mesh in link.visuals]
    corners = [mesh.vertices[mesh.faces] / half for mesh in meshes]
    colors = [np.tile(np.asarray(mesh.material.color[:3], float), (len(mesh.faces), 1)) for mesh in meshes]
    return np.concatenate(corners), np.concatenate(colors)


def surface(asset: Asset, count: int = POINTS) -> tuple[Array, Array]:
    """`count` points spread evenly over the surface in box units, and their colours; both (count, 3)."""
    corners, colors = triangles(asset)
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    share = np.cumsum(area)
    at = (np.arange(count) + 0.5) / count * share[-1]
    face = np.minimum(np.searchsorted(share, at), len(area) - 1)
    u, v = _spread(count)
    points = a[face] + u[:, None] * (b - a)[face] + v[:, None] * (c - a)[face]
    return points, colors[face]


def field(asset: Asset) -> Field:
    """The asset as one vector (FEATURES,): closeness exp(-(d/REACH)²) in [0, 1], then colours in [0, 1]."""
    points, colors = surface(asset)
    tree = cKDTree(points)
    distance = tree.query(centres(GRID), distance_upper_bound=3 * REACH)[0]
    nearest = tree.query(centres(COLOR_GRID), k=NEIGHBOURS)[1]
    closeness = np.exp(-((distance / REACH) ** 2))
    return np.concatenate([closeness, colors[nearest].mean(1).ravel()]).astype(np.float32)

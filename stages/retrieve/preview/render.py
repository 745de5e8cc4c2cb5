"""Pictures of assets, closed and open, on a plain ground."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene import render
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.posed import moved
from apartgen.stages.scene.soup import Soup, soup
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.body import Body

AZIMUTH, ELEVATION = np.radians(-31.8), np.radians(27.8)
"""Where the camera stands, seen from the asset: before it, to its right and above."""
Direction = tuple[float, float]


def opened(asset: Asset, share: float) -> Soup:
    """The asset's triangles with every joint at this share of its range, standing on z = 0."""
    links = [moved(link, share) for link in asset.links]
    middle = np.array([0.0, 0.0, asset.size[2] / 2])
    return soup([Body(asset.category, "object", asset.category, "", middle, 0.0, links)])


def pictures(
    soups: Sequence[Soup], size: int = 160, direction: Direction = (AZIMUTH, ELEVATION)
) -> list[NDArray[np.uint8]]:
    """A square picture (size, size, 3) of each, all from one place that shows every one whole."""
    points = np.concatenate([s.corners.reshape(-1, 3) for s in soups])
    camera = Camera.at(points, size * size, *direction, square=True)
    return [render.picture(s, camera, min(0.0, float(points[:, 2].min())) - 1e-3) for s in soups]


def pair(asset: Asset, size: int = 160) -> list[NDArray[np.uint8]]:
    """The asset closed and, when it moves, fully open, at the same scale."""
    return pictures([opened(asset, 0.0), *([opened(asset, 1.0)] if asset.joints else [])], size)

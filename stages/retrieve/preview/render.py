"""Pictures of assets, closed and open, on a plain ground."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.picture import taken
from apartgen.stages.scene.posed import moved
from apartgen.stages.scene.soup import soup
from apartgen.stages.scene.world import ground, open_air
from apartgen.stages.things.asset import Asset, Material
from apartgen.stages.things.body import Body

AZIMUTH, ELEVATION = np.radians(-31.8), np.radians(27.8)
"""Where the camera stands, seen from the asset: before it, to its right and above."""
PAPER = Material("paper", (0.93, 0.93, 0.92, 1.0), 1.0)
Direction = tuple[float, float]


def opened(asset: Asset, share: float) -> Body:
    """The asset with every joint at this share of its range, standing on z = 0."""
    links = [moved(link, share) for link in asset.links]
    middle = np.array([0.0, 0.0, asset.size[2] / 2])
    return Body(asset.category, "object", asset.category, "", middle, 0.0, links)


def pictures(
    bodies: Sequence[Body], size: int = 160, direction: Direction = (AZIMUTH, ELEVATION)
) -> list[NDArray[np.uint8]]:
    """A square picture (size, size, 3) of each, all from one place that shows every one whole."""
    points = np.concatenate([soup([body]).corners.reshape(-1, 3) for body in bodies])
    camera = Camera.at(points, size * size, *direction, square=True)
    floor = ground(np.zeros(3), min(0.0, float(points[:, 2].min())) - 1e-3, PAPER)
    return [taken(open_air([body], floor), camera) for body in bodies]


def pair(asset: Asset, size: int = 160) -> list[NDArray[np.uint8]]:
    """The asset closed and, when it moves, fully open, at the same scale."""
    return pictures([opened(asset, 0.0), *([opened(asset, 1.0)] if asset.joints else [])], size)

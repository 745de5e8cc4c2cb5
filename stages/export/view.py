"""The furnished apartment seen from above, its walls cut off at 1.5 m, as a picture, view.png."""

from pathlib import Path

import numpy as np

from apartgen.stages.export._lowered import lowered
from apartgen.stages.export._readback import read_images
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.picture import taken
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.soup import soup
from apartgen.stages.scene.world import ground, open_air
from apartgen.stages.things.asset import Material

PIXELS = 1_300_000
"""Of the whole picture; its shape follows from what is shown."""
AZIMUTH, ELEVATION = np.radians(-74.0), np.radians(68.0)
"""Where the camera stands, seen from the middle of the house: high from one side."""
GROUND = -0.125
"""Just under the slab, m."""
GRASS = Material("grass", (0.60, 0.64, 0.54, 1.0), 1.0)


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, view.png; needs no graphics card."""
    from PIL import Image

    bodies = lowered(scene.bodies)
    corners = soup(bodies).corners.reshape(-1, 3)
    camera = Camera.at(corners, PIXELS, AZIMUTH, ELEVATION)
    path = out / "view.png"
    Image.fromarray(taken(open_air(bodies, ground(corners.mean(0), GROUND, GRASS)), camera)).save(path, "PNG")
    return [path]


def read_back(files: list[Path]) -> None:
    """By Pillow."""
    read_images(files)

"""The furnished apartment seen from above, its walls cut off at 1.5 m, as a picture, view.png."""

from pathlib import Path

import numpy as np

from apartgen.stages.export._lowered import lowered
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.render import picture
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.soup import soup

PIXELS = 1_300_000
"""Of the whole picture; its shape follows from what is shown."""
AZIMUTH, ELEVATION = np.radians(-74.0), np.radians(68.0)
"""Where the camera stands, seen from the middle of the house: high from one side."""
GROUND = -0.125
"""Just under the slab, m."""


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, view.png; needs no graphics card."""
    from PIL import Image

    every = soup(lowered(scene.bodies))
    camera = Camera.at(every.corners.reshape(-1, 3), PIXELS, AZIMUTH, ELEVATION)
    path = out / "view.png"
    Image.fromarray(picture(every, camera, GROUND)).save(path, "PNG")
    return [path]

"""How surfaces stand up: normal maps of what is woven, quilted, laid and walled, drawn by the pattern that draws their
colour, so that joints lie where they are seen; what is only printed or painted is flat.
"""

from functools import cache

import numpy as np

from apartgen.stages.things import materials
from apartgen.stages.things.materials import Image

DEPTH = {
    "weave": 0.25, "boucle": 1.5, "velvet": 0.8, "leather": 1.0, "quilt": 6.0, "berber": 2.0, "wicker": 2.0,
    "cane": 1.0, "tile": 1.2, "metro": 1.5, "hexagons": 1.2, "bricks": 4.0, "planks": 2.5, "herringbone": 0.7,
}  # fmt: skip
"""From the lowest to the highest point of a pattern, mm; patterns that are not named are flat."""
_LEVELS = 4
"""Normals are rounded to so many steps of a byte: images of them are half as large."""


def standing(texture: str) -> str:
    """The pattern by which a material's surface stands up; empty where it is flat, or an image of a library."""
    pattern = materials.pattern(texture) if texture in materials.textures() else ""
    return pattern if pattern in DEPTH else ""


@cache
def normals(pattern: str, size: int = 256) -> Image:
    """The normal map (size, size, 3) of a pattern: x to the right, y up, z out of the surface; it meets itself."""
    shade = materials.shades(pattern, size)
    height = DEPTH[pattern] / 1000 * shade / np.ptp(shade)
    for axis in (0, 1):
        height = (2 * height + np.roll(height, 1, axis) + np.roll(height, -1, axis)) / 4
    step = 2 * materials.repeat(pattern) / size
    right, down = ((np.roll(height, -1, axis) - np.roll(height, 1, axis)) / step for axis in (1, 0))
    slope = np.stack([-right, down, np.ones_like(height)], -1)
    unit = slope / np.linalg.norm(slope, axis=2, keepdims=True)
    image: Image = np.clip(np.rint(unit * 127.5 / _LEVELS) * _LEVELS + 128, 0, 255).astype(np.uint8)
    image.flags.writeable = False
    return image

"""Rooms from straight above, as image metrics compare them: boxes coloured by category, one renderer for both sides.

Floor light on white, objects from low to high, each with a dark edge where its front is. Openings are not drawn:
data sets of rooms often lack them.
"""

import colorsys
import zlib
from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from apartgen.schemas.base import Point, RoomType
from apartgen.schemas.layout import Box
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array

Picture = NDArray[np.uint8]
Colour = tuple[int, int, int]

PIXELS = 256
"""Side of a picture."""
SIDE = 6.2
"""What it spans, m, as in the field's renders of 3D-FRONT; rooms where people live and dine get twice as much."""
LARGE = ("living_room", "dining_room")
FLOOR: Colour = (225, 220, 210)
FRONT = 0.06
"""Width of the strip that marks the front, m."""
_SUPERSAMPLED = 4


def picture(polygon: Sequence[Point], objects: Sequence[Box], kind: RoomType) -> Picture:
    """One room seen by an orthographic camera above the middle of its floor, (256, 256, 3)."""
    corners = np.asarray(polygon, float)
    middle = (corners.min(0) + corners.max(0)) / 2
    scale = PIXELS * _SUPERSAMPLED / (SIDE * (2 if kind in LARGE else 1))
    image = Image.new("RGB", (PIXELS * _SUPERSAMPLED,) * 2, "white")
    pen = ImageDraw.Draw(image)

    def fill(points: Array, colour: Colour) -> None:
        at = (points - middle) * [scale, -scale] + image.width / 2
        pen.polygon([(float(x), float(y)) for x, y in at], fill=colour)

    fill(corners, FLOOR)
    for o in sorted(objects, key=lambda o: (o.center[2] + o.size[2] / 2, o.category, o.center)):
        base = boxes.of([o])
        d, w = (s / 2 for s in o.size[:2])
        strip = boxes.spread(base, [[max(d - FRONT, -d), -w, 0]], [[d, w, 1]])
        fill(boxes.corners(base)[0], colour(o.category))
        fill(boxes.corners(strip)[0], _dark(colour(o.category)))
    return np.asarray(image.reduce(_SUPERSAMPLED), np.uint8)


@cache
def colour(category: str) -> Colour:
    """A category's colour: hue and lightness from its name, so that a longer vocabulary changes no picture."""
    code = zlib.crc32(category.encode())
    rgb = colorsys.hls_to_rgb(code % 360 / 360, 0.35 + code // 360 % 4 * 0.1, 0.65)
    red, green, blue = (round(255 * v) for v in rgb)
    return red, green, blue


def _dark(colour: Colour) -> Colour:
    red, green, blue = (v // 2 for v in colour)
    return red, green, blue

"""A drawing as lines and words in metres, by layer and thing: for formats that are no pictures."""

from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.text import Text
from numpy.typing import NDArray


@dataclass(frozen=True)
class Stroke:
    """Points (n, 2) that a pen goes through, curves in short steps."""

    layer: str
    thing: str
    points: NDArray[np.float64]
    closed: bool
    dashed: bool

    def seen_from(self, middle: tuple[float, float], yaw: float) -> "Stroke":
        """The same in the frame of a thing."""
        c, s = np.cos(yaw), np.sin(yaw)
        return replace(self, points=(self.points - middle) @ np.array([[c, -s], [s, c]]))


@dataclass(frozen=True)
class Word:
    """Text about a place."""

    layer: str
    thing: str
    text: str
    at: tuple[float, float]


def strokes(sheet: Figure) -> list[Stroke]:
    """All lines of what has the name LAYER/THING, in the order in which it was drawn."""
    axes, found = sheet.axes[0], list[Stroke]()
    metres = axes.transData.inverted()
    for artist in axes.get_children():
        layer, slash, thing = (artist.get_gid() or "").partition("/")
        if not slash or not isinstance(artist, Patch | Line2D):
            continue
        path, whole = artist.get_path(), artist.get_transform()
        dashed = artist.get_linestyle() not in ("-", "solid")
        for line in path.to_polygons(whole, closed_only=False):
            points = np.asarray(line, float)
            if len(points) > 1:
                shut = bool(np.allclose(points[0], points[-1]))
                found.append(Stroke(layer, thing, metres.transform(points)[:-1 if shut else None], shut, dashed))
    return found


def words(sheet: Figure) -> list[Word]:
    """All text of what has such a name."""
    found = []
    for artist in sheet.axes[0].get_children():
        layer, slash, thing = (artist.get_gid() or "").partition("/")
        if slash and isinstance(artist, Text):
            x, y = (float(v) for v in artist.get_position())
            found.append(Word(layer, thing, artist.get_text(), (x, y)))
    return found

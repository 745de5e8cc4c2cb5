"""Draws lines and shapes of a plan, in metres, in the frame of one object at a time."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc, Ellipse, FancyBboxPatch, Patch, Polygon, Rectangle
from matplotlib.transforms import Affine2D

INK = "#4a4744"
FAINT = "#a09a92"
PAPER = "#ffffff"
WOOD = "#f3e7d3"
CLOTH = "#e9e6e1"
STEEL = "#eceff1"
WATER = "#dfeaf0"
GREEN, LEAF = "#cfe0c2", "#6f9a5e"
DARK = "#37383a"
LINE = 0.55
DASHES = (0, (4, 3))


@dataclass(frozen=True)
class Pen:
    """Draws on `axes` about an object's centre; +x is its front, +y its left. `name` says what is drawn, as
    LAYER/THING.
    """

    axes: Axes
    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    order: float = 3.0
    name: str | None = None

    def _place(self, patch: Patch) -> None:
        turn = Affine2D().rotate(self.yaw).translate(self.x, self.y)
        patch.set_transform(turn + self.axes.transData)
        patch.set_zorder(self.order)
        patch.set_gid(self.name)
        self.axes.add_artist(patch)  # of no matter to limits, which are given

    def _style(self, fill: str | None, ink: str, width: float, dashed: bool) -> dict[str, Any]:
        face = {"facecolor": fill} if fill else {"fill": False}
        return {**face, "edgecolor": ink, "linewidth": width, "linestyle": DASHES if dashed else "-",
                "joinstyle": "round"}

    def rect(self, x0: float, x1: float, y0: float, y1: float, fill: str | None = PAPER, r: float = 0.0,
             ink: str = INK, width: float = LINE, dashed: bool = False) -> None:
        """A rectangle, its corners rounded by `r`."""
        style = self._style(fill, ink, width, dashed)
        r = min(r, (x1 - x0) / 2.01, (y1 - y0) / 2.01)
        if r <= 0:
            self._place(Rectangle((x0, y0), x1 - x0, y1 - y0, **style))
        else:
            inner = (x0 + r, y0 + r), x1 - x0 - 2 * r, y1 - y0 - 2 * r
            self._place(FancyBboxPatch(*inner, boxstyle=f"round,pad={r},rounding_size={r}", **style))

    def oval(self, x: float, y: float, rx: float, ry: float, fill: str | None = None, ink: str = INK,
             width: float = LINE, dashed: bool = False) -> None:
        """An ellipse about (x, y)."""
        self._place(Ellipse((x, y), 2 * rx, 2 * ry, **self._style(fill, ink, width, dashed)))

    def shape(self, points: Any, fill: str | None = PAPER, ink: str = INK, width: float = LINE,
              dashed: bool = False) -> None:
        """A closed polygon."""
        self._place(Polygon(np.asarray(points), closed=True, **self._style(fill, ink, width, dashed)))

    def line(self, *points: tuple[float, float], ink: str = INK, width: float = LINE, dashed: bool = False) -> None:
        """An open line through the points."""
        self._place(Polygon(np.asarray(points), closed=False, **self._style(None, ink, width, dashed)))

    def arc(self, x: float, y: float, radius: float, start: float, end: float, ink: str = INK,
            width: float = LINE, dashed: bool = False) -> None:
        """Part of a circle between two angles in degrees."""
        style = DASHES if dashed else "-"
        self._place(Arc((x, y), 2 * radius, 2 * radius, theta1=start, theta2=end, ec=ink, lw=width, ls=style))

    def word(self, x: float, y: float, text: str, size: float = 4.5, ink: str = FAINT) -> None:
        """Small text, upright on the page."""
        c, s = np.cos(self.yaw), np.sin(self.yaw)
        self.axes.text(self.x + c * x - s * y, self.y + s * x + c * y, text, fontsize=size, color=ink, ha="center",
                       va="center", zorder=self.order, gid=self.name)

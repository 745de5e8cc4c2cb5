"""Where a picture is taken from: far enough to show everything."""

from dataclasses import dataclass

import numpy as np

from apartgen.stages.scene.soup import Array, Index, length

FIELD = np.radians(32.0)
BORDER = 0.04
"""Share of the picture left about what is shown."""


@dataclass(frozen=True)
class Camera:
    """A pinhole at `eye`; rows of `frame` are right, up, back; at 1 m the image is `half` wide about `middle`."""

    eye: Array
    frame: Array
    half: Array
    middle: Array
    rows: int
    columns: int

    @classmethod
    def at(cls, points: Array, pixels: int, azimuth: float, elevation: float, square: bool = False) -> "Camera":
        """One that sees all of the points (n, 3) from a direction, rad; its image of so many pixels is cut to fit."""
        points = np.unique(points.round(2), axis=0).astype(float)
        flat = np.cos(elevation)
        back = np.array([np.cos(azimuth) * flat, np.sin(azimuth) * flat, np.sin(elevation)])
        right = np.cross([0.0, 0.0, 1.0], back) / flat
        frame = np.stack([right, np.cross(back, right), back])
        center = (points.min(0) + points.max(0)) / 2
        eye = center + back * np.linalg.norm(np.ptp(points, axis=0)) / 2 / np.tan(FIELD / 2)
        seen = (points - eye) @ frame.T
        flat_points = seen[:, :2] / -seen[:, 2:]
        lo, hi = flat_points.min(0), flat_points.max(0)
        half = (hi - lo) / 2 + BORDER * (hi - lo).max()
        half = np.full(2, half.max()) if square else half
        single = np.float32
        shape = float(half[1] / half[0])
        rows, columns = round((pixels * shape) ** 0.5), round((pixels / shape) ** 0.5)
        return cls(eye.astype(single), frame.astype(single), half, (lo + hi) / 2, rows, columns)

    def rays(self, pixels: Index, within: Array) -> Array:
        """Unit directions (n, 3) through a point of each pixel, `within` it in [0, 1)²."""
        x = (2 * (pixels % self.columns + within[0]) / self.columns - 1) * self.half[0] + self.middle[0]
        y = (1 - 2 * (pixels // self.columns + within[1]) / self.rows) * self.half[1] + self.middle[1]
        way = np.stack([x, y, np.full(len(pixels), -1.0)], -1).astype(np.float32)
        found: Array = (way / length(way)) @ self.frame
        return found

"""Where a picture is taken from: far enough to show everything."""

from dataclasses import dataclass

import numpy as np

from apartgen.stages.scene.lens import pinhole
from apartgen.stages.scene.soup import Array, Index

FIELD = np.radians(32.0)
MIDDLE = np.array([0.5, 0.5])
"""Of a pixel."""
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

    @classmethod
    def looking(cls, eye: Array, yaw: float, pitch: float, field: float, columns: int, rows: int) -> "Camera":
        """One at `eye` that looks along `yaw`, `pitch` above the horizon, and sees `field` from left to right, rad."""
        ahead = np.array([np.cos(yaw) * np.cos(pitch), np.sin(yaw) * np.cos(pitch), np.sin(pitch)])
        x, y = np.sin(yaw), -np.cos(yaw)
        up = [y * ahead[2], -x * ahead[2], x * ahead[1] - y * ahead[0]]
        frame = np.array([[x, y, 0.0], up, -ahead])
        half = np.tan(field / 2) * np.array([1.0, rows / columns])
        return cls(np.asarray(eye, np.float32), frame.astype(np.float32), half, np.zeros(2), rows, columns)

    @property
    def intrinsics(self) -> tuple[float, float, float, float]:
        """fx, fy, cx, cy in pixels; the middle of the first pixel is at (0.5, 0.5)."""
        fx, fy = self.columns / 2 / self.half[0], self.rows / 2 / self.half[1]
        return float(fx), float(fy), float(self.columns / 2 - fx * self.middle[0]), float(
            self.rows / 2 + fy * self.middle[1])

    def rays(self, pixels: Index, within: Array) -> Array:
        """Unit directions (n, 3) through a point of each pixel, `within` it in [0, 1)²."""
        return np.asarray(pinhole(pixels, self.rows, self.columns, np.asarray(within, float), self.half, self.middle,
                                  self.frame.astype(float)))


@dataclass(frozen=True)
class Panorama:
    """All that is seen from `eye`: columns from the back over the left round to the back, rows from above to below."""

    eye: Array
    rows: int
    columns: int

    def rays(self, pixels: Index, within: Array) -> Array:
        """Unit directions (n, 3) through a point of each pixel, `within` it in [0, 1)²; the middle looks along +x."""
        yaw = np.pi * (1 - 2 * (pixels % self.columns + within[0]) / self.columns)
        pitch = np.pi * (0.5 - (pixels // self.columns + within[1]) / self.rows)
        flat = np.cos(pitch)
        return np.stack([flat * np.cos(yaw), flat * np.sin(yaw), np.sin(pitch)], -1).astype(np.float32)

"""Patterns of surfaces as images that tile: wood, cloth, stone, and what floors and walls are laid and papered with.

Each draws a square image of shades about a colour, (size, size, 3), and meets itself at its edges.
"""

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pattern = Callable[[np.random.Generator, int, Array], Array]


def noise(rng: np.random.Generator, size: int, width: float, length: float | None = None) -> Array:
    """Periodic Gaussian noise (size, size), unit variance; feature sizes in shares of the image, y then x."""
    kept = np.fft.rfft2(rng.standard_normal((size, size)))
    kept *= _keep(size, width, width if length is None else length)
    field = np.fft.irfft2(kept, (size, size))
    spread = field.std() + 1e-12
    field -= field.mean()
    field /= spread
    return np.asarray(field)


@lru_cache(maxsize=64)
def _keep(size: int, width: float, length: float) -> Array:
    """Shares of waves, (size, size / 2 + 1), that noise of such features keeps."""
    fy, fx = np.fft.fftfreq(size, 1 / size)[:, None], np.fft.rfftfreq(size, 1 / size)[None, :]
    return np.asarray(np.exp(-((fy * width) ** 2 + (fx * length) ** 2) * 4))


def lit(color: Array, change: Array) -> Array:
    """The colour with a relative change of brightness (h, w)."""
    return np.asarray(color * (1 + change[..., None]))


def grid(size: int) -> tuple[Array, Array]:
    """Image coordinates in [0, 1): x (1, size), y (size, 1)."""
    t = np.arange(size) / size
    return t[None, :], t[:, None]


def wood(rng: np.random.Generator, size: int, color: Array) -> Array:
    _, y = grid(size)
    warp = noise(rng, size, 0.25, 0.6)
    rings = np.sin(2 * np.pi * (9 * y + 0.55 * warp))
    return lit(color, 0.05 * rings + 0.05 * noise(rng, size, 0.01, 0.5) + 0.04 * warp)


def _weave(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    over = np.sin(64 * np.pi * x) * np.sin(64 * np.pi * y)
    return lit(color, 0.07 * over + 0.04 * noise(rng, size, 0.01, 0.12) + 0.04 * noise(rng, size, 0.12, 0.01))


def _boucle(rng: np.random.Generator, size: int, color: Array) -> Array:
    return lit(color, 0.07 * noise(rng, size, 0.02) + 0.03 * noise(rng, size, 0.2))


def _velvet(rng: np.random.Generator, size: int, color: Array) -> Array:
    return lit(color, 0.06 * noise(rng, size, 0.3) + 0.05 * noise(rng, size, 0.008))


def _leather(rng: np.random.Generator, size: int, color: Array) -> Array:
    cells = np.abs(noise(rng, size, 0.025))
    return lit(color, 0.12 * np.minimum(cells, 0.8) - 0.06 + 0.04 * noise(rng, size, 0.3))


def _quilt(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    seam = np.minimum(np.abs(np.sin(2 * np.pi * (x + y))), np.abs(np.sin(2 * np.pi * (x - y))))
    return lit(color, -0.14 * np.exp(-seam * 9) + 0.01 * noise(rng, size, 0.01))


def _stripe(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    band = np.where((x * 5 % 1) < 0.22, -0.38, 0.0) + 0 * y
    return lit(color, band + 0.05 * noise(rng, size, 0.01))


def _berber(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    line = np.abs(np.abs((2 * x) % 1 - 0.5) + np.abs((2 * y) % 1 - 0.5) - 0.5)
    return lit(color, -0.65 * (line < 0.03) + 0.05 * noise(rng, size, 0.015))


def _kilim(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    step = np.floor(16 * np.abs((2 * x) % 1 - 0.5)) / 16 + y * 2
    tones = np.array([[1.0, 1.0, 1.0], [0.45, 0.5, 0.62], [1.3, 1.42, 1.5], [0.75, 0.55, 0.5]])
    return np.asarray(color * tones[(step * 4 % 4).astype(int)] * (1 + 0.05 * noise(rng, size, 0.01))[..., None])


def _persian(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    u, v = np.abs(x - 0.5), np.abs(y - 0.5)
    figure = np.cos(10 * np.pi * u) * np.cos(10 * np.pi * v) + 0.6 * np.cos(30 * np.pi * np.hypot(u, v))
    shade = np.where(figure > 0.75, 0.9, np.where(figure < -0.7, -0.4, 0.0))
    return lit(color, shade + 0.06 * noise(rng, size, 0.01))


def _marble(rng: np.random.Generator, size: int, color: Array) -> Array:
    vein = np.abs(noise(rng, size, 0.22) + 0.35 * noise(rng, size, 0.05))
    sign = -1.0 if color.mean() > 128 else 1.6
    return lit(color, sign * 0.3 * np.exp(-vein * 14) + sign * 0.05 * noise(rng, size, 0.3))


def _speckle(rng: np.random.Generator, size: int, color: Array) -> Array:
    return lit(color, 0.10 * noise(rng, size, 0.012) + 0.03 * noise(rng, size, 0.1))


def _terrazzo(rng: np.random.Generator, size: int, color: Array) -> Array:
    chips, tint = noise(rng, size, 0.05), noise(rng, size, 0.09)
    shade = np.where(chips > 1.25, np.where(tint > 0, -0.35, -0.6), 0.0)
    return np.asarray(lit(color, shade) * np.where((chips > 1.25)[..., None], [1.1, 0.95, 0.85], 1.0))


def _cloud(rng: np.random.Generator, size: int, color: Array) -> Array:
    return lit(color, 0.05 * noise(rng, size, 0.2) + 0.04 * noise(rng, size, 0.02))


def _tile(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    edge = np.minimum(np.abs((2 * x) % 1 - 0.5), np.abs((2 * y) % 1 - 0.5)) < 0.008
    each = rng.normal(0, 0.015, (2, 2)).repeat(size // 2 + 1, 0).repeat(size // 2 + 1, 1)[:size, :size]
    each = np.roll(each, size // 4, (0, 1))
    return lit(color, np.where(edge, -0.22, each) + 0.01 * noise(rng, size, 0.1))


def _planks(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    row = np.minimum((y * 10).astype(int), 9)
    joint = np.abs((x + row * 0.37) % 1 - 0.5) < 0.002
    tone = rng.normal(0, 0.06, 10)[row] + 0 * x
    gap = ((y * 10) % 1 < 0.03) | joint
    return np.asarray(wood(rng, size, color) * (1 + tone - 0.35 * gap)[..., None])


def _brushed(rng: np.random.Generator, size: int, color: Array) -> Array:
    return lit(color, 0.02 * noise(rng, size, 0.004, 0.8))


def _wicker(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    strand = np.abs(np.sin(6 * np.pi * (x + (np.floor(y * 6) % 2) / 6)) * np.sin(6 * np.pi * y))
    return lit(color, 0.4 * strand - 0.25 + 0.04 * noise(rng, size, 0.02))


def _cane(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    hole = (((4 * x) % 1 - 0.5) ** 2 + ((4 * y) % 1 - 0.5) ** 2) < 0.07
    return lit(color, np.where(hole, -0.55, 0.0) + 0.04 * noise(rng, size, 0.03))


PATTERNS: dict[str, Pattern] = {
    "wood": wood, "weave": _weave, "boucle": _boucle, "velvet": _velvet, "leather": _leather, "quilt": _quilt,
    "kilim": _kilim, "persian": _persian, "stripe": _stripe, "berber": _berber, "wicker": _wicker,
    "marble": _marble, "speckle": _speckle, "terrazzo": _terrazzo, "cloud": _cloud, "tile": _tile,
    "planks": _planks, "brushed": _brushed, "cane": _cane,
}  # fmt: skip

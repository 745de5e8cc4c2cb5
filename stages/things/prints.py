"""What pictures on walls show: hills, a shore, a meadow in dabs, sprigs, strokes of a brush; all of it tiles.

Each draws a square image, top row first, whose colours are on the whole the one it is given.
"""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.things.patterns import Array, Pattern, grid, noise

_HUES = {
    "hills": ((226, 214, 196), (206, 178, 160), (164, 152, 146), (112, 122, 122), (70, 88, 88), (44, 58, 60)),
    "shore": ((214, 222, 224), (232, 206, 178), (96, 138, 152), (58, 104, 124), (206, 188, 152)),
    "meadow": ((196, 208, 206), (122, 140, 84), (84, 108, 62), (196, 74, 56), (226, 190, 92), (232, 226, 206)),
    "sprigs": ((234, 228, 212), (74, 96, 70), (122, 134, 96), (168, 112, 84)),
    "strokes": ((228, 220, 206), (52, 66, 84), (190, 120, 82), (210, 176, 120), (140, 154, 150)),
}
"""Colours by print, from back to front."""


def _hues(name: str) -> list[Array]:
    return [np.array(hue, float) for hue in _HUES[name]]


def _even(image: Array, color: Array) -> Array:
    """The image with this colour for its mean."""
    return np.asarray(image + (color - image.mean((0, 1))))


def _over(image: Array, where: NDArray[np.floating], hue: Array) -> Array:
    """A hue laid over a share of every pixel."""
    share = np.clip(where, 0, 1)[..., None]
    return np.asarray(image * (1 - share) + hue * share)


def _about(size: int, a: float, b: float, far: float) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Rows (n, 1) and columns (1, m) of the pixels no farther than that from a place, the sides being one."""
    rows = np.arange(max(int((b - far) * size), 0), min(int((b + far) * size) + 2, size))
    return rows[:, None], np.arange(int((a - far) * size) - 1, int((a + far) * size) + 2)[None] % size


def _canvas(rng: np.random.Generator, size: int) -> Array:
    """What paint does on canvas: a brush's marks that lie across, (size, size, 1)."""
    return (3.0 * noise(rng, size, 0.012, 0.06))[..., None]


def _hills(rng: np.random.Generator, size: int, color: Array) -> Array:
    _, y = grid(size)
    low, *ridges = _hues("hills")
    sky = np.asarray(low - 40 * (1 - np.minimum(2 * y, 1))[..., None] * [0.6, 0.3, -0.2])
    image = np.broadcast_to(sky, (size, size, 3)).copy()
    for k, hue in enumerate(ridges):
        rough = noise(rng, size, 1.0, 0.22 / (1 + 0.35 * k))[:1] + 0.12 * noise(rng, size, 1.0, 0.03)[:1]
        top = 0.34 + 0.13 * k + 0.05 * rough
        below = (y - top) * size / 2 + 0.5
        image = _over(image, below, hue + 22 * np.clip(1 - (y - top) / 0.18, 0, 1)[..., None])
    return _even(image + _canvas(rng, size), color)


def _shore(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    high, low, far, near, sand = _hues("shore")
    share = np.clip(y / 0.42, 0, 1)[..., None]
    image = np.broadcast_to(high * (1 - share) + low * share, (size, size, 3)).copy()
    image = _over(image, 0.55 * np.clip(noise(rng, size, 0.03, 0.25), 0, 1.4) * (y < 0.42), high + 24)
    deep = np.clip((y - 0.42) / 0.4, 0, 1)[..., None]
    water = far * (1 - deep) + near * deep
    water = water + (26 * np.clip(noise(rng, size, 0.008, 0.09) - 0.6, 0, 1.2) * (0.3 + deep[..., 0]))[..., None]
    image = np.where((y >= 0.42)[..., None], water, image)
    edge = 0.8 + 0.025 * np.sin(2 * np.pi * x) + 0.02 * noise(rng, size, 1.0, 0.12)[:1]
    image = _over(image, (y - edge) * size / 2 + 0.5, sand)
    image = _over(image, np.exp(-(((y - edge) / 0.012) ** 2)), high + 20)
    return _even(image + _canvas(rng, size), color)


def _meadow(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    sky, light, dark, *flowers = _hues("meadow")
    grass = np.clip(0.5 + 0.35 * noise(rng, size, 0.05, 0.02), 0, 1)[..., None]
    line = 0.3 + 0.02 * noise(rng, size, 1.0, 0.15)[:1]
    image = np.broadcast_to(sky, (size, size, 3)) + 8 * noise(rng, size, 0.05, 0.2)[..., None]
    image = _over(image, (y - line) * size / 2 + 0.5, np.asarray(light * (1 - grass) + dark * grass))
    many = 150
    for a, b, kind in zip(rng.random(many), np.sort(rng.beta(1.6, 1.2, many)), rng.integers(3, size=many), strict=True):
        at, wide = 0.36 + 0.6 * b, 0.006 + 0.016 * b
        at_hand = _about(size, a, at, 2 * wide)
        u, v = x[0, at_hand[1]] - a, y[at_hand[0], 0] - at
        dab = ((u + 0.5) % 1 - 0.5) ** 2 + (v * 1.3) ** 2
        image[at_hand] = _over(image[at_hand], 1.6 - dab / (wide * wide), flowers[int(kind)] + rng.normal(0, 12))
    return _even(image + _canvas(rng, size), color)


def _sprigs(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    ground, *hues = _hues("sprigs")
    image = np.broadcast_to(ground, (size, size, 3)) + 2.5 * noise(rng, size, 0.02)[..., None]
    for k, foot in enumerate((0.26, 0.52, 0.76)):
        hue, lean = hues[k], rng.normal(0, 0.1)
        height = 0.6 + 0.22 * rng.random()
        for t in np.linspace(0.12, 1.0, 9):
            at, up = foot + lean * t * t, 0.92 - height * t
            for side in (-1, 1):
                angle, long = np.pi / 2 - side * (0.95 - 0.4 * t), 0.1 * (1.15 - 0.75 * t)
                at_hand = _about(size, at, up, 1.5 * long)
                u, v = (x[0, at_hand[1]] - at + 0.5) % 1 - 0.5, up - y[at_hand[0], 0]
                along = u * np.cos(angle) + v * np.sin(angle) - long / 2
                over = v * np.cos(angle) - u * np.sin(angle)
                leaf = 1 - (along / (long / 2)) ** 2 - (over / (0.3 * long)) ** 2
                shade = hue + rng.normal(0, 9) - 14 * (np.abs(over) < 0.0025)[..., None]
                image[at_hand] = _over(image[at_hand], 5 * leaf, shade)
        t = np.clip((0.92 - y) / height, 0, 1)
        stem = np.abs((x - foot - lean * t * t + 0.5) % 1 - 0.5)
        image = _over(image, (0.0045 - stem) * 400 * ((y < 0.92) & (0.92 - y < height)), hue - 25)
    return _even(image, color)


def _strokes(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    ground, *hues = _hues("strokes")
    image = np.broadcast_to(ground, (size, size, 3)) + 3 * noise(rng, size, 0.01)[..., None]
    for k in range(9):
        a, b, turn = rng.random(), rng.random(), rng.normal(0.25, 0.35)
        long, wide = 0.16 + 0.2 * rng.random(), 0.035 + 0.06 * rng.random()
        u, v = (x - a + 0.5) % 1 - 0.5, (y - b + 0.5) % 1 - 0.5
        along, over = u * np.cos(turn) + v * np.sin(turn), v * np.cos(turn) - u * np.sin(turn)
        ragged = along + 0.02 * noise(rng, size, 0.01, 0.3)
        bristles = 0.85 + 0.18 * np.sin(over / wide * 21 + noise(rng, size, 0.3)) * (0.4 + 0.6 * np.abs(along) / long)
        inside = np.clip((wide - np.abs(over)) * 160, 0, 1) * np.clip((long - np.abs(ragged)) * 90, 0, 1)
        image = _over(image, inside * bristles, hues[k % len(hues)] + rng.normal(0, 10))
    return _even(image, color)


PRINTS: dict[str, Pattern] = {
    "hills": _hills, "shore": _shore, "meadow": _meadow, "sprigs": _sprigs, "strokes": _strokes,
}

_MANY = {
    "hills": (5, (158, 157, 152)), "shore": (4, (169, 180, 175)), "meadow": (4, (142, 154, 118)),
    "sprigs": (6, (218, 211, 193)), "strokes": (5, (192, 180, 165)),
}
"""How many there are of each, and the colour of the first."""
_TINTS = ((0, 0, 0), (-14, 0, 14), (8, -4, -14), (-12, 4, -8), (6, -8, 4), (-6, -6, -4))

SHEETS: dict[str, tuple[str, tuple[int, int, int]]] = {
    f"{name}_{k + 1}": (name, (red + _TINTS[k][0], green + _TINTS[k][1], blue + _TINTS[k][2]))
    for name, (many, (red, green, blue)) in _MANY.items() for k in range(many)}
"""Every print by its material's name: its pattern and colour."""

"""What floors and walls are laid and papered with: herringbone, hexagons, chequers, bricks, leaves; all of it tiles."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.things.patterns import Array, Pattern, grid, lit, noise

_STAVE = 4
"""A herringbone's staves are so many times as long as wide; the pattern repeats after twice as many widths."""


def _herringbone(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    cells = 2 * _STAVE
    i, j = (np.floor(v * cells).astype(int) + np.zeros((size, size), int) for v in (x, y))
    k = (i - j) % cells
    level = k < _STAVE
    along = np.where(level, k, cells - 1 - k)
    row, start = np.where(level, j, i), (np.where(level, i, j) - along) % cells
    own = (row * cells + start) * 2 + level
    tone = rng.normal(0, 0.07, own.max() + 1)[own]
    across, run = np.where(level, y * cells % 1, x * cells % 1), np.where(level, x * cells % 1, y * cells % 1)
    gap = (across < 0.05) | ((along == 0) & (run < 0.05))
    grain = np.where(level, noise(rng, size, 0.01, 0.3), noise(rng, size, 0.3, 0.01))
    return lit(color, tone + 0.05 * grain - 0.32 * gap)


def _hexagons(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    columns, rows = 7, 8
    first, second = np.full((size, size), np.inf), np.full((size, size), np.inf)
    for a, b in [((c + 0.5 * (r % 2)) / columns, (r + 0.25) / rows) for r in range(rows) for c in range(columns)]:
        # No pixel's nearest two middles are as far away as two rows.
        u, v = (x[0] - a + 0.5) % 1 - 0.5, (y[:, 0] - b + 0.5) % 1 - 0.5
        near = np.ix_(np.abs(v) < 2 / rows, np.abs(u) < 2 / rows)
        far = np.hypot(u[near[1]], v[near[0]])
        second[near] = np.minimum(second[near], np.maximum(first[near], far))
        first[near] = np.minimum(first[near], far)
    joint = second - first < 0.016
    return lit(color, np.where(joint, -0.22, 0.02 * noise(rng, size, 0.08)))


def _chequers(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    dark = (np.floor(2 * x + 0.5) + np.floor(2 * y + 0.5)) % 2 == 1
    edge = np.minimum(np.abs((2 * x) % 1 - 0.5), np.abs((2 * y) % 1 - 0.5)) < 0.006
    return lit(color, np.where(edge, -0.15, np.where(dark, -0.42, 0.42)) + 0.02 * noise(rng, size, 0.1))


def _coursed(rows: int, columns: int, joint: float, depth: float, spread: float) -> Pattern:
    """Courses of stones that are shifted by half a stone, `joint` of a course's height apart."""

    def draw(rng: np.random.Generator, size: int, color: Array) -> Array:
        x, y = grid(size)
        row = np.floor(y * rows).astype(int)
        run = x * columns + 0.5 * (row % 2) + 0.25
        stone = (np.floor(run).astype(int) % columns) + columns * row
        across, share = (y * rows + 0.5) % 1, joint * columns / rows
        gap: NDArray[np.bool_] = (np.abs(across - 0.5) > 0.5 - joint / 2) | (run % 1 < share)
        tone = rng.normal(0, spread, rows * columns)[stone]
        return lit(color, np.where(gap, depth, tone) + 0.02 * noise(rng, size, 0.03))

    return draw


def _striped_paper(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, _ = grid(size)
    band = np.where((x * 4 % 1) < 0.5, 0.035, -0.035) + np.zeros((size, size))
    return lit(color, band + 0.008 * noise(rng, size, 0.02))


def _leaves(rng: np.random.Generator, size: int, color: Array) -> Array:
    x, y = grid(size)
    figure = np.zeros((size, size), bool)
    for a, b, turn in ((0.25, 0.25, 0.5), (0.75, 0.75, -0.5), (0.25, 0.75, 2.2), (0.75, 0.25, -2.2)):
        u, v = (x - a + 0.5) % 1 - 0.5, (y - b + 0.5) % 1 - 0.5
        for side in (-1, 1):
            for step in (-0.13, 0.0, 0.13):
                angle = turn + side * 0.7
                p, q = u - step * np.cos(turn), v - step * np.sin(turn)
                along, over = p * np.cos(angle) + q * np.sin(angle) - 0.06, q * np.cos(angle) - p * np.sin(angle)
                figure |= (along / 0.062) ** 2 + (over / 0.02) ** 2 < 1
    return lit(color, np.where(figure, -0.16, 0.03) + 0.008 * noise(rng, size, 0.02))


def _lime(rng: np.random.Generator, size: int, color: Array) -> Array:
    return lit(color, 0.018 * noise(rng, size, 0.3) + 0.012 * noise(rng, size, 0.05, 0.12))


LAID: dict[str, Pattern] = {
    "herringbone": _herringbone, "hexagons": _hexagons, "chequers": _chequers, "leaves": _leaves,
    "metro": _coursed(4, 2, 0.06, -0.2, 0.012), "bricks": _coursed(8, 2, 0.14, -0.16, 0.05),
    "striped_paper": _striped_paper, "lime": _lime,
}  # fmt: skip

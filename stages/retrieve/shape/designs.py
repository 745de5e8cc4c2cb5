"""Which pieces of the embedded library the autoencoder learns from, is tested on, and are indexed."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.retrieve.shape.fields import field
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.categories import CATEGORIES, TABLE

Size = tuple[float, float, float]

SEEDS = 2
"""Variants of each style that are indexed."""
SHARES = (-0.6, 0.0, 0.6)
"""Indexed sizes: the usual one, and this share of the way to the smallest and the largest."""


class Maker(Protocol):
    """What builds pieces to measure; `apartgen.stages.retrieve.furniture` is one."""

    def styles(self, category: str) -> tuple[str, ...]:
        """Styles of a category."""

    def build(self, category: str, style: str, size: Size, seed: int = 0) -> Asset:
        """A piece of exactly that size."""


def embedded_maker() -> Maker:
    """The embedded library's builder."""
    from apartgen.stages.retrieve import furniture

    maker: Maker = furniture
    return maker


class Design(NamedTuple):
    """One piece to build."""

    category: str
    style: str
    size: Size
    seed: int


def indexed(maker: Maker, categories: Iterable[str] = CATEGORIES) -> Iterator[Design]:
    """The designs of the index, in a fixed order."""
    for name in categories:
        kind = TABLE[name]
        usual, lo, hi = (np.asarray(side) for side in (kind.size, kind.min, kind.max))
        for style in maker.styles(name):
            for share in SHARES:
                size = usual + abs(share) * ((hi if share > 0 else lo) - usual)
                for seed in range(SEEDS):
                    yield Design(name, style, _rounded(size), seed)


def drawn(
    maker: Maker, variants: int, rng: np.random.Generator, categories: Iterable[str] = CATEGORIES
) -> Iterator[Design]:
    """`variants` designs of every style at sizes drawn log-uniformly from the category's range."""
    for name in categories:
        kind = TABLE[name]
        lo, hi = np.log(kind.min), np.log(kind.max)
        for style in maker.styles(name):
            for size in np.exp(rng.uniform(lo, hi, (variants, 3))):
                yield Design(name, style, _rounded(size), int(rng.integers(SEEDS)))


def _rounded(size: NDArray[np.float64]) -> Size:
    d, w, h = (round(float(side), 3) for side in size)
    return d, w, h


def fields(maker: Maker, designs: Iterable[Design]) -> NDArray[np.float32]:
    """Fields of the built designs, (n, FEATURES)."""
    return np.stack([field(maker.build(*design)) for design in designs])

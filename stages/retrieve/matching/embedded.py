"""The embedded library: the design comes from the nearest latent, the builder makes the size."""

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from schemas.errors import BadInput
from stages.asset import Asset
from stages.categories import TABLE
from stages.latents import Index, index
from stages.retrieve.matching.config import RetrieveConfig
from stages.retrieve.matching.table import Table

NAME = "parametric"


class Maker(Protocol):
    """What builds the pieces."""

    def build(self, category: str, style: str, size: tuple[float, float, float], seed: int = 0) -> Asset:
        """A piece of exactly that size."""

    def load(self, id: str) -> Asset:
        """The piece of that id."""


class Embedded:
    """Furniture made to measure."""

    def __init__(self, config: RetrieveConfig, table: Index | None = None, maker: Maker | None = None) -> None:
        """`table` and `maker` stand in for the shipped index and builder."""
        if maker is None:
            from stages.retrieve import furniture

            maker = furniture
        self._config, self._maker = config, maker
        self._index = index() if table is None else table
        self._table = Table(
            self._index.category, self._index.size, self._index.latent, np.ones(len(self._index.category), bool)
        )

    def load(self, id: str) -> Asset:
        """The piece of that id; BadInput when there is none."""
        return self._maker.load(id)

    def design(self, category: str, size: ArrayLike, latent: ArrayLike) -> tuple[str, int]:
        """Style and seed of the nearest indexed piece; size only decides between equal latents."""
        rows = self._table.rows(category)
        if rows is None:
            raise BadInput(f"the embedded library has no {category!r}; make its index anew with `apartgen train shape`")
        loose = self._config.model_copy(update={"size_weight": self._config.size_weight * 0.01})
        best = int(rows.row[int(np.argmin(self._table.costs(category, size, latent, loose)))])
        return self._index.style[best], int(self._index.seed[best])

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None
    ) -> Asset | None:
        """A piece of the nearest design at `size`, brought into the category's range and under `limit`."""
        kind = TABLE[category]
        wanted = np.clip(np.asarray(size, float), kind.min, kind.max)
        if limit is not None:
            wanted = np.minimum(wanted, limit)
            if (wanted < np.asarray(kind.min) - 1e-6).any():
                return None
        return self.make(category, wanted, latent)

    def make(self, category: str, size: ArrayLike, latent: ArrayLike) -> Asset:
        """A piece of the nearest design of exactly this size, rounded down to whole millimetres."""
        style, seed = self.design(category, size, latent)
        return self._maker.build(category, style, millimetres(np.asarray(size, float).tolist()), seed=seed)


def millimetres(size: Sequence[float]) -> tuple[float, float, float]:
    """Sizes rounded down to whole millimetres, so that an id can hold them and nothing outgrows its box."""
    d, w, h = (max(math.floor(side * 1000 + 1e-6), 1) / 1000 for side in size)
    return d, w, h

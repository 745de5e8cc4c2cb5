"""The embedded library: the design comes from the nearest latent, the builder makes the size."""

import logging
import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from apartgen.schemas.errors import BadInput, Unknown
from apartgen.stages.retrieve.matching import hands
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.table import Table
from apartgen.stages.things.asset import Array, Asset
from apartgen.stages.things.categories import TABLE, unknown
from apartgen.stages.things.latents import Index, index

log = logging.getLogger("apartgen")
NAME = hands.MADE


class Maker(Protocol):
    """What builds the pieces."""

    def build(
        self, category: str, style: str, size: tuple[float, float, float], seed: int = 0, right: bool = False
    ) -> Asset:
        """A piece of exactly that size; what is handed has its leaf hung on the left or `right`."""

    def load_asset(self, id: str) -> Asset:
        """The piece of that id."""


class Embedded:
    """Furniture made to measure."""

    def __init__(self, config: RetrieveConfig, table: Index | None = None, maker: Maker | None = None) -> None:
        """`table` and `maker` stand in for the shipped index and builder."""
        if maker is None:
            from apartgen.stages.retrieve import furniture

            maker = furniture
        self._maker = maker
        self._loose = config.model_copy(update={"size_weight": 0.01 * config.size_weight})
        self._whole = set(TABLE) if table is not None else set[str]()
        self._given = table

    @cached_property
    def _index(self) -> Index:
        """Read when it is first asked what there is: whoever only fetches pieces by id needs none of it."""
        return index() if self._given is None else self._given

    @cached_property
    def _latents(self) -> dict[tuple[str, str, int], Array]:
        return _means(self._index)

    @cached_property
    def _table(self) -> Table:
        own = self._index
        return Table(own.category, own.size, own.latent, np.ones(len(own.category), bool))

    def _take(self, table: Index) -> None:
        self._index, self._latents = table, _means(table)
        self._table = Table(table.category, table.size, table.latent, np.ones(len(table.category), bool))

    def _complete(self, category: str) -> None:
        """Sees to it that the index has every design of a category."""
        if category in self._whole or category not in TABLE:
            return
        self._whole.add(category)
        from apartgen.stages.retrieve import furniture

        known = self.styles(category)
        if new := [style for style in furniture.styles(category) if style not in known]:
            from apartgen.stages.retrieve.matching import newcomers

            found, wrong = newcomers.sound(furniture, category, new)
            if wrong and not (known or found):
                raise wrong[0]
            for error in wrong:
                log.warning("%s; this style is left out", error)
            for table in found:
                self._take(newcomers.joined(self._index, table))

    def load_asset(self, id: str) -> Asset:
        """The piece of that id; BadInput when there is none."""
        return self._maker.load_asset(id)

    def styles(self, category: str) -> frozenset[str]:
        """Styles that a category comes in."""
        self._complete(category)
        return frozenset(s for s, c in zip(self._index.style, self._index.category, strict=True) if c == category)

    def design(self, category: str, id: str) -> tuple[str, int] | None:
        """Style and seed of a piece by its id; None where the index has no such design of the category."""
        self._complete(category)
        match id.split("/"):
            case [name, style, _, seed, *_] if seed.isdecimal() and (name, style, int(seed)) in self._latents:
                return (style, int(seed)) if name == category else None
        return None

    def costs(self, category: str, size: ArrayLike, latent: ArrayLike) -> dict[tuple[str, int], float]:
        """Cost of each design of a category, by style and seed; size only decides between equal latents."""
        self._complete(category)
        rows = self._table.rows(category)
        if rows is None:
            raise BadInput(f"the embedded library has no {category!r}; make its index anew with `apartgen train shape`")
        cost = self._table.costs(category, size, latent, self._loose)
        found: dict[tuple[str, int], float] = {}
        for row, value in zip(rows.row.tolist(), cost.tolist(), strict=True):
            design = self._index.style[row], int(self._index.seed[row])
            found[design] = min(value, found.get(design, np.inf))
        return found

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None,
        design: tuple[str, int] | None = None, right: bool = False,
    ) -> Asset | None:  # fmt: skip
        """A piece at `size`, brought into the category's range and under `limit`, of a given or the nearest design; its
        leaf is on the left or `right` if it is handed."""
        if category not in TABLE:
            raise Unknown(unknown(category))
        kind = TABLE[category]
        wanted = np.clip(np.asarray(size, float), kind.min, kind.max)
        if limit is not None:
            wanted = np.minimum(wanted, limit)
            if (wanted < np.asarray(kind.min) - 1e-6).any():
                return None
        if design is None:
            costs = self.costs(category, wanted, latent)
            design = min(costs, key=lambda one: (costs[one], one))
        self._complete(category)
        style, seed = design
        size = millimetres(wanted.tolist())
        # Only a maker of what is handed need know of hands.
        made = (self._maker.build(category, style, size, seed=seed, right=True) if right and kind.handed
                else self._maker.build(category, style, size, seed=seed))
        return replace(made, latent=self._latents[category, style, seed])


def _means(table: Index) -> dict[tuple[str, str, int], Array]:
    """Each design's latent, the mean over its indexed sizes."""
    rows: dict[tuple[str, str, int], list[int]] = {}
    for i, key in enumerate(zip(table.category, table.style, table.seed.tolist(), strict=True)):
        rows.setdefault(key, []).append(i)
    return {key: table.latent[own].mean(0) for key, own in rows.items()}


def millimetres(size: Sequence[float]) -> tuple[float, float, float]:
    """Sizes rounded down to whole millimetres, so that an id can hold them and nothing outgrows its box."""
    d, w, h = (max(math.floor(side * 1000 + 1e-6), 1) / 1000 for side in size)
    return d, w, h

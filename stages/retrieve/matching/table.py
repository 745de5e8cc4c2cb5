"""Assets as arrays, grouped by category, so that a query is one pass over its own category."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.things.categories import TABLE

Array = NDArray[np.float32]

SIZE_SCALE = 0.2
"""A side this many natural units (about 20 %) off costs as much as one standard deviation of latent."""
SLACK = 1e-4
"""Sides within 0.1 mm are equal, m."""


@dataclass(frozen=True)
class Rows:
    """Assets of one category: `row` (k) numbers them in their library; sizes are kept side by side (3, k)."""

    row: NDArray[np.int64]
    size: Array
    log_size: Array
    latent: Array
    square: Array
    static: NDArray[np.bool_]


class Table:
    """Per-category arrays over a library's assets."""

    def __init__(self, category: Sequence[str], size: ArrayLike, latent: ArrayLike, moving: ArrayLike) -> None:
        """`category` (n), `size` (n, 3) metres, `latent` (n, 32), `moving` (n) whether it has a joint."""
        names, label = np.unique(np.asarray(category, dtype=np.str_), return_inverse=True)
        sizes, latents = np.asarray(size, np.float32).reshape(-1, 3), np.asarray(latent, np.float32).reshape(-1, 32)
        still = ~np.asarray(moving, bool)
        self._groups: dict[str, Rows] = {}
        for i, name in enumerate(names):
            own = np.flatnonzero(label == i)
            side, z = np.ascontiguousarray(sizes[own].T), latents[own]
            self._groups[str(name)] = Rows(own, side, np.log(side), z, (z * z).sum(1), still[own])

    def rows(self, category: str) -> Rows | None:
        """The assets of a category."""
        return self._groups.get(category)

    def costs(
        self, category: str, size: ArrayLike, latent: ArrayLike, config: RetrieveConfig,
        among: NDArray[np.int64] | slice = slice(None),
    ) -> Array:  # fmt: skip
        """Cost of the category's assets, or those `among` them, as `RetrieveConfig` says; no latent costs nothing."""
        rows = self._groups[category]
        off = (rows.log_size[:, among] - np.log(np.asarray(size, np.float32))[:, None]) / SIZE_SCALE
        cost = config.size_weight * (off * off).sum(0)
        z = np.asarray(latent, np.float32)
        if z.size:
            distance = rows.square[among] - 2 * (rows.latent[among] @ z) + z @ z
            cost += config.latent_weight * np.maximum(distance, 0) / z.size
        if TABLE[category].articulated:
            cost += config.static_cost * rows.static[among]
        return np.asarray(cost, np.float32)

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None, config: RetrieveConfig
    ) -> tuple[int, float] | None:
        """Row and cost of the cheapest asset within tolerance of `size`, no side above `limit`; None if none is."""
        rows = self._groups.get(category)
        if rows is None:
            return None
        wanted = np.asarray(size, np.float32)
        top = (wanted * (1 + config.tolerance) if limit is None else np.asarray(limit, np.float32)) + SLACK
        least = np.minimum(wanted, top) * (1 - config.tolerance) - SLACK
        fits = np.ones(len(rows.row), bool)
        for side, low, high in zip(rows.size, least, top, strict=True):
            fits &= (side >= low) & (side <= high)
        among = np.flatnonzero(fits)
        if not len(among):
            return None
        cost = self.costs(category, size, latent, config, among)
        best = int(np.argmin(cost))
        return int(rows.row[among[best]]), float(cost[best])

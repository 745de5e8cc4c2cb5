"""Assets as arrays, grouped by category, so that a query is one pass over its own category."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stages.categories import TABLE
from stages.retrieve.matching.config import RetrieveConfig

Array = NDArray[np.float32]

SIZE_SCALE = 0.2
"""A side this many natural units (about 20 %) off costs as much as one standard deviation of latent."""
SLACK = 1e-4
"""Sides within 0.1 mm are equal, m."""


@dataclass(frozen=True)
class Rows:
    """Assets of one category: `row` numbers them in their library, the rest is what a query looks at."""

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
        names = np.asarray(category, dtype=np.str_)
        sizes, latents = np.asarray(size, np.float32).reshape(-1, 3), np.asarray(latent, np.float32).reshape(-1, 32)
        still = ~np.asarray(moving, bool)
        self._groups: dict[str, Rows] = {}
        order = np.argsort(names, kind="stable")
        for group in np.split(order, np.flatnonzero(np.diff(np.unique(names[order], return_inverse=True)[1])) + 1):
            if len(group):
                own, z = sizes[group], latents[group]
                self._groups[str(names[group[0]])] = Rows(group, own, np.log(own), z, (z * z).sum(1), still[group])

    def rows(self, category: str) -> Rows | None:
        """The assets of a category."""
        return self._groups.get(category)

    def costs(self, category: str, size: ArrayLike, latent: ArrayLike, config: RetrieveConfig) -> Array:
        """Cost (k,) of each asset of the category, as `RetrieveConfig` defines it; an empty latent costs nothing."""
        rows = self._groups[category]
        off = (rows.log_size - np.log(np.asarray(size, np.float32))) / SIZE_SCALE
        cost = config.size_weight * np.einsum("ij,ij->i", off, off)
        z = np.asarray(latent, np.float32)
        if z.size:
            cost += config.latent_weight * np.maximum(rows.square - 2 * (rows.latent @ z) + z @ z, 0) / z.size
        if TABLE[category].articulated:
            cost += config.static_cost * rows.static
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
        fits = ((rows.size <= top) & (rows.size >= least)).all(1)
        if not fits.any():
            return None
        cost = np.where(fits, self.costs(category, size, latent, config), np.inf)
        best = int(np.argmin(cost))
        return int(rows.row[best]), float(cost[best])

"""A library that remembers what it made, because repairs ask for the same again and again."""

from collections.abc import Hashable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from apartgen.stages.things.asset import Asset
from apartgen.stages.walkable.site import Candidates


class Kept:
    """The answers of a library, kept for one apartment."""

    def __init__(self, library: Candidates) -> None:
        self._library = library
        self._nearest: dict[Hashable, Asset | None] = {}
        self._designs: dict[Hashable, list[Asset]] = {}
        self._made: dict[tuple[str, str], Asset] = {}

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None, like: str = ""
    ) -> Asset | None:
        """See `Candidates`."""
        key = category, _key(size), _key(latent), None if limit is None else _key(limit), like
        if key not in self._nearest:
            self._nearest[key] = self._remembered(self._library.nearest(category, size, latent, limit, like))
        return self._nearest[key]

    def alternatives(self, category: str, size: ArrayLike, latent: ArrayLike, like: str = "") -> Iterator[Asset]:
        """See `Candidates`."""
        key = category, _key(size), _key(latent), like
        if key not in self._designs:
            self._designs[key] = list(self._library.alternatives(category, size, latent, like))
            for asset in self._designs[key]:
                self._remembered(asset)
        return iter(self._designs[key])

    def load_asset(self, library: str, id: str) -> Asset:
        """See `Candidates`."""
        if (library, id) not in self._made:
            self._made[library, id] = self._library.load_asset(library, id)
        return self._made[library, id]

    def _remembered(self, asset: Asset | None) -> Asset | None:
        if asset is not None:
            self._made[asset.library, asset.id] = asset
        return asset


def _key(values: ArrayLike) -> tuple[float, ...]:
    return tuple(np.asarray(values, float).tolist())

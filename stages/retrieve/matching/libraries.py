"""Several asset libraries at once."""

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from numpy.typing import ArrayLike

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.matching import embedded, hands
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.embedded import Embedded
from apartgen.stages.retrieve.matching.indexed import TABLE_FILE, IndexedLibrary
from apartgen.stages.things.asset import Asset

KEPT = 512
"""Assets kept in memory."""
AT_ONCE = 4
"""Sets of libraries kept open."""


class LibrarySet:
    """The embedded library and those a user has indexed; the first named wins a tie."""

    def __init__(self, own: Embedded, others: list[IndexedLibrary]) -> None:
        self.embedded = own
        self.others = {library.name: library for library in others}
        if len(self.others) < len(others) or embedded.NAME in self.others:
            raise BadInput(f"two libraries share a name: {sorted([embedded.NAME, *(o.name for o in others)])}")
        self.load_asset = lru_cache(maxsize=KEPT)(self._load)

    def _load(self, library: str, id: str) -> Asset:
        """The asset of a library by id; BadInput when there is none."""
        if library == embedded.NAME:
            return self.embedded.load_asset(id)
        if library not in self.others:
            known = ", ".join([embedded.NAME, *self.others])
            raise BadInput(f"asset library {library!r} is not open (open: {known}); give its folder with --library")
        return self.others[library].load_asset(id)

    def owned(self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None) -> Asset | None:
        """The cheapest asset that fits of the libraries a user has indexed; None where none does."""
        others = list(self.others.values())
        hits = [(other.nearest(category, size, latent, limit), i) for i, other in enumerate(others)]
        found = [(hit[1], i, hit[0]) for hit, i in hits if hit is not None]
        if not found:
            return None
        _, which, row = min(found)
        return others[which].at(row)

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None, like: str = ""
    ) -> Asset | None:
        """The cheapest asset of all libraries that fits, else one made to measure; None if even that is too big.

        What is made to measure has the design of `like`, where that is the id of such a piece.
        """
        own = self.owned(category, size, latent, limit)
        design = self.embedded.design(category, like)
        return own or self.embedded.nearest(category, size, latent, limit, design, hands.on_the_right(like))

    def alternatives(self, category: str, size: ArrayLike, latent: ArrayLike, like: str = "") -> Iterator[Asset]:
        """Every design made to measure at that size, the one closest in latent first, opening to the side of `like`."""
        costs = self.embedded.costs(category, size, latent)
        for design in sorted(costs, key=lambda one: (costs[one], one)):
            made = self.embedded.nearest(category, size, latent, size, design, hands.on_the_right(like))
            if made is not None:
                yield made


def open_libraries(config: RetrieveConfig | None = None) -> LibrarySet:
    """The libraries a configuration names, ready to search and load from."""
    config = config or RetrieveConfig()
    return LibrarySet(Embedded(config), [IndexedLibrary(Path(folder), config) for folder in config.libraries])


def shared_libraries(config: RetrieveConfig | None = None) -> LibrarySet:
    """As `open_libraries`, but once for all homes of a process; a library indexed anew is opened anew.

    What is remembered of assets by their loader, here and in later stages, serves the next home instead of piling up.
    """
    config = config or RetrieveConfig()
    tables = [Path(folder) / TABLE_FILE for folder in config.libraries]
    written = tuple(table.stat().st_mtime_ns if table.exists() else 0 for table in tables)
    return _shared(config.model_dump_json(), written)


@lru_cache(maxsize=AT_ONCE)
def _shared(config: str, _written: tuple[int, ...]) -> LibrarySet:
    return open_libraries(RetrieveConfig.model_validate_json(config))

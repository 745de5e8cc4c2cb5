"""Who does the work of a data set: this machine's cores, a Ray cluster, or jobs of a scheduler.

An engine is a function as `pool.results`, which gives the results in the order of the work whoever dies; it may keep
files in a folder that all machines see.
"""

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Protocol, TypeVar

from apartgen.dataset import on_ray, on_submitit, pool
from apartgen.schemas.errors import BadInput

Work = TypeVar("Work")
Result = TypeVar("Result")


class Engine(Protocol):
    """What an engine's module has."""

    def results(self, function: Callable[[Work], Result], work: Iterable[Work], workers: int | None,
                lost: Callable[[Work], Result], folder: Path) -> Iterator[Result]:
        """What the function gives for each piece, in order; `lost(piece)` for one that its worker does not survive."""


class _Local:
    """Processes of this machine."""

    @staticmethod
    def results(function: Callable[[Work], Result], work: Iterable[Work], workers: int | None,
                lost: Callable[[Work], Result], folder: Path) -> Iterator[Result]:
        """As `pool.results`."""
        return pool.results(function, work, pool.cores(workers), lost)


LOCAL = "local"
ENGINES: dict[str, Engine] = {LOCAL: _Local(), "ray": on_ray, "submitit": on_submitit}


def engine(name: str) -> Engine:
    """BadInput for one that there is none of."""
    if name not in ENGINES:
        raise BadInput(f"--engine {name}: there are: {', '.join(ENGINES)}")
    return ENGINES[name]

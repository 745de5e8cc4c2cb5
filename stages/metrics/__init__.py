"""Figures of merit, one module each, found by name.

A member has `measure(home, against=None) -> list[Value]` for one apartment, or `compare(homes, real) -> list[Value]`
for a set of apartments against real ones (those of images take a `network`, too), or both. `published` versions
compute a figure as its source's code does.
"""

import logging
from collections.abc import Callable, Sequence
from functools import cache, partial
from inspect import signature
from pathlib import Path
from types import ModuleType
from typing import Any

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Metrics, Value
from apartgen.schemas.plan import Plan, Program
from apartgen.schemas.populate import without_things
from apartgen.stages import registry
from apartgen.stages.metrics import _networks, _seen, _sets
from apartgen.stages.metrics._beside import beside
from apartgen.stages.metrics._table import Row, markdown, side_by_side, table
from apartgen.stages.registry import contract

LOG = logging.getLogger("apartgen")
__all__ = ["Row", "compare", "markdown", "names", "run", "side_by_side", "table"]


def names() -> dict[str, str]:
    """Every metric and its one line of help."""
    return registry.members(__name__)


def run(home: Plan, names: Sequence[str] | None = None, against: Plan | Program | None = None) -> Metrics:
    """Measure one apartment's furniture by the named metrics, all that apply by default.

    `against` is the programme or plan the rooms are compared with, the apartment's own programme by default.
    Raises BadInput for an unknown metric, and for a named one that needs what the artifact does not hold; another
    package's that fails is left out with a warning where it was not named.
    """
    home = without_things(home)
    one = partial(_measure, home=home, against=against)
    return Metrics(values=[value for name in _chosen(home, names) for value in _given(name, one, names is not None)])


@cache
def _member(name: str) -> ModuleType:
    return registry.load(__name__, name)


@cache
def _sound() -> dict[str, ModuleType]:
    return registry.sound(__name__)


def _able(function: str) -> tuple[str, ...]:
    """The members that have a function of that name."""
    return tuple(name for name, member in _sound().items() if hasattr(member, function))


def _given(name: str, figures: Callable[[str], list[Value]], asked: bool) -> list[Value]:
    """The figures of a metric; none, and a warning, where another package's fails that nobody `asked` for by name."""
    try:
        return figures(name)
    except BadInput as error:
        if asked or registry.bringer(__name__, name) is None:
            raise
        LOG.warning("%s", error)
        return []


def _measure(name: str, home: Plan, against: Plan | Program | None) -> list[Value]:
    found = _figures(name, "measure", _member(name).measure(home, against))
    there = ["apartment", *(room.id for room in home.rooms)]
    if strange := [value.of for value in found if value.of not in there]:
        fault = f"measure gave a value of {strange[0]!r}; of is one of {', '.join(there)}"
        raise BadInput(registry.told(__name__, name, fault, "metric"))
    return found


def _figures(name: str, called: str, given: Any) -> list[Value]:
    """What a metric gave; BadInput, with its name, for what are no figures with names."""
    fault = contract.unfit(given, list[Value])
    found: list[Value] = [] if fault else given
    if not all(value.name for value in found):
        fault = "gave a value without a name; give it one, by which it is written"
    if fault:
        raise BadInput(registry.told(__name__, name, f"{called} {fault}", "metric"))
    return found


def _chosen(home: Plan, wanted: Sequence[str] | None) -> list[str]:
    if wanted is None:
        return [name for name in _able("measure") if isinstance(home, _member(name).NEEDS)]
    for name in wanted:
        if not hasattr(_member(name), "measure"):
            raise BadInput(f"metric {name!r} compares a set of apartments with real ones; it says nothing of one")
        if not isinstance(home, _member(name).NEEDS):
            raise BadInput(f"metric {name!r} needs objects, which a plan has not; give a layout or a later artifact")
    return list(wanted)


def _of_rooms(name: str) -> bool:
    """Whether a metric measures the furniture of single rooms and has no comparison of sets of its own."""
    return not hasattr(_member(name), "compare") and _member(name).NEEDS is Layout


def _comparing() -> tuple[str, ...]:
    """The members that compare sets."""
    return (*_able("compare"), *(name for name in _able("measure") if _of_rooms(name)))


def compare(
    homes: Sequence[Layout], real: Sequence[Layout], names: Sequence[str] | None = None, inception: Path | None = None
) -> Metrics:
    """Measure a set of apartments against a set of real ones by the named metrics, all by default.

    What is of single rooms is given as means over the rooms of either set. Image metrics take the Inception-v3
    weights of `inception`, else the packaged network; by default they are left out where there is neither.
    """
    able = tuple(names or _comparing())
    if unfit := [name for name in able if not (hasattr(_member(name), "compare") or _of_rooms(name))]:
        raise BadInput(f"metric {unfit[0]!r} does not compare sets; those that do: {', '.join(_comparing())}")
    if not homes or not real:
        raise BadInput("comparing sets needs at least one apartment on either side")
    seeing = [name for name in able
              if not _of_rooms(name) and "network" in signature(_member(name).compare).parameters]
    if names is None and inception is None and not _networks.installed():
        LOG.warning("%s left out: %s", ", ".join(seeing), _networks.MISSING)
        able, seeing = tuple(name for name in able if name not in seeing), []
    network = _networks.network(inception) if seeing else None
    extra = {name: {"network": network} for name in seeing}

    def one(name: str) -> list[Value]:
        if _of_rooms(name):
            return beside(partial(_measure, name, against=None), homes, real)
        return _figures(name, "compare", _member(name).compare(homes, real, **extra.get(name, {})))

    values = [value for name in able for value in _given(name, one, bool(names))]
    return Metrics(values=values, notes=[_sets.NOTE, *([_seen.note(network)] if network else [])])

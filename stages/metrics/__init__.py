"""Figures of merit, one module each, found by name.

A member has `measure(home, against=None) -> list[Value]` for one apartment, or `compare(homes, real) -> list[Value]`
for a set of apartments against real ones, or both. `published` versions compute a figure as its source's code does.
"""

from collections.abc import Sequence
from functools import cache
from types import ModuleType

from schemas.errors import BadInput
from schemas.layout import Layout
from schemas.metrics import Metrics, Value
from schemas.plan import Plan, Program
from stages import registry
from stages.metrics._table import Row, markdown, side_by_side, table

__all__ = ["Row", "compare", "markdown", "names", "run", "side_by_side", "table"]


def names() -> dict[str, str]:
    """Every metric and its one line of help."""
    return registry.members(__name__)


def run(home: Plan, names: Sequence[str] | None = None, against: Plan | Program | None = None) -> Metrics:
    """Measure one apartment by the named metrics, all that apply by default.

    `against` is the programme or plan the rooms are compared with, the apartment's own programme by default.
    Raises BadInput for an unknown metric, and for a named one that needs what the artifact does not hold.
    """
    return Metrics(values=[value for name in _chosen(home, names) for value in _measure(name, home, against)])


@cache
def _member(name: str) -> ModuleType:
    return registry.load(__name__, name)


@cache
def _able(function: str) -> tuple[str, ...]:
    """The members that have a function of that name."""
    return tuple(name for name in names() if hasattr(_member(name), function))


def _measure(name: str, home: Plan, against: Plan | Program | None) -> list[Value]:
    found: list[Value] = _member(name).measure(home, against)
    return found


def _chosen(home: Plan, wanted: Sequence[str] | None) -> list[str]:
    fits = [name for name in _able("measure") if isinstance(home, _member(name).NEEDS)]
    if wanted is None:
        return fits
    for name in wanted:
        if not hasattr(_member(name), "measure"):
            raise BadInput(f"metric {name!r} compares a set of apartments with real ones; it says nothing of one")
        if name not in fits:
            raise BadInput(f"metric {name!r} needs objects, which a plan has not; give a layout or a later artifact")
    return list(wanted)


def compare(homes: Sequence[Layout], real: Sequence[Layout], names: Sequence[str] | None = None) -> Metrics:
    """Measure a set of apartments against a set of real ones by the named metrics, all by default."""
    able = _able("compare")
    unfit = [name for name in names or [] if name not in able]
    if unfit:
        raise BadInput(f"metric {unfit[0]!r} does not compare sets; those that do: {', '.join(able)}")
    if not homes or not real:
        raise BadInput("comparing sets needs at least one apartment on either side")
    chosen = able if names is None else names
    return Metrics(values=[value for name in chosen for value in _member(name).compare(homes, real)])

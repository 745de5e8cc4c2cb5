"""Which of several furnishings of a room is best: the one of least energy, a sum of terms, one a file.

A term is `cost(room) -> float`, at least 0, of a furnished room (`apartgen.stages.use.Furnished`); `WEIGHTS` says how
much each counts, 1 where it does not.
"""

from collections.abc import Iterable, Sequence
from functools import cache
from math import inf
from types import ModuleType

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen.stages.use import Furnished, of_plan

WEIGHTS = {"faults": 1.0, "contents": 1.0, "neighbours": 1.0, "likeness": 1.0, "axes": 1.0, "crowding": 1.0,
           "distances": 1.0}


@cache
def terms() -> dict[str, ModuleType]:
    """Every term by name."""
    return {name: registry.load(__name__, name) for name in registry.members(__name__)}


def cost(plan: Plan, room_id: str, objects: Iterable[Box]) -> float:
    """The energy of a room of a plan with those of the objects that are in it; 0 is a room with nothing to wish for."""
    return energy(of_plan(plan, room_id, objects))


def energy(room: Furnished) -> float:
    """The sum of all terms."""
    return sum(WEIGHTS.get(name, 1.0) * value for name, value in parts(room).items())


def parts(room: Furnished) -> dict[str, float]:
    """Every term by name, unweighted."""
    return {name: _cost(name, term, room) for name, term in terms().items()}


def _cost(name: str, term: ModuleType, room: Furnished) -> float:
    value: float = term.cost(room)
    if not 0 <= value < inf:
        fault = f"cost gave {value:g} for {room.site.id}; it is to be a number from 0 on"
        plugin = registry.bringer(__name__, name)
        raise BadInput(plugin.told(fault) if plugin else f"{name}: {fault}")
    return value


def best(plan: Plan, room_id: str, candidates: Sequence[Sequence[Box]]) -> int:
    """Index of the furnishing of least energy, the first of equals."""
    return min(range(len(candidates)), key=lambda k: cost(plan, room_id, candidates[k]))

"""How people use furniture: faults of a furnished room by name, and what it lacks for those who live there."""

from collections.abc import Iterator
from functools import cache
from types import ModuleType

from apartgen.stages import registry
from apartgen.stages.use.fault import Fault, activities, weights
from apartgen.stages.use.room import Furnished, of_plan
from apartgen.stages.use.site import alone, site
from apartgen.stages.use.wants import Lack, arrivals, belongings, eat_together, lacks, lacks_of

__all__ = [
    "Fault", "Furnished", "Lack", "activities", "alone", "arrivals", "belongings", "eat_together", "faults", "lacks",
    "lacks_of", "of_plan", "site", "weights",
]


@cache
def rules() -> dict[str, ModuleType]:
    """The rules of every activity, by its name."""
    package = f"{__name__}.rules"
    return {name: registry.load(package, name) for name in registry.members(package)}


def faults(room: Furnished, but: tuple[str, ...] = ()) -> Iterator[Fault]:
    """All faults of a room, those of activities `but` left out."""
    for name, rule in rules().items():
        if name not in but:
            yield from rule.faults(room)

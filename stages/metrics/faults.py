"""Faults of use: furniture that nobody could use where it stands, by room and by name."""

from collections import Counter
from collections.abc import Iterable

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages import use
from apartgen.stages.metrics._shares import objects

NEEDS = Layout
APART = {"stand": "bodies", "neighbours": "neighbours"}
"""Activities of a version of their own; `use` has all others."""
VERSIONS = ("use", *APART.values())
FAULT = "fault/"
"""Begins the names of single faults, of rooms that have them."""


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Faults of every room, and of the apartment the mean over its furnished rooms.

    Versions: use = furniture that is of no use where it stands · bodies = what stands in something else, in a wall or
    in a doorway · neighbours = what minds the doors and windows. Of rooms also fault/NAME: how often they have it.
    """
    things = objects(home)
    found = {room.id: use.of_plan(home, room.id, things) for room in home.rooms}
    named = {id: list(use.faults(room)) for id, room in found.items() if room.objects}
    counts = {id: Counter(version(fault) for fault in faults) for id, faults in named.items()}
    whole = [_value("faults", _mean([count[v] for count in counts.values()]), v, "apartment") for v in VERSIONS]
    rooms = [_value("faults", count[v], v, id) for id, count in counts.items() for v in VERSIONS]
    each = [_value(FAULT + name, number, "ours", id) for id, faults in named.items()
            for name, number in Counter(fault.name for fault in faults).items()]
    return [*whole, *rooms, *each]


def version(fault: use.Fault) -> str:
    """Under which version a fault is counted."""
    return APART.get(use.activities()[fault.name], "use")


def _value(name: str, value: float | None, version: str, of: str) -> Value:
    return Value(name=name, value=value, unit="faults", version=version, of=of)


def _mean(numbers: Iterable[int]) -> float | None:
    values = list(numbers)
    return sum(values) / len(values) if values else None

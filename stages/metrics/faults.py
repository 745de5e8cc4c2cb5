"""Faults of use: furniture that nobody could use where it stands, by room and by name."""

from collections import Counter
from collections.abc import Sequence

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages import use
from apartgen.stages.metrics._named import Told, compared
from apartgen.stages.metrics._shares import crowded, objects
from apartgen.stages.metrics._table import FAULT

NEEDS = Layout
APART = {"stand": "bodies", "neighbours": "neighbours"}
"""Activities of a version of their own; `use` has all others."""
VERSIONS = ("use", *APART.values())


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Faults of every room, and of the apartment the mean over its furnished rooms.

    None of rooms, and so of the apartment, that are too crowded to tell.
    Versions: use = furniture that is of no use where it stands · bodies = what stands in something else, in a wall or
    in a doorway · neighbours = what minds the doors and windows. Of rooms also fault/NAME: how often they have it.
    """
    things = objects(home)
    furnished, crowds = {o.room for o in things}, crowded(things)
    rooms = {room.id: _told(home, room.id) for room in home.rooms if room.id in furnished - crowds}
    known = bool(rooms) and not crowds
    means = {v: sum(told["faults", v] for told in rooms.values()) / len(rooms) if known else None for v in VERSIONS}
    whole = [Value(name="faults", value=mean, unit="faults", version=v) for v, mean in means.items()]
    return [*whole, *(Value(name=name, value=number, unit="faults", version=v, of=id)
                      for id, told in rooms.items() for (name, v), number in told.items())]


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """Faults a room in two sets, in all and by type; real rooms without openings have none with neighbours."""
    return compared(_told, "faults", homes, real)


def version(fault: use.Fault) -> str:
    """Under which version a fault is counted."""
    return APART.get(use.activities()[fault.name], "use")


def _told(home: Plan, room: str) -> Told:
    found = list(use.faults(use.of_plan(home, room, objects(home))))
    counts = Counter(version(fault) for fault in found)
    whole = {("faults", v): float(counts[v]) for v in VERSIONS}
    return whole | {(FAULT + name, "ours"): float(n) for name, n in Counter(fault.name for fault in found).items()}

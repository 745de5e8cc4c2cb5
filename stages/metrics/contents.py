"""Contents: what those who live there miss in a room, and what it has too much of."""

from collections.abc import Sequence

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages import use
from apartgen.stages.metrics._named import Told, compared
from apartgen.stages.metrics._shares import crowded, objects
from apartgen.stages.metrics._table import LACK

NEEDS = Layout
UNITS = {"number": "things", "cost": "faults", "ours": "things"}


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """What every room lacks, and of the apartment the mean over its rooms.

    None of rooms, and so of the apartment, that are too crowded to tell.
    Versions: number = how many things are wanted or too much · cost = what going without them costs, 1 being a piece
    of furniture of no use. Of rooms also lack/NAME: how many are lacking.
    """
    crowds = crowded(objects(home))
    rooms = {room.id: _told(home, room.id) for room in home.rooms if room.id not in crowds}
    means = {v: None if crowds else sum(told["lacks", v] for told in rooms.values()) / len(rooms)
             for v in ("number", "cost")}
    whole = [Value(name="lacks", value=mean, unit=UNITS[v], version=v) for v, mean in means.items()]
    return [*whole, *(Value(name=name, value=value, unit=UNITS[v], version=v, of=id)
                      for id, told in rooms.items() for (name, v), value in told.items())]


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """What a furnished room lacks in two sets, in all and by type."""
    return compared(_told, "things", homes, real)


def _told(home: Plan, room: str) -> Told:
    found = list(use.lacks(use.of_plan(home, room, objects(home))))
    whole = {("lacks", "number"): float(len(found)), ("lacks", "cost"): sum(lack.cost for lack in found)}
    return whole | {(LACK + lack.name, "ours"): lack.number for lack in found}

"""Contents: what those who live there miss in a room, and what it has too much of."""

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages import use
from apartgen.stages.metrics._shares import objects

NEEDS = Layout
UNITS = {"number": "things", "cost": "faults"}
LACK = "lack/"
"""Begins the names of what single rooms lack."""


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """What every room lacks, and of the apartment the mean over its rooms.

    Versions: number = how many things are wanted or too much · cost = what going without them costs, 1 being a piece
    of furniture of no use. Of rooms also lack/NAME: how many are lacking.
    """
    things = objects(home)
    found = {room.id: list(use.lacks(use.of_plan(home, room.id, things))) for room in home.rooms}
    rooms = {id: {"number": float(len(lacks)), "cost": sum(lack.cost for lack in lacks)} for id, lacks in found.items()}
    whole = [Value(name="lacks", value=sum(room[v] for room in rooms.values()) / len(rooms), unit=unit, version=v)
             for v, unit in UNITS.items()]
    of_rooms = [Value(name="lacks", value=room[v], unit=unit, version=v, of=id)
                for id, room in rooms.items() for v, unit in UNITS.items()]
    each = [Value(name=LACK + lack.name, value=lack.number, unit="things", of=id)
            for id, lacks in found.items() for lack in lacks]
    return [*whole, *of_rooms, *each]


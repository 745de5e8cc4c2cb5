"""Kitchens off the living room, drawn by lot where a prompt says nothing of them."""

from numpy.random import Generator

from apartgen.schemas.plan import AskedRoom, Program
from apartgen.stages.plan.check import entrance_room, neighbours
from apartgen.stages.plan.rehung import moved

SILENT = frozenset({"bedroom", "bathroom", "study", "balcony", "storage", "closet", "utility"})
"""Rooms of which a prompt may speak and yet leave open where the kitchen opens."""
SHARE = 0.65
"""Share of closed kitchens off the hallway that open off the living room instead."""
DOOR = 1.1
"""Hallway that a door takes, m²; the room that has the door instead gets it."""


def off_living(program: Program, rng: Generator) -> Program:
    """The programme with its kitchen, were it to open off the hallway alone, by lot off the living room; else as is."""
    near, types = neighbours(program), {room.id: room.base for room in program.rooms}
    kitchens = [room.id for room in program.rooms if room.type == "kitchen"]
    if len(kitchens) != 1 or program.complete or rng.random() >= SHARE:
        return program
    (kitchen,), hall = kitchens, entrance_room(program).id
    bound = any(kitchen in (one.of, one.to) or "doors" in (one.kind, one.to) for one in program.requirements)
    if bound or near[kitchen] != [hall] or types[hall] != "hallway":
        return program
    link = next(pair for pair in program.links if kitchen in pair)
    found = next(moved(program, link, hall), program)
    host = neighbours(found)[kitchen][0]
    if types[host] != "living_room" or hall not in near[host]:
        return program
    return found.model_copy(update={"rooms": [_less(room, hall, host) for room in found.rooms]})


def _less(room: AskedRoom, hall: str, host: str) -> AskedRoom:
    """A room of the programme when one of the hallway's doors has gone to another one."""
    given = {hall: -DOOR, host: DOOR}.get(room.id, 0.0)
    return room if room.area is None else room.model_copy(update={"area": round(room.area + given, 2)})

"""Busy hallways: which one, and which way it runs best through a home with neighbours."""

from apartgen.schemas.plan import Envelope, Program, Side
from apartgen.stages.plan.blocks import entrance_sides
from apartgen.stages.plan.check import links

HUB = 4
"""Doors from which a hallway is a corridor between two rows of rooms."""
MANY = 8
"""Doors from which there is hardly another way to reach them all."""
ENDS: tuple[tuple[Side, Side], tuple[Side, Side]] = (("south", "north"), ("west", "east"))


def doors(program: Program, room: str) -> int:
    """Links that a room has."""
    return sum(room in pair for pair in links(program))


def hub(program: Program) -> int | None:
    """The hallway with most doors, if they are many."""
    halls = {i: doors(program, room.id) for i, room in enumerate(program.rooms) if room.base == "hallway"}
    best = max(halls, key=lambda i: halls[i], default=None)
    return best if best is not None and halls[best] >= HUB else None


def along(envelope: Envelope) -> int | None:
    """The axis (0: x) on which a corridor ends where one comes in and has windows at both rows; None if either does."""
    entrances, party = entrance_sides(envelope), envelope.party_walls
    good = [
        any(side in entrances for side in ENDS[1 - axis]) + sum(side not in party for side in ENDS[axis]) / 2
        for axis in (0, 1)
    ]
    return None if good[0] == good[1] else int(good[1] > good[0])

"""Who lives in a home, as its plan tells: how many sleep where, where they eat, where they wash their clothes."""

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator

from apartgen.schemas.plan import Plan, Room
from apartgen.stages.layout.meals import table_of
from apartgen.stages.use.household import duties, sleepers, washes_in


@dataclass(frozen=True)
class Household:
    """What furnishing one room knows of the rest: sleepers in the home; whether this bedroom is the main one; whether
    a table is wanted here, None where that is left open; whether a bed is (a home without bedrooms); whether clothes
    are washed here."""

    sleepers: int = 2
    main: bool = True
    table: bool | None = None
    bed: bool = False
    laundry: bool | None = None
    coats: bool = True


def of_room(plan: Plan, room: Room, rng: Generator) -> Household:
    """What furnishing `room` needs to know."""
    if len(plan.rooms) == 1:
        return Household(sleepers=int(rng.choice([1, 2, 2, 3, 4, 4, 5])), main=bool(rng.random() < 0.6))
    table, of = table_of(plan), duties(plan, room)
    open_question = room.base == "living_room" and table is None
    return Household(
        sleepers=sleepers(plan) or 2,
        main=of.main == 1,
        table=None if open_question else table is not None and table[0] == room.id,
        bed=of.sleeps == 1,
        laundry=of.washes == 1 or washes_in(plan) is None,
    )


def one_of(rng: Generator, *some: str) -> str:
    """One of them."""
    return str(np.asarray(some)[int(rng.integers(len(some)))])

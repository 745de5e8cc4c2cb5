"""How many people a home is for, read off its plan."""

import numpy as np

from apartgen.schemas.plan import Plan, Room

DOUBLE = 9.6
"""A bedroom of so much floor sleeps two, m²."""
STUDIO = 30.0
"""A home without bedrooms of which the largest room has so much floor sleeps two, m²."""

PLACES = (("dining_room", 0.0), ("kitchen", 11.0), ("living_room", 14.0), ("kitchen", 7.5), ("living_room", 10.0))
"""Where people eat, the likeliest first, with the floor that takes, m²."""


def sleepers(plan: Plan) -> int | None:
    """Who sleeps in the home: two in a large bedroom, one in a small one; None for a room by itself."""
    if len(plan.rooms) == 1 and plan.rooms[0].base != "living_room":
        return None
    beds = [room for room in plan.rooms if room.base == "bedroom"]
    if not beds:
        return None if len(plan.rooms) == 1 else 1 + (_area(_largest(plan)) >= STUDIO)
    return sum(1 + (_area(room) >= DOUBLE) for room in beds)


def eats_in(plan: Plan) -> str | None:
    """The room where a home has its meals: a dining room, else a kitchen with floor for a table, else a living room;
    None for a room by itself."""
    if len(plan.rooms) == 1:
        return None
    for kind, least in PLACES:
        fitting = [room for room in plan.rooms if room.base == kind and _area(room) >= least]
        if fitting:
            return max(fitting, key=_area).id
    return None


def _largest(plan: Plan) -> Room:
    return max(plan.rooms, key=_area)


def _area(room: Room) -> float:
    x, y = np.array(room.polygon, float).T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2

"""Where a home without a dining room eats: a rule over all its rooms, where those of `sense.toml` are of one room."""

import shapely

from apartgen.schemas.plan import Plan, Room
from apartgen.stages.things.categories import CATEGORIES, stand_in, used_for
from apartgen.stages.use.household import places, sleepers

TABLES = tuple(name for name in CATEGORIES if name in used_for("dine"))
SMALL = 10.0
"""In a room below this floor area, m², the table is a round one."""
ROUND = 1 / 3
"""Share of round ones among tables elsewhere."""
AROUND, FOUR, WIDE = 6, 4, 27.0
"""So many eat at a round table at most, and so many in a room of less floor, m²: with chairs for six drawn back it
takes 2.9 m each way, for which two of three smaller living rooms have no place beside the sofa."""
FEWEST = 6
"""A room that is to hold fewer objects than this is not asked for a table: seats at it would be all it has."""


def table_of(plan: Plan, chance: float = 1.0) -> tuple[str, str] | None:
    """The room, and the category of table, in which the home is to have its meals; `chance`, in [0, 1), picks which.

    None where a dining room sees to that, where the prompt speaks of tables itself, where no room has the floor, and
    for a room by itself, which is no home.
    """
    if _spoken(plan) or len(plan.rooms) == 1 or _apart(plan):
        return None
    for kind, least in places(plan):
        fitting = [room for room in plan.rooms if room.base == kind and _area(room) >= least and _holds(plan, room)]
        if fitting:
            room = max(fitting, key=_area)
            most = AROUND if _area(room) >= WIDE else FOUR
            round_ = (_area(room) < SMALL or chance < ROUND) and (sleepers(plan) or 0) <= most
            return room.id, "round_table" if round_ else "dining_table"
    return None


def without_table(plan: Plan) -> list[str]:
    """Living rooms that have none of their own, as a dining room has; unless the prompt speaks of tables."""
    return [] if _spoken(plan) or not _apart(plan) else [room.id for room in plan.rooms if room.base == "living_room"]


def _apart(plan: Plan) -> bool:
    return any(room.base == "dining_room" for room in plan.rooms)


def _spoken(plan: Plan) -> bool:
    return any(stand_in(asked.category, TABLES) for asked in plan.program.objects)


def _holds(plan: Plan, room: Room) -> bool:
    return plan.program.counts.get(room.id, FEWEST) >= FEWEST


def _area(room: Room) -> float:
    return float(shapely.Polygon(room.polygon).area)

"""What a room's contents get besides what the model draws: a nightstand for everyone in a bed, a desk for who sleeps
alone and for children, a lamp in every bedroom and one overhead in every room, a wardrobe where one sleeps, a chair for
everyone at the table where a home eats; and what has no use where something else is not to be."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from apartgen.stages.layout.sense import sense
from apartgen.stages.things.categories import CATEGORIES, TABLE
from apartgen.stages.use import kinds
from apartgen.stages.use.wants import desks_due

STAND, DESK, SEAT, CHAIR = "nightstand", "desk", "office_chair", "chair"
MOST = 6
"""More chairs at a table are left to the model, which draws them where they find floor: where eight were put into every
sample fewer found a place than of six."""
LAMP, LAMPS = "table_lamp", frozenset({"table_lamp", "wall_lamp", "floor_lamp"})
"""What one reads by in bed."""
LIGHT, WARDROBE = "ceiling_lamp", "wardrobe"


def completed(names: Sequence[str], asked: Mapping[str, int], room: str, area: float, diners: int = 0) -> list[str]:
    """Contents of a type of room with a nightstand for each of two who share a bed and for who has one alone, and a
    desk with its chair in a bedroom of one and of children, or two for these, and a lamp where one sleeps, and one
    overhead, and a wardrobe where there is a bed, and a chair at the table for each of so many `diners`, up to six, if
    their number was not `asked` for."""
    count, bedroom = Counter(map(kinds.basic, names)), room == "bedroom"
    alone = count["single_bed"] == 1 and count["double_bed"] + count["bunk_bed"] == 0
    stands = 2 * count["double_bed"] + alone - sum(count[name] for name in kinds.BEDSIDE)
    more = [STAND] * max(0, stands) if STAND not in asked else []
    desks = desks_due(count, area) if bedroom else 0
    if DESK not in asked and (lacking := desks - sum(count[name] for name in kinds.DESKS)) > 0:
        seats = desks - sum(count[name] for name in kinds.CHAIRS) if SEAT not in asked else 0
        more += [DESK] * lacking + [SEAT] * max(0, min(seats, lacking))
    if bedroom and LAMPS.isdisjoint(count) and LAMPS.isdisjoint(asked):
        more.append(LAMP)
    if LIGHT not in asked and not count[LIGHT] and room in TABLE[LIGHT].rooms:
        more.append(LIGHT)
    if not kinds.BEDS.isdisjoint(count) and kinds.HANGING.isdisjoint(count) and kinds.HANGING.isdisjoint(asked):
        more.append(WARDROBE)
    if CHAIR not in asked and not kinds.TABLES.isdisjoint(count):
        more += [CHAIR] * max(0, min(diners, MOST) - count[CHAIR])
    return [*names, *more]


def idle(asked: Mapping[str, int], there: Iterable[str], kind: str) -> dict[str, int]:
    """0 of what is of no use in a room of a kind, as nothing that it needs is to be there: of a chair without a desk.

    What is asked for by number, or there, is meant as it is said; what is like something does for it.
    """
    held = {kinds.basic(name) for name in (*there, *(name for name, count in asked.items() if count))}
    barred = {name for name, count in asked.items() if not count} - held
    of_use = {CATEGORIES[c]: {CATEGORIES[k] for k in company} for c, company in sense().needs}
    near = {name: {other for other in company if other in held or kind in TABLE[other].rooms}
            for name, company in of_use.items() if name not in asked}
    return {name: 0 for name, company in near.items() if company and company <= barred}

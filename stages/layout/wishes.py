"""What a programme asks of its rooms: which wishes no layout can meet, and which this one did not."""

import difflib
from collections import Counter
from collections.abc import Sequence

from apartgen.schemas.errors import BadInput, Unknown
from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.layout.config import N_MAX
from apartgen.stages.things.categories import TABLE, by_word, unknown
from apartgen.stages.use import kinds
from apartgen.stages.use.household import parents_in

FOR_TWO = 9.0
"""Floor of a main bedroom, m², in which a bed for two stands."""
TWO_BEDS = 12.0
"""Floor of a bedroom where two single beds stand rather than a bunk bed, m²."""


def of_room(program: Program, room: str) -> Counter[str]:
    """Objects asked for in a room by category; 0 where there should be none."""
    wished = Counter[str]()
    for asked in program.objects:
        if asked.room == room:
            wished[asked.category] += asked.count
    return wished


def of_sleepers(program: Program, room: str, area: float) -> dict[str, int]:
    """Beds of a room in which children are known to sleep, one for each: single ones where two fit beside one another
    (`area`, m²), else bunk beds, of which there are none in the other bedrooms; one bed for two in the only bedroom
    that is not theirs; nothing where a bed is asked for. Where nothing is known of children it is the main
    bedroom's."""
    known = {asked.id: asked.children for asked in program.rooms}
    if not kinds.BEDS.isdisjoint(of_room(program, room)):
        return {}
    if not any(known.values()):
        return {"double_bed": 1, "single_bed": 0} if area >= FOR_TWO and room == _main(program) else {}
    many = known.get(room)
    if not many:
        return {"bunk_bed": 0, **({"double_bed": 1, "single_bed": 0} if room == parents_in(program) else {})}
    bunks = many // 2 if area < TWO_BEDS or many > 2 else 0
    return {name: 0 for name in kinds.BEDS} | {"bunk_bed": bunks, "single_bed": many - 2 * bunks}


def _main(program: Program) -> str | None:
    """The bedroom with a bathroom of its own, the first of several; one alone is nobody's main one."""
    if sum(room.base == "bedroom" for room in program.rooms) < 2:
        return None
    return next((room.private_to for room in program.rooms if room.base == "bathroom" and room.private_to), None)


def check(plan: Plan) -> None:
    """BadInput for a wish that no layout can meet: an unknown category, or too many objects."""
    for room in plan.rooms:
        wished, count = of_room(plan.program, room.id), plan.program.counts.get(room.id)
        for category in wished.keys() - TABLE.keys():
            raise Unknown(f"program.objects: wanted in {room.id}: {_near(category)}")
        most = max(wished.total(), count or 0)
        if most > N_MAX:
            raise BadInput(f"program: {most} objects wanted in {room.id}; a room holds at most {N_MAX}, ask for fewer")
        if count is not None and wished.total() > count:
            raise BadInput(f"program: {wished.total()} objects wanted by category in {room.id}, but {count} in all "
                           "(counts); make them agree")


def _near(category: str) -> str:
    words = category.replace("_", " ").lower()
    near = [words] if words in by_word() else difflib.get_close_matches(words, by_word(), n=3)
    found = dict.fromkeys(by_word()[word] for word in near)
    return unknown(category, *found)


def unmet(program: Program, room: str, objects: Sequence[Box]) -> list[str]:
    """What a furnished room lacks of what was asked for it, or has beyond it, in words."""
    found, count = Counter(o.category for o in objects), program.counts.get(room)
    lacks = [] if count in (None, len(objects)) else [f"{len(objects)} objects, {count} were asked for"]
    for category, wanted in of_room(program, room).items():
        if found[category] < wanted or (wanted == 0 and found[category]):
            lacks.append(f"{found[category]} {category}, {wanted} asked for")
    return lacks

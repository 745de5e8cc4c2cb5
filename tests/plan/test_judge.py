"""The judge of plans finds each way in which a good plan can be spoiled."""

from collections.abc import Callable

import pytest
from plan.flats import flat

from schemas.plan import Opening, Plan
from stages import polygons
from stages.plan import validate


def changed(plan: Plan, pick: Callable[[Opening], bool], **update: object) -> Plan:
    """The plan with the first opening that is picked changed, or dropped where nothing is updated."""
    index = next(i for i, o in enumerate(plan.openings) if pick(o))
    openings = list(plan.openings)
    openings[index : index + 1] = [openings[index].model_copy(update=update)] if update else []
    return plan.model_copy(update={"openings": openings})


def shifted(plan: Plan, pick: Callable[[Opening], bool], by: float) -> Plan:
    opening = next(o for o in plan.openings if pick(o))
    (ax, ay), (bx, by_) = opening.segment
    dx, dy = (by, 0.0) if ay == by_ else (0.0, by)
    return changed(plan, lambda o: o is opening, segment=((ax + dx, ay + dy), (bx + dx, by_ + dy)))


def spoiled() -> dict[str, tuple[Plan, str]]:
    plan = flat("two_bedroom")
    room = plan.rooms[1]
    x0, y0, x1, y1 = polygons.floor(room).bounds
    grown = [(x + (0.3 if x == x1 else -0.3), y + (0.3 if y == y1 else -0.3)) for x, y in room.polygon]
    wider = [r.model_copy(update={"polygon": grown}) if r is room else r for r in plan.rooms]
    away = [(x + 0.4, y + 0.4) for x, y in room.polygon]
    moved = [r.model_copy(update={"polygon": away}) if r is room else r for r in plan.rooms]
    bed = next(r.id for r in plan.rooms if r.type == "bedroom")
    dark = [o for o in plan.openings if not (o.kind == "window" and o.rooms == [bed])]
    door = next(o for o in plan.openings if o.kind == "door")
    other = next(r.id for r in plan.rooms if r.id not in door.rooms)
    return {
        "no door": (changed(plan, lambda o: o.kind == "door"), "joined by 0"),
        "no entrance": (changed(plan, lambda o: o.kind == "entrance"), "exactly one entrance"),
        "no window": (plan.model_copy(update={"openings": dark}), "has no window"),
        "rooms overlap": (plan.model_copy(update={"rooms": wider}), "closer than a wall"),
        "a room elsewhere": (plan.model_copy(update={"rooms": moved}), "centre line"),
        "clockwise": (_turned(plan), "counter-clockwise"),
        "a room less": (plan.model_copy(update={"rooms": plan.rooms[:-1]}), "not the rooms asked for"),
        "entrance in a corner": (shifted(plan, lambda o: o.kind == "entrance", 20.0), "does not open onto"),
        "leaf into nowhere": (changed(plan, lambda o: o.kind == "door", into=other), "no room of its own"),
        "slit": (changed(plan, lambda o: o.kind == "window", segment=_narrow(plan)), "wide"),
        "party wall": (_among_neighbours(plan), "party wall"),
    }


def _turned(plan: Plan) -> Plan:
    room = plan.rooms[0].model_copy(update={"polygon": plan.rooms[0].polygon[::-1]})
    return plan.model_copy(update={"rooms": [room, *plan.rooms[1:]]})


def _narrow(plan: Plan) -> tuple[tuple[float, float], tuple[float, float]]:
    (ax, ay), (bx, by) = next(o for o in plan.openings if o.kind == "window").segment
    return (ax, ay), (ax + 0.1 * (bx - ax), ay + 0.1 * (by - ay))


def _among_neighbours(plan: Plan) -> Plan:
    envelope = plan.program.envelope.model_copy(update={"party_walls": ["north", "south", "east", "west"]})
    return plan.model_copy(update={"program": plan.program.model_copy(update={"envelope": envelope})})


@pytest.mark.parametrize("how", sorted(spoiled()))
def test_finds(how: str) -> None:
    plan, word = spoiled()[how]
    assert any(word in fault for fault in validate(plan)), validate(plan)


def test_finds_colliding_leaves() -> None:
    plan = flat("two_bedroom")
    inward = [o.model_copy(update={"into": "hallway_1"}) if "hallway_1" in o.rooms else o for o in plan.openings]
    crowded = validate(plan.model_copy(update={"openings": inward}))
    assert any("leaf" in fault or "leaves" in fault for fault in crowded), crowded

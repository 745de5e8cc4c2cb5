"""The judge of plans finds each way in which a good plan can be spoiled."""

from collections.abc import Callable
from typing import Any

import pytest
from plan.flats import drawn, flat

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.plan import validate
from apartgen.stages.space import polygons


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


@pytest.mark.parametrize("beside", [False, True])
@pytest.mark.parametrize("width, passes", [(1.3, False), (1.4, False), (1.6, True)])
def test_finds_a_leaf_that_closes_a_hallway_while_it_stands_open(width: float, passes: bool, beside: bool) -> None:
    """A leaf of .8 m with its lever; a bathroom `beside` the entrance, entered farther on, is near through a wall."""
    rooms = [drawn("hallway_1", 0, 0, 6, width), drawn("storage_1", 1, -2.1, 4, -0.1),
             drawn("bedroom_1", 6.1, -1, 10, 3)]
    doors: list[dict[str, Any]] = [
        {"id": "entrance_1", "rooms": ["hallway_1"], "segment": ((-0.15, width - 0.02), (-0.15, width - 0.92)),
         "kind": "entrance", "into": "hallway_1"},
        {"id": "door_1", "rooms": ["hallway_1", "storage_1"], "segment": ((2.4, -0.05), (3.2, -0.05)), "kind": "door",
         "into": "hallway_1"},
        {"id": "door_2", "rooms": ["hallway_1", "bedroom_1"], "segment": ((6.05, 0.2), (6.05, 1.1)), "kind": "door",
         "into": "bedroom_1"},
    ]
    if beside:
        rooms.append(drawn("bathroom_1", 0, width + 0.1, 5, width + 2.1))
        doors.append({"id": "door_3", "rooms": ["hallway_1", "bathroom_1"], "kind": "door", "into": "bathroom_1",
                      "segment": ((3.8, width + 0.05), (4.6, width + 0.05))})
    asked = [{"id": room.id, "type": room.type} for room in rooms]
    plan = Plan.model_validate({"program": {"rooms": asked}, "rooms": rooms,
                                "openings": [door | {"sill": 0.0, "head": 2.1, "hinge": 0} for door in doors]})
    assert (not [fault for fault in validate(plan) if "stand open" in fault]) == passes


def test_links_without_a_door_are_told_in_the_order_of_the_programme() -> None:
    plan = flat("two_bedroom")
    shut = plan.model_copy(update={"openings": [o for o in plan.openings if o.kind not in ("door", "opening")]})
    asked = [" and ".join(sorted(pair)) for pair in [*plan.program.links, *plan.program.open_links]]
    told = [fault.split(" are joined by 0")[0] for fault in validate(shut) if " are joined by 0" in fault]
    assert told == list(dict.fromkeys(asked)) and len(told) > 4


@pytest.mark.parametrize(("factor", "wrong"), [(1.2005, False), (1.2025, True), (0.7995, False), (0.7975, True)])
def test_an_area_is_off_by_more_than_a_fifth_beyond_what_rounding_changes(factor: float, wrong: bool) -> None:
    plan = flat("two_bedroom")
    bed = next(r for r in plan.rooms if r.type == "bedroom")
    wanted = polygons.floor(bed).area / factor
    rooms = [r.model_copy(update={"area": wanted}) if r.id == bed.id else r for r in plan.program.rooms]
    asked = plan.model_copy(update={"program": plan.program.model_copy(update={"rooms": rooms}), "relaxed": []})
    assert any(f"{bed.id} has" in fault for fault in validate(asked)) == wrong

"""Limits of doors, lengths and widths: doors move where they must, what is asked is judged of the plan."""

import numpy as np
import pytest

from apartgen.schemas.plan import Program, Requirement
from apartgen.stages.plan import PlanConfig, build, validate
from apartgen.stages.plan.check import links
from apartgen.stages.plan.rehung import rehung
from apartgen.stages.space import polygons

ROOMS = {"living_room_1": 24.0, "kitchen_1": 9.0, "bedroom_1": 14.0, "bedroom_2": 12.0, "bathroom_1": 5.0,
         "storage_1": 2.5, "hallway_1": 8.0}  # fmt: skip


def flat(*asked: tuple[str, str, str, str | None], complete: bool = False) -> Program:
    """All rooms off the hallway; what is asked as kind, of, to and value."""
    rooms = [{"id": name, "type": name[:-2], "area": area} for name, area in ROOMS.items()]
    rows = [Requirement(id=f"asked_{i}", kind=k, of=of, to=to, value=v) for i, (k, of, to, v) in enumerate(asked, 1)]
    doors = [("hallway_1", name) for name in ROOMS if name != "hallway_1"]
    return Program(rooms=rooms, links=doors, requirements=rows, complete=complete)


def doors_of(program: Program, room: str) -> int:
    return sum(room in pair for pair in links(program))


@pytest.mark.parametrize("most", [3, 4, 5])
def test_rooms_move_their_doors_from_a_hallway_of_so_many(most: int) -> None:
    program = rehung(flat(("at_most", "hallway_1", "doors", str(most))))
    assert doors_of(program, "hallway_1") == most
    assert {room for pair in links(program) for room in pair} == set(ROOMS), "every room keeps a door"
    assert all({"bedroom_1", "bathroom_1"} != set(pair) for pair in links(program)), "the one bath is nobody's own"


def test_a_room_gets_as_many_doors_as_it_should_have() -> None:
    program = rehung(flat(("at_least", "living_room_1", "doors", "2")))
    assert doors_of(program, "living_room_1") == 2 and set(flat().links) < set(program.links)


@pytest.mark.parametrize("least", [2, 3, 4])
def test_other_rooms_doors_move_to_a_room_that_has_too_few(least: int) -> None:
    program = rehung(flat(("at_least", "living_room_1", "doors", str(least))))
    assert doors_of(program, "living_room_1") == least
    assert {room for pair in links(program) for room in pair} == set(ROOMS)


def test_nothing_opens_where_it_must_not() -> None:
    program = rehung(flat(("no_door", "hallway_1", "kitchen_1", None)))
    assert {"hallway_1", "kitchen_1"} not in [set(pair) for pair in links(program)]
    assert doors_of(program, "kitchen_1") == 1


def test_a_complete_programme_keeps_its_doors() -> None:
    program = flat(("at_most", "hallway_1", "doors", "2"), complete=True)
    assert rehung(program) == program


@pytest.mark.parametrize(("kind", "to", "value"), [
    ("at_most", "doors", "4"), ("at_most", "length", "6"), ("at_least", "width", "1.4"),
])  # fmt: skip
def test_what_is_asked_of_a_hallway_is_met_and_told(kind: str, to: str, value: str) -> None:
    asked, found = flat((kind, "hallway_1", to, value)), []
    for seed in range(3):
        plan = build(asked, PlanConfig(), np.random.default_rng(seed))
        assert validate(plan) == []
        hall = next(polygons.floor(room) for room in plan.rooms if room.id == "hallway_1")
        extent = max(hall.bounds[2] - hall.bounds[0], hall.bounds[3] - hall.bounds[1])
        doors = sum(o.kind in ("door", "opening") and "hallway_1" in o.rooms for o in plan.openings)
        half = 0.97 * float(value) / 2
        wide = hall.buffer(-half, join_style="mitre").buffer(half, join_style="mitre").area > 0.99 * hall.area
        truth = {"doors": doors <= 4, "length": extent <= 6.18, "width": wide}[to]
        assert plan.program.requirements[0].met is truth
        found.append(truth)
    assert sum(found) >= 2

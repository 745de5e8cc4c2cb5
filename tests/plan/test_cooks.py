"""Kitchens lie at the room where one eats, and open off the living room in most homes where nobody says otherwise."""

import numpy as np
import pytest

from apartgen import planning
from apartgen.schemas.plan import Program, Requirement, Walls
from apartgen.stages import seeds
from apartgen.stages.plan import cooks
from apartgen.stages.plan.problem import Slack, Whim, open_problem, whim
from apartgen.stages.plan.wished import ADJACENT

ROOMS = ("hallway_1", "living_room_1", "kitchen_1", "bedroom_1", "bathroom_1")


def star(rooms: tuple[str, ...] = ROOMS, **more: object) -> Program:
    """Rooms of 10 m² off a hallway."""
    asked = [{"id": room, "type": room[:-2], "area": 10.0} for room in rooms]
    return Program(rooms=asked, links=[(rooms[0], room) for room in rooms[1:]], **more)


def drawn(program: Program, many: int) -> list[Program]:
    return [cooks.off_living(program, np.random.default_rng(seed)) for seed in range(many)]


def test_a_kitchen_has_its_one_door_to_the_living_room_in_its_share_of_homes() -> None:
    before = star()
    found = drawn(before, 400)
    moved = [program for program in found if program != before]
    assert len(moved) / 400 == pytest.approx(cooks.SHARE, abs=4 * (0.25 / 400) ** 0.5)
    for program in moved:
        assert {frozenset(pair) for pair in program.links if "kitchen_1" in pair} == {
            frozenset(("kitchen_1", "living_room_1"))}  # fmt: skip
        areas = {room.id: room.area for room in program.rooms}
        assert areas["living_room_1"] > 10.0 > areas["hallway_1"] and sum(areas.values()) == pytest.approx(50.0)


@pytest.mark.parametrize("program", [
    star(complete=True),
    star(requirements=[Requirement(id="asked_1", kind="no_door", of="kitchen_1", to="living_room_1")]),
    star(requirements=[Requirement(id="asked_1", kind="at_least", of="hallway_1", to="doors", value=4)]),
    star((*ROOMS, "kitchen_2")),
    star(ROOMS[:1] + ROOMS[2:]),
    star().model_copy(update={"links": [*star().links, ("kitchen_1", "living_room_1")]}),
])  # fmt: skip
def test_other_kitchens_keep_their_doors(program: Program) -> None:
    assert all(found == program for found in drawn(program, 20))


@pytest.mark.parametrize(("prompt", "open_to"), [
    ("two-bedroom flat", {"hallway_1", "living_room_1"}),
    ("two-bedroom flat, the kitchen opens off the hallway", {"hallway_1"}),
    ("two-bedroom flat where every room opens onto the hallway", {"hallway_1"}),
])  # fmt: skip
def test_only_a_prompt_that_leaves_the_kitchen_open_has_it_drawn(prompt: str, open_to: set[str]) -> None:
    found = set()
    for seed in range(12):
        program, _ = planning.read(prompt, planning.PlanSettings(), seeds.drawn(seed, "plan"))
        found |= {room for pair in program.links if "kitchen_1" in pair for room in pair} - {"kitchen_1"}
    assert found == open_to
    usual, _ = planning.read(prompt, planning.PlanSettings())
    assert ("hallway_1", "kitchen_1") in usual.links, "without chances nothing is drawn"


def beside(program: Program) -> set[tuple[int, int]]:
    """Rooms by place that some draw wants beside one another."""
    walls = Walls()
    lots = [whim(program, walls, 0, np.random.default_rng(seed)) for seed in range(8)]
    rows = np.vstack([open_problem(program, one, walls, Slack()).wishes for one in lots])
    return {(int(row[1]), int(row[2])) for row in rows if row[0] == ADJACENT}


def test_a_kitchen_without_a_door_to_where_one_eats_is_to_lie_there() -> None:
    assert beside(star()) == {(2, 1)}
    assert beside(star((*ROOMS, "dining_room_1"))) == {(2, 5)}
    assert beside(star().model_copy(update={"links": [*star().links, ("kitchen_1", "living_room_1")]})) == set()
    asked = [Requirement(id="asked_1", kind="apart", of="living_room_1", to="kitchen_1")]
    assert (2, 1) not in beside(star(requirements=asked))


def test_wishes_of_a_draw_do_not_yield_to_a_search_without_wishes() -> None:
    nothing = Whim((1,) * 5, [], "rectangle", 1.0, beside=[(2, 1)])
    full, less = (open_problem(star(), nothing, Walls(), slack).wishes for slack in (Slack(), Slack(heed=0.1)))
    assert full.tolist() == less.tolist() and len(full) == 1

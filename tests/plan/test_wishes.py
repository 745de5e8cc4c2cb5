"""What else is asked of rooms is weighed while a plan is sought, and judged of the plan's geometry."""

import numpy as np
import pytest
from plan.test_energy import energy, row_of_three

from apartgen.schemas.plan import Opening, Plan, Program, Requirement, Room, Walls
from apartgen.stages.plan import PlanConfig, build, wished
from apartgen.stages.plan.met import judged
from apartgen.stages.plan.reader import read
from apartgen.stages.plan.wishes import COUNTS, wishes

WIDTHS = {"living_room_1": 3.0, "study_1": 4.0, "bedroom_1": 5.0}


def row(kind: str, of: str, value: str | None = None, to: str | None = None) -> Requirement:
    return Requirement(id="asked_1", kind=kind, of=of, to=to, value=value)


@pytest.mark.parametrize(
    ("kind", "room", "other", "x", "y", "lack"),
    [
        (wished.PLACE, 2, -1, 1, 0, 0.0),  # the bedroom ends the row in the east
        (wished.PLACE, 0, -1, 1, 0, 9 / 6 + wished.ASIDE + 4.5 / 6),  # the living room is 9 m from there
        (wished.PLACE, 0, -1, -1, 0, 0.0),
        (wished.CENTRE, 1, -1, 0, 0, 0.0),  # the study's middle is 1 m off the home's, of 6
        (wished.CENTRE, 2, -1, 0, 0, 3.5 / 6 - wished.MIDDLE),
        (wished.BESIDE, 0, 1, -1, 0, 0.0),
        (wished.BESIDE, 0, 1, 1, 0, 3.5 + 7 / 4),
        (wished.ADJACENT, 0, 1, 0, 0, 0.0),
        (wished.ADJACENT, 0, 2, 0, 0, wished.WALL + 4.0),
        (wished.APART, 0, 2, 0, 0, 0.0),
        (wished.APART, 0, 1, 0, 0, 2.0),
        (wished.SERVING, 0, 2, 0, 1, 2.5 - wished.CARRIED),  # for a wall that lacks stands the middle between rooms
        (wished.LENGTHS, 1, -1, 2.9, 3.9, 0.0),
        (wished.LENGTHS, 1, -1, 3.9, 2.4, 0.5),
        (wished.LONG, 2, -1, 4.0, 0.0, 0.9),  # the bedroom's floor is 4.9 by 2.9
        (wished.LONG, 2, -1, 1e3, 5.5, 0.6),
        (wished.WIDE, 1, -1, 1e3, 3.5, 0.6),
        (wished.WIDE, 1, -1, 2.0, 0.0, 0.9),
        (wished.WIDE, 1, -1, 3.0, 2.5, 0.0),
    ],
)
def test_lacks_of_a_row_of_rooms(kind: int, room: int, other: int, x: float, y: float, lack: float) -> None:
    p, tree = row_of_three()
    bare = energy(p, tree)[0]
    wish = np.array([[kind, room, other, x, y, 10.0]], float)
    assert energy(p._replace(wishes=wish), tree)[0] - bare == pytest.approx(10 * lack, abs=1e-6)


def test_requirements_become_rows() -> None:
    asked = [row("position", "bedroom_1", "north_east"), row("adjacent", "study_1", to="bedroom_1"),
             row("near", "living_room_1", to="entrance"), row("dimension", "study_1", "5 x 4"),
             row("use", "study_1", "bedroom"), row("at_least", "home", "60")]  # fmt: skip
    rooms = [{"id": name, "type": name[:-2]} for name in WIDTHS]
    rows = wishes(Program(rooms=rooms, requirements=asked)).tolist()
    assert [r[:5] for r in rows] == [
        [wished.PLACE, 2, -1, 1, 1], [wished.ADJACENT, 1, 2, 0, 0], [wished.NEAR_ENTRANCE, 0, -1, 0, 0],
        [wished.LENGTHS, 1, -1, 5, 4]]  # fmt: skip
    assert [r[5] for r in rows] == [COUNTS[int(r[0])] for r in rows]


def drawn(*asked: Requirement) -> list[bool | None]:
    """What is met in three rooms in a row from west to east, entered into the first from the west."""
    x, rooms = 0.0, []
    for name, width in WIDTHS.items():
        rooms.append(Room(id=name, type=name[:-2], polygon=[(x, 0), (x + width, 0), (x + width, 3), (x, 3)]))
        x += width + 0.1
    door = Opening(id="e", kind="entrance", rooms=["living_room_1"], segment=((-0.1, 1), (-0.1, 2)), sill=0, head=2)
    pane = Opening(id="w", kind="window", rooms=["bedroom_1"], segment=((8, 3.1), (9, 3.1)), sill=1, head=2)
    program = Program(rooms=[{"id": r.id, "type": r.type} for r in rooms], requirements=list(asked))
    plan = Plan(program=program, rooms=rooms, openings=[door, pane], height=2.6, walls=Walls(inner=0.1, outer=0.3))
    return [r.met for r in judged(plan).program.requirements]


def test_what_is_met_is_seen_in_the_geometry() -> None:
    yes = [row("position", "bedroom_1", "east"), row("position", "living_room_1", "left"),
           row("position", "study_1", "centre"), row("position", "living_room_1", "front"),
           row("position", "bedroom_1", "back"), row("position", "study_1", "right", "living_room_1"),
           row("orientation", "bedroom_1", "north"), row("adjacent", "study_1", to="bedroom_1"),
           row("apart", "living_room_1", to="bedroom_1"), row("near", "living_room_1", to="entrance"),
           row("apart", "bedroom_1", to="entrance"), row("dimension", "study_1", "3 x 4"),
           row("order", "bedroom_1", "largest"), row("order", "living_room_1", "smaller", "study_1"),
           row("at_least", "bedroom_1", "15"), row("at_most", "home", "36")]  # fmt: skip
    no = [row("position", "bedroom_1", "west"), row("position", "bedroom_1", "centre"),
          row("position", "study_1", "left", "living_room_1"), row("orientation", "bedroom_1", "south"),
          row("adjacent", "living_room_1", to="bedroom_1"), row("apart", "study_1", to="bedroom_1"),
          row("apart", "living_room_1", to="entrance"), row("dimension", "study_1", "3 x 5"),
          row("order", "study_1", "largest"), row("order", "study_1", "larger", "bedroom_1"),
          row("at_least", "bedroom_1", "16"), row("at_most", "home", "34")]  # fmt: skip
    assert drawn(*yes) == [True] * len(yes)
    assert drawn(*no) == [False] * len(no)
    assert drawn(row("position", "living_room_1", "somewhere"), row("near", "attic_1")) == [None, None]


@pytest.mark.parametrize("side", ["north", "south", "east", "west"])
def test_a_plan_has_its_kitchen_where_it_was_asked_for(side: str) -> None:
    asked = read(f"One-bedroom flat with the kitchen in the {side}.")
    plans = [build(asked, PlanConfig(processes=1), np.random.default_rng(seed)) for seed in range(3)]
    assert sum(plan.program.requirements[0].met is True for plan in plans) >= 2


def test_what_is_not_met_is_told(caplog: pytest.LogCaptureFixture) -> None:
    both = read("One-bedroom flat with the kitchen in the north.")
    south = both.requirements[0].model_copy(update={"id": "asked_2", "value": "south", "text": "kitchen in the south"})
    asked = both.model_copy(update={"requirements": [*both.requirements, south]})
    plan = build(asked, PlanConfig(processes=1), np.random.default_rng(0))
    missed = [r.text for r in plan.program.requirements if r.met is False]
    assert missed and [f'plan: not met: "{text}"' for text in missed] == [m for m in caplog.messages if "not met" in m]

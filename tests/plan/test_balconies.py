"""Balconies that hang before their rooms, and sides with windows, in programmes by hand."""

import numpy as np
import pytest
import shapely

from apartgen.schemas.plan import AskedRoom, Envelope, Plan, Program, Requirement, Walls
from apartgen.stages.plan import met
from apartgen.stages.plan.balconies import hang, hung, indoors
from apartgen.stages.plan.surroundings import surrounded

TYPES = {"hallway_1": "hallway", "living_room_1": "living_room", "bedroom_1": "bedroom", "balcony_1": "balcony"}
LINKS = [("hallway_1", "living_room_1"), ("hallway_1", "bedroom_1"), ("living_room_1", "balcony_1")]


def program(*left_out: str) -> Program:
    rooms = [AskedRoom(id=name, type=kind) for name, kind in TYPES.items() if name not in left_out]  # type: ignore[arg-type]
    return Program(rooms=rooms, links=[pair for pair in LINKS if not set(pair) & set(left_out)])


def test_indoors_are_all_rooms_and_links_but_those_of_the_balcony() -> None:
    assert hung(program()) == {"balcony_1": "living_room_1"}
    inside = indoors(program())
    assert [room.id for room in inside.rooms] == ["hallway_1", "living_room_1", "bedroom_1"]
    assert [set(pair) for pair in inside.links] == [set(pair) for pair in LINKS[:2]]


def test_without_a_balcony_all_is_indoors() -> None:
    assert indoors(program("balcony_1")) == program("balcony_1")


def test_a_balcony_hangs_an_outer_wall_before_its_room_and_clear_of_all_others() -> None:
    """The living room's south is free; its east side is the bedroom's, and a house stands before its north."""
    floors = {"living_room_1": shapely.box(0, 0, 5, 4), "bedroom_1": shapely.box(5.1, 0, 8, 4),
              "hallway_1": shapely.box(0, 4.1, 8, 5.3)}
    walls = Walls(inner=0.1, outer=0.3)
    out = hang(program(), floors, walls)
    assert out is not None and {name: out[name] for name in floors} == floors
    balcony = out["balcony_1"]
    assert balcony.area >= 1.8 - 1e-9
    assert all(floor.distance(balcony) >= 0.3 - 1e-6 for floor in floors.values())
    assert balcony.distance(floors["living_room_1"]) == pytest.approx(0.3)


def test_where_no_facade_is_free_there_is_no_balcony() -> None:
    walls = Walls(inner=0.1, outer=0.3)
    shut = program().model_copy(update={"envelope": Envelope(party_walls=["south", "east", "north", "west"])})
    assert hang(shut, {"living_room_1": shapely.box(0, 0, 5, 4)}, walls) is None


@pytest.mark.parametrize("number", [1, 2, 3, 4])
def test_a_home_has_as_many_sides_with_windows_as_it_is_said_to_have(number: int) -> None:
    asked = program("balcony_1").model_copy(update={"envelope": Envelope(facades=number)})
    for seed in range(8):
        found = surrounded(asked, 1.2, 60.0, 0, np.random.default_rng(seed))
        assert len(set(found.party_walls)) == len(found.party_walls) == 4 - number and found.facades == number


def test_a_home_that_found_no_plan_for_long_is_drawn_with_windows_on_all_sides() -> None:
    found = [surrounded(program("balcony_1"), 1.2, 60.0, 80, np.random.default_rng(seed)) for seed in range(8)]
    assert [(one.party_walls, one.facades) for one in found] == [([], 4)] * 8


FLOORS = {"living_room_1": shapely.box(0, 0, 7, 5), "hallway_1": shapely.box(0, 5.1, 3, 6.3)}
WALLS = Walls(inner=0.1, outer=0.3)


def asked(value: str, to: str | None = None, kind: str = "position") -> Program:
    place = Requirement(id="asked_1", kind=kind, of="balcony_1", to=to, value=value, text=value)
    return program("bedroom_1").model_copy(update={"requirements": [place]})


SIDES = [("east", 0, 1), ("west", 0, -1), ("south", 1, -1), ("left", 0, -1)]


@pytest.mark.parametrize(("value", "axis", "sign"), SIDES)
@pytest.mark.parametrize(("kind", "to"), [("position", None), ("position", "living_room_1"), ("orientation", None)])
def test_a_balcony_hangs_on_the_side_asked_for(value: str, axis: int, sign: int, kind: str, to: str | None) -> None:
    """Wholly beyond that side of its room, though its longest façade is another; the hallway's part has none."""
    out = hang(asked(value, to, kind), FLOORS, WALLS)
    assert out is not None
    bounds, room = out["balcony_1"].bounds, FLOORS["living_room_1"].bounds
    assert bounds[axis] > room[axis + 2] if sign > 0 else bounds[axis + 2] < room[axis]


@pytest.mark.parametrize(("value", "middle"), [("south_east", 5.0), ("south_west", 2.0)])
def test_a_balcony_in_a_corner_hangs_at_the_end_of_a_facade(value: str, middle: float) -> None:
    out = hang(asked(value), {**FLOORS, "living_room_1": shapely.box(0, 0, 7, 2)}, WALLS)
    assert out is not None
    x, y = out["balcony_1"].centroid.coords[0]
    assert (x > middle if value.endswith("east") else x < middle) and y < 1


def test_the_place_of_a_balcony_is_asked_of_its_room() -> None:
    for kind in ("position", "orientation"):
        rows = indoors(asked("north", kind=kind)).requirements
        assert [(r.of, r.value) for r in rows] == [("living_room_1", "north")]
    own = indoors(asked("north", "living_room_1")).requirements
    assert [(r.of, r.to) for r in own] == [("balcony_1", "living_room_1")], "a side of its own room is its own matter"


@pytest.mark.parametrize(("room", "met_by"), [("living_room_1", True), ("bedroom_1", False)])
def test_a_balcony_is_next_to_the_room_that_it_hangs_before(room: str, met_by: bool) -> None:
    """A bedroom beside the living room, whose wall faces no part of the balcony."""
    floors = {**FLOORS, "bedroom_1": shapely.box(7.1, 0, 10, 5)}
    whole = program()
    out = hang(whole, floors, WALLS)
    assert out is not None
    rooms = [{"id": name, "type": TYPES[name], "polygon": shapely.get_coordinates(shape.exterior)[-2::-1].tolist()}
             for name, shape in out.items()]
    plan = Plan.model_validate({"program": whole, "rooms": rooms, "openings": [], "walls": WALLS})
    for pair in (("balcony_1", room), (room, "balcony_1")):
        next_to = Requirement(id="1", kind="adjacent", of=pair[0], to=pair[1])
        assert met.met(next_to, met._seen(plan)) is met_by

"""Descriptions of whole plans: a text is worded from a drawn plan, the reader has to find that plan in it."""

from collections import Counter

import numpy as np
import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

PLACES = ("north", "south", "east", "west", "north_east", "north_west", "south_east", "south_west", "centre")
ROOMS = {
    "living room": "living_room", "kitchen": "kitchen", "bathroom": "bathroom", "master room": "bedroom",
    "common room 1": "bedroom", "common room 2": "bedroom", "balcony": "balcony", "storage room": "storage",
}  # fmt: skip
FOOT = 0.3048


def worded(name: str, place: str, sides: tuple[int, int], beside: str, way: int) -> str:
    """One room's part of a description, in one of four manners."""
    where = f"{place.replace('_', ' ')} {'of the house' if place == 'centre' else 'corner' if '_' in place else 'side'}"
    a, b = sides
    return [
        f"The {name} is located in the {where}. It is next to the {beside}. It is {a} feet wide by {b} feet long.",
        f"{name} is at {where}, near {beside}, size is {a}x{b} sq ft.",
        f"The {name} is on the {where} of the floor plan and borders the {beside}. Size: {a} ft. by {b} ft.",
        f"The {a}x{b} {name} occupies the {where}. It is adjacent to the {beside}. "
        f"Its size is {a} feet in width and {b} feet in length.",
    ][way]


def drawn(rng: np.random.Generator) -> tuple[dict[str, tuple[str, tuple[int, int], str]], str]:
    """Rooms with their place, sides and neighbour, and the text that says so."""
    names = list(rng.permutation(list(ROOMS)))[: rng.integers(5, 9)]
    names += [name for name in ("living room", "kitchen") if name not in names]
    way = int(rng.integers(4))
    plan = {}
    for k, name in enumerate(names):
        sides = (int(rng.integers(6, 15)), int(rng.integers(6, 15)))
        plan[name] = (str(rng.choice(PLACES)), sides, names[k - 1])
    return plan, " ".join(worded(name, *row, way) for name, row in plan.items())


def found(program: Program) -> Counter[tuple[str, str, int]]:
    """Type, place and area in square feet of each room as the programme has them."""
    place = {r.of: str(r.value) for r in program.requirements if r.kind == "position" and r.to is None}
    return Counter((r.type, place.get(r.id, ""), round(r.area / FOOT**2)) for r in program.rooms)


@pytest.mark.parametrize("seed", range(60))
def test_the_plan_that_was_drawn_is_found(seed: int) -> None:
    plan, text = drawn(np.random.default_rng(seed))
    program = read(text)
    wanted = Counter((ROOMS[n], place, a * b) for n, (place, (a, b), _) in plan.items())
    assert found(program) == wanted, text
    pairs = {frozenset((r.of, r.to)) for r in program.requirements if r.kind == "adjacent"}
    assert len(pairs) == len({frozenset((name, row[2])) for name, row in plan.items()}), text


def test_what_lies_to_a_side_of_the_room_spoken_of() -> None:
    program = read(
        "The bathroom is on the western side of the house. The living room is to the east, and common room 2 is to "
        "the north. The dimensions are 11X8. Common room 1 is in the southwest corner, with the kitchen to the south. "
        "Common room 2 is in the northwest corner. The kitchen is in the south. To the north is the living room. "
        "The living room is in the center of the plan."
    )
    beside = {(r.of, r.value, r.to) for r in program.requirements if r.kind == "position" and r.to}
    assert beside == {
        ("living_room_1", "east", "bathroom_1"), ("bedroom_2", "north", "bathroom_1"),
        ("kitchen_1", "south", "bedroom_1"), ("living_room_1", "north", "kitchen_1"),
    }  # fmt: skip
    assert {r.of: r.value for r in program.requirements if r.kind == "dimension"} == {"bathroom_1": "3.35 x 2.44"}


REST = ("kitchen at north direction size 8*8 feet bathroom at west direction size 6*6 feet "
        "master room at south west corner size 12*10 feet ")


def places(text: str) -> set[tuple[str, str, str | None]]:
    return {(r.of, str(r.value), r.to) for r in read(text).requirements if r.kind == "position"}


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("living room at east direction upside of master room", [("east", None), ("north", "bedroom_1")]),
        ("living room at south east corner downside of kitchen", [("south_east", None), ("south", "kitchen_1")]),
        ("living room at south east corner right side of master room", [("south_east", None), ("east", "bedroom_1")]),
        ("living room at north east corner left side of the kitchen", [("north_east", None), ("west", "kitchen_1")]),
        ("living room at north west to east direction", [("north", None)]),
        ("living room at east to west direction", []),
        ("living room at south direction", [("south", None)]),
        ("The living room is in the north east corner, adjacent to all rooms to the south.", [("north_east", None)]),
    ],
)
def test_where_a_room_lies_and_of_which(said: str, meant: list[tuple[str, str | None]]) -> None:
    found = places(REST + said + " size 20*12 feet")
    assert {(value, to) for of, value, to in found if of == "living_room_1"} == set(meant)
    assert {("kitchen_1", "north", None), ("bathroom_1", "west", None), ("bedroom_1", "south_west", None)} <= found


@pytest.mark.parametrize(
    ("living", "balcony", "owner"),
    [
        ("north side", "It is in the south west corner, next to the living room and the master room", "bedroom_1"),
        ("west side", "It is in the south west corner, next to the living room and the master room", "living_room_1"),
        ("north side", "It is on the south side, next to the living room", "living_room_1"),
        ("north side", "It is on the north side, next to the master room and the living room", "living_room_1"),
    ],
)
def test_a_balcony_hangs_before_what_lies_at_its_side(living: str, balcony: str, owner: str) -> None:
    program = read(
        f"The living room is on the {living} of the house. The master room is in the south west corner. The kitchen is "
        f"on the east side. The bathroom is in the center. There is a balcony. {balcony}."
    )
    assert [set(pair) for pair in program.links if "balcony_1" in pair] == [{owner, "balcony_1"}]


def test_no_room_is_added_to_a_whole_plan() -> None:
    text = (
        "The living room is in the center. The kitchen is in the north east corner, next to the living room. "
        "The master room is on the west side. The bathroom is on the south side, between master room and kitchen."
    )
    assert Counter(r.type for r in read(text).rooms) == {"living_room": 1, "kitchen": 1, "bedroom": 1, "bathroom": 1}


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        ("kitchen 3 x 4 m", "3 x 4"),
        ("kitchen 10 feet in width and 12 feet in length", "3.05 x 3.66"),
        ("kitchen 10 ft. by 12 ft.", "3.05 x 3.66"),
        ("kitchen 10*12 sq ft", "3.05 x 3.66"),
        ("kitchen 12x10, living room 20x15, bedroom 12x12", "3.66 x 3.05"),
        ("kitchen 3x4, living room 6x5, bedroom 4x4", "3 x 4"),
        ("Küche 3 m breit und 4 m lang", "3 x 4"),
    ],
)
def test_lengths_and_widths(text: str, sides: str) -> None:
    kitchen = next(r for r in read(text).requirements if r.kind == "dimension" and r.of == "kitchen_1")
    assert kitchen.value == sides


@pytest.mark.parametrize("size", [
    "It is 24 m2. It is 4 m wide by 6 m long.", "It is 4 m wide by 6 m long. It is 24 m2."])
def test_sides_that_are_told_beside_an_area_are_kept(size: str) -> None:
    program = read(
        f"The living room is on the north side. {size} The kitchen is on the south side. The bedroom is on the west "
        "side. The bathroom is on the east side."
    )
    assert [(r.of, r.value) for r in program.requirements if r.kind == "dimension"] == [("living_room_1", "4 x 6")]
    assert next(room.area for room in program.rooms if room.id == "living_room_1") == 24

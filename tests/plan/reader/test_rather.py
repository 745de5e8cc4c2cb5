"""Rooms, places and things that are to be others than those first named, and what `it` is at an entrance."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

FLAT = "Two-bed flat."


def kinds(program: Program) -> list[str]:
    return [r.type for r in program.rooms]


def doors(program: Program, room: str) -> set[str]:
    return {a if b == room else b for a, b in program.links if room in (a, b)}


@pytest.mark.parametrize("text", [
    "Two-bed flat with a study. Actually the study can be left out.", "Two-bed flat with a study. Hmm, better without.",
])  # fmt: skip
def test_what_is_left_out_is_not_there(text: str) -> None:
    program = read(text)
    assert "study" not in kinds(program) and not program.unread


def test_one_of_those_counted_becomes_another_room() -> None:
    program = read("Three-bed flat. Make one of the bedrooms a study instead.")
    assert kinds(program).count("bedroom") == 2 and kinds(program).count("study") == 1 and not program.unread
    program = read("Three bedrooms, two baths. Change the second bath to a toilet.")
    assert kinds(program).count("bathroom") == 2 and min(r.area or 0 for r in program.rooms) < 3


def test_not_an_open_kitchen() -> None:
    program = read(f"{FLAT} Not an open kitchen but a separate one with a door to the hall.")
    assert not program.open_links and doors(program, "kitchen_1") == {"hallway_1"}


def test_a_door_to_each_bedroom_and_none_to_the_hall() -> None:
    program = read(f"{FLAT} The bathroom has a door to each bedroom but none to the hall.")
    assert doors(program, "bathroom_1") == {"bedroom_1", "bedroom_2"}


THINGS = [
    ("The washing machine shouldn't be in the bathroom but in the kitchen.",
     {("kitchen_1", "washing_machine", 1), ("bathroom_1", "washing_machine", 0)}),
    ("Each bedroom gets a wardrobe, the main one two.", {("bedroom_1", "wardrobe", 2), ("bedroom_2", "wardrobe", 1)}),
    ("Each bedroom has a wardrobe. The main bedroom has two wardrobes.",
     {("bedroom_1", "wardrobe", 2), ("bedroom_2", "wardrobe", 1)}),
    ("Three beds: a double in the main bedroom and two singles in the other.",
     {("bedroom_1", "double_bed", 1), ("bedroom_2", "single_bed", 2)}),
    ("Two sofas in the living room, one of them a corner sofa.",
     {("living_room_1", "sofa", 1), ("living_room_1", "corner_sofa", 1)}),
]


@pytest.mark.parametrize(("text", "things"), THINGS)
def test_things_stand_where_they_are_meant_to(text: str, things: set[tuple[str, str, int]]) -> None:
    program = read(f"{FLAT} {text}")
    assert {(o.room, o.category, o.count) for o in program.objects} == things
    assert kinds(program).count("bedroom") == 2


PLACES = [
    ("The kitchen is in the north-west corner, the bathroom in the north-east one.",
     {("position", "kitchen_1", None, "north_west"), ("position", "bathroom_1", None, "north_east")}),
    ("The first door on the right is the bathroom, the second the kitchen.",
     {("position", "bathroom_1", None, "right"), ("position", "kitchen_1", None, "right")}),
    ("The kitchen is at the opposite end of the flat from the living room.",
     {("apart", "kitchen_1", "living_room_1", None)}),
    ("The kitchen is to the left of the entrance, the bathroom to the right of it.",
     {("position", "kitchen_1", "entrance", "left"), ("position", "bathroom_1", "entrance", "right")}),
    ("Every room apart from the bathroom has at least 8 m².",
     {("at_least", room, None, "8") for room in ("kitchen_1", "living_room_1", "bedroom_1", "bedroom_2")}),
]


@pytest.mark.parametrize(("text", "asked"), PLACES)
def test_places(text: str, asked: set[tuple[str, str, str | None, str | None]]) -> None:
    program = read(f"{FLAT} {text}")
    assert {(r.kind, r.of, r.to, r.value) for r in program.requirements} == asked and not program.unread


def test_numbers_and_shares() -> None:
    program = read("Two-bed flat, at least 60 m² but no more than 70.")
    assert {(r.kind, r.of, float(r.value or 0)) for r in program.requirements} == {
        ("at_least", "home", 60.0), ("at_most", "home", 70.0)}  # fmt: skip
    areas = {r.id: r.area or 0 for r in read(f"{FLAT} The bathroom is a third of the size of the main bedroom.").rooms}
    assert areas["bathroom_1"] == pytest.approx(areas["bedroom_1"] / 3, rel=0.01)


def test_the_latter_is_open_to_the_living_room() -> None:
    program = read("A kitchen and a dining room, the latter open to the living room. One-bedroom flat.")
    assert program.open_links == [("dining_room_1", "living_room_1")]

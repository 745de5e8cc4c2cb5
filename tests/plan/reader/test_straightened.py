"""Clauses whose order or words mislead about doors, neighbours, sizes and limits."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

FLAT = "Two-bedroom flat."
Asked = set[tuple[str, str, str | None, str | None]]


def asked(program: Program) -> Asked:
    return {(r.kind, r.of, r.to, r.value) for r in program.requirements}


def doors(program: Program, room: str) -> set[str]:
    return {a if b == room else b for a, b in program.links if room in (a, b)}


SAID: list[tuple[str, Asked]] = [
    ("No corridor longer than 3 m.", {("at_most", "hallway_1", "length", "3")}),
    ("Neither bedroom should have a door to the living room.",
     {("no_door", f"bedroom_{n}", "living_room_1", None) for n in (1, 2)}),
    ("No bedroom may be next to the kitchen or the entrance.",
     {("apart", f"bedroom_{n}", to, None) for n in (1, 2) for to in ("kitchen_1", "entrance")}),
    ("Keep the kitchen and the bathroom together, but the bedrooms apart.",
     {("adjacent", "kitchen_1", "bathroom_1", None), ("apart", "bedroom_1", "bedroom_2", None)}),
    ("Kitchen and living room on opposite sides of the hall.", {("opposite", "kitchen_1", "living_room_1", None)}),
    ("The living room should be the biggest, then the kitchen, then the bathroom.",
     {("order", "living_room_1", None, "largest"), ("order", "living_room_1", "kitchen_1", "larger"),
      ("order", "kitchen_1", "bathroom_1", "larger")}),
]  # fmt: skip


@pytest.mark.parametrize(("text", "wishes"), SAID)
def test_wishes(text: str, wishes: Asked) -> None:
    program = read(f"{FLAT} {text}")
    assert asked(program) == wishes and not program.unread
    assert {r.type for r in program.rooms} == {"living_room", "kitchen", "bedroom", "bathroom", "hallway"}


@pytest.mark.parametrize("text", [
    "Nothing but the bathroom between the two bedrooms.", "The bathroom must be between them.",
    "The bathroom it must be between them.",
])  # fmt: skip
def test_a_bathroom_between_the_bedrooms(text: str) -> None:
    program = read(f"{FLAT} {text}")
    assert doors(program, "bathroom_1") == {"bedroom_1", "bedroom_2"}
    assert any(r.type == "living_room" for r in program.rooms)


def test_the_only_way() -> None:
    program = read("A one-bedroom flat with a dining room. The only way to the kitchen is through the dining room.")
    assert doors(program, "kitchen_1") == {"dining_room_1"}


def test_a_desk_for_two_counts_no_rooms() -> None:
    program = read(f"{FLAT} A desk for two in the study.")
    assert {(o.room, o.category, o.count) for o in program.objects} == {("study_1", "desk", 1)}
    assert doors(program, "study_1") == {"hallway_1"}


def test_it_is_the_hall() -> None:
    program = read("Need a 2-bed flat: hall in the middle, every room opens off it, kitchen opposite the living room.")
    assert doors(program, "hallway_1") == {r.id for r in program.rooms} - {"hallway_1"}
    assert len(program.links) == len(program.rooms) - 1


def test_a_bath_that_stands_in_the_bathroom() -> None:
    program = read(f"{FLAT} A bath and a shower in the bathroom.")
    assert {(o.room, o.category) for o in program.objects} == {("bathroom_1", "bath"), ("bathroom_1", "shower")}


def test_a_room_counted_and_then_limited_is_one_room() -> None:
    program = read("rooms: bedroom x2, bathroom x1, kitchen. constraints: bathroom <= 6 m2.")
    assert sum(r.type == "bathroom" for r in program.rooms) == 1
    assert asked(program) == {("at_most", "bathroom_1", None, "6")}


@pytest.mark.parametrize("text", [
    "Each bedroom is at least 11 m², the living room and the kitchen together have 30 m². Two-bedroom flat.",
    "Appartement de deux chambres : chaque chambre fait au moins 11 m², le séjour et la cuisine font ensemble 30 m².",
    "Zwei Schlafzimmer mit mindestens 11 m², Küche und Wohnzimmer haben zusammen 30 m².",
])  # fmt: skip
def test_an_area_of_two_beside_that_of_each(text: str) -> None:
    areas = {r.id: r.area or 0 for r in read(text).rooms}
    assert areas["living_room_1"] + areas["kitchen_1"] == pytest.approx(30, abs=0.05) and areas["bedroom_1"] >= 11


def test_a_spanish_clause_goes_on() -> None:
    program = read("Piso de dos dormitorios: el baño solo tiene puerta al pasillo y la cocina está junto al comedor.")
    assert doors(program, "bathroom_1") == {"hallway_1"}


def test_nobody_walks_through_the_kitchen_to_the_living_room() -> None:
    program = read(f"{FLAT} Dining room open to the living room. Kitchen has a door to the hallway and a door to the "
                   "dining room.")  # fmt: skip
    assert doors(program, "hallway_1") >= {"living_room_1", "kitchen_1"}
    row = read("The kitchen has a door to the utility room, which has no other door. Two bedrooms, one bath.")
    assert not row.requirements and doors(row, "utility_1") == {"kitchen_1"}

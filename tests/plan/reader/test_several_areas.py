"""Areas of several rooms: of each of them, of all together, and limits that none passes."""

import pytest

from apartgen.stages.plan.reader import read

FLAT = "2 bedrooms, a study."
LIVED = ("kitchen_1", "living_room_1")
EACH = [
    ("The study and both bedrooms are 12 m² each.", ("study_1", "bedroom_1", "bedroom_2")),
    ("The study and the bedrooms are each 12 m².", ("study_1", "bedroom_1", "bedroom_2")),
    ("The study, the kitchen and the bathroom have 12 m² each.", ("study_1", "kitchen_1", "bathroom_1")),
]
LIMITED = [
    ("The study and the bedrooms should be at least 12 m².", "at_least", {"study_1", "bedroom_1", "bedroom_2"}),
    ("Each of the bedrooms and the study must be at least 12 m².", "at_least", {"study_1", "bedroom_1", "bedroom_2"}),
    ("The study as well as the kitchen must be at least 12 m².", "at_least", {"study_1", "kitchen_1"}),
    ("Neither the study nor the kitchen should be larger than 12 m².", "at_most", {"study_1", "kitchen_1"}),
    ("Neither the study nor the kitchen should be smaller than 12 m².", "at_least", {"study_1", "kitchen_1"}),
    ("The living room is 24 m², the kitchen and the study at most 12 m².", "at_most", {"study_1", "kitchen_1"}),
]
TOGETHER = [
    ("Kitchen and living room share 30 m².", LIVED), ("A kitchen and a living room that share 30 m².", LIVED),
    ("The kitchen and the living room have 30 m² in total.", LIVED),
    ("The kitchen, the dining room and the living room together measure 30 m².", (*LIVED, "dining_room_1")),
    ("The two bedrooms add up to 30 m².", ("bedroom_1", "bedroom_2")),
    ("The kitchen and both bedrooms together have 30 m².", ("kitchen_1", "bedroom_1", "bedroom_2")),
]  # fmt: skip


def areas(text: str) -> dict[str, float]:
    program = read(text)
    assert program.total_area is None and not program.unread
    return {r.id: r.area or 0.0 for r in program.rooms}


@pytest.mark.parametrize(("text", "rooms"), EACH)
def test_an_area_said_of_a_list_is_that_of_each(text: str, rooms: tuple[str, ...]) -> None:
    assert {areas(f"{FLAT} {text}")[r] for r in rooms} == {12.0}


@pytest.mark.parametrize(("text", "kind", "rooms"), LIMITED)
def test_a_limit_said_of_a_list_is_that_of_each(text: str, kind: str, rooms: set[str]) -> None:
    found = [r for r in read(f"{FLAT} {text}").requirements if r.kind != "area"]
    assert {r.of for r in found} == rooms and {(r.kind, float(r.value or 0)) for r in found} == {(kind, 12.0)}


@pytest.mark.parametrize("words", ["larger than 25 m² nor smaller than 18 m²", "smaller than 18 nor larger than 25 m²"])
def test_both_limits_of_one_area(words: str) -> None:
    program = read(f"{FLAT} The living room must not be {words}.")
    assert {(r.kind, r.of, r.value) for r in program.requirements} == {
        ("at_least", "living_room_1", "18"), ("at_most", "living_room_1", "25")}  # fmt: skip
    assert program.total_area is None


@pytest.mark.parametrize(("text", "rooms"), TOGETHER)
def test_an_area_of_several_is_shared(text: str, rooms: tuple[str, ...]) -> None:
    found = areas(f"{FLAT} {text}")
    assert sum(found[r] for r in rooms) == pytest.approx(30.0, abs=0.05)
    assert found["bathroom_1"] == 5.0


def test_an_area_behind_a_list_is_that_of_the_last_room() -> None:
    found = areas("Two bedrooms. The living room, the kitchen, is 12 m².")
    assert found["kitchen_1"] == 12.0 and found["living_room_1"] > 20

"""What is said of one room and in fewer words of another, and rooms of people among those counted."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

FLAT = "Two-bedroom flat."
BEDS = {"bedroom_1", "bedroom_2"}


def pairs(program: Program, kind: str) -> set[frozenset[str | None]]:
    return {frozenset((r.of, r.to)) for r in program.requirements if r.kind == kind}


def test_neither_must_another_room() -> None:
    told = "The kitchen must not share a wall with the bathroom, and neither must the study"
    found = read(f"{FLAT} {told} with the living room.")
    assert pairs(found, "apart") == {frozenset(("kitchen_1", "bathroom_1")), frozenset(("study_1", "living_room_1"))}
    found = read(f"{FLAT} {told}.")
    assert pairs(found, "apart") == {frozenset(("kitchen_1", "bathroom_1")), frozenset(("study_1", "bathroom_1"))}


@pytest.mark.parametrize("words", ["and so does the living room", "as does the living room", "like the living room"])
def test_another_room_faces_the_same_side(words: str) -> None:
    program = read(f"{FLAT} The bedrooms face south, {words}.")
    assert {(r.of, r.kind, r.value) for r in program.requirements} == {
        (room, "orientation", "south") for room in {*BEDS, "living_room_1"}}  # fmt: skip


def test_a_door_like_that_of_others() -> None:
    program = read("Two bedrooms which open off the hallway, as the only bathroom does, and a kitchen off the lounge.")
    assert {a if b == "hallway_1" else b for a, b in program.links if "hallway_1" in (a, b)} >= {*BEDS, "bathroom_1"}
    assert not any({a, b} <= {*BEDS, "bathroom_1"} for a, b in program.links)


@pytest.mark.parametrize("before", ["The study is next to the kitchen.", "The study faces north."])
def test_it_is_compared(before: str) -> None:
    program = read(f"{FLAT} {before} It should be larger than the bathroom.")
    assert {(r.of, r.to, r.value) for r in program.requirements if r.kind == "order"} == {
        ("study_1", "bathroom_1", "larger")}  # fmt: skip


def test_swapped_for_another() -> None:
    program = read("A flat with 3 bedrooms and a study. Swap the study for a second bathroom.")
    kinds = [r.type for r in program.rooms]
    assert "study" not in kinds and kinds.count("bathroom") == 2


def test_a_way_on_foot_and_another_door() -> None:
    program = read("Game map. You walk from the hall into the living room, from the living room into the kitchen and "
                   "from the kitchen into the pantry; another door leads from the hall into the bedroom, and the "
                   "bathroom can be reached only through the bedroom.")  # fmt: skip
    assert {frozenset(link) for link in program.links} == {
        frozenset(pair) for pair in (("hallway_1", "living_room_1"), ("living_room_1", "kitchen_1"),
                                     ("kitchen_1", "storage_1"), ("hallway_1", "bedroom_1"),
                                     ("bathroom_1", "bedroom_1"))}  # fmt: skip
    assert not program.open_links


@pytest.mark.parametrize("text", [
    "We need three bedrooms: one for us, one for her and one for our son. The grandmother's bedroom is next to the "
    "bathroom.",
    "三间卧室、一间客厅、一间厨房和两个卫生间，其中一个卫生间在主卧里，爷爷奶奶的卧室朝南。",
    "The grandparents have an own bedroom with an own shower room, then the parents' bedroom, one room for the two "
    "children, a family bathroom off the hallway, a kitchen, and a living room.",
])  # fmt: skip
def test_rooms_of_people_are_among_those_there_are(text: str) -> None:
    program = read(text)
    assert sum(r.type == "bedroom" for r in program.rooms) == 3
    assert not any(a.startswith("bedroom") and b.startswith("bedroom") for a, b in program.links)


def test_studies_and_games_that_are_no_rooms() -> None:
    for text in ("Dead ends matter in our exploration study: a two-bedroom flat.",
                 "Co-op cooking game: a two-bedroom flat."):  # fmt: skip
        kinds = [r.type for r in read(text).rooms]
        assert "study" not in kinds and kinds.count("kitchen") == 1 and kinds.count("bedroom") == 2


def test_a_large_store_is_no_home() -> None:
    program = read("A living room, a bedroom, a bathroom, a hallway and a storage room of 15 m².")
    assert program.total_area is None and {r.id: r.area for r in program.rooms}["storage_1"] == 15


def test_things_spoken_of_and_then_counted() -> None:
    program = read("I collect plants. A one-bedroom flat with ten plants in the living room.")
    assert [(o.room, o.category, o.count) for o in program.objects] == [("living_room_1", "plant", 10)]


def test_a_separate_toilet_behind_a_bath() -> None:
    program = read("Appartement : trois chambres, une salle de bains avec baignoire, des toilettes séparées.")
    assert sum(r.type == "bathroom" for r in program.rooms) == 2


def test_a_place_behind_a_colon() -> None:
    program = read("bedrooms: 1; bathrooms: 1; kitchen: north of the living room")
    assert [(r.kind, r.of, r.to, r.value) for r in program.requirements] == [
        ("position", "kitchen_1", "living_room_1", "north")]  # fmt: skip

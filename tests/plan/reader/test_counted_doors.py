"""How many doors a room is to have, as people say it."""

import pytest

from apartgen.stages.plan.reader import read

FLAT = "2 bedrooms, one bathroom"
ONE = {("at_most", "bathroom_1", 1.0)}
TWO = {("at_most", "bedroom_1", 1.0), ("at_most", "bedroom_2", 1.0)}
SAID = [
    (f"{FLAT}. The bathroom has only one door.", ONE),
    (f"{FLAT}, and the bathroom has just one door", ONE),
    (f"{FLAT} with a single door", ONE),
    (f"{FLAT}; the bathroom gets one door only", ONE),
    (f"{FLAT}; the bathroom should not have a second door", ONE),
    (f"No second door to the bathroom; {FLAT}.", ONE),
    (f"{FLAT}. One door to the bathroom is enough.", ONE),
    (f"{FLAT}. There is only one door to the bathroom.", ONE),
    (f"{FLAT}. No bedroom has more than one door.", TWO),
    (f"{FLAT}. Each bedroom has only one door.", TWO),
    (f"{FLAT}. The kitchen needs two doors.", {("at_least", "kitchen_1", 2.0)}),
    ("Zwei Schlafzimmer. Das Bad hat nur eine Tür.", ONE),
    ("Appartement avec deux chambres. La salle de bain n'a qu'une seule porte.", ONE),
    ("Piso de dos dormitorios. El baño tiene una sola puerta.", ONE),
    ("两室一厅一卫，卫生间只有一扇门。", ONE),
]
TO_THE_LOUNGE = [
    "has only one door, to the living room", "has one door, to the living room",
    "has just one door, which leads to the living room", "has one door only, from the living room",
]  # fmt: skip


@pytest.mark.parametrize(("text", "limits"), SAID)
def test_doors_that_are_counted_are_limited(text: str, limits: set[tuple[str, str, float]]) -> None:
    program = read(text)
    assert {(r.kind, r.of, float(r.value or 0)) for r in program.requirements if r.to == "doors"} == limits
    assert len(program.requirements) == len(limits) and not program.unread


def test_a_limit_stands_beside_a_door_denied() -> None:
    program = read("One bedroom. No door between the kitchen and the living room, and the bathroom has only one door.")
    assert {(r.kind, r.of) for r in program.requirements} == {("no_door", "kitchen_1"), ("at_most", "bathroom_1")}


@pytest.mark.parametrize("words", TO_THE_LOUNGE)
def test_the_one_door_is_where_it_is_said(words: str) -> None:
    program = read(f"{FLAT}. The kitchen {words}.")
    assert [set(link) for link in program.links if "kitchen_1" in link] == [{"kitchen_1", "living_room_1"}]


def test_doors_told_one_by_one_are_no_limit() -> None:
    program = read(f"{FLAT}. The kitchen has two doors, one to the hall and one to the living room.")
    assert not program.requirements
    assert {a if b == "kitchen_1" else b for a, b in program.links if "kitchen_1" in (a, b)} == {
        "hallway_1", "living_room_1"}  # fmt: skip
    two = read(f"{FLAT}. The kitchen has one door to the hall and one to the living room.")
    assert not two.requirements and len([link for link in two.links if "kitchen_1" in link]) == 2

"""What is said of all rooms of a list that is a subject."""

import pytest

from apartgen.stages.plan.reader import read

BEDS = {"bedroom_1", "bedroom_2"}
SAID = [
    ("2 bed flat where the living room and both bedrooms face south and the kitchen faces north", "orientation",
     {*BEDS, "living_room_1"}),
    ("2 bed flat; living room, kitchen and both bedrooms face south", "orientation",
     {*BEDS, "living_room_1", "kitchen_1"}),
    ("2 bed flat where both bedrooms and the kitchen are on the south side", "position", {*BEDS, "kitchen_1"}),
    ("2 bed flat. The kitchen, living room and bedrooms should all face south.", "orientation",
     {*BEDS, "living_room_1", "kitchen_1"}),
    ("2 bed flat with the living room and both bedrooms facing south", "orientation", {*BEDS, "living_room_1"}),
    ("2 bedrooms, a study, the kitchen and the living room face south", "orientation", {"kitchen_1", "living_room_1"}),
    ("3 bedrooms. The living room and two bedrooms face south.", "orientation", {*BEDS, "living_room_1"}),
    ("3 bedrooms. Two bedrooms face south.", "orientation", BEDS),
    ("The kitchen is next to the bathroom, the living room and the study face south.", "orientation",
     {"living_room_1", "study_1"}),
    ("A kitchen, a living room and a study facing south.", "orientation", {"study_1"}),
    ("The flat has a kitchen, a bathroom and two bedrooms on the south side.", "position", BEDS),
    ("Zwei Schlafzimmer. Wohnzimmer, Küche und beide Schlafzimmer liegen nach Süden.", "orientation",
     {*BEDS, "living_room_1", "kitchen_1"}),
    ("T3. Le salon et les deux chambres donnent au sud.", "orientation", {*BEDS, "living_room_1"}),
    ("两室一厅，客厅和两个卧室都朝南。", "orientation", {*BEDS, "living_room_1"}),
]


@pytest.mark.parametrize(("text", "kind", "rooms"), SAID)
def test_a_side_said_of_a_list_is_that_of_each(text: str, kind: str, rooms: set[str]) -> None:
    found = [r for r in read(text).requirements if r.value == "south"]
    assert {r.of for r in found} == rooms and {r.kind for r in found} == {kind}


def test_a_list_is_far_from_the_entrance() -> None:
    program = read("2 bed flat, study. The study, the bathroom and all bedrooms are far from the entrance.")
    assert {r.of for r in program.requirements if r.kind == "apart"} == {*BEDS, "study_1", "bathroom_1"}


def test_a_side_without_its_verb_is_faced_as_the_one_before() -> None:
    program = read("2 bed flat. Living room faces south, kitchen and bathroom north, bedrooms east.")
    assert {(r.of, r.value) for r in program.requirements if r.kind == "orientation"} == {
        ("living_room_1", "south"), ("kitchen_1", "north"), ("bathroom_1", "north"), ("bedroom_1", "east"),
        ("bedroom_2", "east")}  # fmt: skip

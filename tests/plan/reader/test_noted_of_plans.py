"""What is noted of a plan in passing: loops, pairs of neighbours, ways, limits, and what no plan is asked for."""

from collections import Counter

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read


def kinds(program: Program) -> Counter[str]:
    return Counter(str(room.type) for room in program.rooms)


def asked(program: Program) -> set[tuple[str, str, str | None, str | None]]:
    return {(r.kind, r.of, r.to, r.value) for r in program.requirements}


@pytest.mark.parametrize("study", ["assistive robot study", "a user study", "our robotics study"])
def test_a_study_of_research_is_no_room(study: str) -> None:
    assert not kinds(read(f"layout for {study}: one bedroom flat"))["study"]


@pytest.mark.parametrize("study", ["a small study for home office", "a study as a home office"])
def test_a_study_to_work_in_is_one(study: str) -> None:
    assert kinds(read(f"two bedroom flat with {study}"))["study"] == 1


@pytest.mark.parametrize("doors", [
    "all doors at least 90 cm wide", "every door must be at least 0.9 m wide", "doors of 90 cm", "90 cm wide doors",
    "doors no narrower than 85 cm", "alle Türen mindestens 90 cm breit", "les portes de 90 cm de large",
    "puertas de al menos 90 cm",
])  # fmt: skip
def test_widths_of_doors_are_told_and_none_of_rooms(doors: str) -> None:
    program = read(f"one bedroom flat, {doors}")
    assert not program.requirements
    assert any("how wide doors are" in words for words in program.unread)


@pytest.mark.parametrize("sides", ["on the north and south sides", "to the south", "facing east and west"])
def test_windows_of_a_home_place_no_bedroom(sides: str) -> None:
    program = read(f"two-bedroom flat, windows only {sides}")
    assert not program.requirements
    assert program.unread


@pytest.mark.parametrize("said", [
    "a bathroom without toilet", "a bathroom with no wc", "a shower room without a toilet"])
def test_what_no_plan_has_is_told(said: str) -> None:
    assert read(f"one bedroom flat with {said}").unread


@pytest.mark.parametrize("said", [
    "kitchen with island, living room with a TV, connected by a wide opening",
    "living room with two armchairs, kitchen with an island, joined by an archway",
    "knock the kitchen through to the living room", "knock through the wall between the kitchen and the living room",
])  # fmt: skip
def test_open_to_one_another(said: str) -> None:
    assert ("kitchen_1", "living_room_1") in read(f"One bedroom flat. {said}.").open_links


@pytest.mark.parametrize("said", ["a loop between", "there is a loop through", "a circular route from"])
def test_loops_have_a_door_from_each_to_the_next(said: str) -> None:
    program = read(f"two bedroom flat; {said} kitchen, dining room and living room")
    loop = {("dining_room_1", "kitchen_1"), ("dining_room_1", "living_room_1"), ("kitchen_1", "living_room_1")}
    assert loop <= set(program.links)
    assert not program.requirements


def test_pairs_of_neighbours() -> None:
    program = read("two bedrooms, adjacency: bed1-bath, kitchen-living")
    assert kinds(program)["bedroom"] == 2
    pairs = {("adjacent", "bedroom_1", "bathroom_1", None), ("adjacent", "kitchen_1", "living_room_1", None)}
    assert asked(program) == pairs


@pytest.mark.parametrize("way", [
    "bathroom must be reachable without passing through a bedroom",
    "the bathroom is accessible without going through any bedroom",
])  # fmt: skip
def test_not_through_bedrooms(way: str) -> None:
    program = read(f"Exactly 5 rooms (living room, kitchen, 2 bedrooms, bathroom), no corridors, {way}.")
    assert kinds(program)["bedroom"] == 2
    assert ("bathroom_1", "living_room_1") in program.links


@pytest.mark.parametrize("area", ["max area 80", "maximum area: 80 m2", "max total area = 80"])
def test_limits_in_lists(area: str) -> None:
    program = read(f"bedrooms>=2; bathrooms=1; {area}")
    assert kinds(program)["bedroom"] == 2
    assert asked(program) == {("at_most", "home", None, "80")}


@pytest.mark.parametrize("bath", [
    "one bathroom between the two bedrooms with a door from each (jack and jill)",
    "a bathroom between both bedrooms with doors to both",
])  # fmt: skip
def test_a_bathroom_between_two_bedrooms_is_one(bath: str) -> None:
    program = read(f"two bedrooms, {bath}, plus kitchen and living room")
    assert kinds(program)["bathroom"] == 1
    assert {("bathroom_1", "bedroom_1"), ("bathroom_1", "bedroom_2")} <= set(program.links)


@pytest.mark.parametrize("way", ["Bedroom is after living room", "The bedroom comes after the living room"])
def test_rooms_after_others_are_reached_through_them(way: str) -> None:
    assert ("bedroom_1", "living_room_1") in read(f"Flat with a hall, kitchen and bathroom. {way}.").links


@pytest.mark.parametrize("most", ["is the most big", "must be the biggest", "should be largest"])
def test_the_largest_of_bedrooms(most: str) -> None:
    larger = {("order", "bedroom_1", f"bedroom_{n}", "larger") for n in (2, 3)}
    assert asked(read(f"Three bedrooms, the one of parents {most}.")) == larger


@pytest.mark.parametrize("where", ["must to be in the side of kitchen", "must be on the side of the kitchen"])
def test_beside_rooms_in_other_words(where: str) -> None:
    assert ("balcony_1", "kitchen_1") in read(f"Apartment of 60 m2 with balcony, the balcony {where}.").links


def test_her_room_near_the_bathroom() -> None:
    program = read("My grandmother she live with us so she need a room near to bathroom.")
    assert ("adjacent", "bedroom_2", "bathroom_1", None) in asked(program)


def test_no_hall_and_two_doors() -> None:
    program = read("Flat has not corridor. You enter direct in the living room with the kitchen inside. "
                   "Two doors: one for bedroom and one for bathroom.")  # fmt: skip
    assert kinds(program) == {"living_room": 1, "kitchen": 1, "bedroom": 1, "bathroom": 1}
    assert {("bathroom_1", "living_room_1"), ("bedroom_1", "living_room_1")} <= set(program.links)


@pytest.mark.parametrize("place", ["place for washing machine", "space for a washing machine"])
def test_a_place_for_machines_is_not_the_bedroom(place: str) -> None:
    program = read(f"Flat. One bedroom with big wardrobe and {place}.")
    assert ("bathroom_1", "washing_machine") in {(o.room, o.category) for o in program.objects}

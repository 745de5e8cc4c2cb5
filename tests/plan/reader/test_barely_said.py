"""Few words, or such as learners of English write: rooms that are none, or were counted before."""

from collections import Counter

import pytest

from apartgen.stages.plan.reader import read

COUNTS = [
    ("Flat with three bedrooms and two bathrooms. Main bedroom in the north.", "bedroom", 3),
    ("Flat with three bedrooms. Master bedroom facing east, kitchen west.", "bedroom", 3),
    ("Two bedrooms and a study. Largest bedroom near the bathroom.", "bedroom", 2),
    ("House for a family with three children. Every child has its own bedroom. The parents have a bedroom with a "
     "bathroom.", "bedroom", 4),
    ("House for family with three childrens: every child have own bedroom, and the parents have bedroom with own "
     "bathroom.", "bedroom", 4),
    ("Single-room environment for a test: a kitchen of 14 m².", "bedroom", 0),
    ("exclude: [hallway]\nrooms: [living_room, kitchen, bedroom, bathroom]", "hallway", 0),
    ("two-bedroom flat; without: [hallway, balcony]", "balcony", 0),
    ("two-bedroom flat; without: [hallway, balcony]", "hallway", 0),
    ('{"bedrooms": 2, "exclude": ["dining_room"]}', "dining_room", 0),
    ("It is not needed a dining room. One-bedroom flat.", "dining_room", 0),
    ("One-bedroom flat, and please a small room for to wash the clothes.", "utility", 1),
    ("A unit-test scene: a kitchen and a living room with a door between them, nothing else.", "bedroom", 0),
    ("Produce layout: bedroom with ensuite bathroom and walk-in closet, nothing else.", "living_room", 0),
    ('{"home": {"bedroom": 2, "study": 1}, "constraints": ["study apart from kitchen"]}', "study", 1),
]


@pytest.mark.parametrize(("said", "kind", "count"), COUNTS)
def test_so_many_rooms_are_meant(said: str, kind: str, count: int) -> None:
    program = read(said)
    assert Counter(room.type for room in program.rooms)[kind] == count and not program.unread


def test_two_rooms_are_told_whole() -> None:
    program = read("Two rooms for an experiment: a bedroom and a study, with one door between them.")
    assert sorted(room.id for room in program.rooms) == ["bedroom_1", "study_1"]
    assert [set(pair) for pair in program.links] == [{"bedroom_1", "study_1"}]


def test_rooms_that_are_apart_are_asked_to_be() -> None:
    program = read("Two-bedroom flat with a study. The study is apart from the kitchen.")
    assert [(r.kind, {r.of, r.to}) for r in program.requirements] == [("apart", {"study_1", "kitchen_1"})]


def test_two_times_so_big_is_twice_as_large() -> None:
    program = read("Two-bedroom flat, the living room is two times so big as the kitchen.")
    areas = {room.id: room.area or 0.0 for room in program.rooms}
    assert areas["living_room_1"] == pytest.approx(2 * areas["kitchen_1"], rel=0.02)


WAYS = ["has doorway to", "has an entrance from", "has its own entrance from", "has a passage to"]


@pytest.mark.parametrize("said", WAYS)
def test_a_way_in_from_a_room_is_a_door(said: str) -> None:
    program = read(f"Two-bedroom flat with a study. The kitchen {said} the study.")
    assert {"kitchen_1", "study_1"} in [set(pair) for pair in program.links] and not program.unread


AREAS = [
    ('{"areas": {"living_room": 28, "kitchen": 12, "bedroom_1": 16, "bedroom_2": 11}, "unit": "m2"}', [28, 12, 16, 11]),
    ('{"living_room": 28, "kitchen": 9, "bedroom_1": 16, "bedroom_2": 11}', [28, 9, 16, 11]),
    ("living_room: 24\nkitchen: 10\nbedroom_1: 14\nbedroom_2: 12", [24, 10, 14, 12]),
    ('{"rooms": {"living_room": 24.5, "kitchen": 9, "bedroom_1": 12, "bedroom_2": 9}}', [24.5, 9, 12, 9]),
]


@pytest.mark.parametrize(("said", "areas"), AREAS)
def test_numbers_too_large_for_counts_are_areas(said: str, areas: list[float]) -> None:
    program = read(said)
    asked = {r.of: float(r.value or 0) for r in program.requirements if r.kind == "area"}
    assert [asked[room] for room in ("living_room_1", "kitchen_1", "bedroom_1", "bedroom_2")] == areas
    assert Counter(room.type for room in program.rooms)["living_room"] == 1 and not program.unread


def test_small_numbers_are_counts() -> None:
    program = read('{"living_room": 1, "kitchen": 1, "bedroom": 4, "bathroom": 2}')
    counts = Counter(room.type for room in program.rooms)
    assert (counts["living_room"], counts["bedroom"], counts["bathroom"]) == (1, 4, 2)
    assert not [r for r in program.requirements if r.kind == "area"]


def test_a_balcony_leaves_the_dining_room_its_doors() -> None:
    program = read("Flat with 3 bedrooms, a dining room, and a balcony off the dining room.")
    doors = {frozenset(pair) for pair in program.links if "dining_room_1" in pair}
    assert doors == {frozenset(("dining_room_1", room)) for room in ("balcony_1", "kitchen_1", "living_room_1")}


@pytest.mark.parametrize("before", ["plan_home(%s)", "Tool call: plan_home. Args: %s", "generate_layout: %s;"])
def test_a_call_is_read_by_its_arguments(before: str) -> None:
    program = read(before % '{"bedrooms": 2, "areas": {"living_room": 28, "bedroom_2": 11}}')
    areas = {r.of: r.value for r in program.requirements if r.kind == "area"}
    assert areas == {"living_room_1": "28", "bedroom_2": "11"}
    assert Counter(room.type for room in program.rooms)["bedroom"] == 2


def test_two_times_so_small_is_not_twice_as_large() -> None:
    program = read("Two-bedroom flat, the kitchen is two times so small as the living room.")
    areas = {room.id: room.area or 0.0 for room in program.rooms}
    assert areas["kitchen_1"] < areas["living_room_1"]

"""Lists with numbers or bars, keys and values, signs for limits; what rooms of one phrase are to one another."""

from collections import Counter

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

FLAT = {"living_room": 1, "kitchen": 1, "bedroom": 2, "bathroom": 1, "hallway": 1}


def rooms(prompt: str) -> dict[str, int]:
    """How many of each type."""
    return dict(Counter(room.type for room in read(prompt).rooms))


def asked(prompt: str) -> set[tuple[str, str, str | None, str | None]]:
    """Requirements without their words."""
    return {(r.kind, r.of, r.to, str(r.value) if r.value else None) for r in read(prompt).requirements}


def area(program: Program, room: str) -> float | None:
    """What a room is to have."""
    return next(r.area for r in program.rooms if r.id == room)


@pytest.mark.parametrize("prompt", [
    "1. living room 2. kitchen 3. bedroom 4. bedroom 5. bathroom 6. hall",
    "1) hall\n2) living room\n3) kitchen\n4) bedroom\n5) bedroom\n6) bathroom",
    "hall | living room | kitchen | bathroom | two bedrooms",
    "type: flat; bedrooms: 2; bathrooms: 1",
    "bed:2 bath:1 study:0",
])  # fmt: skip
def test_lists_are_the_rooms_they_list(prompt: str) -> None:
    assert rooms(prompt) == FLAT


def test_an_extra_is_what_stands_behind_it() -> None:
    assert rooms("bedrooms: 2; extras: balcony, storage") == FLAT | {"balcony": 1, "storage": 1}


def test_values_of_keys_are_areas() -> None:
    nested = read('{"living_room": {"area": 25}, "kitchen": {"area": 10}, "bedroom": {"area_m2": 14}}')
    assert [area(nested, room) for room in ("living_room_1", "kitchen_1", "bedroom_1")] == [25, 10, 14]
    assert sum(room.area or 0 for room in read("{bedrooms: 3, area_m2: 120}").rooms) == pytest.approx(120, rel=0.01)
    assert sum(room.area or 0 for room in read("flat of 60 meters square").rooms) == pytest.approx(60, rel=0.01)


def test_the_size_behind_a_count_of_rooms_is_the_flats() -> None:
    flat = read("Un deux-pièces de 45 m² avec cuisine ouverte")
    assert sum(room.area or 0 for room in flat.rooms) == pytest.approx(45, rel=0.01)


@pytest.mark.parametrize(("prompt", "wanted"), [
    ("two-bedroom flat, hall >= 1.4 m wide", ("at_least", "hallway_1", "width", "1.4")),
    ("two-bedroom flat, total <= 80 m2", ("at_most", "home", None, "80")),
    ("a two-bedroom flat larger than 70 m²", ("at_least", "home", None, "70")),
    ("trois chambres et un séjour d'au moins 25 m²", ("at_least", "living_room_1", None, "25")),
    ("two-bedroom flat, the living room larger than all other rooms", ("order", "living_room_1", None, "largest")),
    ("a flat with two bedrooms opposite each other", ("opposite", "bedroom_1", "bedroom_2", None)),
    ("a flat whose two bedrooms face one another", ("opposite", "bedroom_1", "bedroom_2", None)),
    ("Zwei Schlafzimmer einander gegenüber, ein Bad", ("opposite", "bedroom_1", "bedroom_2", None)),
    ("deux chambres côte à côte, une cuisine", ("adjacent", "bedroom_1", "bedroom_2", None)),
    ("two-bedroom flat; the bedrooms should not touch each other", ("apart", "bedroom_1", "bedroom_2", None)),
    ("two-bedroom flat; the kitchen has no door to the hallway", ("no_door", "kitchen_1", "hallway_1", None)),
    ("Die Küche soll keine Tür zum Flur haben, zwei Schlafzimmer", ("no_door", "kitchen_1", "hallway_1", None)),
    ("la cocina no puede tener puerta al pasillo; dos dormitorios", ("no_door", "kitchen_1", "hallway_1", None)),
])  # fmt: skip
def test_it_becomes_this_requirement_alone(prompt: str, wanted: tuple[str, str, str | None, str | None]) -> None:
    assert asked(prompt) == {wanted}

"""People who have rooms of their own, two limits of one area, areas behind `open`, sides that rooms look to."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read


def count(program: Program, kind: str) -> int:
    return sum(room.type == kind for room in program.rooms)


def area(program: Program, room: str) -> float | None:
    return next(r.area for r in program.rooms if r.id == room)


def rows(program: Program) -> set[tuple[str, str, str | None, str | None]]:
    return {(r.kind, r.of, r.to, None if r.value is None else str(r.value)) for r in program.requirements}


@pytest.mark.parametrize(("text", "bedrooms"), [
    ("A flat for roommates with a bedroom each.", 2), ("Three cousins who want a room each, one bathroom.", 3),
    ("A flat for my parents and me.", 2), ("A flat for my sister and me.", 2), ("A flat for me and my wife.", 1),
    ("Two detectives: a bedroom each, one bathroom.", 2), ("We need two rooms for sleeping, one bathroom.", 2),
    ("A flat with two bedrooms and a room where friends can stay over.", 3),
])  # fmt: skip
def test_everybody_has_a_bedroom_and_a_home_around_it(text: str, bedrooms: int) -> None:
    program = read(text)
    assert count(program, "bedroom") == bedrooms
    assert min(count(program, kind) for kind in ("living_room", "kitchen", "bathroom")) >= 1


def test_a_toilet_of_guests_is_one_more() -> None:
    plain = read("A two-bedroom flat with a bathroom.")
    guests = read("A two-bedroom flat with a bathroom; guests have a toilet.")
    assert count(guests, "bathroom") == count(plain, "bathroom") + 1 and not guests.unread


@pytest.mark.parametrize("text", [
    "Two bedrooms, a study of at least 8 m² and at most 10 m².", "Two bedrooms, a study between 8 and 10 m².",
    "Deux chambres, un bureau entre 8 et 10 m².", "Zwei Schlafzimmer, ein Arbeitszimmer zwischen 8 und 10 m².",
])  # fmt: skip
def test_both_limits_are_those_of_one_room(text: str) -> None:
    program = read(text)
    assert rows(program) == {("at_least", "study_1", None, "8"), ("at_most", "study_1", None, "10")}
    assert area(program, "study_1") == pytest.approx(9.0, abs=0.5) and program.total_area is None


@pytest.mark.parametrize("text", [
    "Deux chambres, une cuisine ouverte de 8 m².", "Deux chambres, une cuisine américaine de 8 m².",
    "Two bedrooms, a kitchen, open, of 8 m².",
])  # fmt: skip
def test_an_area_behind_open_is_the_rooms_own(text: str) -> None:
    program = read(text)
    assert area(program, "kitchen_1") == pytest.approx(8.0, abs=0.1) and program.total_area is None


@pytest.mark.parametrize("verb", ["faces", "looks to the", "is facing", "looks", "must have windows to the"])
def test_a_room_looks_to_a_side(verb: str) -> None:
    assert ("orientation", "living_room_1", None, "south") in rows(read(f"One bedroom; the living room {verb} south."))


def test_near_the_way_in_is_no_further_hallway() -> None:
    program = read("Piso con recibidor, dos dormitorios y despacho. El despacho está cerca de la entrada.")
    assert ("near", "study_1", "entrance", None) in rows(program) and count(program, "hallway") == 1


def test_corners_and_denied_neighbours_in_chinese() -> None:
    assert ("position", "bedroom_1", None, "south_east") in rows(read("两室两卫，主卧在东南角"))
    assert rows(read("61平米，一室一厅，卫生间不要挨着厨房")) == {("apart", "bathroom_1", "kitchen_1", None)}


def test_chinese_storage_and_passages() -> None:
    program = read("三室两卫，带储藏间。玄关通客厅和内走廊；内走廊通三间卧室。")
    assert count(program, "storage") == 1 and count(program, "hallway") == 2 and not program.unread

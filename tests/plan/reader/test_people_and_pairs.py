"""People who have rooms of their own, two limits of one area, areas behind `open`, sides that rooms look to."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.spelling import correct


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


@pytest.mark.parametrize(("text", "bedrooms"), [
    ("family with two small children", 3), ("Flat for a family with three teenage kids", 4),
    ("family with a little girl", 2),
    ("Apartment for a couple with a newborn baby", 2),
    ("Flat for a family with two small children who share a room", 2),
    ("Une famille avec deux jeunes enfants", 3), ("Wohnung für eine Familie mit zwei kleinen Kindern", 3),
    ("Apartment for an elderly couple with a live-in carer", 2), ("Apartment for a family with a nanny", 4),
    ("Apartment for three generations", 4), ("apartment for a professor", 1), ("Flat for a young professional", 1),
    ("apartment for an elderly woman", 1), ("a two-bedroom apartment for a software engineer", 2),
    ("Flat for a woman with two kids", 3), ("Flat for a teacher and her daughter", 2),
    ("House for a man and his wife", 1),
    ("Wohnung für eine Lehrerin", 1), ("Appartement pour un professeur", 1), ("Piso para una profesora", 1),
    ("适合一位教授住的公寓", 1), ("三代同堂的房子", 4), ("flat with two kids' rooms", 3),
    ("family with two kids and a grandfather", 4), ("Familie mit zwei Kindern und Oma", 4),
    ("Appartement pour une famille avec deux enfants et une grand-mère", 4),
    ("Wohnung mit zwei Kinderzimmern", 3),
    ("1b1b apartment of a researcher", 1), ("flat share for three students", 3),
])  # fmt: skip
def test_a_home_is_for_those_whom_it_is_said_to_be_for(text: str, bedrooms: int) -> None:
    program = read(text)
    assert count(program, "bedroom") == bedrooms and not program.unread
    assert min(count(program, kind) for kind in ("living_room", "kitchen", "bathroom")) >= 1


@pytest.mark.parametrize(("text", "rooms"), [
    ("a hotel room", "bedroom bathroom"), ("Motel room with two single beds", "bedroom bathroom"),
    ("A hotel room with a balcony", "balcony bedroom bathroom"), ("Hotelzimmer", "bedroom bathroom"),
    ("Chambre d'hôtel", "bedroom bathroom"), ("Habitación de hotel", "bedroom bathroom"),
    ("酒店房间", "bedroom bathroom"),
    ("tiny house", "living_room kitchen bathroom"),
])  # fmt: skip
def test_rooms_of_hotels_and_tiny_houses_are_all_that_there_is(text: str, rooms: str) -> None:
    program = read(text)
    assert sorted(room.type for room in program.rooms) == sorted(rooms.split()) and not program.unread


@pytest.mark.parametrize("text", ["Apartment for an artist with a studio", "House for a potter with a bright studio"])
def test_a_studio_of_somebodys_apartment_is_a_room(text: str) -> None:
    program = read(text)
    assert count(program, "study") == 1 and count(program, "bedroom") >= 1


@pytest.mark.parametrize("word", ["collects", "friendly", "collector", "random"])
def test_words_that_mean_no_room_are_no_slips_of_others(word: str) -> None:
    """`collects` was taken for `connects`, `friendly` for `friends`."""
    lexicon = read_lexicon()
    assert correct(word, lexicon) == word


@pytest.mark.parametrize(("text", "total", "bedrooms"), [
    ("max 50 m2 one-bedroom flat", 50, 1), ("at most 60 m² two-bedroom apartment", 60, 2),
    ("Under 90 m2 3-bed house", 90, 3),
])  # fmt: skip
def test_a_limit_before_a_home_is_the_homes(text: str, total: float, bedrooms: int) -> None:
    program = read(text)
    assert program.total_area == total and count(program, "bedroom") == bedrooms and not program.unread
    assert {asked.of for asked in program.requirements} == {"home"}


@pytest.mark.parametrize(("small", "plain"), [
    ("small two-room apartment", "two-room apartment"), ("kleine Dreizimmerwohnung", "Dreizimmerwohnung"),
    ("Petit trois-pièces", "trois-pièces"), ("Piso pequeño de dos habitaciones", "Piso de dos habitaciones"),
])  # fmt: skip
def test_a_small_home_of_some_rooms_is_smaller(small: str, plain: str) -> None:
    less, usual = read(small), read(plain)
    assert [room.type for room in less.rooms] == [room.type for room in usual.rooms] and not less.unread
    assert sum(room.area or 0 for room in less.rooms) < 0.9 * sum(room.area or 0 for room in usual.rooms)


@pytest.mark.parametrize(("text", "asked"), [
    ("Need 2 beds 1 bath, bedrooms must not touch", ("apart", "bedroom_1", "bedroom_2", None)),
    ("Two-bedroom flat. The kitchen must not touch the bathroom.", ("apart", "kitchen_1", "bathroom_1", None)),
    ("One-bedroom flat, the kitchen should touch the living room", ("adjacent", "kitchen_1", "living_room_1", None)),
    ("2 bedrooms, one of which is a home office.", ("use", "bedroom_1", None, "study")),
])  # fmt: skip
def test_rooms_that_touch_and_rooms_that_are_others(text: str, asked: tuple[str, str, str | None, str | None]) -> None:
    program = read(text)
    assert rows(program) == {asked} and not program.unread and count(program, "study") == 0


def test_cooking_classes_are_no_second_kitchen() -> None:
    assert count(read("A flat with a big kitchen for cooking classes, one bedroom."), "kitchen") == 1


def test_what_every_room_is_at_is_not_the_only_one() -> None:
    assert count(read("entrance opens directly into the living room"), "bathroom") == 1
    assert count(read("every room is connected to the hallway"), "bedroom") >= 1
    assert [room.type for room in read("a hallway").rooms] == ["hallway"]


@pytest.mark.parametrize(("text", "rooms"), [
    ("i want apartment with tree bedrooms", {"bedroom": 3}),
    ("WG für 3 Studenten ohne Wohnzimmer, zwei Klos", {"bathroom": 2}),
    ("un F2, toilettes loin de la cuisine", {"bedroom": 1, "bathroom": 2}),
    ("un F2, bureau dans la chambre", {"study": 0}),
    ("apartamento para mi abuela y su perro", {"bedroom": 1}),
    ("两室一厅一厨一卫，其中一间做书房", {"bedroom": 1, "study": 1}),
    ("a couple with twins and a live-in grandmother", {"bedroom": 4}),
])  # fmt: skip
def test_rooms_are_as_many_as_are_meant(text: str, rooms: dict[str, int]) -> None:
    program = read(text)
    assert {kind: count(program, kind) for kind in rooms} == rooms and not program.unread


@pytest.mark.parametrize(("text", "areas"), [
    ("apartment for a couple with one bedroom with a balcony of 4 m² and a pantry", {"balcony_1": 4.0}),
    ("one bedroom with a bathroom of 5 m²", {"bathroom_1": 5.0}),
    ("a bedroom with a closet of 3 m² and a study", {"closet_1": 3.0}),
])  # fmt: skip
def test_an_area_is_of_the_room_before_it(text: str, areas: dict[str, float]) -> None:
    """Bedrooms of 4 m² were made, for one of whom a single bed was all that there was room for."""
    program = read(text)
    assert areas.items() <= {room.id: room.area for room in program.rooms}.items()
    assert (area(program, "bedroom_1") or 0) >= 10

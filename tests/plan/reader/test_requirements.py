"""Places, limits and uses that a prompt asks for become typed requirements of the right rooms."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

SIDES = ("left", "right", "north", "south", "east", "west")


def asked(program: Program) -> set[tuple[str, str, str | None, str | None]]:
    return {(r.kind, r.of, r.to, None if r.value is None else str(r.value)) for r in program.requirements}


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("way", ["is to the {} of", "is on the {} side of", "lies {} of"])
def test_a_room_beside_another(side: str, way: str) -> None:
    program = read(f"One-bedroom flat. The kitchen {way.format(side)} the living room.")
    assert ("position", "kitchen_1", "living_room_1", side) in asked(program)
    assert not program.unread


@pytest.mark.parametrize(
    ("words", "kind"),
    [("at least", "at_least"), ("no smaller than", "at_least"), ("minimum", "at_least"), ("at most", "at_most"),
     ("no larger than", "at_most"), ("not more than", "at_most"), ("up to", "at_most"), ("max.", "at_most")],
)  # fmt: skip
@pytest.mark.parametrize("room", ["kitchen", "bathroom", "living_room"])
def test_limits_of_areas(words: str, kind: str, room: str) -> None:
    program = read(f"One-bedroom flat, the {room.replace('_', ' ')} {words} 12 m².")
    assert asked(program) == {(kind, f"{room}_1", None, "12")}
    assert next(r.area for r in program.rooms if r.id == f"{room}_1") == pytest.approx(12, rel=0.01)


@pytest.mark.parametrize(("text", "low", "high"), [("between 50 and 55 m²", 50, 55), ("60 to 70 m²", 60, 70)])
def test_ranges_limit_the_home(text: str, low: float, high: float) -> None:
    program = read(f"A one-bedroom flat of {text}.")
    assert asked(program) == {("at_least", "home", None, f"{low}"), ("at_most", "home", None, f"{high}")}
    assert program.total_area == pytest.approx((low + high) / 2)


@pytest.mark.parametrize(
    "verb", ["that serves as", "which also serves as", "doubling as", "used as", "that doubles as"]
)
def test_one_room_with_two_uses_is_one_room(verb: str) -> None:
    program = read(f"Two bedrooms, a lounge, a kitchen, a bathroom and a dining room {verb} a study.")
    assert [r.type for r in program.rooms].count("study") == 0
    assert ("use", "dining_room_1", None, "study") in asked(program)


@pytest.mark.parametrize("pair", [("bedroom", "bathroom"), ("kitchen", "study")])
def test_two_rooms_joined_by_and_lie_together(pair: tuple[str, str]) -> None:
    program = read(f"A lounge on the left, and a {pair[0]} and a {pair[1]} at the back.")
    assert {("position", f"{room}_1", None, "back") for room in pair} <= asked(program)
    assert ("position", "living_room_1", None, "left") in asked(program)


def test_it_may_be_the_entrance() -> None:
    program = read("A bedroom far from the entrance, a kitchen close to it, a living room and a bathroom.")
    assert asked(program) == {("apart", "bedroom_1", "entrance", None), ("near", "kitchen_1", "entrance", None)}


@pytest.mark.parametrize(
    ("prompt", "bedrooms"),
    [
        ("Two bedrooms for the children, one for us, a lounge, a kitchen.", 3),
        ("Two bedrooms, one for the children, a lounge, a kitchen.", 2),
        ("Three bedrooms; our twins share one, and the third is a guest room. A lounge and a kitchen.", 3),
        ("A parents' bedroom, a children's bedroom, a second children's bedroom, a lounge, a kitchen.", 3),
        ("Two-bedroom flat, our son's room next to grandmother's room.", 2),
        ("Two-bedroom flat with a maid's room.", 3),
        ("A flat of five rooms of 14 m² each, a kitchen and a bathroom.", 4),
        ("Dreizimmerwohnung, das Schlafzimmer nach Osten.", 2),
    ],
)
def test_bedrooms_are_counted_once(prompt: str, bedrooms: int) -> None:
    program = read(prompt)
    assert [r.type for r in program.rooms].count("bedroom") == bedrooms, program.unread


def test_areas_of_each_room_are_not_the_flats() -> None:
    program = read("A flat of five rooms of 14 m² each, a kitchen and a bathroom.")
    assert program.total_area is None
    assert {r.area for r in program.rooms if r.type in ("living_room", "bedroom")} == {14.0}


@pytest.mark.parametrize(
    ("prompt", "row"),
    [
        ("Two bedrooms, the kitchen should be the smallest room.", ("order", "kitchen_1", None, "smallest")),
        ("Two bedrooms. The largest room is the kitchen.", ("order", "kitchen_1", None, "largest")),
        ("One bedroom, a kitchen larger than the bathroom.", ("order", "kitchen_1", "bathroom_1", "larger")),
        ("One bedroom, the kitchen is smaller than the bedroom.", ("order", "kitchen_1", "bedroom_1", "smaller")),
    ],
)
def test_orders_by_area(prompt: str, row: tuple[str, str, str | None, str]) -> None:
    assert row in asked(read(prompt))


@pytest.mark.parametrize("kind", ["kitchen", "bathroom", "living room"])
def test_the_largest_room_is_given_the_largest_area(kind: str) -> None:
    program = read(f"One bedroom. The {kind} should be the largest room.")
    area = {r.id: r.area or 0.0 for r in program.rooms}
    assert max(area, key=lambda room: area[room]) == f"{kind.replace(' ', '_')}_1"


def test_the_largest_room_with_an_area_is_the_living_room() -> None:
    program = read("Three rooms and a kitchen, the biggest room being 25 m².")
    assert next(r.area for r in program.rooms if r.type == "living_room") == 25.0
    assert program.total_area is None


def test_what_is_denied_of_both_rooms_is_apart() -> None:
    program = read("Two bedrooms, neither of which should be next to the kitchen.")
    assert asked(program) == {("apart", f"bedroom_{n}", "kitchen_1", None) for n in (1, 2)}


@pytest.mark.parametrize("unit", ["m", "metres"])
def test_length_and_width(unit: str) -> None:
    program = read(f"One-bedroom flat, the living room is 5 {unit} long and 4 {unit} wide.")
    assert asked(program) == {("dimension", "living_room_1", None, "5 x 4")}


def test_only_before_two_rooms_of_a_longer_list_leaves_the_home_open() -> None:
    program = read("We need five bedrooms, but only two bathrooms, and all bedrooms should be at least 10 m².")
    assert {"living_room", "kitchen", "hallway"} <= {r.type for r in program.rooms} and not program.complete


@pytest.mark.parametrize("verb", ["must not have", "should not include", "need not have"])
def test_what_a_flat_must_not_have(verb: str) -> None:
    program = read(f"The flat {verb} a dining room or a balcony. Three bedrooms, two baths.")
    assert not {"dining_room", "balcony"} & {r.type for r in program.rooms}


def test_a_place_of_what_is_no_room_is_nobodys() -> None:
    program = read("A two-bedroom flat with a mezzanine above the living room.")
    assert not program.requirements and any(word.startswith("mezzanine") for word in program.unread)


def test_a_room_one_reaches_from_another_opens_off_it() -> None:
    program = read("A utility room that you reach from the kitchen. Three bedrooms, one bathroom.")
    assert ("kitchen_1", "utility_1") in program.links and ("hallway_1", "utility_1") not in program.links


def test_it_is_the_entrance_of_the_sentence_before() -> None:
    program = read("The entrance is on the south side. The kitchen is next to it. Two bedrooms.")
    assert ("near", "kitchen_1", "entrance", None) in asked(program)
    assert program.envelope.entrance == "south"


@pytest.mark.parametrize(
    ("prompt", "rows"),
    [
        ("One bedroom. The lounge is north of the kitchen and west of the bedroom.",
         {("living_room_1", "kitchen_1", "north"), ("living_room_1", "bedroom_1", "west")}),
        ("One bedroom. The kitchen is left of the lounge and the bedroom is above the kitchen.",
         {("kitchen_1", "living_room_1", "left"), ("bedroom_1", "kitchen_1", "north")}),
        ("One bedroom. To the left of the kitchen is the bathroom.", {("bathroom_1", "kitchen_1", "left")}),
        ("One bedroom. The hall leads to the kitchen, right of it is the bathroom.",
         {("bathroom_1", "kitchen_1", "right")}),
    ],
)  # fmt: skip
def test_who_lies_beside_whom(prompt: str, rows: set[tuple[str, str, str]]) -> None:
    assert asked(read(prompt)) == {("position", *row) for row in rows}


def test_on_the_left_of_the_hall_are_its_doors() -> None:
    program = read("On the left of the hall are two bedrooms. One bathroom.")
    assert not program.requirements and ("bedroom_1", "hallway_1") in program.links


@pytest.mark.parametrize(
    ("prompt", "wish"),
    [
        ("Un piso con un baño que no esté al lado de la cocina", ("apart", "bathroom_1", "kitchen_1", None)),
        ("两室一厅，客用卫生间在门口附近", ("near", "bathroom_1", "entrance", None)),
        ("Appartement : le séjour est la plus grande pièce", ("order", "living_room_1", None, "largest")),
        ("A flat; the bathroom must not adjoin the kitchen", ("apart", "bathroom_1", "kitchen_1", None)),
        ("Bathroom in the north-east corner of a one-bedroom flat", ("position", "bathroom_1", None, "north_east")),
    ],
)
def test_wishes_in_five_languages(prompt: str, wish: tuple[str, str, str | None, str | None]) -> None:
    assert wish in asked(read(prompt))

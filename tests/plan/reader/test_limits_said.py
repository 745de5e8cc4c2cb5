"""Limits of doors, lengths and widths, and rooms without a door between them, as requirements."""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

FLAT = "two-bedroom flat"
DOORS, LENGTH, WIDTH = "doors", "length", "width"


def limits(program: Program) -> list[tuple[str, str, str | None, float]]:
    rows = [r for r in program.requirements if r.kind in ("at_least", "at_most")]
    return [(r.kind, r.of, r.to, float(r.value or 0)) for r in rows]


SAID = [
    (f"A {FLAT} whose hallway has three doors or fewer.", ("at_most", "hallway_1", DOORS, 3)),
    (f"A {FLAT} with a hallway of at most four doors.", ("at_most", "hallway_1", DOORS, 4)),
    (f"A {FLAT}, no more than four doors off the corridor.", ("at_most", "hallway_1", DOORS, 4)),
    (f"At most four doors lead off the hall in a {FLAT}", ("at_most", "hallway_1", DOORS, 4)),
    (f"A {FLAT}. The hallway must not have more than four doors.", ("at_most", "hallway_1", DOORS, 4)),
    (f"A {FLAT}; the living room must have at least three doors.", ("at_least", "living_room_1", DOORS, 3)),
    (f"A {FLAT} with a corridor no longer than 4 m.", ("at_most", "hallway_1", LENGTH, 4)),
    (f"A {FLAT}, the corridor must not be longer than 15 feet.", ("at_most", "hallway_1", LENGTH, 15 * 0.3048)),
    (f"A {FLAT}, hallway at most 5 metres long.", ("at_most", "hallway_1", LENGTH, 5)),
    (f"A {FLAT} whose corridor is shorter than 6 m.", ("at_most", "hallway_1", LENGTH, 6)),
    (f"A {FLAT}, the corridor of 5 m maximum.", ("at_most", "hallway_1", LENGTH, 5)),
    (f"A {FLAT}, the corridor should be at least 1.4 m wide.", ("at_least", "hallway_1", WIDTH, 1.4)),
    (f"A {FLAT}, the hallway with a width of at least 140 cm.", ("at_least", "hallway_1", WIDTH, 1.4)),
    (f"A {FLAT} with a hallway not wider than 1.3 m.", ("at_most", "hallway_1", WIDTH, 1.3)),
    (f"A {FLAT}, the living room no narrower than 4 m.", ("at_least", "living_room_1", WIDTH, 4)),
    ("Dreizimmerwohnung, der Flur höchstens 4 m lang.", ("at_most", "hallway_1", LENGTH, 4)),
    ("Dreizimmerwohnung, der Flur nicht länger als 5 m.", ("at_most", "hallway_1", LENGTH, 5)),
    ("Piso de dos dormitorios, el pasillo de no más de 5 m de largo.", ("at_most", "hallway_1", LENGTH, 5)),
    ("Un T3, le couloir de 5 m de long maximum.", ("at_most", "hallway_1", LENGTH, 5)),
    ("Un T3, le couloir ne doit pas dépasser 8 m de long.", ("at_most", "hallway_1", LENGTH, 8)),
    ("Un T3, le séjour ne doit pas être plus large que 5 m.", ("at_most", "living_room_1", WIDTH, 5)),
    ("Piso de dos dormitorios. El pasillo no debe superar 5 m de largo.", ("at_most", "hallway_1", LENGTH, 5)),
]


@pytest.mark.parametrize(("text", "row"), SAID)
def test_a_limit_is_asked_of_its_room_and_changes_no_room(text: str, row: tuple[str, str, str, float]) -> None:
    program = read(text)
    (found,) = limits(program)
    assert found[:3] == row[:3] and found[3] == pytest.approx(row[3], abs=1e-3)
    assert not program.unread
    kinds = sorted(room.type for room in program.rooms)
    assert kinds.count("bedroom") == 2 and kinds.count("hallway") == 1 and kinds.count("living_room") == 1


def test_two_limits_of_one_room_and_of_many() -> None:
    found = limits(read("Main bedroom at least 3.5 m wide and at most 5 m long, a second bedroom, a living room."))
    assert found == [("at_least", "bedroom_1", WIDTH, 3.5), ("at_most", "bedroom_1", LENGTH, 5)]
    found = limits(read(f"The bedrooms must be no narrower than 3 m. A {FLAT}."))
    assert found == [("at_least", f"bedroom_{n}", WIDTH, 3) for n in (1, 2)]


def test_areas_keep_their_limits_beside_lengths() -> None:
    found = limits(read(f"A {FLAT}, the hall no more than 6 m2 and no longer than 5 m."))
    assert sorted(found, key=str) == [("at_most", "hallway_1", LENGTH, 5), ("at_most", "hallway_1", None, 6)]
    found = limits(read(f"A {FLAT} of between 50 and 55 m²."))
    assert found == [("at_least", "home", None, 50), ("at_most", "home", None, 55)]


@pytest.mark.parametrize("words", ["without any long passage", "with no long corridors", "without long hallways"])
def test_no_long_hallway_is_a_limit_of_every_hallway(words: str) -> None:
    ((kind, of, to, metres),) = limits(read(f"A {FLAT} {words}."))
    assert (kind, of, to) == ("at_most", "hallway_1", LENGTH) and metres < 9
    assert limits(read(f"A {FLAT} with short corridors.")) == []


@pytest.mark.parametrize("words", [
    "the kitchen must not open onto the hallway", "no door between the kitchen and the hallway",
    "no direct access from the kitchen to the hallway", "the kitchen is not connected to the hallway",
])  # fmt: skip
def test_no_door_is_asked_for_and_none_is_there(words: str) -> None:
    program = read(f"A {FLAT}; {words}.")
    assert [(r.kind, {r.of, r.to}) for r in program.requirements] == [("no_door", {"kitchen_1", "hallway_1"})]
    assert ("hallway_1", "kitchen_1") not in program.links and any("kitchen_1" in pair for pair in program.links)


@pytest.mark.parametrize("text", [
    "Dreizimmerwohnung, keine Tür zwischen Küche und Wohnzimmer.", "Un T3, pas de porte entre la cuisine et le séjour.",
    "Piso de dos dormitorios, que no haya puerta entre la cocina y el salón.",
])  # fmt: skip
def test_no_door_in_other_languages(text: str) -> None:
    program = read(text)
    assert [(r.kind, {r.of, r.to}) for r in program.requirements] == [("no_door", {"kitchen_1", "living_room_1"})]
    assert ("kitchen_1", "living_room_1") not in program.links and not program.unread


@pytest.mark.parametrize("words", ["a bed at most 1.6 m wide", "the dining table at least 2 m long"])
def test_what_is_said_of_furniture_is_told_and_no_limit_of_a_room(words: str) -> None:
    program = read(f"A {FLAT}, {words}.")
    assert limits(program) == [] and any("wide" in told or "long" in told for told in program.unread)


@pytest.mark.parametrize("said, kind", [
    ("can't have more than", "at_most"), ("cannot have more than", "at_most"), ("shouldn't be more than", "at_most"),
    ("can't have less than", "at_least"), ("mustn't be smaller than", "at_least"),
    ("must not be less than", "at_least"),
])
def test_what_cannot_be_more_is_at_most(said: str, kind: str) -> None:
    program = read(f"The flat {said} 55 m², our budget is tight! Living room, kitchen, one bedroom, bathroom.")
    assert [(asked.kind, asked.of, float(asked.value)) for asked in program.requirements] == [(kind, "home", 55.0)]

"""Classes of what is said, each as a grid of its parts: who has what, which of several, the rest, corrections."""

from itertools import product

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read

PEOPLE = {"My son and my daughter": 2, "Our two kids": 2, "Each of our three kids": 3, "Both of our children": 2}
NEEDS = ("get a room", "need a bedroom", "want their own bedroom")


@pytest.mark.parametrize("who, need", list(product(PEOPLE, NEEDS)))
def test_each_child_has_a_room_with_what_is_said_of_it_and_the_parents_have_theirs(who: str, need: str) -> None:
    each = "" if who.startswith("Each") else "each "
    found = read(f"{who} {each}{need} with a desk.")
    assert rooms(found).startswith(f"B{PEOPLE[who] + 1} ")
    assert sum(asked.category == "desk" for asked in found.objects) == PEOPLE[who]


@pytest.mark.parametrize("number, stop", list(product(("two", "three", "4"), (", each", "; each", ". Each"))))
def test_grown_ups_who_are_counted_have_a_room_each(number: str, stop: str) -> None:
    beds = {"two": 2, "three": 3, "4": 4}[number]
    found = read(f"A flat for {number} students{stop} has a bedroom with a desk.")
    assert rooms(found).startswith(f"B{beds} ")
    assert sum(asked.category == "desk" for asked in found.objects) == beds


@pytest.mark.parametrize(
    "household, beds",
    [("a family of four", 3), ("a family of four and their grandmother", 4), ("a family of five with a nanny", 5),
     ("two parents, three children and a grandfather", 5), ("grandparents, parents and two kids", 4)],
)  # fmt: skip
def test_who_lives_with_a_family_has_a_room(household: str, beds: int) -> None:
    assert rooms(read(f"A home for {household}.")).startswith(f"B{beds} ")


LARGE, SMALL = ("largest", "larger", "bigger", "big"), ("smallest", "smaller", "small")


@pytest.mark.parametrize("size, noun", list(product((*LARGE, *SMALL), ("bedroom", "one"))))
@pytest.mark.parametrize("said, fact", [("faces north", "orientation {} north"), ("has a desk", "{} has 1 desk"),
                                        ("is next to the kitchen", "adjacent {} K1")])  # fmt: skip
def test_a_size_tells_which_of_several_is_meant(size: str, noun: str, said: str, fact: str) -> None:
    found = read(f"Two bedrooms. The {size} {noun} {said}.")
    room = "B1" if size in LARGE else "B2"
    assert fact.format(room) in facts(found) or fact.format(room).replace("B1 K1", "K1 B1") in facts(found)
    area = {asked.id: asked.area or 0.0 for asked in found.rooms}
    assert area["bedroom_1"] > area["bedroom_2"]


@pytest.mark.parametrize("first, second", [("larger", "smaller"), ("smaller", "larger"), ("big", "small")])
def test_two_sizes_tell_two_rooms(first: str, second: str) -> None:
    found = read(f"Two bedrooms: the {first} one is 16 m² and the {second} one 11." if first != "smaller" else
                 "Two bedrooms: the smaller one is 11 m² and the larger one 16.")  # fmt: skip
    assert {"B1=16", "B2=11"} <= facts(found)


@pytest.mark.parametrize("rest", ["everything else", "all other rooms", "the rest"])
def test_everything_else_is_not_what_was_named(rest: str) -> None:
    found = facts(read(f"A two-bedroom flat. The bedrooms are on the north side, {rest} is on the south side."))
    assert {"position B1 north", "position B2 north", "position L1 south", "position K1 south"} <= found
    assert not {"position B1 south", "position B2 south"} & found


@pytest.mark.parametrize("every, baths", list(product(("each bedroom", "every bedroom", "all bedrooms"), (0, 1, 2))))
def test_a_room_beside_each_of_several_is_no_further_one(every: str, baths: int) -> None:
    said = ("", " and one bathroom", " and two bathrooms")[baths]
    found = read(f"A flat with three bedrooms{said}; {every} is next to a bathroom.")
    assert rooms(found) == ("B3 H K L W" if baths == 1 else "B3 H K L W2")
    beside = {fact.split()[1] for fact in facts(found) if fact.startswith("adjacent")}
    assert beside | {"B1"} == {"B1", "B2", "B3"}


@pytest.mark.parametrize("alike", ["of equal size", "of the same size", "equal in size"])
def test_rooms_counted_together_are_of_one_size(alike: str) -> None:
    found = read(f"Three rooms {alike}, a kitchen and a bathroom.")
    assert len({asked.area for asked in found.rooms if asked.type in ("living_room", "bedroom")}) == 1


ANEW = (", no, ", ", actually ", ", or rather ", " - correction: ")


@pytest.mark.parametrize("word", ANEW)
def test_what_is_said_anew_takes_the_place_of_what_was_said(word: str) -> None:
    assert "K1=12" in facts(read(f"A two-bedroom flat with a kitchen of 10 m²{word}12 m²."))
    told = facts(read(f"A two-bedroom flat with a balcony off the kitchen{word}off the living room."))
    assert "L1Y1" in told and "K1Y1" not in told


@pytest.mark.parametrize("word", ["Forget", "Skip", "Leave out"])
def test_a_room_is_taken_back(word: str) -> None:
    assert rooms(read(f"A two-bedroom flat with a study. {word} the study.")) == "B2 H K L W"


@pytest.mark.parametrize("none", ["None of them", "Neither of them", "Neither of the bedrooms"])
def test_none_of_them_denies_it_of_all(none: str) -> None:
    found = facts(read(f"A two-bedroom flat. {none} is next to the kitchen."))
    assert {"apart B1 K1", "apart B2 K1"} <= found


@pytest.mark.parametrize("other", ["the bathroom and", "the kitchen and", ""])
def test_rooms_away_from_another_and_the_entrance(other: str) -> None:
    found = facts(read(f"Two bedrooms. Keep the bedrooms away from {other} the entrance."))
    assert {"apart B1 entrance", "apart B2 entrance"} <= found


def test_an_area_after_other_words_of_a_room_is_that_rooms() -> None:
    found = read("A living room with a balcony. The balcony faces south and is 6 m².")
    assert found.total_area is None and "balcony_1" in {r.id for r in found.rooms if r.area == 6}
    found = read("Three bedrooms, the largest one has its own bathroom and measures 18 m².")
    assert found.total_area is None and {"B1=18", "B1W1"} <= facts(found)


def test_it_is_what_the_sentence_before_was_about() -> None:
    assert "orientation Y1 south" in facts(read("The bedroom has a balcony. It faces south."))
    assert "position S1 north" in facts(read("The study is small. It is on the north side."))


def test_a_difference_of_areas_is_no_area() -> None:
    found = read("Bedroom 1 is 3 m² larger than bedroom 2.")
    assert min(room.area or 0 for room in found.rooms if room.type == "bedroom") > 6
    assert any(words.startswith("3 m2") for words in found.unread)


def test_no_at_the_end_of_a_key_denies_that_key() -> None:
    assert rooms(read("Bedrooms: 2. Balcony: yes. Study: no. Kitchen: open.")) == "B2 H K L W Y"


def test_furniture_is_shared_out_over_the_rooms_that_have_it() -> None:
    found = facts(read("Three bedrooms: one has a double bed, the others have single beds."))
    assert {"B1 has 1 double_bed", "B2 has 1 single_bed", "B3 has 1 single_bed"} <= found
    found = facts(read("One-bedroom flat: two chairs in the kitchen, four in the dining room."))
    assert "K1 has 2 chair" in found and any(fact.endswith("has 4 chair") for fact in found)
    found = facts(read("A two-bedroom flat with a lamp in every room except the bathroom."))
    assert {"B1 has 1 table_lamp", "B2 has 1 table_lamp", "L1 has 1 table_lamp"} <= found
    assert not any(fact.startswith("W1 has") for fact in found)


@pytest.mark.parametrize("many, beds", [("Two of them", 2), ("The other two", 2), ("Each of them", 3)])
def test_what_some_of_several_have_each_of_them_has(many: str, beds: int) -> None:
    assert len([r for r in read(f"Three bedrooms. {many} with a balcony.").rooms if r.type == "balcony"]) == beds


def test_a_pantry_is_no_store() -> None:
    found = facts(read("A two-bedroom flat, kitchen with pantry, storage next to the entrance."))
    assert {"K1T1", "H1T2", "near T2 entrance"} <= found


def test_one_bathroom_is_one_but_for_each() -> None:
    assert rooms(read("Two bedrooms with one bathroom.")) == "B2 H K L W"
    assert rooms(read("Three bedrooms with one bathroom each.")) == "B3 H K L W3"


def test_sizes_without_a_verb_of_their_own() -> None:
    found = facts(read("Three bedrooms; give the largest a balcony and the smallest a desk."))
    assert {"B1Y1", "B3 has 1 desk"} <= found
    found = read("Two-bedroom flat, all rooms at least 8 m² and the living room the biggest.")
    assert "order L1 largest" in facts(found)
    assert {"adjacent B3 K1", "adjacent B4 K1"} <= facts(read("Four bedrooms, the two smallest next to the kitchen."))


def test_two_sizes_are_two_rooms_where_nobody_counts() -> None:
    found = facts(read("An apartment where the larger bedroom faces south and the smaller one faces north."))
    assert {"orientation B1 south", "orientation B2 north"} <= found


def test_what_neither_of_two_rooms_has_denies_neither_of_them() -> None:
    assert rooms(read("One-bedroom flat; neither the kitchen nor the bathroom has a window.")) == "B H K L W"


def test_several_rooms_before_one_that_opens_off_another_do_not_open_off_it() -> None:
    found = facts(read("Three bedrooms, two bathrooms and a utility room off the kitchen."))
    assert "K1U1" in found and not {"K1W1", "K1W2"} & found


def test_one_of_several_that_is_not_wanted_takes_none_of_the_others_away() -> None:
    assert rooms(read("House with 4 bedrooms; without the larger bedroom.")).startswith(("B4", "B3"))
    assert not any("entrance" in fact for fact in facts(read("Two bedrooms opposite a study and the entrance.")))

"""Clauses that end where the next has a verb of its own, pairs spoken of again, ways in that are the only ones."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("only", ["that you can only reach through", "that has the door only from", "entered only from",
                                  "accessible only via"])  # fmt: skip
def test_a_living_room_entered_only_from_the_kitchen_has_no_other_door(only: str) -> None:
    found = facts(read(f"Two bedrooms, a bathroom, a kitchen, and a living room {only} the kitchen."))
    assert {"K1L1", "H1K1"} <= found and "H1L1" not in found


def test_a_living_room_beside_a_kitchen_has_a_way_of_its_own_where_nobody_says_only() -> None:
    assert "H1L1" in facts(read("Two bedrooms. The kitchen connects to the living room and to the hallway."))


def test_with_joins_rooms_in_the_next_clause_too() -> None:
    found = read("Two bedrooms. The lounge connects with the hall, the kitchen with the lounge.")
    assert {"H1L1", "K1L1"} <= facts(found) and "H1K1" not in facts(found)


@pytest.mark.parametrize("joint", [", and", " and", ","])
@pytest.mark.parametrize("first", ["the kitchen is smaller than the study", "the study is the largest room"])
def test_a_comparison_ends_where_the_next_clause_has_a_verb(first: str, joint: str) -> None:
    found = facts(read(f"Two bedrooms and a study. Note: {first}{joint} both bedrooms are next to the bathroom."))
    assert {"adjacent B1 W1", "adjacent B2 W1"} <= found
    assert not {"adjacent K1 W1", "adjacent S1 W1"} & found


@pytest.mark.parametrize("desk", ["and in every bedroom one desk", ", in every bedroom a desk",
                                  "and in each bedroom a desk"])  # fmt: skip
def test_what_is_in_every_bedroom_is_a_clause_of_its_own(desk: str) -> None:
    found = facts(read(f"We need three bedrooms {desk}. One bathroom."))
    assert {"B1 has 1 desk", "B2 has 1 desk", "B3 has 1 desk"} <= found


@pytest.mark.parametrize("things", ["a double bed", "a desk and two chairs", "a bed, a desk and two monitors"])
def test_then_behind_furniture_lists_on(things: str) -> None:
    found = facts(read(f"1 bedroom with {things}, then a living room, a kitchen and a bathroom."))
    assert {"B1H1", "H1L1"} <= found and "B1L1" not in found


@pytest.mark.parametrize("none", [" but with no door between them", ", without a door between them",
                                  ", no door between them", " and there is no door between them"])  # fmt: skip
def test_no_door_between_them_is_between_those_named(none: str) -> None:
    found = facts(read(f"Two bedrooms. The main bedroom is adjacent to the bathroom{none}. A study."))
    assert {"adjacent B1 W1", "no_door B1 W1"} <= found
    assert "no_door B1 B2" in facts(read(f"A kitchen. Two bedrooms side by side{none}."))


@pytest.mark.parametrize("beside", ["beside it", "next to it"])
def test_it_behind_a_place_near_the_entrance_is_the_room(beside: str) -> None:
    found = facts(read(f"One bedroom near the entrance, the bathroom {beside}, a living room and a kitchen."))
    assert {"near B1 entrance", "adjacent W1 B1"} <= found and "near W1 entrance" not in found


@pytest.mark.parametrize("said", ["两个卧室分别是15平米和10平米", "两个卧室，15平米和10平米",
                                  "Two bedrooms: 15 m² and 10 m²",
                                  "Two bedrooms are 15 m² and 10 m²"])  # fmt: skip
def test_several_areas_are_those_of_several_rooms(said: str) -> None:
    found = facts(read(said))
    assert {"B1=15", "B2=10"} <= found and not any(fact.startswith("all=") for fact in found)


@pytest.mark.parametrize("kitchen", ['{"open_to": "living_room"}', '{"area_m2": 12, "open_to": "living_room"}',
                                     '{"open_to": "living_room", "area_m2": 12}'])  # fmt: skip
def test_a_relation_may_be_a_key(kitchen: str) -> None:
    found = facts(read(f'{{"bedrooms": 2, "bathrooms": 1, "kitchen": {kitchen}, "study": {{"next_to": "kitchen"}}}}'))
    assert {"K1~L1", "adjacent S1 K1"} <= found and ("12" not in kitchen or "K1=12" in found)


@pytest.mark.parametrize("own", ["Each of us needs own bedroom", "Each of us wants a room", "Each needs a bedroom"])
def test_each_of_us_is_each_of_those_counted_before(own: str) -> None:
    assert rooms(read(f"We are two friends who live together. {own}, the living room can be small.")) == "B2 H K L W"


@pytest.mark.parametrize("who", ["Everyone in the family of four has their own room",
                                 "Everybody in our family of four gets a room"])  # fmt: skip
def test_a_family_of_which_nobody_shares_has_as_many_bedrooms(who: str) -> None:
    assert rooms(read(f"{who}. One bathroom.")) == "B4 H K L W"


@pytest.mark.parametrize("one", ["two people, one bathroom each", "two people with a bathroom each"])
def test_each_behind_a_room_counts_it(one: str) -> None:
    assert rooms(read(f"A one-bedroom flat for {one}.")) == "B H K L W2"


@pytest.mark.parametrize("small", ["small", "cramped", "poky"])
def test_a_cramped_study_is_small(small: str) -> None:
    assert "S1=6.75" in facts(read(f"One bedroom, a {small} study, living room, kitchen, bathroom."))


@pytest.mark.parametrize("to", ["you can only get to the study through the master bedroom",
                                "we can only enter the study via the master bedroom"])  # fmt: skip
def test_what_one_can_only_get_to_through_a_room_has_that_door_alone(to: str) -> None:
    found = facts(read(f"Two bedrooms. {to.capitalize()}, and to the walk-in closet only through the study."))
    assert {"B1S1", "C1S1"} <= found and not {"H1S1", "B1C1", "C1H1"} & found


@pytest.mark.parametrize("out", ["where you go out from", "onto which you step from", "where one can go out through"])
def test_where_you_go_out_from_is_a_door_of_the_last_room(out: str) -> None:
    found = facts(read(f"Two bedrooms, one bath and a balcony {out} the kitchen."))
    assert "K1Y1" in found and not {"K1W1", "L1Y1"} & found


@pytest.mark.parametrize("other", ["another one", "another", "the other door", "a second one leads"])
def test_another_door_is_no_other_room(other: str) -> None:
    found = read(f"From the living room, one door leads to the kitchen and {other} to a hallway serving three bedrooms "
                 "and two bathrooms.")  # fmt: skip
    assert rooms(found) == "B3 H K L W2" and {"K1L1", "H1L1", "B1H1"} <= facts(found)


@pytest.mark.parametrize("his", ["the room of my son", "the room of our daughter", "the bedroom of our son"])
def test_the_room_of_somebody_is_one_more(his: str) -> None:
    found = facts(read(f"From the hall you can enter the kitchen, the bathroom, our bedroom and {his}."))
    assert {"B1H1", "B2H1"} <= found


def test_who_studies_something_wants_no_study() -> None:
    assert rooms(read("One bedroom, one bathroom. I study cooking, so the kitchen needs an oven.")) == "B H K L W"
    assert rooms(read("One bedroom, one bathroom, and we need a study.")) == "B H K L S W"


@pytest.mark.parametrize("both", ["two bedrooms both of 12", "two bedrooms, each of 12", "two bedrooms of 12"])
def test_both_before_an_area_is_of_the_bedrooms(both: str) -> None:
    assert {"B1=12", "B2=12", "K1=8"} <= facts(read(f"Kitchen of 8 square meter, {both}, living room of 25."))


@pytest.mark.parametrize("said", ["is for a baby: place a cot there", "is small. Put a cot there",
                                  "is next to the kitchen; we need a cot there"])  # fmt: skip
def test_what_is_put_there_is_put_where_the_clause_is_about(said: str) -> None:
    assert "B2 has 1 cot" in facts(read(f"Two bedrooms. The second bedroom {said}."))


@pytest.mark.parametrize("beside", ["off", "next to"])
def test_what_a_room_has_in_it_is_not_its_neighbours(beside: str) -> None:
    found = facts(read(f"Two bedrooms and a storage room {beside} the kitchen with shelving in it."))
    assert "T1 has 1 shelving" in found and "K1 has 1 shelving" not in found


@pytest.mark.parametrize("one", [", one bedroom is for us, the other is for guests", ". One bedroom is for guests",
                                 ", one bedroom has a desk, the other bedroom a piano"])  # fmt: skip
def test_one_bedroom_of_which_something_is_said_is_one_of_those_counted(one: str) -> None:
    assert rooms(read(f"Two bedrooms{one}.")) == "B2 H K L W"


@pytest.mark.parametrize("own, then", [("its own bathroom", "two balconies"), ("a closet", "three balconies"),
                                       ("its own bathroom", "2 balconies and a study")])  # fmt: skip
def test_what_each_has_ends_before_several_others(own: str, then: str) -> None:
    found = rooms(read(f"A living room, a kitchen, three bedrooms each with {own}, {then}."))
    assert f"Y{3 if 'three' in then else 2}" in found.split()


@pytest.mark.parametrize("no", ["There is no wall", "No wall", "I want no wall", "There are no walls"])
def test_no_wall_between_two_rooms_is_an_opening(no: str) -> None:
    found = facts(read(f"Three-bedroom apartment. {no} between the kitchen and the living room."))
    assert "K1~L1" in found and "no_door K1 L1" not in found


@pytest.mark.parametrize("listed", ["one bedroom, one office and a balcony", "one bedroom, an office and a balcony",
                                    "1 bedroom, 1 office and 1 balcony"])  # fmt: skip
def test_the_last_of_a_list_of_single_rooms_opens_off_another(listed: str) -> None:
    found = facts(read(f"A flat with {listed} off the kitchen."))
    assert {"H1S1", "K1Y1"} <= found and "K1S1" not in found


@pytest.mark.parametrize("then", ["the robot will be parked there", "bikes are kept there", "skis can lie there"])
def test_what_happens_there_is_nothing_put_there(then: str) -> None:
    found = read(f"A home: three bedrooms, two bathrooms. Put a storage room of 3 m2 near the entrance, {then}.")
    assert rooms(found) == "B3 H K L T W2" and {"H1T1", "near T1 entrance"} <= facts(found)


@pytest.mark.parametrize("heading", ["Wheelchair study", "A lighting study", "Grasping study", "Study of daylight"])
def test_a_study_of_something_is_no_room_as_a_heading(heading: str) -> None:
    assert rooms(read(f"{heading}: 1 bedroom flat, corridor at least 1.4 m wide.")) == "B H K L W"


def test_a_study_with_what_it_has_is_a_room() -> None:
    assert "S" in rooms(read("Small study: 8 m2, desk. One bedroom, kitchen.")).split()
    assert "S" in rooms(read("Study: 8 m2. One-bedroom flat.")).split()


@pytest.mark.parametrize("bed", ["robot testbed", "robot test bed", "test-bed"])
def test_a_testbed_is_no_bedroom(bed: str) -> None:
    found = facts(read(f"A {bed}. There is one bedroom with a wardrobe. The bathroom is next to the bedroom."))
    assert "adjacent W1 B1" in found and not any(fact.startswith("B2") for fact in found)


@pytest.mark.parametrize("area", ["60 m2 at most", "60 m2 at the most", "no balcony, 60 m2 at most"])
def test_a_limit_behind_its_area(area: str) -> None:
    found = read(f"A flat for sim2real transfer, {area}, one bedroom.")
    assert "at_most home 60" in facts(found) and not any("most" in words for words in found.unread)
    assert "at_least K1 12" in facts(read("One bedroom, a kitchen of 12 m2 at least, a bathroom."))


@pytest.mark.parametrize("other", ["the children use the other bathroom in the corridor", "the other bathroom is off "
                                   "the corridor", "the children use other bathroom in the corridor"])  # fmt: skip
def test_the_other_bathroom_beside_one_that_is_owned_is_not_that_one(other: str) -> None:
    found = facts(read(f"We need three bedrooms. The bedroom of parents has own bathroom and {other}."))
    assert {"B1W1", "H1W2"} <= found and not {"H1W1", "B2W2"} & found

"""Constructions of grammar in several wordings each: what is left out, what is contrasted, whose a clause is."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("hall", ["one long hallway", "a long corridor", "a short corridor", "a narrow hallway"])
def test_a_hallway_of_some_style_is_a_hallway(hall: str) -> None:
    found = facts(read(f"A two-bedroom flat with {hall}, no wider than 1.2 m. The bathroom is off the kitchen."))
    assert {"at_most H1 width 1.2", "B1H1", "B2H1", "K1W1"} <= found
    assert rooms(read(f"A studio with {hall}.")) == "H K L W"


@pytest.mark.parametrize(
    "own", ["each one with his own bathroom", "each with her own bathroom", "each with its own bath"]
)
def test_each_one_has_his_own(own: str) -> None:
    assert {"B1W1", "B2W2"} <= facts(read(f"The apartment has 2 bedrooms, {own}, and one toilet."))


@pytest.mark.parametrize("who", ["student", "students'", "tenant", "flatmate's"])
def test_a_students_room_is_a_bedroom(who: str) -> None:
    found = read(
        f"A flat with four {who} rooms of fourteen m² each, a kitchen of sixteen square metres and a bathroom."
    )
    assert rooms(found).startswith("B4 H K") and {"B1=14", "B4=14", "K1=16"} <= facts(found)


def test_small_words_are_read_in_more_of_their_forms() -> None:
    assert "K1U1" in facts(read("Three bedrooms and a kitchen; the laundry room has the door from the kitchen."))
    assert {room.area for room in read("A flat. The kitchen must to be big.").rooms} & {
        room.area for room in read("A flat. The kitchen is big.").rooms if room.type == "kitchen"
    }
    assert "K1L1" in facts(read("Un trois-pièces avec une cuisine accessible uniquement depuis le séjour."))
    assert rooms(read("A two-bedroom flat, one full bath, one half bath.")) == "B2 H K L W2"
    assert not {"B1W1", "B2W1"} & facts(read("A two-bedroom flat, one full bath, one half bath."))


WAYS = ("both from the hallway and from the living room", "from the hallway and from the living room")


@pytest.mark.parametrize("way", [*WAYS, "from the hallway and the living room"])
def test_a_preposition_said_twice_leads_to_both(way: str) -> None:
    found = read(f"A two-bedroom flat where you can enter the kitchen {way}.")
    assert {"H1K1", "K1L1", "B1H1", "B2H1"} <= facts(found)


@pytest.mark.parametrize("both", ["both from the corridor", "both off the corridor", "each from the corridor"])
def test_rooms_that_are_both_from_a_corridor_open_off_it(both: str) -> None:
    assert {"H1W1", "H1W2"} <= facts(read(f"Four bedrooms. Two bathrooms, {both}."))


@pytest.mark.parametrize("arrow", ["->", "=>", "→", ":"])
def test_an_arrow_to_furniture_says_what_a_room_has(arrow: str) -> None:
    found = facts(
        read(f"bedrooms: 2; kitchen; bedroom 1 {arrow} double bed, wardrobe; bedroom 2 {arrow} single bed, desk")
    )
    assert {"B1 has 1 wardrobe", "B2 has 1 single_bed", "B2 has 1 desk"} <= found


@pytest.mark.parametrize("every", ["every bedroom", "each bedroom", "both bedrooms"])
def test_furniture_behind_its_rooms_begins_a_clause(every: str) -> None:
    assert {"B1 has 1 desk", "B2 has 1 desk"} <= facts(read(f"Two bedrooms, in {every} one desk and one wardrobe."))


@pytest.mark.parametrize("no", ["a separate kitchen, not a kitchenette", "a real kitchen, not just a kitchenette"])
def test_what_a_room_is_not_is_no_second_room(no: str) -> None:
    assert rooms(read(f"A one-bedroom flat with {no}.")) == "B H K L W"


def test_a_kitchen_that_is_not_open_may_have_a_door() -> None:
    found = facts(read("Two bedrooms. The kitchen is not open, it has a door from the corridor."))
    assert "H1K1" in found and not any("no_door" in fact for fact in found)


@pytest.mark.parametrize("none", ["neither of them en suite", "none of them en suite", "neither of them ensuite"])
def test_bathrooms_none_of_which_is_en_suite_open_off_the_hallway(none: str) -> None:
    assert {"H1W1", "H1W2"} <= facts(read(f"A 2-bed flat with two bathrooms, {none}, and a balcony."))


def test_pairs_with_a_hyphen_are_doors() -> None:
    doors = "hall-living room, hall-bathroom, hall-bedroom 1, hall-bedroom 2, living room-kitchen"
    found = read(f"rooms: hall, living room, kitchen, bedroom 1, bedroom 2, bathroom; doors: {doors}")
    assert rooms(found) == "B2 H K L W" and {"K1L1", "H1W1"} <= facts(found)


def test_whose_own_is_not_what_others_share() -> None:
    said = (
        "Two bedrooms share a jack-and-jill bathroom, the master has its own, the third bathroom opens off the hallway."
    )
    found = facts(read(f"Four bedrooms and 3 bathrooms. {said}"))
    assert len([f for f in found if f[:1] == "B" and f[2:3] == "W"]) == 3
    found = facts(read("Apartment for two roommates, each with their own bedroom and private bathroom."))
    assert {"B1W1", "B2W2"} <= found


def test_an_area_behind_a_known_room_is_its() -> None:
    assert rooms(read("Two bedrooms and a study. Living room 24 m², study 9 m².")) == "B2 H K L S W"
    assert "B1Y1" in facts(read("3 bedrooms. Main bedroom of at least 14 m², please, and with a balcony."))


def test_a_table_to_play_on_is_none_to_dine_at() -> None:
    found = read("A flat. Put a pool table in the living room.")
    assert not found.objects and any("pool table" in words for words in found.unread)


def test_a_side_behind_a_list_with_furniture_is_that_of_its_last_room() -> None:
    found = facts(read("Dreizimmerwohnung, offene Küche, Bad mit Badewanne, Gäste-WC und ein Balkon nach Süden"))
    assert "orientation Y1 south" in found and "orientation W2 south" not in found


@pytest.mark.parametrize("no", ["do not", "don't", "are not"])
def test_what_others_do_not_is_denied_of_them(no: str) -> None:
    found = facts(read(f"Two bedrooms, two bathrooms. The two bathrooms share a wall and the two bedrooms {no}."))
    assert "adjacent W1 W2" in found and "apart B1 B2" in found
    found = facts(read("Two bedrooms. The kitchen opens onto the hall, the bathroom does not."))
    assert "no_door W1 H1" in found and "H1K1" in found


@pytest.mark.parametrize("most, least", [("largest", "smallest"), ("biggest", "smallest"), ("smallest", "largest")])
def test_the_largest_room_and_without_a_verb_the_smallest(most: str, least: str) -> None:
    found = facts(read(f"A flat. The living room is the {most} room and the bathroom the {least}."))
    order = {"largest": "largest", "biggest": "largest", "smallest": "smallest"}
    assert {f"order L1 {order[most]}", f"order W1 {order[least]}"} <= found


@pytest.mark.parametrize("said", ["that can only be reached through", "only accessible from", "next to"])
def test_what_ends_a_list_is_said_of_its_last_room(said: str) -> None:
    found = facts(
        read(f"A flat with two bedrooms, one bathroom, a separate toilet and a utility room {said} the kitchen.")
    )
    assert "H1W1" in found and "H1W2" in found and ("K1U1" in found or "adjacent U1 K1" in found)


@pytest.mark.parametrize("own", ["its own door to", "a door to", "a direct door to"])
def test_a_door_in_addition_to_the_one_from_elsewhere(own: str) -> None:
    doors = f"The bedroom has {own} the bathroom in addition to the one from the hall."
    found = read(f"A flat with one bedroom and one bathroom. {doors}")
    assert rooms(found) == "B H K L W" and {"B1W1", "H1W1", "B1H1"} <= facts(found)


def test_also_joins_no_rooms() -> None:
    found = facts(read("A home: bedroom connected to the bathroom, bathroom also accessible from the hall, kitchen."))
    assert {"B1W1", "H1W1"} <= found


def test_rooms_together_are_one_space() -> None:
    assert "D1~K1" in facts(read("1 bed 1 bath, kitchen and dining area together, living room with two armchairs"))
    assert "D1~K1" in facts(
        read("Three bedrooms, a playroom next to the living room and a kitchen open to the dining room.")
    )


@pytest.mark.parametrize("joint", [", and", " and", ","])
def test_a_room_may_be_named_behind_its_place_between_others(joint: str) -> None:
    assert {"B1W1", "B2W1"} <= facts(
        read(f"A flat with 2 bedrooms{joint} between them a bathroom with a door to each.")
    )


def test_and_that_begins_a_clause() -> None:
    found = facts(read("I would like that the bathroom is not beside the kitchen and that the bedroom is at the back."))
    assert {"apart W1 K1", "position B1 back"} <= found and "apart W1 B1" not in found


@pytest.mark.parametrize("instead", ["instead of", "in place of"])
def test_a_room_in_the_place_of_the_second_bedroom_leaves_one(instead: str) -> None:
    assert rooms(read(f"A flat with 2 bedrooms. Make one office {instead} the second bedroom.")) == "B H K L S W"
    assert (
        rooms(read(f"2 bedrooms. We also need an office, so make one office {instead} the second bedroom.")).count("S")
        == 1
    )


@pytest.mark.parametrize("things", ["bed and desk", "bed, desk and sofa", "desk and bed"])
def test_a_bed_among_furniture_is_no_bedroom(things: str) -> None:
    found = read(f"Studio, 32 sqm, {things} in the main room, no balcony")
    assert rooms(found) == "K L W" and {"L1 has 1 double_bed", "L1 has 1 desk"} <= facts(found)


def test_furniture_is_that_of_the_room_it_is_said_with() -> None:
    office = "home office with a desk and two chairs"
    found = facts(read(f"Entrance hall with a coat rack, {office}, tiny bedroom, a bathroom with a shower but no tub."))
    assert {"H1 has 1 coat_rack", "S1 has 1 desk", "S1 has 2 chair", "W1 has 1 shower", "W1 has 0 bath"} <= found


@pytest.mark.parametrize("that", ["that has its own", "which has its own", "with its own"])
def test_what_a_room_has_in_a_clause_behind_it_is_its_own(that: str) -> None:
    found = facts(read(f"A guest room {that} shower room, a main bedroom, a bathroom, a living room and a kitchen."))
    assert {"B2W1", "H1W2"} <= found or {"B2W2", "H1W1"} <= found


@pytest.mark.parametrize("both", ["that both open off", "which both open off", "both off"])
def test_a_list_goes_on_behind_what_both_have(both: str) -> None:
    found = facts(read(f"Flatshare: four bedrooms, two bathrooms {both} the hallway, one big kitchen, no living room"))
    assert {"H1W1", "H1W2"} <= found and not {"K1W1", "K1W2"} & found


@pytest.mark.parametrize(
    "none", ["No study is off the kitchen", "No pantry opens off the kitchen", "No office is next to it"]
)
def test_what_no_study_is_asks_for_none(none: str) -> None:
    assert rooms(read(f"Two-bedroom flat with a kitchen. {none}.")) == "B2 H K L W"


@pytest.mark.parametrize("flat, beds", [("student flat for three", 3), ("shared apartment for four", 4)])
def test_those_who_share_a_flat_have_a_room_each(flat: str, beds: int) -> None:
    assert rooms(read(flat)).startswith(f"B{beds} ")


@pytest.mark.parametrize("anew", ["no, make that", "wait, make that", "actually make it"])
def test_what_follows_rooms_counted_anew_is_said_as_ever(anew: str) -> None:
    way = "where the robot can enter the kitchen both from the hallway and from the living room"
    found = read(f"A two-bedroom flat, {anew} three bedrooms and two baths, {way}.")
    assert rooms(found) == "B3 H K L W2" and {"H1K1", "K1L1"} <= facts(found)
    found = read(f"Three bedrooms, {anew} four bedrooms, two bathrooms (one belongs to the master), a playroom.")
    assert rooms(found) == "B4 H K L S W2"


@pytest.mark.parametrize("like", ["like the bedrooms", "just like the bedrooms", "as are the bedrooms"])
def test_what_is_like_others_is_said_of_them(like: str) -> None:
    found = facts(read(f"2 bedrooms with a balcony each. Kitchen and lounge are off the hall {like}."))
    assert {"B1H1", "B2H1", "H1K1", "H1L1"} <= found and not {"B1K1", "B1L1"} & found


@pytest.mark.parametrize("so", ["So: three bedrooms", "So three bedrooms", "Three bedrooms"])
def test_bedrooms_counted_after_those_who_sleep_there_are_all(so: str) -> None:
    said = "for me, my wife and our twin daughters, who want a room each"
    assert rooms(read(f"A flat {said}. {so}, one bathroom.")) == "B3 H K L W"


def test_a_way_in_said_in_french_is_that_of_the_last_room() -> None:
    found = facts(read("Deux chambres, une salle de bain sans baignoire, des WC séparés et une cuisine accessible "
                       "uniquement depuis le séjour."))  # fmt: skip
    assert {"K1L1", "H1W2"} <= found and "L1W2" not in found


ASKED = ("for ObjectNav episodes", "for a mobile manipulation benchmark", "for a horror game", "for a life sim",
         "the player should find", "on one floor")  # fmt: skip


@pytest.mark.parametrize("why", ASKED)
def test_what_a_plan_is_for_is_not_told_as_unread(why: str) -> None:
    assert not read(f"A two-bedroom flat {why}, with an open kitchen.").unread


def test_a_study_of_users_is_no_room() -> None:
    assert rooms(read("For our user study we need a two-bedroom flat.")) == "B2 H K L W"
    assert any("student" in words for words in read("A student flat.").unread)


@pytest.mark.parametrize("need", ["who each need a study", "who each want an office", "each with their own study"])
def test_what_each_of_two_people_needs_there_are_two_of(need: str) -> None:
    assert rooms(read(f"A one-bedroom flat for two people {need}.")) == "B H K L S2 W"


@pytest.mark.parametrize("just", ["Besides that just", "Otherwise only", "Apart from that just"])
def test_just_some_more_rooms_are_no_whole_home(just: str) -> None:
    more = f"{just} a bathroom, a kitchen and a lounge"
    found = read(f"The office is near the entrance. The bedroom is at the back. {more}.")
    assert rooms(found) == "B H K L S W"

"""Constructions of grammar in several wordings each: what is left out, what is contrasted, whose a clause is."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("hall", ["one long hallway", "a long corridor", "a short corridor", "a narrow hallway"])
def test_a_hallway_of_some_style_is_a_hallway(hall: str) -> None:
    found = facts(read(f"A two-bedroom flat with {hall}, no wider than 1.2 m. The bathroom is off the kitchen."))
    assert {"at_most H1 width 1.2", "B1H1", "B2H1", "K1W1"} <= found
    assert rooms(read(f"A studio with {hall}.")) == "H K L W"


@pytest.mark.parametrize("own", ["each one with his own bathroom", "each with her own bathroom", "each with its own bath"])
def test_each_one_has_his_own(own: str) -> None:
    assert {"B1W1", "B2W2"} <= facts(read(f"The apartment has 2 bedrooms, {own}, and one toilet."))


@pytest.mark.parametrize("who", ["student", "students'", "tenant", "flatmate's"])
def test_a_students_room_is_a_bedroom(who: str) -> None:
    found = read(f"A flat with four {who} rooms of fourteen m² each, a kitchen of sixteen square metres and a bathroom.")
    assert rooms(found).startswith("B4 H K") and {"B1=14", "B4=14", "K1=16"} <= facts(found)


def test_small_words_are_read_in_more_of_their_forms() -> None:
    assert "K1U1" in facts(read("Three bedrooms and a kitchen; the laundry room has the door from the kitchen."))
    assert {room.area for room in read("A flat. The kitchen must to be big.").rooms} & {
        room.area for room in read("A flat. The kitchen is big.").rooms if room.type == "kitchen"
    }
    assert "K1L1" in facts(read("Un trois-pièces avec une cuisine accessible uniquement depuis le séjour."))
    assert rooms(read("A two-bedroom flat, one full bath, one half bath.")) == "B2 H K L W2"
    assert not {"B1W1", "B2W1"} & facts(read("A two-bedroom flat, one full bath, one half bath."))

"""Amounts that are denied, taken back or said anew: what holds is the room's, and nothing of the rest the home's."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("One bedroom. The living room is not 26 m² but 22 m².", "B L", "L1=22, !all=26"),
    ("One bedroom. The living room should have 22 and not 26 m².", "B L", "L1=22, !all=26"),
    ("One bedroom. The living room is 22 sqm instead of 26 sqm.", "B L", "L1=22, !all=26"),
    ("One bedroom; living room 22 m² not 26 m², kitchen 9 m².", "B H K L W", "L1=22, K1=9, !all=26"),
    ("One bedroom; living room 26 m² → 22 m².", "B L", "L1=22, !all=22"),
    ("One bedroom, 22 m² living room, not 26 m².", "B L", "L1=22, !all=26"),
    ("One bedroom. The living room has 26 m² - er, 22.", "B L", "L1=22, !unread er"),
    ("One bedroom. The living room has 26 m². Make it 22 instead.", "B L", "L1=22, !unread instead"),
    ("Two bedrooms. Three bedrooms instead.", "B3 H K L W2", "!unread instead"),
    ("Two bedrooms, a kitchen. A study instead.", "B2 H K L S W", "unread instead"),
    ("A 70 m² flat, not 80 m², with two bedrooms.", "B2 H K L W", "all=70, !unread 80"),
    ("Two bedrooms, 12 and 10 m², sorry, 12 and 11.", "B2 H K L W", "B1=12, B2=11"),
    ("One bedroom. Living room 26 m², kitchen 9 m². Sorry, the living room is 22 m².", "B H K L W", "L1=22, K1=9"),
    ("One bedroom. Living room 26 m², kitchen 9 m². Correction: kitchen 11.", "B H K L W", "L1=26, K1=11"),
    ("Two bedrooms. Bedroom 1 is 14 m², bedroom 2 is 10 m². Sorry, bedroom 1 is 15 m².", "B2 H K L W", "B1=15, B2=10"),
    ("One bedroom. The kitchen is 9 m², the bath 5 m². No wait, the kitchen is 12 m² and the bath 6 m².", "B H K L W",
     "K1=12, W1=6"),
    ("One bedroom flat. The kitchen is 9 m². Actually the kitchen should be 12 m².", "B H K L W", "K1=12"),
    ("Two bedrooms of 12 m²; the first bedroom is 14 m².", "B2 H K L W", "B1=14, B2=12"),
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)


@pytest.mark.parametrize("said", ["22 m², not 26", "22 m² (not 26)", "22 rather than 26 m²", "~~26~~ 22 m²",
                                  "26, no, 22 m²", "26 m², make that 22 m²", "26 m², sorry, 22"])  # fmt: skip
def test_nothing_denied_is_left_or_told(said: str) -> None:
    program = read(f"A one-bedroom flat. The living room has {said}.")
    areas = {room.type: room.area for room in program.rooms}
    assert (areas["living_room"], program.total_area, program.unread) == (22, None, [])


@pytest.mark.parametrize("said", ["Der Wohnraum hat 22 m², nicht 26. Ein Zimmer, ein Bad, eine Küche.",
                                  "Le salon fait 22 m², pas 26. Une chambre, une cuisine."])  # fmt: skip
def test_other_languages_deny_them_too(said: str) -> None:
    program = read(said)
    areas = {room.type: room.area for room in program.rooms}
    assert (areas["living_room"], program.total_area, program.unread) == (22, None, [])

"""Numbers of rooms with a least and a most, counts said anew in fields, and how many rooms a home may have at all."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("A flat with between two and three bedrooms and one bathroom.", "B2 H K L W", "H1W1, !B1W1"),
    ("Somewhere between 2 and 4 small bedrooms, one or two bathrooms, a study.", "B2 H K L S W", "H1W1"),
    ("2-3 bedrooms and 1-2 bathrooms.", "B2 H K L W", ""),
    ("A house with three to four bedrooms with desks.", "B3 H K L W2", "B3 has 1 desk"),
    ("Haus mit drei bis vier Schlafzimmern und ein oder zwei Bädern.", "B3 H K L W", ""),
    ("Un piso con entre dos y cuatro dormitorios y uno o dos baños.", "B2 H K L W", "H1W1"),
    ("Un appartement de deux à trois chambres.", "B2 H K L W", ""),
    ("两到四个卧室，一个卫生间。", "B2 H K L W", ""),
    ("bedrooms: 2-4, bathrooms: 1-2", "B2 H K L W", ""),
    ("Bedrooms: between 2 and 4", "B2 H K L W", "!adjacent B1 B2"),
    ("3 (or 4) bedrooms and a kitchen", "B3 H K L W2", "!unread 3"),
    # no range
    ("0-2 bedrooms, one bathroom and a living room", "B2 H K L W", "unread 0"),
    ("The bathroom lies between bedrooms 1 and 2; three bedrooms.", "B3 H K L W", "B1W1, B2W1, !B3W1"),
    ("A kitchen between 10 and 12 m2 and two bedrooms.", "B2 H K L W", "at_least K1 10, at_most K1 12"),
    # fields said anew
    ("bathrooms: one -> two; bedrooms: 2", "B2 H K L W2", "!W1W2"),
    ("bedrooms: 2 → make that 3, bathrooms: 1", "B3 H K L W", ""),
    ("bedrooms: 1 -> 2 -> 4, study: 1", "B4 H K L S W2", ""),
    ("living room -> kitchen -> pantry; one bedroom", "B H K L T W", "K1L1, K1T1"),
    # limits of a whole home are told, what is counted of it is had
    ("At most five rooms in total including the hallway; at least two of them bedrooms.", "B2 H K L W",
     "unread at most five rooms in total including the hallway"),
    ("No more than eight rooms altogether, at least three of which are bedrooms.", "B3 H K L W2",
     "unread no more than eight rooms altogether"),
]  # fmt: skip

test_the_least_of_a_range_is_meant = as_meant(SENTENCES)


@pytest.mark.parametrize("said", ["between 2 and 3 bedrooms", "two or three bedrooms", "2 to 3 large bedrooms"])
def test_nothing_of_a_range_is_told(said: str) -> None:
    assert read(f"A flat with {said} and a kitchen.").unread == []

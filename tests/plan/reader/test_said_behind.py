"""What is said behind rooms named before: not needed, not en suite, instead, so much smaller, for whom, all of them."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    # not needed
    ("Flat with three bedrooms. They share one bathroom and one kitchen. Living room is not needed.", "B3 H K W",
     "!unread needed"),
    ("Two bedrooms. A hallway is not necessary.", "B2 K L W", ""),
    ("A balcony isn't needed. Two bedrooms.", "B2 H K L W", ""),
    ("Two bedrooms, a dining room is not required.", "B2 H K L W", ""),
    ("Two bedrooms. Balcony not needed, study and pantry not needed.", "B2 H K L W", ""),
    ("Ein Balkon wird nicht gebraucht. Zwei Schlafzimmer.", "B2 H K L W", ""),
    ("Zwei Schlafzimmer. Ein Esszimmer ist nicht nötig.", "B2 H K L W", ""),
    ("Deux chambres. Un balcon n'est pas nécessaire.", "B2 H K L W", ""),
    ("Dos dormitorios. El balcón no es necesario.", "B2 H K L W", ""),
    ("Dos dormitorios. No hace falta balcón.", "B2 H K L W", ""),
    ("Two bedrooms; a study is needed.", "B2 H K L S W", "!unread needed"),
    ("Two bedrooms. A door between the kitchen and the living room is not needed.", "B2 H K L W",
     "unread is not needed"),
    # not en suite
    ("Two bedrooms and two bathrooms, neither of which is en suite.", "B2 H K L W2", "H1W1, H1W2"),
    ("Two bedrooms and two bathrooms, neither is en suite.", "B2 H K L W2", "H1W1, H1W2"),
    ("Three bedrooms, two bathrooms, not en suite.", "B3 H K L W2", "H1W1, H1W2"),
    ("Two bathrooms that are not en suite, three bedrooms.", "B3 H K L W2", "H1W1, H1W2"),
    ("Three bedrooms and two bathrooms. The bathrooms must not be en suite.", "B3 H K L W2", "H1W1, H1W2"),
    ("Three bedrooms, two bathrooms, one of them en suite.", "B3 H K L W2", "B1W1, H1W2"),
    # instead
    ("First I thought two bedrooms, but please do three instead.", "B3 H K L W2", "!unread instead"),
    ("I wanted two bedrooms at first but now three instead. One of them will be 9 m2.", "B3 H K L W2", "B1=9"),
    ("Two bedrooms, no wait, make it three bedrooms instead.", "B3 H K L W2", "!unread instead"),
    ("One-bedroom flat. No bathtub in the bathroom, a shower instead.", "B H K L W",
     "W1 has 1 shower, !unread instead"),
    ("Two bedrooms; the desk is in the study instead.", "B2 H K L S W", "unread instead"),
    # so much more or less
    ("Two bedrooms. The first bedroom is 15 m2, the other is 3 m2 smaller.", "B2 H K L W", "B1=15, B2=12"),
    ("Two bedrooms: the main one is 16 m², the second one is 4 m² smaller.", "B2 H K L W", "B1=16, B2=12"),
    ("The kitchen is 10 m² and the living room is 12 m² larger. One bedroom.", "B H K L W", "K1=10, L1=22"),
    ("The living room is 25 m². The kitchen is 10 m² smaller than the living room. Two bedrooms.", "B2 H K L W",
     "L1=25, K1=15"),
    ("Bedroom 1 has 14 m2, bedroom 2 is 2 m2 bigger than bedroom 1.", "B2 H K L W", "B1=14, B2=16"),
    ("Two bedrooms. The kitchen is 3 m² larger than the study.", "B2 H K L S W", "unread 3 m2"),
    # some of them
    ("Four bedrooms. Two of them are 12 m2, other two are 10 m2. Two bathrooms.", "B4 H K L W2",
     "B1=12, B2=12, B3=10, B4=10, !all=12"),
    ("Three bedrooms: two of them have 12 m2 and the third has 9 m2.", "B3 H K L W2", "B1=12, B2=12, B3=9, !all=12"),
    ("Three bedrooms, two of which are 10 m² each.", "B3 H K L W2", "B1=10, B2=10, !B3=10"),
    # the flat's area behind a list
    ("bedroom + kitchen + bathroom + living room, 40 sqm, no hallway", "B K L W", "all=40, !L1=40"),
    ("One bedroom, kitchen, bathroom, living room, 45 m2", "B H K L W", "all=45"),
    ("two bedrooms, kitchen, living room, 25 m2", "B2 H K L W", "L1=25"),
    ("Two bedrooms, kitchen 10 m², living room, 38 m²", "B2 H K L W", "L1=38, K1=10"),
    # for whom
    ("3 bedrooms, one for the parents and two for the kids. The parents have an ensuite, and the family bathroom is "
     "next to both kids' rooms.", "B3 H K L W2", "adjacent W2 B2, adjacent W2 B3, B1W1"),
    ("Four bedrooms: one for parents, one for grandmother and two for children. The grandmother's room must be next to "
     "the bathroom.", "B4 H K L W", "adjacent B2 W1"),
    ("Three bedrooms, one for us, one for my mother, one for the baby. My mother's room is next to the bathroom.",
     "B3 H K L W", "adjacent B2 W1"),
    ("Two bedrooms for the children, one for us.", "B3 H K L W2", ""),
    # all of them
    ("A four-bedroom house whose bedrooms are all away from the entrance and whose kitchen is near it. Three "
     "bathrooms, two of them en suite.", "B4 H K L W3",
     "apart B1 entrance, apart B4 entrance, near K1 entrance, !apart W1 entrance"),
    ("The study and the kitchen are both at the back. Two bedrooms.", "B2 H K L S W",
     "position S1 back, position K1 back"),
    ("We are three students. Every one has his own room with a desk, all rooms same size. One kitchen, one bathroom.",
     "B3 H K L W", "!B1=14, !B3=9.5"),
    ("Apartment for my parents, only 1 bedroom but large, bathroom with shower, no bath tub, and the hall must be wide "
     "minimum 1.2 meters.", "B H K L W", "at_least H1 width 1.2, W1 has 1 shower, W1 has 0 bath, !unread large"),
    # once more of those before
    ("Three bedrooms, each smaller than the one before.", "B3 H K L W2",
     "order B2 B1 smaller, order B3 B2 smaller, !unread before"),
    ("Two bedrooms. No rooms off the kitchen.", "B2 H K L W", "unread no rooms, !B1K1, !B2K1"),
    ("Zwei Schlafzimmer. Kein Schlafzimmer an der Küche.", "B2 H K L W", "apart B1 K1, apart B2 K1"),
    ("Two bedrooms. The kitchen is larger than the study and has an oven.", "B2 H K L S W",
     "K1 has 1 oven, order K1 S1 larger, !S1 has 1 oven"),
    ("The study is smaller than the main bedroom and has a desk. Two bedrooms.", "B2 H K L S W",
     "S1 has 1 desk, !B1 has 1 desk"),
    ("A couple, one of whom studies at home, two bedrooms.", "B2 H K L W", "unread studies"),
    ("Flat for a woman who studies medicine, one bedroom.", "B H K L W", "unread studies"),
    ("A flat with two bedrooms and two studies.", "B2 H K L S2 W", ""),
    ("Two bedrooms and a larder. We can store skis there.", "B2 H K L T W", "unread store"),
    ("She has a bedroom with a desk. Her two brothers share a bedroom. They all use one bathroom.", "B2 H K L W",
     "H1W1, !B2W1"),
    ("We need three bedrooms. The bedroom of parents has own bathroom and the children use other bathroom in the "
     "corridor.", "B3 H K L W2", "B1W1, H1W2, !B1W2, unread children"),
    ("It should have two bedrooms, one for the parents and other for the baby. One bathroom, beside the baby bedroom.",
     "B2 H K L W", "adjacent W1 B2"),
]  # fmt: skip


NOTHING_SAID = [
    "Scene for object-goal navigation: a flat with one bedroom.",
    "For a long-horizon household robot benchmark I need a two-bedroom apartment.",
    "Vision-and-language navigation: one-bedroom flat in a simulated environment.",
    "Detective's apartment for a noir game, one bedroom.",
    "Stealth level, flat with two bedrooms.",
    "Level idea: a flat with two bedrooms.",
    "Escape room in a one-bedroom flat.",
    "Shooter game map: a two-bedroom flat.",
    "I am searching for a flat with two bedrooms.",
]
"""Prompts whose other words say who asks and what for."""


@pytest.mark.parametrize("prompt", NOTHING_SAID)
def test_words_for_the_asker_are_not_told(prompt: str) -> None:
    assert not read(prompt).unread


@pytest.mark.parametrize(
    ("prompt", "word"),
    [("A flat on two levels, one bedroom.", "level"), ("One bedroom, a map room.", "map"),
     ("A flat for a wheelchair user, one bedroom.", "wheelchair"), ("Our grandmother's flat, one bedroom.", "grandm"),
     ("For a navigation study we want one bedroom.", "navigation"), ("A split-level flat, one bedroom.", "level")],
)  # fmt: skip
def test_words_that_may_say_something_are_told(prompt: str, word: str) -> None:
    assert any(word in entry for entry in read(prompt).unread)


test_the_programme_is_as_meant = as_meant(SENTENCES)

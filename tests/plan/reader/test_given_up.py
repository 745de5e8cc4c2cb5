"""Rooms wished for and then given up, and such as are not."""

from sentences.facts import as_meant

GIVEN_UP = [
    ("The user first wanted a studio with a balcony, then decided against the balcony. Plan a studio of 28 m² without "
     "a balcony.", "K L W", "L1W1, K1~L1, all=28"),
    ("Initially she wanted a two-bedroom flat with a study, then she decided against the study.", "B2 H K L W", ""),
    ("We first wanted a balcony but then decided against it. Two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("At first we wanted a flat with a balcony, later we gave up the balcony. Two bedrooms.", "B2 H K L W", ""),
    ("The client asked for a one-bedroom flat with a study, then dropped the study.", "B H K L W", ""),
    ("The user wanted two bedrooms and a dining room, but then changed his mind about the dining room.", "B2 H K L W",
     ""),
    ("They wanted a balcony at first, then decided against one. One bedroom.", "B H K L W", ""),
    ("We decided against a balcony. Two bedrooms.", "B2 H K L W", ""),
    ("Two bedrooms. We thought about a study and decided against it.", "B2 H K L W", ""),
    ("After some thought we have decided against the dining room. Two bedrooms.", "B2 H K L W", ""),
    ("My first plan had a study; I have since abandoned the study. Two bedrooms and a bathroom.", "B2 H K L W", ""),
    ("Two bedrooms with a balcony; in the end no balcony.", "B2 H K L W", ""),
    ("First a balcony was planned, then it was dropped. One bedroom.", "B H K L W", ""),
    ("Two bedrooms and a study. The study was later scrapped.", "B2 H K L W", ""),
    ("Wir wollten erst einen Balkon, haben uns dann aber dagegen entschieden. Zwei Schlafzimmer.", "B2 H K L W", ""),
    ("Au début nous voulions un balcon, puis nous y avons renoncé. Deux chambres.", "B2 H K L W", ""),
    ("Al principio queríamos un balcón, pero luego lo descartamos. Dos dormitorios.", "B2 H K L W", ""),
    ("We have decided against a second bathroom. Two bedrooms.", "B2 H K L W", ""),
    ("Two bedrooms and a balcony, but in the end we chose not to have the balcony.", "B2 H K L W", ""),
    ("We were going to have a study, but no longer. Two bedrooms.", "B2 H K L W", ""),
    ("There was to be a dining room, yet my wife talked me out of it. Two bedrooms.", "B2 H K L W", ""),
    ("I originally asked for a guest toilet, but I decided against it. Two bedrooms.", "B2 H K L W", ""),
    ("A study was on the list at first, but we have given it up. Two bedrooms.", "B2 H K L W", ""),
    ("A flat with two bedrooms; I toyed with a walk-in closet but decided against it.", "B2 H K L W", ""),
    ("A robot takes the cup to the study and dropped it. One bedroom.", "B H K L S W", ""),
    ("I decided on a balcony after all. One bedroom.", "B H K L W Y", ""),
    ("We decided against the balcony on the north side and want one off the kitchen. One bedroom.", "B H K L W Y",
     "K1Y1"),
]  # fmt: skip

test_a_room_given_up_is_not_planned = as_meant(GIVEN_UP)

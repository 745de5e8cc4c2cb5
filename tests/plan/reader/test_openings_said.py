"""Rooms that share a space: openings as nouns, rooms open to each other, to `it`, in lists and in keyed lines."""

from sentences.facts import as_meant

SENTENCES = [
    # to each other
    ("Only a kitchen and a dining room open to each other, nothing else.", "D K", "D1~K1"),
    ("The kitchen and the living room open onto one another. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("One bedroom; living room and dining room opening to each other.", "B D H K L W", "D1~L1"),
    ("Two bedrooms, living room and kitchen which open into each other.", "B2 H K L W", "K1~L1"),
    ("Two bedrooms that open to each other.", "B2 H K L W", "!B1~B2"),
    # together with
    ("2 bedrooms, one kitchen together with the living room.", "B2 H K L W", "K1~L1"),
    ("Two bedrooms, the kitchen together with living room, one bathroom.", "B2 H K L W", "K1~L1"),
    ("A living room together with a kitchen and two bedrooms.", "B2 H K L W", "!K1~L1"),
    # in its wall
    ("Two bedrooms. The kitchen has an opening in the living room wall.", "B2 H K L W", "K1~L1"),
    # an adjective behind its verb
    ("The living room is 25 m², and the kitchen should be open to it. Two bedrooms.", "B2 H K L W", "K1~L1, L1=25"),
    ("The living room should take up a third of the area, and the kitchen should be open to it. One bedroom.",
     "B H K L W", "K1~L1, !H1K1"),
    ("The kitchen must be open to the living room. One bedroom.", "B H K L W", "K1~L1"),
    ("The kitchen has to be open onto the living room. One bedroom.", "B H K L W", "K1~L1"),
    # keyed
    ("apartment; bedrooms: 2; bathrooms: 1; kitchen: open plan; balcony: yes", "B2 H K L W Y", "K1~L1"),
    ("kitchen (open plan), living room, two bedrooms", "B2 H K L W", "K1~L1"),
    ("kitchen - open plan, living room, 2 bedrooms", "B2 H K L W", "K1~L1"),
    ("living room -> dining room (open), kitchen; hall -> living room, 2 bedrooms, bathroom", "B2 D H K L W",
     "D1~L1, K1L1, !K1~L1, !H1K1"),
    # an opening
    ("The kitchen connects to the living room through a wide opening. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("The kitchen is connected to the living room via an archway. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("The dining room leads into the living room through an opening without a door. One bedroom.", "B D H K L W",
     "D1~L1"),
    ("The dining room opens into the living room without a door. One bedroom.", "B D H K L W", "D1~L1"),
    ("A large opening joins the kitchen and the living room. One bedroom.", "B H K L W", "K1~L1"),
    ("A wide arch connects the kitchen to the living room. One bedroom.", "B H K L W", "K1~L1"),
    ("There is a wide opening between the kitchen and the living room. One bedroom.", "B H K L W", "K1~L1"),
    ("The kitchen has a wide opening to the living room. One bedroom.", "B H K L W", "K1~L1"),
    ("One bedroom, a kitchen with a large opening to the living room.", "B H K L W", "K1~L1"),
    ("Two bedrooms and a big opening to the south.", "B2 H K L W", "unread a big opening"),
    # a door that is not there is no opening
    ("Two bedrooms. The study is without a door to the hallway.", "B2 H K L S W", "no_door S1 H1, !H1~S1"),
    ("The bathroom is next to the main bedroom with no door between them. Two bedrooms.", "B2 H K L W",
     "no_door W1 B1, !B1~W1"),
    # it
    ("One-bedroom flat. The kitchen is located to the north of the living room and connects to it.", "B H K L W",
     "K1L1, position K1 L1 north, !B1K1"),
    ("The kitchen lies to the east of the living room and opens into it. One bedroom.", "B H K L W", "K1L1"),
    ("The study is to the left of the living room and is reached from it. One bedroom.", "B H K L S W", "L1S1"),
    ("Two bedrooms. The kitchen is west of the living room and has a door to it.", "B2 H K L W", "K1L1"),
    ("Reception room of 40 sqm, dining room of 20 sqm opening into it without a door, kitchen off the dining room, "
     "four bedrooms.", "B4 D H K L W2", "D1~L1, D1K1, L1=40, D1=20, !H1K1"),
    ("A living room, a study opening off it, two bedrooms.", "B2 H K L S W", "L1S1, !B1S1"),
    ("A living room with a balcony, a kitchen that opens onto it, two bedrooms.", "B2 H K L W Y", "K1L1, !B1K1"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

"""A clause without a verb behind one with a link: its room is no object of the link."""

from sentences.facts import as_meant

SENTENCES = [
    ("A two-bedroom flat. The bathroom must not be reachable from the kitchen, bedroom far from the entrance.",
     "B2 H K L W", "no_door W1 K1, apart B1 entrance, !no_door W1 B1"),
    ("A two-bedroom flat. The bathroom must not open into the kitchen, the bedrooms away from the entrance.",
     "B2 H K L W", "no_door W1 K1, apart B1 entrance, apart B2 entrance, !no_door W1 B1, !no_door W1 B2"),
    ("A one-bedroom flat. The bathroom must not be reachable from the kitchen or the living room, bedroom facing east.",
     "B H K L W", "no_door W1 K1, no_door W1 L1, orientation B1 east, !no_door W1 B1"),
    ("A one-bedroom flat. The bathroom must not be accessible from the living room, bedroom at the back.", "B H K L W",
     "no_door W1 L1, position B1 back, !no_door W1 B1"),
    ("A one-bedroom flat. The bathroom opens off the hallway, bedroom far from the entrance.", "B H K L W",
     "H1W1, apart B1 entrance, !B1W1"),
    ("A two-bedroom flat. The bathroom must not be reachable from the kitchen, the study or the living room.",
     "B2 H K L S W", "no_door W1 K1, no_door W1 S1, no_door W1 L1"),
]  # fmt: skip

test_the_room_is_no_object = as_meant(SENTENCES)

"""Doors told of several rooms together: around one, in a chain, of neither of two, two ways into one."""

from sentences.facts import as_meant

SENTENCES = [
    # around one
    ("A living room in the centre with a kitchen, a study and two bedrooms around it, each opening into it.", "B2 K "
     "L S",
     "B1L1, B2L1, K1L1, L1S1, position L1 centre"),
    ("A dining room in the middle and, around it, each with a door to it, a kitchen, a study and a bedroom.", "B D K S",
     "B1D1, D1K1, D1S1, !B1H1"),
    ("A lounge of 20 m2; the kitchen, bathroom and two bedrooms are all arranged around it, each with its own door "
     "onto "
     "it.", "B2 K L W", "B1L1, B2L1, K1L1, L1W1, L1=20, !B1K1"),
    ("The kitchen, a study and two bedrooms surround the living room, each with a door to it.", "B2 K L S",
     "B1L1, B2L1, K1L1, L1S1"),
    # a chain
    ("Entrance, then living room, then study, then bedroom in one straight chain with the bathroom as a dead end off "
     "the "
     "bedroom; nothing else.", "B H L S W", "H1L1, L1S1, B1S1, B1W1, !H1W1"),
    ("Start in the kitchen. From it a door to the study, from there one to the bedroom.", "B K S", "K1S1, B1S1, !B1K1"),
    ("Begin in the kitchen. From it a door to the study, from there one to the bedroom, and only from the bedroom can "
     "one reach the bathroom.", "B H K L S W", "K1S1, B1S1, B1W1, !H1W1"),
    # neither of two
    ("The study must be next to the nursery, and neither may open into the living room. Two bedrooms.", "B2 H K L S W",
     "adjacent S1 B2, no_door S1 L1, no_door B2 L1"),
    ("The kitchen should be beside the dining room and neither should have a door to the hallway. One bedroom.",
     "B D H K L W", "adjacent K1 D1, no_door K1 H1, no_door D1 H1"),
    ("Neither the study nor the nursery has a door to the kitchen. Two bedrooms.", "B2 H K L S W",
     "no_door S1 K1, no_door B2 K1"),
    ("Neither the kitchen nor the bathroom should be next to the study. One bedroom.", "B H K L S W",
     "apart K1 S1, apart W1 S1"),
    ("Zwei Schlafzimmer. Weder die Küche noch das Bad darf eine Tür zum Wohnzimmer haben.", "B2 H K L W",
     "no_door K1 L1, no_door W1 L1"),
    ("Deux chambres. Ni la cuisine ni la salle de bain ne donnent sur le salon.", "B2 H K L W",
     "no_door K1 L1, no_door W1 L1"),
    ("Casa con dos dormitorios; ni la cocina ni el baño dan al salón.", "B2 H K L W", "no_door K1 L1, no_door W1 L1"),
    # between two of three
    ("Bedrooms 2 and 3 share a bathroom between them, three bedrooms.", "B3 H K L W",
     "adjacent W1 B2, adjacent W1 B3, !adjacent W1 B1, H1W1"),
    ("(1) 3 bedrooms; (2) bedroom 1 >= 14 sqm; (3) bedroom 1 and bedroom 3 share a bathroom between them; (4) entrance "
     "on the west side.", "B3 H K L W", "adjacent W1 B1, adjacent W1 B3, !adjacent W1 B2, H1W1"),
    ("A three-bedroom flat, the two children's rooms share one bath between them.", "B3 H K L W",
     "adjacent W1 B2, adjacent W1 B3"),
    ("Three bedrooms and one bathroom between the three bedrooms.", "B3 H K L W", "H1W1, !B1W1"),
    ("A bathroom between three bedrooms.", "B3 H K L W", "H1W1, !B1W1"),
    # ways
    ("Two ways into the kitchen, one from the hallway and one from the dining room; one bedroom.", "B D H K L W",
     "H1K1, D1K1"),
    ("A flat with two doors into the main bedroom: one from the living room and one through its bathroom, which also "
     "opens to the hall.", "B H K L W", "B1L1, B1W1, H1W1, !L1W1"),
    ("Two bedrooms. You can get into the bathroom two ways: from the main bedroom and from the hall.", "B2 H K L W",
     "B1W1, H1W1"),
    ("The bathroom can be entered from two sides, from the main bedroom and from the hall; two bedrooms.", "B2 H K L W",
     "B1W1, H1W1"),
    ("One-bedroom flat with a pantry you can only get into from the kitchen.", "B H K L T W", "K1T1, !H1T1"),
    ("A thief comes past the living room and escapes by the balcony, which you only reach from the kitchen. One "
     "bedroom.",
     "B H K L W Y", "K1Y1, !L1Y1, !adjacent L1 Y1"),
    ("The bathroom must be en suite to the larger bedroom only. Two bedrooms.", "B2 H K L W", "B1W1, !H1W1"),
    ("Tres dormitorios, el principal con baño propio, otro baño en el pasillo y una terraza en la cocina.",
     "B3 H K L W2 Y", "H1W2, K1Y1, !K1W2"),
]  # fmt: skip

test_doors_are_as_told = as_meant(SENTENCES)

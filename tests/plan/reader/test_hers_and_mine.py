"""Rooms that are told by whose they are, `hers`, `his bedroom … ours`, and rooms that are not to be neighbours."""

from sentences.facts import as_meant

TOLD = [
    ("Two studies, one bedroom. My study should face east, hers should face north.", "B H K L S2 W",
     "orientation S1 east, orientation S2 north"),
    ("Two studies and one bedroom. My study faces south and his faces east.", "B H K L S2 W",
     "orientation S1 south, orientation S2 east"),
    ("Two bedrooms. My bedroom has a desk, and his has a bookshelf.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 bookshelf"),
    ("Zwei Arbeitszimmer, ein Schlafzimmer. Mein Arbeitszimmer soll nach Osten gehen, ihres nach Norden.",
     "B H K L S2 W", "orientation S1 east, orientation S2 north"),
    ("Deux bureaux, une chambre. Mon bureau doit donner à l'est, le sien au nord.", "B H K L S2 W",
     "orientation S1 east, orientation S2 north"),
    ("My teenage son wants his peace: his bedroom shouldn't share a wall with ours. He has his own bathroom, entered "
     "only from his room; ours is off the hallway. There is a desk in his room.", "B2 H K L W2",
     "apart B2 B1, B2W1, B2 has 1 desk"),
    ("Our daughter is noisy: her room must not be next to our bedroom. One bathroom.", "B2 H K L W", "apart B2 B1"),
    ("My mother lives with us. Her bedroom should not share a wall with ours. One bathroom.", "B2 H K L W",
     "apart B2 B1"),
    ("It is for my old parents: one bedroom for them and one guest room, each have one double bed.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 double_bed"),
    ("Deux chambres qui ne soient pas l'une à côté de l'autre.", "B2 H K L W", "apart B1 B2, !adjacent B1 B2"),
    ("Deux chambres qui ne se touchent pas.", "B2 H K L W", "apart B1 B2"),
    ("Les deux chambres ne doivent pas être voisines.", "B2 H K L W", "apart B1 B2"),
    ("Les deux chambres ne doivent pas avoir de mur commun.", "B2 H K L W", "apart B1 B2"),
    ("Zwei Schlafzimmer, die keine gemeinsame Wand haben.", "B2 H K L W", "apart B1 B2"),
    ("Dos dormitorios que no sean contiguos.", "B2 H K L W", "apart B1 B2"),
    ("Dos dormitorios que no compartan pared.", "B2 H K L W", "apart B1 B2"),
    ("Dos dormitorios contiguos.", "B2 H K L W", "adjacent B1 B2"),
]  # fmt: skip

test_whose_rooms_and_which_are_apart = as_meant(TOLD)

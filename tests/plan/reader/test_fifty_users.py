"""Prompts as fifty users type them, of which the first reading had shown something missed."""

from sentences.facts import as_meant

SENTENCES = [
    # none of several
    ("A 3-bedroom apartment where no two bedrooms share a wall.", "B3 H K L W2",
     "apart B1 B2, apart B1 B3, apart B2 B3"),
    ("Three bedrooms. No bedrooms should be next to each other.", "B3 H K L W2", "apart B1 B2, apart B2 B3"),
    ("Three bedrooms and two bathrooms; no two bathrooms are adjacent to each other.", "B3 H K L W2", "apart W1 W2"),
    # open
    ("One-bedroom flat: living room, kitchen and dining room, all open to each other.", "B D H K L W",
     "D1~K1, D1~L1"),
    ("There should be no doors between the living room and the dining room, only an opening. Two bedrooms.",
     "B2 D H K L W", "D1~L1, !no_door L1 D1, !unread an opening"),
    # doors counted and told one by one
    ("Two-bedroom unit. The bathroom has two doors, one to the hallway and one to the master bedroom.", "B2 H K L W",
     "H1W1, B1W1"),
    ("The corridor has five doors: two bedrooms, the bathroom, the kitchen and the living room.", "B2 H K L W",
     "B1H1, B2H1, H1K1, H1L1"),
    ("The flat has one entrance hall, from it goes one door to living room, one door to bathroom and one door to "
     "bedroom.", "B H K L W", "H1L1, H1W1, B1H1, !B1W1, !L1W1"),
    ("One-bedroom flat. The bathroom can be reached from the bedroom as well as from the living room.", "B H K L W",
     "B1W1, L1W1"),
    # the largest beside the two smaller ones
    ("Three-bedroom flat; the two smaller bedrooms share a bathroom, the largest has its own.", "B3 H K L W2",
     "B1W2"),
    ("Three bedrooms. The two larger bedrooms face south, the smallest faces north.", "B3 H K L W2",
     "orientation B1 south, orientation B2 south, orientation B3 north"),
    # what is no room
    ("2 bedroom house, living room, bathroom, garage next to the kitchen", "B2 H K L W",
     "unread garage, !adjacent W1 K1"),
    ("I want the bedroom far from the street and the living room in front. A flat with a kitchen.", "B H K L W",
     "unread street, !apart B1 L1"),
    ("Two bedrooms, a study, preferably next to the living room", "B2 H K L S W", "adjacent S1 L1"),
    ("Two bedrooms, a study, maybe off the living room", "B2 H K L S W", "L1S1"),
    # the entrance and another room
    ("Three bedrooms in total. One bedroom must be close to the entrance and to the bathroom.", "B3 H K L W",
     "near B1 entrance, adjacent B1 W1"),
    ("Two bedrooms. The study should be close to the entrance and to the bathroom.", "B2 H K L S W",
     "near S1 entrance, adjacent S1 W1"),
    ("Two bedrooms. The study should be near the entrance and the bathroom.", "B2 H K L S W",
     "near S1 entrance, adjacent S1 W1"),
    ("Two bedrooms. The study is near the entrance and the bathroom is at the back.", "B2 H K L S W",
     "near S1 entrance, position W1 back, !adjacent S1 W1"),
    # each
    ("A two bedrooms flat with a bathroom each and a separate WC.", "B2 H K L W3", "B1W1, B2W2, H1W3"),
    # measures
    ("A flat with wide hall at least 1,50 m and two bedrooms.", "B2 H K L W", "at_least H1 width 1.5"),
    ("Two bedrooms and a long hallway of at least 4 m.", "B2 H K L W", "at_least H1 length 4"),
    ("Busco un piso de 80 metros con tres habitaciones.", "B3 H K L W2", "all=80"),
    ("I look for an apartment of 60 meters with one bedroom.", "B H K L W", "all=60"),
    ("The living room has 30 quadrat meters. Two bedrooms.", "B2 H K L W", "L1=30"),
    ("Three rooms apartment: one room for me, one for my brother, one living room.", "B2 H K L W", ""),
    # other languages
    ("我想要一个60平方米的两居室，卧室都朝南，不要阳台。", "B2 H K L W", "orientation B1 south, orientation B2 south"),
    ("La cuisine doit donner sur la salle à manger, qui donne elle-même sur le salon. Trois chambres.", "B3 D H K L W2",
     "D1K1, D1L1, !K1L1"),
    ("The kitchen opens onto the dining room, which itself opens onto the living room. Two bedrooms.", "B2 D H K L W",
     "D1K1, D1L1, !unread itself"),
    # not needed, of things
    ("stairs are not needed, two bedrooms", "B2 H K L W", "unread stairs, !unread are not needed"),
    ("Two bedrooms. A bathtub is not needed.", "B2 H K L W", "W1 has 0 bath"),
    ("A layout where the kitchen cannot be seen from the living room. Two bedrooms.", "B2 H K L W", "unread seen"),
    ("A flat with no doors between hallway, living room and kitchen; two bedrooms.", "B2 H K L W",
     "unread with no doors between"),
    # suites and people
    ("The master suite has a bedroom, a walk-in closet and a bathroom. There are two more bedrooms which share the "
     "second bathroom.", "B3 C H K L W2", "B1W1, B1C1, H1W2"),
    ("an apartment with a master suite with walk-in closet, a kids room, two bathrooms", "B2 C H K L W2", "B1C1, B1W1"),
    ("three bedrooms: the first for parents with bath, the second for our son, the third for our daughter; kids share "
     "a bathroom", "B3 H K L W2", "B1W1, H1W2, !unread parents"),
    ("A flat for an old couple. Their bedroom must be near the bathroom; the guest room is near the entrance.",
     "B2 H K L W", "adjacent B1 W1, near B2 entrance"),
    ("Give each of the three bedrooms a desk; only the largest one gets a double bed, the others single beds. A flat.",
     "B3 H K L W2", "B1 has 1 double_bed, B2 has 1 single_bed, B3 has 1 single_bed, B3 has 1 desk"),
    # places
    ("The house has a living room, a kitchen to its left, a bathroom to its right, and two bedrooms at the back.",
     "B2 H K L W", "position K1 L1 left, position W1 L1 right, position B1 back, position B2 back"),
    ("Une maison avec quatre chambres, dont deux au nord, deux salles de bains et un bureau à côté de l'entrée.",
     "B4 H K L S W2", "near S1 entrance, position B1 north, !near W1 entrance"),
    ("Two bathrooms and a study near the entrance. Three bedrooms.", "B3 H K L S W2",
     "near S1 entrance, !near W2 entrance"),
    # words for rooms
    ("Spaceship: 4 cabins with a bunk bed each, mess hall with a table and 8 chairs, galley, two washrooms.",
     "B4 D H K L W2", "B4 has 1 bunk_bed, D1 has 8 chair"),
    ("Dreizimmerwohnung, Küche mit Zugang zum Esszimmer, ein separates WC beim Eingang.", "B D H K L W2",
     "D1K1, !D1~K1, near W1 entrance"),
    # doors that rooms have of themselves
    ("A two-bedroom flat and a bathroom that both bedrooms can access directly.", "B2 H K L W", "B1W1, B2W1, !H1W1"),
    ("Two bedrooms and a balcony which the living room and the kitchen can access.", "B2 H K L W Y", "K1Y1"),
    ("The master bedroom should not share any wall with the kitchen or the living room. Three bedrooms.",
     "B3 H K L W2", "apart B1 K1, apart B1 L1"),
    ("Die Wohnung hat 90 Quadratmeter. Küche und Bad liegen nebeneinander, das Schlafzimmer ist am weitesten vom "
     "Eingang entfernt.", "B H K L W", "all=90, adjacent K1 W1, apart B1 entrance, !B1W1, H1W1"),
    # some of so much, one of so much
    ("3 bedrooms: 2 of 10 m2 and one of 15 m2 with its own bathroom.", "B3 H K L W2", "B1=10, B2=10, B3=15, B3W1"),
    ("Five bedrooms: two of 10 m2, two of 12 m2 and one of 15 m2.", "B5 H K L W3", "B2=10, B3=12, B4=12, B5=15"),
    # one room for several purposes
    ("Cabin: one big room for living, cooking and eating, two bedrooms, one bathroom.", "B2 D H K L W",
     "D1~K1, D1~L1"),
    ("Flat with one room to cook, eat and live in and two bedrooms.", "B2 D H K L W", "D1~K1, D1~L1"),
    # what the last round of prompts had shown
    ("A flat: the kitchen and the living room are separated by a corridor, one bedroom, one bathroom next to the "
     "bedroom.", "B H K L W", "H1K1, H1L1, adjacent W1 B1, !B1K1, !B1L1"),
    ("A three-bedroom home with a wide opening between the dining room and the living room, and the kitchen next to "
     "the dining room but with a door.", "B3 D H K L W2", "D1~L1, D1K1, !D1~K1"),
    ("The flat should have one bedroom larger than 14 m2 and one smaller than 10 m2, a kitchen and a living room.",
     "B2 H K L W", "at_least B1 14, at_most B2 10"),
    ("Create: 1 hallway; off the hallway: bathroom, bedroom, living room; off the living room: kitchen, balcony; off "
     "the bedroom: closet.", "B C H K L W Y", "K1L1, L1Y1, B1C1, !H1K1, !B1L1"),
    ("I want a plan with no bathroom next to the kitchen and no bedroom next to the living room. Two bedrooms.",
     "B2 H K L W", "apart W1 K1, apart B2 L1, !apart K1 B1"),
    ("It is for three persons, so every bedroom must have a door to the corridor and nobody should go through the "
     "kitchen. A flat.", "B2 H K L W", "B1H1, B2H1, !B1K1"),
    ("The toilet should be separate from the bathroom, both near to the bedrooms. Three bedrooms.", "B3 H K L W2",
     "adjacent W1 B3, adjacent W2 B1"),
    ("I need an apartment where kitchen has two doors: one goes to the dining room, other goes to the hall. Two "
     "bedrooms.", "B2 D H K L W", "D1K1, H1K1, !D1H1"),
    ("The bedroom of the son is next to the bedroom of the daughter, but the bedroom of the parents is far from both.",
     "B3 H K L W2", "adjacent B2 B3, apart B1 B2, apart B1 B3"),
    ("Piso de tres habitaciones, la principal con vestidor y baño, las otras dos comparten un baño.", "B3 C H K L W2",
     "B1C1, B1W1, H1W2"),
    ("Piso de un dormitorio. El baño tiene que estar cerca del dormitorio.", "B H K L W", "adjacent W1 B1"),
    ("两室一厅一厨一卫，两个卧室在客厅两边，卫生间挨着主卧，厨房靠近入口。", "B2 H K L W",
     "adjacent W1 B1, near K1 entrance"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

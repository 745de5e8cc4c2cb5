"""Which of several rooms is meant: the one with the balcony, her room and his, near what; and where things are."""

from sentences.facts import as_meant

SENTENCES = [
    # which has what
    ("Two bedrooms, one with a balcony and one with a desk. The one with the balcony is 16 m².", "B2 H K L W Y",
     "B1Y1, B2 has 1 desk, B1=16"),
    ("Two bedrooms, one with a balcony. The bedroom with the balcony faces south.", "B2 H K L W Y",
     "B1Y1, orientation B1 south"),
    ("Two bathrooms, one with a tub and one with a shower; make the one with the tub 7 m². Two bedrooms.",
     "B2 H K L W2", "W1 has 1 bath, W2 has 1 shower, W1=7"),
    ("Two bathrooms, one of them with a bathtub. The bathroom with the bathtub is off the hall. Two bedrooms.",
     "B2 H K L W2", "H1W1, W1 has 1 bath, !W2 has 1 bath"),
    ("Three bedrooms: one has a desk, one a piano. The one with the piano is 18 m².", "B3 H K L W2",
     "B1 has 1 desk, B2 has 1 piano, B2=18"),
    ("My sister and I share a flat: she has the bigger bedroom, I have the one with the balcony.", "B2 H K L W Y",
     "B2Y1"),
    ("The second bedroom is half as big as the first one, which is 16 m².", "B2 H K L W", "B1=16, B2=8"),
    # whose
    ("Her room has a piano, his has a desk and a bookshelf. One bathroom, kitchen, living room.", "B2 H K L W",
     "B1 has 1 piano, B2 has 1 desk, B2 has 1 bookshelf"),
    ("My room has a desk, my brother's a piano. One bathroom, kitchen, living room.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 piano"),
    ("I have the small room next to the kitchen, my sister the room with the balcony. One bath.", "B2 H K L W Y",
     "adjacent B1 K1, B2Y1"),
    ("We sleep in the room at the back; our son gets the one at the front. Two bathrooms.", "B2 H K L W2",
     "position B1 back, position B2 front"),
    ("Home of three: mum and dad share, I have the little room next to the kitchen. One bath.", "B2 H K L W",
     "adjacent B2 K1"),
    ("A flat. The boys share, our daughter has her own room.", "B3 H K L W2", ""),
    ("We are four students and want each our own room, two bathrooms.", "B4 H K L W2", ""),
    ("We are four. Each of us wants a room.", "B4 H K L W2", ""),
    ("My office must not be next to the nursery. We are two plus a baby.", "B2 H K L S W", "apart S1 B2"),
    ("我和我妻子住一间，孩子住一间，父母住一间，一个书房，两个卫生间", "B3 H K L S W2", ""),
    # near what
    ("Two bedrooms. The study is far away from the kitchen, near the entrance.", "B2 H K L S W",
     "near S1 entrance, !near K1 entrance"),
    ("El despacho tiene que estar lejos del salón y cerca de la entrada. Dos dormitorios.", "B2 H K L S W",
     "apart S1 L1, near S1 entrance"),
    ("The flat has a kitchen with a table, a pantry off it and a bedroom.", "B H K L T W", "K1T1"),
    ("Two bedrooms, a bathroom between them and a kitchen open to the living room.", "B2 H K L W", "B1W1, B2W1, !K1W1"),
    ("Quiero dos dormitorios iguales, un baño entre ellos y una cocina.", "B2 H K L W", "B1W1, B2W1"),
    ("Zwei Schlafzimmer, dazwischen ein Bad, und eine Küche.", "B2 H K L W", "B1W1, B2W1"),
    ("Both bathrooms are off the hall, neither belongs to a bedroom. Three bedrooms.", "B3 H K L W2", "H1W1, H1W2"),
    ("One bedroom, a study; the study has two doors, to the hall and to the bedroom. Kitchen, living room, bathroom.",
     "B H K L S W", "B1S1, H1S1"),
    # where things are
    ("Two bedrooms. A sofa is in the study, not in the living room.", "B2 H K L S W",
     "S1 has 1 sofa, L1 has 0 sofa, H1S1"),
    ("Two bedrooms. Two desks and a bookshelf are in the study.", "B2 H K L S W",
     "S1 has 2 desk, S1 has 1 bookshelf, H1S1"),
    ("Put a washing machine in the bathroom, not in the kitchen. One-bedroom flat.", "B H K L W",
     "W1 has 1 washing_machine, K1 has 0 washing_machine"),
    ("The tv is not in the bedroom. One-bedroom flat.", "B H K L W", "B1 has 0 tv"),
    ("Two-bedroom flat, one wardrobe per bedroom.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("One bedroom with no bed, a hall, a living room with two sofas. A flat.", "B H K L W",
     "B1 has 0 double_bed, L1 has 2 sofa"),
    ("Zwei Schlafzimmer, Küche 10 m², Wohnzimmer doppelt so groß.", "B2 H K L W", "K1=10, L1=20"),
    # taken back and put elsewhere
    ("The flat has a dining room - or no, skip that. Two bedrooms.", "B2 H K L W", ""),
    ("A balcony off the kitchen. Actually, put it off the living room instead. Two bedrooms.", "B2 H K L W Y",
     "L1Y1, !K1Y1"),
    ("Not three bedrooms but two, and not one bathroom but two.", "B2 H K L W2", ""),
    ("Two bedrooms, a kitchen with four chairs, no, six.", "B2 H K L W", "K1 has 6 chair"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

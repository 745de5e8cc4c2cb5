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

FURTHER = [
    # said anew
    ("Das Schlafzimmer soll 16 m² haben, nein, lieber 14, und das Bad 6 m².", "B W", "B1=14, W1=6"),
    ("The bedroom is 12 m² - make it 14 - and the bathroom 5 m².", "B W", "B1=14, W1=5"),
    ("There's a piano in the hall, no, in the living room. One-bedroom flat.", "B H K L W",
     "L1 has 1 piano, !H1 has 1 piano"),
    ("A former three-bedroom flat, now a two-bedroom with a home office.", "B2 H K L S W", ""),
    ("My partner works at home, so one of the two bedrooms becomes a study.", "B H K L S W", ""),
    # none
    ("A flat with a door between the kitchen and the living room and none between the kitchen and the hall.",
     "B2 H K L W", "K1L1, no_door K1 H1, !no_door L1 K1"),
    ("La cocina no debe dar al pasillo, sino al salón. Un piso.", "B2 H K L W", "K1L1, !H1K1"),
    # which
    ("两间卧室，大的那间12平米，小的8平米", "B2 H K L W", "B1=12, B2=8"),
    ("Two bedrooms; the door to the first is from the living room and the door to the second is from the hall.",
     "B2 H K L W", "B1L1, B2H1"),
    ("The living room is the biggest room, the bathroom is the smallest. Two bedrooms.", "B2 H K L W",
     "order L1 largest, order W1 smallest"),
    ("Four bedrooms, three of them doubles; two bathrooms, one en suite.", "B4 H K L W2", ""),
    ("A flat with a bedroom, a kitchen and a bathroom, each at least 10 square metres.", "B H K L W",
     "at_least B1 10, at_least K1 10, at_least W1 10"),
    ("Im Kinderzimmer zwei Betten, im Elternschlafzimmer ein Bett. Ein Bad.", "B2 H K L W",
     "B2 has 2 double_bed, B1 has 1 double_bed"),
    ("Küche am Ende des Flurs, zwei Schlafzimmer, ein Bad.", "B2 H K L W", "H1K1"),
    ("A flat where guests don't have to cross the living room to get to the bathroom.", "B2 H K L W",
     "no_door L1 W1, !L1W1"),
    ("Bedroom 12 sqm, kitchen 8 sqm, bathroom 4 sqm; the living room gets what is left of 50 sqm.", "B H K L W",
     "all=50, !L1=50"),
    ("Zwei Zimmer für die Kinder, eins für uns, zwei Bäder.", "B3 H K L W2", ""),
    ("Une chambre pour nous, une pour les enfants, un bureau qui donne sur le salon et non sur le couloir.",
     "B2 H K L S W", "L1S1, !H1S1"),
    ("两间卧室，一间朝南一间朝北", "B2 H K L W", "orientation B1 south, orientation B2 north"),
    # where a room is not to be
    ("No bedroom faces north. Two bedrooms.", "B2 H K L W", "unread not faces north"),
    ("Not a single bedroom faces north. Two bedrooms.", "B2 H K L W", "unread not faces north"),
    ("The bathroom does not face south. Two bedrooms.", "B2 H K L W",
     "unread not face south, !orientation W1 south"),
    ("The bathroom is 6 m², sorry, I meant the kitchen. One-bedroom flat.", "B H K L W", "K1=6, !W1=6"),
    ("Two bedrooms; the kitchen opens onto the dining room rather than onto the hall.", "B2 D H K L W", "D1K1, D1L1"),
]  # fmt: skip

test_so_is_what_is_told_of_one = as_meant(FURTHER)

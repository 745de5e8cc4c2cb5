"""What stands behind remarks in commas, in keys of data, behind letters and in notes of clients."""

from sentences.facts import as_meant

SENTENCES = [
    ("The bathroom of our house is tiny, just 4 m², and the living room is huge, 34 m². Two bedrooms.", "B2 H K L W",
     "W1=4, L1=34, !all=4"),
    ("One bedroom. The kitchen in this apartment is big, about 14 square metres.", "B H K L W", "K1=14, !all=14"),
    ("The living room of my home has 30 m²; one bedroom.", "B H K L W", "L1=30, !all=30"),
    ("Das Bad meiner Wohnung ist klein, nur 4 m². Ein Schlafzimmer.", "B H K L W", "W1=4, !all=4"),
    ("Le salon de mon appartement est grand, il fait 30 m². Une chambre.", "B H K L W", "L1=30, !all=30"),
    ("The kitchen, which is open to the living room, has 12 m². One bedroom.", "B H K L W", "K1=12, K1~L1, !L1=12"),
    ("The kitchen, opposite the bathroom, is only 7 m². One bedroom.", "B H K L W", "K1=7, opposite K1 W1, !W1=7"),
    ("The bedroom, next to the living room, measures about 15 m². One bathroom.", "B H K L W", "B1=15, !L1=15"),
    ("The one-bedroom flat is small, only 40 m².", "B H K L W", "all=40"),
    ("A two-bedroom flat, very bright, has 70 m².", "B2 H K L W", "all=70"),
    ('{"bedrooms": 1, "bathrooms": 1, "living_room_m2": 24, "bedroom_m2": 13}', "B H K L W", "B1=13, L1=24"),
    ("bedrooms=2; bathrooms=1; bedroom_sqm=12; bathroom_sqm=5", "B2 H K L W", "B1=12, B2=12, W1=5"),
    ("bathroom_area_m2=6, bathrooms=1, bedrooms=1, study_m2=8", "B H K L S W", "W1=6, S1=8"),
    ('{"num_bedrooms": 2, "num_bathrooms": 1, "bathroom_m2": 5, "total_m2": 60}', "B2 H K L W",
     "W1=5, all=60, !unread num"),
    ('{"rooms": {"bedroom": 1, "bathroom": 1, "study": 1}, "bedroom_m2": 13, "study_m2": 8}', "B H K L S W",
     "B1=13, S1=8"),
    ("Two bedrooms A and B: bedroom A faces north, bedroom B faces south. Bathroom off bedroom B.", "B2 H K L W",
     "orientation B1 north, orientation B2 south, B2W1, !orientation B1 south, !unread b"),
    ("Bedrooms A and B, bathroom, kitchen. A on the north side, B on the south side; the bathroom is next to B.",
     "B2 H K L W", "position B1 north, position B2 south, adjacent W1 B2"),
    ("rooms: bedroom A (15 m2); bedroom B (10 m2); study; bathroom. bedroom A on the west side, bedroom B on the "
     "east side, study next to bedroom B.", "B2 H K L S W",
     "B1=15, B2=10, position B1 west, position B2 east, adjacent S1 B2"),
    ("Three bedrooms. Bedroom A has its own bathroom. Bedroom C is not next to the kitchen and bedroom B gets a "
     "desk. Two bathrooms.", "B3 H K L W2", "B1W1, apart B3 K1, B2 has 1 desk"),
    ("Put in every bedroom a desk. Two bedrooms.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("one-bedroom flat; washing machine x1 in bathroom; dishwasher x0 in kitchen", "B H K L W",
     "W1 has 1 washing_machine, K1 has 0 dishwasher"),
    ("two-bedroom flat. single bed x2 in each bedroom, floor lamp x3 in living room, tv x0 in living room",
     "B2 H K L W", "B1 has 2 single_bed, B2 has 2 single_bed, L1 has 3 floor_lamp, L1 has 0 tv"),
    ("bedroom x2, bathroom x1; double bed x1 in master bedroom", "B2 H K L W", "B1 has 1 double_bed"),
    ("living room 4 x 5 m, kitchen 3x2 m, one bedroom", "B H K L W", "dimension L1 4 x 5"),
    ("Needs: 2 bedrooms. Cot in parents' bedroom. The other bedroom is the guest room with a double bed.",
     "B2 H K L W", "B1 has 1 cot, B2 has 1 double_bed"),
    ("2 bedrooms, 1 bath. Bedroom 1 = parents' room, bedroom 2 = kids' room with two single beds.", "B2 H K L W",
     "B2 has 2 single_bed"),
    ("3 bedrooms, 2 bathrooms. Other bedrooms = kids' rooms, each with a single bed.", "B3 H K L W2", ""),
    ("Two bedrooms; bedroom 2 is a nursery with a cot.", "B2 H K L W", "B2 has 1 cot"),
    ("Two bedrooms; the larger bedroom is the children's room with two single beds.", "B2 H K L W",
     "B2 has 2 single_bed, B2=14.3"),
    ("A one-bedroom flat where the kitchen, the bathroom, the bedroom and the living room all open off the hallway, "
     "and there is also a door between kitchen and living room.", "B H K L W", "H1K1, H1L1, K1L1, !B1K1, !B1L1, !K1W1"),
    ("One-bedroom flat: kitchen and bathroom open off the hallway, plus a second door between the kitchen and the "
     "dining room.", "B D H K L W", "H1K1, D1K1, !K1W1, !D1W1"),
    ("One bedroom. Living room and kitchen are off the hall, with a door between the living room and the kitchen as "
     "well.", "B H K L W", "H1K1, H1L1, K1L1"),
    ("One bedroom. The living room, which has the balcony too, must have at least three doors.", "B H K L W Y",
     "at_least L1 doors 3, L1Y1, !at_least Y1 doors 3"),
    ("One bedroom. The hallway, which also leads to the study, should be at least 1.4 m wide.", "B H K L S W",
     "at_least H1 width 1.4, H1S1, !at_least S1 width 1.4"),
    ("One bathroom. The bedroom, which has a balcony, should face south.", "B H K L W Y",
     "orientation B1 south, B1Y1, !orientation Y1 south"),
    ("One bedroom. The kitchen has a door to the living room but none to the hallway.", "B H K L W",
     "K1L1, no_door K1 H1"),
    ("One bedroom. The study has a door to the bedroom and none to the hall.", "B H K L S W", "B1S1, no_door S1 H1"),
    ("One bedroom. The bathroom is off the hallway. The bedroom has no door to the hallway, only one to the "
     "bathroom.", "B H K L W", "B1W1, H1W1, no_door B1 H1, !B1H1"),
    ("The player starts in the study, which has no door to the hall; from the study you get to the bedroom, and the "
     "bedroom leads to the hall. One bathroom.", "B H K L S W", "B1S1, B1H1, no_door S1 H1, !H1S1"),
    ("Three bedrooms: ours has its own bathroom, and my mother-in-law's is on the south side, right opposite the other "
     "bathroom, which is off the hall.", "B3 H K L W2",
     "B1W1, H1W2, position B3 south, opposite B3 W2, !position W1 south"),
    ("Three bedrooms: ours faces east, my mother's faces south and our son's is next to the kitchen. One bathroom.",
     "B3 H K L W", "orientation B1 east, orientation B3 south, adjacent B2 K1, !orientation B1 south"),
    ("Our twins sleep in one bedroom and we sleep in the other; theirs must be next to ours. They get a bunk bed, we "
     "get a double bed. One bathroom.", "B2 H K L W", "adjacent B2 B1, B2 has 1 bunk_bed, B1 has 1 double_bed"),
    ("Two bedrooms. We sleep in one bedroom and the children in the other. Ours is on the south side, theirs is "
     "opposite the bathroom.", "B2 H K L W", "position B1 south, opposite B2 W1"),
    ("Piso de dos dormitorios, un balcón en el salón y, en la cocina, dos frigoríficos.", "B2 H K L W Y",
     "L1Y1, K1 has 2 fridge, !K1Y1"),
    ("Wohnung, 2 Schlafzimmer, 1 Bad, Abstellraum mit Zugang von der Küche.", "B2 H K L T W", "K1T1, !H1T1"),
    ("Zwei Schlafzimmer, Balkon mit Zugang vom Schlafzimmer.", "B2 H K L W Y", "B1Y1, !L1Y1"),
    ("A studio of 32 m² with the kitchen in a separate room.", "K L W", "K1L1, !K1~L1"),
    ("Studio with kitchen in another room, 30 m².", "K L W", "K1L1, !K1~L1"),
    ("Two bedrooms, two bathrooms: the first bathroom is off my bedroom, the second is for everybody and its door is "
     "in the corridor.", "B2 H K L W2", "B1W1, H1W2, !W1W2, !H1W1"),
    ("Un appartement de deux chambres, un balcon au salon et, dans la cuisine, deux réfrigérateurs.", "B2 H K L W Y",
     "L1Y1, K1 has 2 fridge, !K1Y1"),
    ("One bedroom. The living room is on the south side of the flat.", "B H K L W", "position L1 south"),
    ("Two bedrooms. The kitchen and the bathroom are on the northern side of our house.", "B2 H K L W",
     "position K1 north, position W1 north"),
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)

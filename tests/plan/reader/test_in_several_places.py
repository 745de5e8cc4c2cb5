"""Furniture of several rooms, doors denied or told beside others, clauses turned round, people told twice."""

from sentences.facts import as_meant

SENTENCES = [
    # furniture that several rooms are to have, or to be without
    ("No rugs, please: not in the living room, not in the hallway and not in the bedroom. One-bedroom flat.",
     "B H K L W",
     "L1 has 0 rug, H1 has 0 rug, B1 has 0 rug"),
    ("One-bedroom flat, no rug in the living room, the hallway or the bedroom.", "B H K L W",
     "L1 has 0 rug, H1 has 0 rug, B1 has 0 rug"),
    ("One-bedroom flat. No rugs in the living room and hallway.", "B H K L W", "L1 has 0 rug, H1 has 0 rug"),
    ("One-bedroom flat with a rug in the living room, in the hallway and in the bedroom.", "B H K L W",
     "L1 has 1 rug, H1 has 1 rug, B1 has 1 rug"),
    ("One-bedroom flat. There must be no mirror in the bedroom, nor in the bathroom, nor in the hall.", "B H K L W",
     "B1 has 0 mirror, W1 has 0 mirror, H1 has 0 mirror"),
    ("One-bedroom flat. Neither the living room nor the bedroom should have a tv.", "B H K L W",
     "L1 has 0 tv, B1 has 0 tv"),
    ("Keine Teppiche: weder im Wohnzimmer noch im Flur. Ein Schlafzimmer, ein Bad.", "B H K L W",
     "L1 has 0 rug, H1 has 0 rug"),
    ("Kein Teppich im Wohnzimmer, im Flur und im Schlafzimmer. Ein Schlafzimmer, ein Bad.", "B H K L W",
     "L1 has 0 rug, H1 has 0 rug, B1 has 0 rug"),
    ("Pas de tapis dans le salon ni dans le couloir. Une chambre, une salle de bains.", "B H K L W",
     "L1 has 0 rug, H1 has 0 rug"),
    ("Ninguna alfombra en el salón ni en el pasillo ni en el dormitorio. Un dormitorio, un baño.", "B H K L W",
     "L1 has 0 rug, H1 has 0 rug, B1 has 0 rug"),
    ("客厅和走廊都不要地毯，一室一厅。", "B H K L W", "L1 has 0 rug, H1 has 0 rug"),
    ("Two bedrooms. A desk in the study, in the bedrooms two lamps each.", "B2 H K L S W", "S1 has 1 desk, !B1 has 1 "
     "desk"),
    ("Three bedrooms without a desk or a tv. One bathroom.", "B3 H K L W",
     "B1 has 0 desk, B3 has 0 desk, B1 has 0 tv, B3 has 0 tv, !L1 has 1 tv"),
    ("Weder Balkon noch Arbeitszimmer. Zwei Schlafzimmer.", "B2 H K L W", ""),
    # no door, told behind the rooms
    ("Flat with one bedroom. Between kitchen and bathroom should not be a door.", "B H K L W", "no_door K1 W1, H1W1"),
    ("One-bedroom flat. Between the kitchen and the bathroom there is no door.", "B H K L W", "no_door K1 W1, H1W1"),
    ("Zwischen Küche und Bad soll keine Tür sein. Wohnung mit einem Schlafzimmer.", "B H K L W", "no_door K1 W1, H1W1"),
    ("Entre la cuisine et la salle de bains, pas de porte. Appartement avec une chambre.", "B H K L W",
     "no_door K1 W1, H1W1"),
    ("Entre la cocina y el baño no debe haber puerta. Piso de un dormitorio.", "B H K L W", "no_door K1 W1, H1W1"),
    ("Two-bedroom flat. No door between the kitchen and the living room: the robot has to go through the hallway.",
     "B2 H K L W", "no_door K1 L1, H1K1, H1L1"),
    # doors that are told, and those beside them
    ("The hallway connects to the bedroom, the bathroom and the kitchen; the kitchen connects to the living room.",
     "B H K L W", "B1H1, H1W1, H1K1, K1L1, !H1L1"),
    ("The living room is reached through the kitchen. One bedroom, one bathroom, both off the hallway.", "B H K L W",
     "H1K1, K1L1, !H1L1"),
    ("The kitchen has one door to the hallway and one to the living room. One bedroom, one bathroom.", "B H K L W",
     "H1K1, K1L1, H1L1"),
    ("A dining room that is open to the kitchen, with a door to the living room; three bedrooms and one bathroom.",
     "B3 D H K L W", "D1K1, D1~K1, D1L1, H1K1, H1L1"),
    ("Three bedrooms and one bathroom. The kitchen has a door to the dining room, which is open to the living room.",
     "B3 D H K L W", "D1K1, D1~L1, D1L1, H1K1, H1L1"),
    ("An old flat whose dining room has doors to both the parlour and the kitchen. One bedroom, one bathroom.",
     "B D H K L W", "D1K1, D1L1, H1K1, H1L1"),
    ("Two bedrooms; the kitchen opens onto the dining room, which opens onto the living room.", "B2 D H K L W",
     "D1K1, D1L1, !H1K1"),
    ("A living room of 32 m² flows openly into the kitchen, while two bedrooms and a bathroom complete the apartment.",
     "B2 H K L W", "K1~L1, L1=32"),
    # verbs of people that say nothing of rooms
    ("Two bedrooms, each with its own en suite bathroom. My bedroom must not be near the kitchen, I smell everything.",
     "B2 H K L W2", "B1H1, B2H1, B1W1, B2W2, H1K1, apart B1 K1"),
    ("One bedroom. The kitchen should be opposite the living room so that I only have to go straight across the "
     "hallway, "
     "and the bedroom opposite the bathroom.", "B H K L W", "opposite K1 L1, opposite B1 W1"),
    ("Please to make flat for my parents and me. They sleep in one bedroom, in double bed. I sleep in other bedroom, "
     "in "
     "single bed.", "B2 H K L W", "B1 has 1 double_bed, B2 has 1 single_bed"),
    # people who have rooms
    ("Three kids, and each gets a bedroom. One more bedroom for us parents with its own bathroom, another bathroom off "
     "the hallway.", "B4 H K L W2", "B1W1, H1W2"),
    ("The twins share a room with two single beds, their big sister has her own room with a desk, and my husband and I "
     "have one with a double bed. One bathroom.", "B3 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed, B3 has 1 desk"),
    ("Four bedrooms and a bathroom. The baby sleeps in the bedroom next to ours; the two older ones have a bedroom "
     "each.",
     "B4 H K L W", "adjacent B2 B1"),
    ("Three bedroom, one bathroom and one toilet more.", "B3 H K L W2", "H1W1, H1W2"),
    # what a plan cannot tell, and words of one language that are another's
    ("Two bedrooms on the eighth floor, with views of the sea.", "B2 H K L W", "unread eighth floor, unread views of "
     "the sea"),
    ("Two bedrooms on the 8th floor, one bathroom.", "B2 H K L W", "unread 8th floor"),
]  # fmt: skip

test_what_is_said_once_of_several_places = as_meant(SENTENCES)

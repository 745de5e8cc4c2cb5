"""What people of many kinds write of who has which room, of doors and of furniture, as a careful reader takes it."""

from sentences.facts import as_meant

SENTENCES = [
    ("We have two boys who share and a girl with her own room; my wife and I take the biggest bedroom. One "
     "bathroom.", "B3 H K L W", "B3H1"),
    ("Our three daughters: the two little ones sleep in bunk beds in one room, the eldest has a room of her own "
     "with a desk. Bedroom for us with en suite, and a family bathroom.", "B3 H K L W2",
     "B2 has 2 bunk_bed, B2H1, B3 has 1 desk, B3H1"),
    ("My son gets the small bedroom, my daughter the big one, and I take the one next to the kitchen. One "
     "bathroom.", "B3 H K L W", "B3H1, adjacent B1 K1"),
    ("Four of us share the flat: everyone gets a room, two bathrooms off the hall, no living room.", "B4 H K W2",
     "B4H1"),
    ("The parents sleep in the bedroom facing south, the children in the two bedrooms facing north. One "
     "bathroom.", "B3 H K L W", "B3H1, orientation B3 north"),
    ("Each of our two kids has a room with a bed and a desk; we have a room with a double bed and a wardrobe. "
     "One bathroom.", "B3 H K L W", "B1 has 1 double_bed, B3 has 1 desk, B3 has 1 double_bed, B3H1"),
    ("No mirrors in the bathroom, hallway or bedrooms. Two bedrooms, one bathroom.", "B2 H K L W",
     "B1 has 0 mirror, B2 has 0 mirror, H1 has 0 mirror"),
    ("The robot must not meet any rugs: none in the kitchen, none in the living room, none in the hall. One-"
     "bedroom flat.", "B H K L W", "K1 has 0 rug"),
    ("Do not put a table in the kitchen; put it in the dining room. Two-bedroom flat.", "B2 D H K L W",
     "D1 has 1 dining_table"),
    ("Neither bedroom has a desk. Two bedrooms, one bathroom, a study with two desks.", "B2 H K L S W",
     "B1 has 0 desk, B2 has 0 desk, !B1 has 1 desk, !B2 has 1 desk"),
    ("Graph: hall-living, hall-bathroom, hall-bedroom, living-kitchen.", "B H K L W", "B1H1, H1W1"),
    ("You cannot walk directly from the kitchen into the living room; you have to pass through the hallway. One-"
     "bedroom flat.", "B H K L W", "H1K1, no_door K1 L1, !K1L1, !K1~L1"),
    ("The living room runs straight into the kitchen without any wall. Two bedrooms and one bathroom.", "B2 H K L W",
     "K1~L1"),
    ("A flat for two flatmates: two bedrooms of the same size, each with en suite, at opposite ends of the flat."
     " Shared kitchen and lounge.", "B2 H K L W2", "apart B1 B2"),
    ("Les jumeaux partagent une chambre, leur sœur a la sienne, et nous avons la plus grande. Une salle de "
     "bains.", "B3 H K L W", "B3H1"),
    ("El pasillo conecta con el dormitorio, el baño y la cocina; la cocina conecta con el salón.", "B H K L W",
     "!H1L1"),
    ("走廊通向卧室、卫生间和厨房，厨房通向客厅。", "B H K L W", "!H1L1"),
    ("Flat please: 1 sleeping room, 1 bath, 1 kitchen. TV not in sleeping room, TV in living room. Kitchen no "
     "have door to living room.", "B H K L W", "B1 has 0 tv, H1K1, no_door K1 L1"),
    ("I want that the bedroom of my parents is near to bathroom and my bedroom is far from it. One bathroom.",
     "B2 H K L W", "B1H1, B2H1, H1K1, H1L1, H1W1, apart B2 W1"),
    ("{\"rooms\": [{\"type\": \"bedroom\", \"count\": 2}, {\"type\": \"bathroom\", \"count\": 1}, {\"type\": "
     "\"kitchen\", "
     "\"open_to\": \"living_room\"}]}", "B2 H K L W", "B2H1, K1~L1"),
    ("Floor plan: foyer -> hallway; hallway -> bedroom, bedroom, bathroom, living; living -> kitchen, balcony",
     "B2 H2 K L W Y", "B2H2"),
    ("Haunted apartment, one bedroom: the player starts in the hallway, every door leads off it, and the "
     "bathroom is at the far end of the hallway.", "B H K L W", "H1W1, !B1K1, !B1L1, !B1W1"),
    ("A roguelike level: 5 rooms in a line, each connected only to the next: hallway, living room, kitchen, "
     "dining room, pantry. Bathroom and bedroom off the hallway.", "B D H K L T W", "D1T1, K1L1"),
    ("Chef's home: a huge kitchen with two ovens and a pantry; a tiny bedroom; the living room is smaller than "
     "the kitchen.", "B H K L T W", "K1T1, !H1T1"),
    ("In my game the family of four lives in a flat with the parents' bedroom at the end of the corridor and the"
     " kids' room next to it.", "B2 H K L W", "H1W1, adjacent B1 B2, position B1 back"),
    ("Sims starter: 1 bed 1 bath, everything as small as possible, kitchen and living in one.", "B H K L W",
     "B1H1, H1L1, H1W1"),
    ("A lighthouse keeper's flat: bedroom facing the sea, kitchen with a table for two, no living room.", "B H K W",
     "!unread facing, unread facing the sea"),
    ("In the flat there are hall, kitchen, big room and bedroom. Big room is 25 meters, bedroom is 15 meters, "
     "kitchen is 10 meters.", "B H K L W", ""),
    ("We want balcony not in bedroom but in kitchen. Two bedrooms.", "B2 H K L W Y", "H1W1, K1Y1"),
    ("Please not make the kitchen open, I don't like smell. Two bedrooms, one bathroom.", "B2 H K L W",
     "H1K1, !K1L1, !K1~L1"),
    ("The bathroom is entering from bedroom and from corridor also. One bedroom flat.", "B H K L W", "B1W1"),
    ("Three bedrooms: ours with a bathroom, one for the boys with two beds, one for our daughter with a desk. A "
     "second bathroom off the hall.", "B3 H K L W2", "B2 has 2 double_bed"),
    ("I have dementia patients in mind: short way from bedroom to toilet, no long corridors, one bedroom, "
     "kitchen open to living room.", "B H K L W", "H1W1, adjacent B1 W1"),
    ("There are three bedrooms: one 10, one 12 and one 15 square metres. The biggest one has the balcony.",
     "B3 H K L W2 Y", "B3Y1, !B1Y1"),
    ("The dining room sits between kitchen and living room with doors to both; three bedrooms, two bathrooms.",
     "B3 D H K L W2", "H1K1, !K1L1"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

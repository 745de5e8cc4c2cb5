"""Clauses turned round, counts said behind, lists of places and of rooms, as a careful reader takes them."""

from sentences.facts import as_meant

SENTENCES = [
    ("The agent should not be able to see the bedroom from the entrance. One bedroom, one bathroom.", "B H K L W",
     "B1H1, H1K1, H1L1, H1W1"),
    ("Detective's flat above a shop: office with its own entrance... no, office off the hallway, one bedroom, "
     "one bathroom, kitchenette in the living room.", "B H K L S W", "H1W1"),
    ("Cozy game: grandma's flat with a sewing room, a kitchen with a round table, a bedroom with a rocking chair"
     " and a balcony full of plants.", "B H K L S W Y", "Y1 has 2 plant, !B1 has 2 plant"),
    ("Our twins want separate rooms, and we want ours as far from theirs as possible. One bathroom.", "B3 H K L W",
     "B2H1, B3H1, apart B1 B2, apart B1 B3"),
    ("Three flatmates, everyone with their own room and desk; one bathroom, one guest toilet, big kitchen, no "
     "living room.", "B3 H K W2", "B2 has 1 desk, B3 has 1 desk"),
    ("Do we need a dining room? No. But a pantry, yes. Three bedrooms, two bathrooms.", "B3 H K L T W2", ""),
    ("Children's bathroom opposite the children's rooms, our bathroom off our bedroom. Two kids.", "B3 H K L W2",
     "B1W2, H1W1"),
    ("I want that my kitchen have window to south and bedroom have window to east. One bedroom, one bathroom, "
     "living room.", "B H K L W", ""),
    ("We are five person: I, my wife, two son and one daughter. Sons sleep together. One bathroom and one "
     "toilet.", "B3 H K L W2", ""),
    ("Flat must have two balcony: one on living room, second on bedroom. One bedroom.", "B H K L W Y2", "B1Y2"),
    ("In kitchen must be table and four chair. In living room not must be table. One bedroom flat.", "B H K L W",
     "K1 has 1 dining_table, L1 has 0 dining_table, !K1 has 2 dining_table"),
    ("Charming two-bedroom apartment with eat-in kitchen, sun-filled lounge leading to a west-facing terrace, "
     "and a family bathroom off the central hallway.", "B2 H K L W Y", "!L1W1"),
    ("Spacious three-bed, two-bath flat (110 sq m): principal bedroom with dressing room and en-suite, two "
     "further doubles, family bathroom, kitchen/diner, separate sitting room.", "B3 C D H K L W2", ""),
    ("Entrance hall with cloakroom; double reception room; galley kitchen; three bedrooms, one with basin; "
     "bathroom; separate WC.", "B3 H K L W2", ""),
    ("The corridor is for wheelchairs, minimum 1.5 m; no bathtub but a shower; desk in the bedroom; one bedroom,"
     " one bathroom, kitchen and living room all off the corridor.", "B H K L W",
     "at_least H1 width 1.5, !at_least H1 length 1.5"),
    ("I get confused by too many doors: at most three doors off the hallway. One bedroom; kitchen open to the "
     "living room.", "B H K L W", "at_most H1 doors 3"),
    ("Wohnung für eine Familie mit drei Kindern: jedes Kind bekommt ein eigenes Zimmer, dazu ein "
     "Elternschlafzimmer mit Bad und ein zweites Bad am Flur.", "B4 H K L W2", "B2H1, B3H1, B4H1"),
    ("Ni balcon ni bureau. Deux chambres, la plus grande avec un dressing, une salle de bains et des toilettes à"
     " part.", "B2 C H K L W2", ""),
    ("Vivienda con dos dormitorios: en el primero una cama doble, en el segundo dos camas individuales. Un baño "
     "junto a la entrada.", "B2 H K L W", "!B1 has 2 single_bed, !B2 has 1 double_bed"),
    ("每个卧室都带卫生间，两个卧室，客厅和厨房是一个空间。", "B2 H K L W2", "B1W1, B2W2, K1L1, K1~L1"),
    ("The kids' rooms and the bathroom open off a small corridor that starts in the living room; the parents' "
     "bedroom opens off the living room. Two kids.", "B3 H K L W", "H1K1"),
    ("A bedroom on each side of the bathroom, both with doors to it, no other way into the bathroom. Living "
     "room, kitchen.", "B2 H K L W", "B2H1, B2W1"),
    ("Please create an apartment with three bedrooms where two of them are next to each other and the third is "
     "far from both. One bathroom.", "B3 H K L W", "adjacent B1 B2"),
    ("req: beds 2, baths 1, layout open-plan, balcony south, store yes", "B2 H K L T W Y", "K1L1, K1~L1, !H1K1"),
    ("Horror map: one bedroom, a bathroom at the end of a long corridor, a kitchen with two doors, one to the "
     "corridor and one to the living room, and a pantry off the kitchen.", "B H K L T W", "K1L1, !B1L1"),
    ("Tutorial level: studio with a bathroom; a bed, a desk and a lamp in the main room, nothing else.", "K L W",
     "K1L1, K1~L1"),
    ("We have a daughter and a son and want each of them to have a room of about 12 m²; our own room can be "
     "small. One bathroom.", "B3 H K L W", "B3H1"),
    ("Our toddler's room must be between our room and the bathroom. Just one bathroom, kitchen open to living.",
     "B2 H K L W", "H1W1, adjacent B2 B1, adjacent B2 W1, !B2W1"),
    ("The au pair sleeps in the small room off the kitchen. Besides that, three bedrooms and two bathrooms.",
     "B4 H K L W2", "B4K1"),
    ("Between living room and bedroom should be the kitchen. One bedroom, one bathroom.", "B H K L W",
     "B1H1, K1L1, adjacent K1 B1, adjacent K1 L1, !B1L1, !H1K1"),
    ("Please do flat for two student, each student need own room with table and bed. Kitchen, bathroom, no "
     "living room.", "B2 H K W",
     "B1 has 1 dining_table, B1 has 1 double_bed, B2 has 1 dining_table, B2 has 1 double_bed, B2H1"),
    ("I don't need big kitchen, but I need big bathroom with bath and shower. One bedroom, living room.", "B H K L W",
     "H1K1"),
    ("Two double bedrooms and a single, refitted bathroom, lounge/diner with patio doors to the balcony, kitchen"
     " off the lounge/diner.", "B3 D H K L W Y", "B3H1, H1K1"),
    ("I need a bathroom I can reach straight from my bedroom and guests can reach from the hall. One bedroom, "
     "kitchen, living room.", "B H K L W", "B1W1"),
    ("No walls between living room, dining area and kitchen so that I can move freely. Two bedrooms, wheelchair "
     "turning circle of 1.5 m in the bathroom.", "B2 D H K L W", "D1K1, D1~K1, D1~L1, !K1L1"),
    ("Bedroom and bathroom must be side by side with a door between them; I get up at night. One-bedroom flat.",
     "B H K L W", "B1W1, !H1W1"),
    ("Wir haben zwei Mädchen, die sich ein Zimmer teilen, und einen Jungen mit eigenem Zimmer. Unser "
     "Schlafzimmer soll ein Bad haben, dazu ein Bad für die Kinder.", "B3 H K L W2", "B1W1, B2H1, B3H1, H1W2"),
    ("Casa pequeña: un dormitorio, un baño, cocina y salón en un solo espacio, y un porche delante del salón.",
     "B H K L W Y", "K1L1, K1~L1, !H1K1"),
    ("Tenemos tres hijos; los dos pequeños comparten habitación y el mayor tiene la suya. Un baño y un aseo.",
     "B3 H K L W2", "B2H1, B3H1"),
    ("La cocina tiene dos puertas, una al pasillo y otra al comedor. Dos dormitorios, un baño.", "B2 D H K L W",
     "B1H1, B2H1, H1W1"),
    ("我们一家四口，两个孩子各住一间，一个卫生间，厨房和餐厅连在一起。", "B3 D H K L W", "B3H1"),
    ("A bathroom shared by both bedrooms and not reachable from anywhere else, plus a toilet off the hall. "
     "Kitchen and living room.", "B2 H K L W2", "B1W1, B2W1, !H1W1"),
    ("The hallway serves everything but the kitchen and the dining room, which you reach through the living "
     "room. Three bedrooms, two bathrooms.", "B3 D H K L W2", "K1L1, !D1K1, !H1K1"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

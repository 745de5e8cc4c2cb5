"""Doors between two rooms of a kind, doors one behind another, and which of two rooms a side or a thing is told of."""

from sentences.facts import as_meant

BETWEEN = [
    ("The two bedrooms have a door between them, besides their doors to the hallway; 1 bathroom.", "B2 H K L W",
     "B1B2, B1H1, B2H1"),
    ("Two bedrooms, with a connecting door.", "B2 H K L W", "B1B2, B1H1, B2H1"),
    ("Two-bedroom flat. There is a door between the bedrooms.", "B2 H K L W", "B1B2, B1H1"),
    ("Two bedrooms off the hall with a communicating door between them.", "B2 H K L W", "B1B2, B1H1, B2H1"),
    ("Two bedrooms. Both have a door to the hall, and there is also a door between them.", "B2 H K L W", "B1B2, B1H1"),
    ("Two bedrooms. They are next to each other and have a door between them.", "B2 H K L W", "B1B2"),
    ("Three bedrooms. The two small ones have a door between them.", "B3 H K L W2", "B2B3, !B1B2"),
    ("The two kids' rooms have a door between them. Then a parents' bedroom.", "B3 H K L W2", "B2B3, B2H1, B3H1"),
    ("The two bathrooms have a door between them. Two bedrooms.", "B2 H K L W2", "W1W2"),
    ("Two bedrooms; there is no door between the two bedrooms.", "B2 H K L W", "no_door B1 B2, !B1B2"),
    ("Zwei Schlafzimmer mit einer Verbindungstür.", "B2 H K L W", "B1B2, B1H1, B2H1"),
    ("Zwischen den beiden Schlafzimmern ist eine Tür. Zwei Schlafzimmer, ein Bad.", "B2 H K L W", "B1B2, B1H1"),
    ("Deux chambres communicantes.", "B2 H K L W", "B1B2, B1H1"),
    ("Il y a une porte entre les deux chambres. Deux chambres.", "B2 H K L W", "B1B2"),
    ("Dos dormitorios comunicados por una puerta.", "B2 H K L W", "B1B2, B1H1"),
    ("两个卧室之间有一扇门。", "B2 H K L W", "B1B2"),
    # one behind another
    ("A door from the hall to the living room, one from the living room to the kitchen, and one from the kitchen back "
     "to the hall. Two bedrooms and a bathroom open off the hall.", "B2 H K L W", "H1L1, K1L1, H1K1"),
    ("Doors: one from the hall to the study, one from the study to the living room. Two bedrooms.", "B2 H K L S W",
     "H1S1, L1S1, H1L1"),
    ("Two bedrooms. The study has a door to the hallway and a door to the living room.", "B2 H K L S W",
     "H1S1, L1S1, H1L1"),
    ("There should be two ways to get to the kitchen: from the hall and from the living room. Two bedrooms.",
     "B2 H K L W", "H1K1, K1L1, H1L1"),
    ("The bathroom has two entrances, from the hall and from the main bedroom. Two bedrooms.", "B2 H K L W",
     "B1W1, H1W1"),
    ("Die Küche hat zwei Zugänge: vom Flur und vom Wohnzimmer. Zwei Schlafzimmer.", "B2 H K L W", "H1K1, K1L1"),
    ("La cuisine a deux accès, par le couloir et par le séjour. Deux chambres.", "B2 H K L W", "H1K1, K1L1"),
    ("La cocina tiene dos accesos: desde el pasillo y desde el salón. Dos dormitorios.", "B2 H K L W", "H1K1, K1L1"),
    # beside and open to each other
    ("Two bedrooms. The kitchen is to be adjacent to the lounge, but without a door between the two.", "B2 H K L W",
     "adjacent K1 L1, no_door K1 L1, H1K1"),
    ("A living room of 30 sqm and, open to it, a kitchen of 12 sqm, nothing else.", "K L", "K1~L1, L1=30, K1=12"),
    ("A dining room, open to the living room but with a door to the kitchen. Two bedrooms.", "B2 D H K L W",
     "D1~L1, D1K1, !D1~K1"),
    ("Scene graph: hallway-living room (door), hallway-bedroom (door), hallway-bathroom (door), living room-kitchen "
     "(open).", "B H K L W", "K1~L1, H1L1"),
    ("Main bedroom with a dressing room and a bathroom, both entered from it. A second bedroom, a bath off the hall.",
     "B2 C H K L W2", "B1C1, B1W1, !C1W1"),
    ("Four-bedroom house with three bathrooms, two of them en suite to bedrooms 1 and 2 and one off the hallway.",
     "B4 H K L W3", "B1W1, B2W2, H1W3, !B2W1, !B1W2"),
    ("Drei Schlafzimmer, zwei Bäder am Flur.", "B3 H K L W2", "H1W1, H1W2"),
    ("Trois chambres, deux salles de bains sur le couloir.", "B3 H K L W2", "H1W1, H1W2"),
    ("Tres dormitorios, dos baños en el pasillo.", "B3 H K L W2", "H1W1, H1W2"),
]  # fmt: skip

test_doors_between_two_rooms_are_theirs = as_meant(BETWEEN)

FACED = [
    ("The balcony off the living room faces south. Two bedrooms.", "B2 H K L W Y",
     "orientation Y1 south, !orientation L1 south"),
    ("A balcony off the sitting room that faces east. Two bedrooms.", "B2 H K L W Y", "orientation Y1 east"),
    ("The study opens off the hall and faces north. Two bedrooms.", "B2 H K L S W",
     "orientation S1 north, !orientation H1 north"),
    ("The study next to the hall faces north. Two bedrooms.", "B2 H K L S W", "orientation S1 north, adjacent S1 H1"),
    ("The kitchen next to the living room is on the south side. Two bedrooms.", "B2 H K L W", "position K1 south"),
    ("The two bedrooms are next to the bathroom and face south.", "B2 H K L W",
     "orientation B1 south, orientation B2 south, !orientation W1 south"),
    ("The living room has a balcony and faces south. Two bedrooms.", "B2 H K L W Y",
     "orientation L1 south, !orientation Y1 south"),
    ("The hall leads to the kitchen, which faces north. Two bedrooms.", "B2 H K L W", "orientation K1 north"),
    ("Two bedrooms. Der Balkon am Wohnzimmer zeigt nach Westen.", "B2 H K L W Y", "orientation Y1 west"),
    ("El balcón del salón mira al sur. Dos dormitorios.", "B2 H K L W Y", "orientation Y1 south"),
    ("Le balcon du séjour donne au sud. Deux chambres.", "B2 H K L W Y", "orientation Y1 south"),
    ("Deux salles de bain donnant sur le couloir, une cuisine et un salon orienté au sud. Deux chambres.",
     "B2 H K L W2", "orientation L1 south, !orientation K1 south"),
    ("Two bedrooms at one end of the flat, the living room at the opposite end.", "B2 H K L W",
     "apart B1 L1, apart B2 L1"),
    ("We need a flat. The kitchen is open to the living room and must have at least 12 m². Two bedrooms.",
     "B2 H K L W", "at_least K1 12, !at_least home 12"),
]  # fmt: skip

FACED += [
    ("Two bedrooms. The kitchen and bathroom face north.", "B2 H K L W",
     "orientation K1 north, orientation W1 north"),
    ("Two bedrooms; the living room and kitchen on the west side.", "B2 H K L W", "position L1 west, position K1 west"),
    ("Two bedrooms; in the living room a sofa with a lamp beside it.", "B2 H K L W", "!adjacent L1 B1"),
]  # fmt: skip

test_a_side_is_its_subjects = as_meant(FACED)

THINGS = [
    ("Two-bedroom flat with a laundry room off the hall: the washing machine goes there, not in the bathroom.",
     "B2 H K L U W", "U1 has 1 washing_machine, W1 has 0 washing_machine"),
    ("Two bedrooms and a utility room. Washing machine and dryer go there.", "B2 H K L U W",
     "U1 has 1 washing_machine, U1 has 1 dryer"),
    ("I'll keep my sofa and my dining table; put both in the living room. One bedroom.", "B H K L W",
     "L1 has 1 sofa, L1 has 1 dining_table"),
    ("Two-bedroom flat. A bed, a desk and a chair in the second bedroom.", "B2 H K L W",
     "B2 has 1 double_bed, B2 has 1 desk, B2 has 1 chair"),
    ("Two-bedroom flat. Washing machine, dryer and an ironing board in the kitchen.", "B2 H K L W",
     "K1 has 1 washing_machine, K1 has 1 dryer, K1 has 1 ironing_board"),
    ("Two bedrooms. The larger gets a double bed, the smaller two single beds.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Zwei Schlafzimmer: ein Doppelbett im ersten, zwei Einzelbetten im zweiten.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed, !B2 has 1 double_bed"),
    ("Deux chambres : un lit double dans la première, deux lits simples dans la deuxième.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Dos dormitorios: una cama doble en el primero, dos camas individuales en el segundo.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Four bedrooms, 11 m² each, with a single bed and a desk.", "B4 H K L W2", "B1 has 1 desk, B4 has 1 single_bed"),
    ("Two bathrooms: only one of them has a bathtub. Three bedrooms.", "B3 H K L W2", "W1 has 1 bath, W2 has 0 bath"),
    ("2 bedrooms, 8 m² for hers, 13 m² for mine. No TV in hers.", "B2 H K L W", "B1=8, B2=13, B1 has 0 tv"),
    ("Two bedrooms: my carer's has a shower room off it, and mine has a bathroom off it. No other bathrooms.",
     "B2 H K L W2", "B2W1, B1W2, !H1W1, !H1W2"),
    ("Studio with a sofa and a round table with four chairs.", "K L W", "L1 has 1 round_table, L1 has 4 chair"),
    ("Two-bedroom flat for a bed-making robot: a double bed in the master bedroom.", "B2 H K L W",
     "B1 has 1 double_bed, !B1 has 2 double_bed"),
    ("Two-bedroom flat for a laundry-folding task, with a utility room off the kitchen.", "B2 H K L U W", "K1U1"),
]  # fmt: skip

COUNTED = [
    ("Two small bedrooms and a big one.", "B3 H K L W2", ""),
    ("Two bedrooms, a big one and a small one.", "B2 H K L W", ""),
    ("Dos dormitorios pequeños y uno grande.", "B3 H K L W2", ""),
    ("Deux petites chambres et une grande.", "B3 H K L W2", ""),
    ("Zwei kleine Schlafzimmer und ein großes.", "B3 H K L W2", ""),
    ("一套公寓，一间卧室，卧室里放一张床。", "B H K L W", "B1 has 1 double_bed"),
    ("living 24, kitchen 10, bedroom 14 and 11, bath 5.", "B2 H K L W", "B1=14, B2=11"),
    ("Two bathrooms: one with a bathtub, the other with a shower, en suite to our bedroom. Three bedrooms.",
     "B3 H K L W2", "W1 has 1 bath, W2 has 1 shower, B1W2, H1W1, !W1W2"),
    ("A utility room off the kitchen, with a washing machine and a dryer. Two bedrooms.", "B2 H K L U W",
     "U1 has 1 washing_machine, U1 has 1 dryer"),
]  # fmt: skip

COUNTED += [
    ("Two bedrooms. Neither of them has a TV.", "B2 H K L W", "B1 has 0 tv, B2 has 0 tv"),
    ("None of the bedrooms has a desk. Two bedrooms.", "B2 H K L W", "B1 has 0 desk, B2 has 0 desk"),
    ("Six chairs around the dining table, which stands in the living room. Two bedrooms.", "B2 H K L W",
     "L1 has 6 chair, L1 has 1 dining_table"),
    ("Two single beds in the guest room, one double bed in ours.", "B2 H K L W",
     "B2 has 2 single_bed, B1 has 1 double_bed"),
    ("Two bedrooms, each with exactly one bed, a nightstand left of it and a wardrobe.", "B2 H K L W",
     "B2 has 1 nightstand, !position B1 B2 left"),
    ("Balcony along the living room and the master bedroom, with a door from each. Two bedrooms.", "B2 H K L W Y",
     "L1Y1, B1Y1"),
    ("主卧比次卧大，客厅最大。两室一厅。", "B2 H K L W", "order L1 largest"),
]  # fmt: skip

test_how_many_there_are = as_meant(COUNTED)

test_things_are_where_they_are_put = as_meant(THINGS)

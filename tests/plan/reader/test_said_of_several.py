"""Beds that are furniture, areas in lists, halls that serve lists, openings, one bedroom of a flat, each their own."""

from sentences.facts import as_meant

BEDS = [
    ("A studio with a kitchenette and a bathroom; put one bed and two armchairs in the main room and no desk.", "K L W",
     "K1~L1, L1W1, L1 has 1 double_bed, L1 has 2 armchair, L1 has 0 desk"),
    ("Studio with bathroom. In the main room there is one bed, a sofa and a table.", "K L W",
     "L1 has 1 double_bed, L1 has 1 sofa"),
    ("A studio: the main room has one bed and one desk.", "K L W", "L1 has 1 double_bed, L1 has 1 desk"),
    ("Studio flat with a shower room, one bed and a wardrobe in the main room.", "K L W",
     "L1 has 1 double_bed, L1 has 1 wardrobe"),
    ("A bedsit with two beds and a table in the living area, one bathroom.", "K L W", "L1 has 2 double_bed"),
    ("Studio apartment, 30 m²; place one bed, one armchair and a bookcase in the living space.", "K L W",
     "L1 has 1 double_bed, L1 has 1 armchair, all=30"),
    ("One studio with one bed in the main room, a bathroom and a balcony.", "K L W Y", "L1 has 1 double_bed"),
    ("Two-bedroom flat. Put one bed and a desk in each bedroom.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 double_bed, B1 has 1 desk, B2 has 1 desk"),
    ("One-bedroom flat; put one bed and one armchair in the living room for guests.", "B H K L W",
     "L1 has 1 double_bed, L1 has 1 armchair"),
    ("I need a studio. Two armchairs and one bed in the main room, please.", "K L W",
     "L1 has 1 double_bed, L1 has 2 armchair"),
    ("Efficiency unit with kitchenette; furnish the main room with one bed and one sofa.", "K L W",
     "L1 has 1 double_bed, L1 has 1 sofa"),
]  # fmt: skip

AREAS = [
    ("Three bedrooms and a single bathroom; the bedroom areas are 9, 11 and 14 m². Living room 22 m².", "B3 H K L W",
     "B1=9, B2=11, B3=14, L1=22"),
    ("Three bedrooms, one bathroom; bedroom sizes: 9, 11 and 14 m².", "B3 H K L W", "B1=9, B2=11, B3=14"),
    ("Three bedrooms (9, 11 and 14 m²), one bathroom.", "B3 H K L W", "B1=9, B2=11, B3=14"),
    ("Two bedrooms. Their areas are 10 and 13 sqm. One bathroom.", "B2 H K L W", "B1=10, B2=13"),
    ("Three bedrooms; the areas of the bedrooms are 9 m², 11 m² and 14 m². One bathroom.", "B3 H K L W",
     "B1=9, B2=11, B3=14"),
    ("Two bedrooms whose areas are 12 and 15 m², one bathroom, a kitchen.", "B2 H K L W", "B1=12, B2=15"),
    ("Two bedrooms, with areas of 12 and 15 m², one bathroom.", "B2 H K L W", "B1=12, B2=15"),
    ("Two bathrooms; the bathroom areas are 4 and 6 m². Two bedrooms.", "B2 H K L W2", "W1=4, W2=6"),
    ("Three bedrooms, one bathroom. The sizes of the bedrooms should be 8, 10 and 12 square metres.", "B3 H K L W",
     "B1=8, B2=10, B3=12"),
    ("Two-bedroom flat; bedrooms measure 11 and 14 m² respectively, living room 24 m².", "B2 H K L W",
     "B1=11, B2=14, L1=24"),
    ("Zwei Schlafzimmer mit 12 und 15 m², ein Bad, Küche, Wohnzimmer.", "B2 H K L W", "B1=12, B2=15"),
    ("Trois chambres de 9, 11 et 14 m², un séjour, une cuisine, une salle de bains.", "B3 H K L W",
     "B1=9, B2=11, B3=14"),
]  # fmt: skip

HALLS = [
    ("Two circulation zones: an entrance hall serving the living room, the kitchen and a guest WC; and a night "
     "corridor, reached from the entrance hall, serving three bedrooms and a bathroom.", "B3 H2 K L W2",
     "H1L1, H1K1, H1W1, H1H2, B1H2, B2H2, B3H2, H2W2"),
    ("An entrance hall serves the living room and the kitchen; a second corridor serves two bedrooms and a bathroom.",
     "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
    ("Two halls: an entrance hall serving the living room and kitchen, and a night corridor serving two bedrooms and "
     "the bathroom.", "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
    ("The hall serves the living room, the kitchen, two bedrooms and one bathroom.", "B2 H K L W",
     "H1L1, H1K1, B1H1, B2H1, H1W1"),
    ("A hallway serving a living room, a kitchen, a bedroom and a bathroom.", "B H K L W", "H1L1, H1K1, B1H1, H1W1"),
    ("An entrance hall with the living room, the kitchen and a guest WC off it; a bedroom corridor with two bedrooms "
     "and a bathroom off it.", "B2 H2 K L W2", "H1L1, H1K1, B1H2, B2H2"),
    ("Entrance hall serving living room, kitchen and study. Night corridor, off the entrance hall, serving two "
     "bedrooms and a bathroom.", "B2 H2 K L S W", "H1L1, H1K1, H1S1, H1H2, B1H2, B2H2, H2W1"),
    ("The vestibule serves the kitchen and the living room, the inner hall serves two bedrooms and the bathroom.",
     "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
    ("Day zone: entrance hall serving living room and kitchen. Night zone: inner corridor serving three bedrooms and "
     "a bathroom.", "B3 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, B3H2, H2W1"),
    ("One circulation zone: a hall that serves the living room, the kitchen, one bedroom and one bathroom.",
     "B H K L W", "H1L1, H1K1, B1H1, H1W1"),
    ("Two corridors: the first serving the living room and the kitchen, the second serving two bedrooms and a "
     "bathroom.", "B2 H2 K L W", "H1L1, H1K1, H1H2, B1H2, B2H2, H2W1"),
]  # fmt: skip

WIDE = [
    ("Living room, 30 sqm, with a wide opening and no door to the dining room; a door from the dining room to the "
     "kitchen. The hall serves the living room, the kitchen, two bedrooms and one bathroom.", "B2 D H K L W",
     "D1~L1, D1K1, L1=30"),
    ("One bedroom. The kitchen has a wide opening to the living room.", "B H K L W", "K1~L1"),
    ("One bedroom. An opening, no door, between the kitchen and the living room.", "B H K L W", "K1~L1"),
    ("One bedroom. The dining room has an opening but no door to the living room.", "B D H K L W", "D1~L1"),
    ("One bedroom. Wide opening without a door from the living room to the dining room.", "B D H K L W", "D1~L1"),
    ("One bedroom, a living room with a large opening instead of a door to the kitchen.", "B H K L W", "K1~L1"),
    ("One bedroom. Between living room and kitchen a wide opening rather than a door.", "B H K L W", "K1~L1"),
    ("One bedroom. The living room opens to the kitchen through a wide opening with no door.", "B H K L W", "K1~L1"),
    ("One bedroom. From the living room, a broad opening with no door to the kitchen.", "B H K L W", "K1~L1"),
    ("One bedroom. The kitchen is joined to the dining room by a wide opening, not a door.", "B D H K L W", "D1~K1"),
    ("One bedroom; living room with an archway and no door to the kitchen.", "B H K L W", "K1~L1"),
]  # fmt: skip

FLATS = [
    ("I am eighty-one and live alone. One bedroom, please, two armchairs in the sitting room and no television in "
     "there, and light blue walls.", "B H K L W", "L1 has 2 armchair, L1 has 0 tv, !B1 has 0 tv"),
    ("One bedroom, please, and a piano in the living room.", "B H K L W", "L1 has 1 piano"),
    ("I need one bedroom with a desk and two armchairs in the lounge.", "B H K L W",
     "B1 has 1 desk, L1 has 2 armchair"),
    ("I live alone. One bedroom, a sofa in the living room.", "B H K L W", "L1 has 1 sofa"),
    ("I want only one bedroom, please, a big table in the living room and no sofa there.", "B H K L W",
     "L1 has 0 sofa"),
    ("We are retired. One bedroom, a television in the sitting room but none in the bedroom.", "B H K L W",
     "L1 has 1 tv, B1 has 0 tv"),
    ("My wife and I need one bedroom. In the sitting room two armchairs and no television.", "B H K L W",
     "L1 has 2 armchair, L1 has 0 tv"),
    ("One bedroom, please. The sitting room has two armchairs and a bookcase.", "B H K L W", "L1 has 2 armchair"),
    ("Just one bedroom for me, with a rocking chair in the lounge, please.", "B H K L W", ""),
    ("I live on my own: one bedroom, and no television in the living room.", "B H K L W", "L1 has 0 tv"),
    ("I am old. One bedroom is enough, with an armchair in the living room.", "B H K L W", "L1 has 1 armchair"),
    ("A bedroom and a bathroom, with a bed in the bedroom.", "B W", "B1W1"),
    ("A living room with two sofas and a tv.", "L", "L1 has 2 sofa"),
]  # fmt: skip

OWN = [
    ("My sister and I each want our own bedroom, and each bedroom should have its own bathroom. And there should be a "
     "little toilet off the hall for visitors.", "B2 H K L W3", "B1W1, B2W2, H1W3"),
    ("Two bedrooms, each bedroom should have its own bathroom, and a guest WC off the hall.", "B2 H K L W3",
     "B1W1, B2W2, H1W3"),
    ("My brother and I each need our own bedroom and each of our bedrooms should have its own bathroom.", "B2 H K L W2",
     "B1W1, B2W2"),
    ("My friend and I both want our own bedroom, with its own bathroom each.", "B2 H K L W2", "B1W1, B2W2"),
    ("Three friends each want their own bedroom, and every bedroom must have its own bathroom.", "B3 H K L W3",
     "B1W1, B2W2, B3W3"),
    ("My mother and I want a bedroom each, and each bedroom needs its own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("We are two sisters; each bedroom should have its own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("My sister and I want our own bedrooms, each with its own bathroom.", "B2 H K L W2", "B1W1, B2W2"),
    ("Two bedrooms. Each bedroom gets a bathroom of its own; a separate toilet is off the hall.", "B2 H K L W3",
     "B1W1, B2W2, H1W3"),
    ("My cousin and I each want our own bedroom. We share the kitchen, the lounge and the bathroom.", "B2 H K L W",
     "H1W1"),
    ("My sister and I each get our own bedroom and each bedroom has its own balcony.", "B2 H K L W Y2", "B1Y1, B2Y2"),
]  # fmt: skip

test_a_bed_in_a_room_is_furniture = as_meant(BEDS)
test_areas_in_a_list_are_of_rooms_in_turn = as_meant(AREAS)
test_a_hall_serves_the_rooms_listed_behind_it = as_meant(HALLS)
test_an_opening_and_no_door_is_an_opening = as_meant(WIDE)
test_one_bedroom_and_furniture_is_a_flat = as_meant(FLATS)
test_each_has_their_own = as_meant(OWN)

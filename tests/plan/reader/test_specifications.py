"""What specifications say: windows counted, rooms open to each other, areas of all and of several, places to eat."""

from sentences.facts import as_meant

test_windows_are_no_rooms = as_meant([
    ("apartment:\n  total: 80 sqm\n  bedroom: 2\n  bathroom: 1\n  living_room: 1\n  windows: living_room 2\n  "
     "entrance: hallway", "B2 H K L W", "all=80, unread windows: living room 2"),
    ("bedrooms: 2\nwindows: living room 2, kitchen 1, bedroom 1 each\narea: 70 m2", "B2 H K L W", "all=70"),
    ("2 bedrooms; 1 bathroom; windows: living_room=2, bedroom=1", "B2 H K L W", ""),
    ('{"bedrooms": 2, "windows": {"living_room": 2, "bedroom": 1}, "kitchen": 1, "area": 80}', "B2 H K L W",
     "all=80"),
])  # fmt: skip
test_open_fields = as_meant([
    ("rooms: living_room(22m2), kitchen(10m2), bedroom(14m2), bathroom(5m2), hallway(6m2); doors: hallway-living_room, "
     "hallway-bedroom, hallway-bathroom; open: kitchen-living_room", "B H K L W", "K1~L1, L1=22"),
    ("rooms: living room, kitchen, dining room, bedroom, bathroom. doors: hallway-living room. openings: "
     "kitchen-dining room, dining room-living room", "B D H K L W", "D1~K1, D1~L1"),
    ("bedrooms: 2\nbathrooms: 1\nopen: kitchen-dining_room, dining_room-living_room", "B2 D H K L W", "D1~K1, D1~L1"),
    ('{"bedrooms": 2, "open": [["kitchen", "living_room"]]}', "B2 H K L W", "K1~L1"),
])  # fmt: skip
test_openings_and_no_door = as_meant([
    ("make flat 60m for student couple, one bedroom, between kitchen and living room should be no door only opening",
     "B H K L W", "K1~L1, all=60, !adjacent B1 K1"),
    ("one bedroom flat, no door between kitchen and living room, just an opening", "B H K L W", "K1~L1"),
    ("Two bedrooms. There should not be a door between the kitchen and the dining room, just an open passage.",
     "B2 D H K L W", "D1~K1, !no_door K1 D1"),
    ("Two bedrooms, zwischen Küche und Wohnzimmer keine Tür, nur eine Öffnung", "B2 H K L W", "K1~L1"),
    ("deux chambres, pas de porte entre la cuisine et le salon, juste une ouverture", "B2 H K L W", "K1~L1"),
    ("dos dormitorios, sin puerta entre la cocina y el salón, solo una abertura", "B2 H K L W", "K1~L1"),
])  # fmt: skip
test_areas_of_all = as_meant([
    ("From the hall you go in the kitchen, in the bathroom and in the living room. All about 52 square metres.",
     "B H K L W", "all=52, !L1=52"),
    ("two bedrooms, a kitchen and a living room; everything together 60 m2", "B2 H K L W", "all=60"),
    ("two bedrooms, a kitchen and a living room. The whole thing 60 sqm.", "B2 H K L W", "all=60"),
    ("two bedrooms, a kitchen and a living room. Total area about 60 m2", "B2 H K L W", "all=60"),
    ("Four bedrooms. All about 12 m2.", "B4 H K L W2", "B1=12, B4=12"),
])  # fmt: skip
test_areas_of_several = as_meant([
    ("kitchen + dining_room + living_room open plan, 45 m2 combined; 1 bedroom; 1 bathroom off bedroom", "B D H K L W",
     "D1~K1, D1~L1, !L1=45"),
    ("two bedrooms, open-plan kitchen, dining and living area, 45 m2 together", "B2 D H K L W",
     "D1~K1, D1~L1, !all=45"),
    ("a study, kitchen + dining + living room open plan, 45 m2 combined, two bedrooms", "B2 D H K L S W",
     "D1~K1, D1~L1, !K1S1"),
    ("Home office layout: study 14 m2 with two desks, bedroom 12 m2, kitchen-living room 28 m2", "B H K L S W",
     "S1=14, K1~L1, !L1=28"),
    ("two bedrooms, kitchen and dining room 20 m2 combined", "B2 D H K L W", "!D1~K1, !D1=20"),
])  # fmt: skip
test_places_to_eat = as_meant([
    ("3-Zimmer-Wohnung, ca. 75 qm, Küche mit Essplatz", "B2 H K L W", "K1 has 1 dining_table"),
    ("two bedrooms with a kitchen that has a dining area for four", "B2 H K L W", "K1 has 4 chair"),
    ("two bedrooms and an eating place in the kitchen", "B2 H K L W", "K1 has 1 dining_table"),
    ("Appartement T3, cuisine avec coin repas", "B2 H K L W", "K1 has 1 dining_table"),
    ("piso de dos dormitorios, cocina con comedor de diario", "B2 H K L W", "K1 has 1 dining_table, !unread diario"),
    ("living room with a dining area, two bedrooms", "B2 D H K L W", "D1~L1"),
])  # fmt: skip
test_in_a_nouns_place = as_meant([
    ("4 bedrooms, 3 bathrooms with one of them ensuite to the master bedroom", "B4 H K L W3", "B1W1, !B1W2"),
    ("one-bedroom flat, kitchen separated from living room by a door", "B H K L W", "K1L1"),
    ("two bedrooms, a door separates the kitchen from the living room", "B2 H K L W", "K1L1"),
    ("two bedrooms, a door between the kitchen and the living room", "B2 H K L W", "K1L1, !adjacent B1 K1"),
    ("three bedrooms and a long corridor. Bedrooms should be at the opposite end of the corridor from the kitchen.",
     "B3 H K L W2", "apart B1 K1, !opposite B1 H1, !unread end"),
])  # fmt: skip
test_more_than_are_listed = as_meant([
    ("Escape room style flat with 5 rooms where you have to walk through each room to reach the next: hallway, study, "
     "living room, kitchen, bedroom.", "B H K L S W", "unread 5 rooms"),
    ("A home of five rooms: two bedrooms, a kitchen, a living room and a hallway", "B2 H K L W", "unread five rooms"),
    ("I need 5 rooms: kitchen, living room, bedroom, bathroom, hallway.", "B H K L W", "!unread 5 rooms"),
    ("Three rooms in a row: bedroom, living room, kitchen, connected by doors.", "B K L", "!unread three rooms"),
    ("Wohnung mit 5 Räumen: Flur, Arbeitszimmer, Wohnzimmer, Küche, Schlafzimmer", "B H K L S W", "unread 5 raumen"),
    ("3 rooms: living room, bedroom, study", "B H K L S W", "!unread 3 rooms"),
])  # fmt: skip
test_homes_of_one_room = as_meant([
    ("studio, 30 m2, must include: bed, desk, wardrobe, kitchenette, bathroom with shower", "K L W",
     "all=30, L1 has 1 double_bed, L1 has 1 desk"),
    ("Studio apartment, 35 m2, bed, desk, sofa, kitchenette, separate bathroom.", "K L W", "L1 has 1 double_bed"),
    ("one room with bed, table, stove and bookshelf, plus a bathroom", "K L W", "L1 has 1 double_bed"),
    ("just one room of 20 m2 with bed, stove, table, and a separate bathroom", "K L W", "all=20"),
    ("two bedrooms, one room with a bed and one room with two desks", "B2 H K L W", "B1 has 1 double_bed"),
    ("One bedroom, bathroom with a shower and no bathtub, a bed with a rug", "B W", "!W1 has 1 double_bed"),
    ("Flat with two bedrooms and a kitchen. All about 55 meters", "B2 H K L W", "all=55"),
])  # fmt: skip
test_what_is_said_behind_the_rooms = as_meant([
    ("Make me one flat with two bedrooms. In the kitchen should stay a table with six chairs, and I don't want rugs.",
     "B2 H K L W", "K1 has 6 chair, B1 has 0 rug, B2 has 0 rug, L1 has 0 rug"),
    ("A bedroom with a single bed, a guest room with a sofa bed, a shower instead of a bath", "B2 H K L W",
     "W1 has 1 shower, W1 has 0 bath, !B2 has 1 shower"),
    ("two bedrooms, a bathroom with a sink, a shower instead of a tub", "B2 H K L W", "W1 has 1 shower, W1 has 0 bath"),
])  # fmt: skip

"""Rooms meant by `it`, `there`, `also`, `does not`; what stands in a room that is named first."""

from sentences.facts import as_meant

OFF_IT = [
    ("We need exactly a kitchen, a living room, a bathroom and a bedroom. No hallway: the front door opens into "
     "the living room, and the other three rooms open off it.", "B K L W", "B1L1, K1L1, L1W1"),
    ("A kitchen, a living room, a bathroom and a bedroom, nothing else. You enter the living room from outside, "
     "and the other rooms all open off it.", "B K L W", "K1L1, B1L1, L1W1, !B1K1, !B1W1"),
    ("One-bedroom flat without a hallway: the entrance is in the living room and the other three rooms lead off it.",
     "B K L W", "K1L1, B1L1, L1W1, !B1K1"),
    ("No hallway: the front door opens into the kitchen, and the bedroom and the bathroom open off it. One bedroom.",
     "B K L W", "B1K1, K1W1, !B1W1"),
    ("Flat with one bedroom. No hall. The entrance leads into the living room; the kitchen, the bedroom and the "
     "bathroom are all off it.", "B K L W", "K1L1, B1L1, L1W1, !B1K1"),
    ("One-bedroom flat, no corridor. You come straight into the living room, and every other room opens off it.",
     "B K L W", "K1L1, B1L1, L1W1, !B1K1"),
]  # fmt: skip
BETWEEN_IT = [
    ("Doors are where our arm fails, so the kitchen may have at most one door, and there must be no door between "
     "it and the living room. One-bedroom flat.", "B H K L W", "at_most K1 doors 1, no_door K1 L1"),
    ("One-bedroom flat. The kitchen should be small, and no door between it and the hallway please.", "B H K L W",
     "no_door K1 H1"),
    ("Two-bedroom flat with a study off the hallway and no door between it and the living room.", "B2 H K L S W",
     "H1S1, no_door S1 L1"),
    ("A flat with two bedrooms. The bathroom is off the hall; there should not be a door between it and the "
     "kitchen.", "B2 H K L W", "H1W1, no_door W1 K1"),
    ("Two bedrooms and a dining room. The dining room faces south, with a door between it and the kitchen.",
     "B2 D H K L W", "orientation D1 south, D1K1"),
    ("One bedroom. The kitchen has one door at most; between it and the living room there must be no door.",
     "B H K L W", "at_most K1 doors 1, no_door K1 L1"),
]  # fmt: skip
IS_WITH = [
    ("In the living room I want two sofas, one coffee table and three armchair. In the kitchen one dining table "
     "with four chairs. The flat is with one bedroom.", "B H K L W",
     "K1 has 1 dining_table, K1 has 4 chair, L1 has 1 coffee_table, L1 has 2 sofa, L1 has 3 armchair"),
    ("In the kitchen two stools. The apartment has two bedrooms.", "B2 H K L W", "B1H1, B2H1, K1 has 2 stool"),
    ("In the living room one sofa. The flat is with two bedroom and one bathroom.", "B2 H K L W", "B1H1, B2H1, H1W1"),
    ("The kitchen is with a dining table. The flat is with one bedroom and one study.", "B H K L S W", "B1H1, H1S1"),
    ("In the bedroom one desk. My home is with one bedroom and one balcony.", "B H K L W Y",
     "B1H1, B1 has 1 desk, L1Y1"),
    ("In the living room I want a sofa and two armchairs. The house is with three bedrooms and two bathrooms.",
     "B3 H K L W2", "H1K1, B2H1, B3H1"),
]  # fmt: skip
STANDS_IN = [
    ("Four of us share: four bedrooms, two bathrooms off the hallway, open kitchen, and in the living room a "
     "dining table and eight chairs.", "B4 H K L W2", "L1 has 1 dining_table, L1 has 8 chair, K1~L1, K1L1"),
    ("Three bedrooms, two bathrooms off the hallway, separate kitchen, and in the living room a sofa and two "
     "armchairs.", "B3 H K L W2", "L1 has 1 sofa, L1 has 2 armchair"),
    ("Two bedrooms, an open kitchen, in the bathroom a washing machine.", "B2 H K L W", "W1 has 1 washing_machine"),
    ("One bedroom, one bathroom, kitchen, and in the bedroom a desk and a bookshelf.", "B H K L W",
     "B1 has 1 desk, B1 has 1 bookshelf"),
    ("Two bedrooms, a balcony, open kitchen and, in the living room, a dining table with six chairs.", "B2 H K L W Y",
     "L1 has 1 dining_table, L1 has 6 chair"),
    ("Two bedrooms, a study, and in the kitchen a dining table and four chairs.", "B2 H K L S W",
     "K1 has 1 dining_table, K1 has 4 chair"),
]  # fmt: skip
AND_BE = [
    ("Grandma is moving in. Her bedroom should share a wall with the bathroom and be near the entrance. With ours "
     "that makes two bedrooms. One bathroom.", "B2 H K L W", "adjacent B1 W1, near B1 entrance"),
    ("Two bedrooms. The study should be next to the kitchen and face north.", "B2 H K L S W",
     "adjacent S1 K1, orientation S1 north"),
    ("Two bedrooms. The second bedroom should be beside the bathroom and be far from the entrance.", "B2 H K L W",
     "adjacent B2 W1, apart B2 entrance"),
    ("The utility room must share a wall with the kitchen and be at the back. Two bedrooms.", "B2 H K L U W",
     "adjacent U1 K1, position U1 back"),
    ("Grandpa's room should be beside the bathroom and lie near the front door. With our bedroom that makes two.",
     "B2 H K L W", "adjacent B2 W1, near B2 entrance"),
    ("The guest room should be opposite the bathroom and close to the entrance. Two bedrooms.", "B2 H K L W",
     "opposite B2 W1, near B2 entrance"),
]  # fmt: skip
ALSO = [
    ("We don't need a balcony, and no dining room either. What we do need is a utility room off the kitchen and a "
     "pantry, also off the kitchen. Two bedrooms, one bathroom.", "B2 H K L T U W", "K1T1, K1U1"),
    ("Two bedrooms, one bathroom, a study off the living room and a balcony, also off the living room.",
     "B2 H K L S W Y", "L1S1, L1Y1, !S1Y1"),
    ("What we need is a pantry off the kitchen and a utility room, likewise off the kitchen. Two bedrooms.",
     "B2 H K L T U W", "K1T1, K1U1, !T1U1"),
    ("Two bedrooms with a storage room off the hallway and a study, also off the hallway.", "B2 H K L S T W",
     "H1T1, H1S1, !S1T1"),
    ("Two bedrooms, a utility room off the kitchen, and a pantry, off the kitchen too.", "B2 H K L T U W",
     "K1T1, K1U1, !T1U1"),
    ("One bedroom, a balcony off the bedroom and a closet, again off the bedroom.", "B C H K L W Y",
     "B1Y1, B1C1, !C1Y1"),
]  # fmt: skip
THERE = [
    ("It's a two-bedroom flat with one bathroom. Guests sleep in the second bedroom: please plan two single beds "
     "there. In the first bedroom, ours, we want a double bed and two bedside tables.", "B2 H K L W",
     "B1 has 1 double_bed, B1 has 2 nightstand, B2 has 2 single_bed"),
    ("Two bedrooms, one bathroom. The kids sleep in the second bedroom: put a bunk bed there.", "B2 H K L W",
     "B2 has 1 bunk_bed"),
    ("Two bedrooms. Guests sleep in the second bedroom; we need two single beds there.", "B2 H K L W",
     "B2 has 2 single_bed"),
    ("Two bedrooms. I work in the second bedroom, so please plan a desk there.", "B2 H K L W", "B2 has 1 desk"),
    ("Two bedrooms. In the second bedroom, my son's, we want a single bed and a desk.", "B2 H K L W",
     "B2 has 1 single_bed, B2 has 1 desk"),
    ("Two bedrooms. We eat in the kitchen: a table and four chairs there, please.", "B2 H K L W",
     "K1 has 1 dining_table, K1 has 4 chair"),
]  # fmt: skip
DOES_NOT = [
    ("Hide-and-seek map: three bedrooms and one bathroom. Bedroom 1 and bedroom 2 each have a walk-in closet; "
     "bedroom 3 doesn't, it gets a wardrobe instead.", "B3 C2 H K L W", "B3 has 1 wardrobe, B1C1, B2C2"),
    ("Three bedrooms, one bathroom. Bedroom 1 has a balcony; bedroom 2 doesn't, it gets a desk.", "B3 H K L W Y",
     "B1Y1, B2 has 1 desk"),
    ("Two bedrooms. The first bedroom has a walk-in closet; the second does not, it has a wardrobe.", "B2 C H K L W",
     "B1C1, B2 has 1 wardrobe"),
    ("Two bedrooms. Bedroom 1 has a walk-in closet; bedroom 2 gets a wardrobe instead.", "B2 C H K L W",
     "B1C1, B2 has 1 wardrobe"),
    ("Three bedrooms. Bedroom 1 and bedroom 2 have a double bed; bedroom 3 doesn't, it has two single beds.",
     "B3 H K L W2", "B3 has 2 single_bed, B1 has 1 double_bed, B2 has 1 double_bed"),
    ("Two bedrooms. Bedroom 1 has a bath of its own, bedroom 2 doesn't, but it gets a balcony.", "B2 H K L W2 Y",
     "B1W1, B2Y1"),
]  # fmt: skip
THERE_IS = [
    ("I am Yuki. In my dream flat there is one bedroom and one bathroom. In the bedroom there is one single bed, "
     "one wardrobe and two bookshelves. There is not a television in the living room.", "B H K L W",
     "B1 has 1 single_bed, B1 has 1 wardrobe, B1 has 2 bookshelf, L1 has 0 tv"),
    ("One bedroom. In the bedroom there is a double bed and two nightstands. There is no television in the living "
     "room.", "B H K L W", "B1 has 2 nightstand, L1 has 0 tv"),
    ("One bedroom. In the kitchen there is one table and four chairs. There are not armchairs in the living room.",
     "B H K L W", "K1 has 4 chair, K1 has 1 dining_table, L1 has 0 armchair"),
    ("In the bedroom there is a desk and a bookshelf. There isn't a sofa in the living room. One bedroom.", "B H K L W",
     "B1 has 1 bookshelf, B1 has 1 desk, L1 has 0 sofa"),
    ("One bedroom. In the living room there are two sofas. There is a desk in the bedroom.", "B H K L W",
     "L1 has 2 sofa, B1 has 1 desk"),
    ("One bedroom. In the bedroom there is one wardrobe and two bookshelves. There is a television in the living "
     "room.", "B H K L W", "B1 has 2 bookshelf, L1 has 1 tv"),
]  # fmt: skip
BUREAU = [
    ("Appartement avec deux chambres et une salle de bains ; dans la chambre des enfants, deux lits simples et un "
     "bureau ; la cuisine est près de l'entrée.", "B2 H K L W", "B2 has 1 desk, B2 has 2 single_bed, near K1 entrance"),
    ("Deux chambres ; dans la chambre des enfants, un lit superposé et deux bureaux.", "B2 H K L W",
     "B2 has 1 bunk_bed, B2 has 2 desk"),
    ("Appartement avec une chambre. Dans la chambre, un lit double, une armoire et un bureau.", "B H K L W",
     "B1 has 1 desk, B1 has 1 wardrobe"),
    ("Deux chambres, un bureau et une salle de bains.", "B2 H K L S W", ""),
    ("Deux chambres ; dans le salon, un canapé et un bureau.", "B2 H K L W", "L1 has 1 desk, L1 has 1 sofa"),
    ("Appartement : une chambre avec un lit simple et un bureau, une salle de bains.", "B H K L W", "B1 has 1 desk"),
]  # fmt: skip
VERB_LAST = [
    ("Wir suchen eine Wohnung mit zwei Schlafzimmern und 78 m²; das Wohnzimmer soll nach Süden gehen und "
     "mindestens 24 m² haben.", "B2 H K L W", "at_least L1 24, orientation L1 south"),
    ("Zwei Schlafzimmer. Die Küche soll nach Osten liegen und höchstens 9 m² haben.", "B2 H K L W",
     "orientation K1 east, at_most K1 9"),
    ("Wohnung mit 80 m² und zwei Schlafzimmern; die Küche soll am Wohnzimmer liegen und mindestens 10 m² haben.",
     "B2 H K L W", "at_least K1 10, all=80"),
    ("Zwei Schlafzimmer; das Wohnzimmer soll nach Westen gehen und 25 m² groß sein.", "B2 H K L W",
     "orientation L1 west, L1=25"),
    ("Zwei Schlafzimmer; das Bad soll neben der Küche sein und mindestens 6 m² haben.", "B2 H K L W",
     "adjacent W1 K1, at_least W1 6"),
    ("Zwei Schlafzimmer; das Wohnzimmer geht nach Süden und hat mindestens 24 m².", "B2 H K L W",
     "orientation L1 south, at_least L1 24"),
]  # fmt: skip
DIAGONAL = [
    ("Two bedrooms. The living room is large and faces south-west.", "B2 H K L W", "orientation L1 south_west"),
    ("Two bedrooms. The kitchen looks to the north-west, the living room faces southeast.", "B2 H K L W",
     "orientation K1 north_west, orientation L1 south_east"),
    ("Two bedrooms. The kitchen lies to the south-west.", "B2 H K L W", "position K1 south_west"),
    ("Zwei Schlafzimmer. Das Wohnzimmer zeigt nach Südwesten.", "B2 H K L W", "orientation L1 south_west"),
    ("Zwei Schlafzimmer, die Küche im Nordosten.", "B2 H K L W", "position K1 north_east"),
    ("Deux chambres. Le salon donne au sud-ouest.", "B2 H K L W", "orientation L1 south_west"),
    ("Dos dormitorios. La cocina mira al noreste.", "B2 H K L W", "orientation K1 north_east"),
    ("两间卧室，客厅朝西南。", "B2 H K L W", "orientation L1 south_west"),
]  # fmt: skip
AGAIN = [
    ("Benchmark scene: 2 bedrooms, 1 bathroom, kitchen with an island. The island has four stools.", "B2 H K L W",
     "K1 has 1 island, K1 has 4 stool"),
    ("Two bedrooms. A dining table with four chairs in the kitchen. The table is round.", "B2 H K L W",
     "K1 has 1 dining_table, K1 has 4 chair"),
    ("A flat with one bedroom. A desk and a bed in the bedroom. The desk has a lamp.", "B H K L W",
     "B1 has 1 desk, B1 has 1 table_lamp"),
    ("Two bedrooms. In the kitchen a table. The table seats six.", "B2 H K L W",
     "K1 has 1 dining_table, K1 has 6 chair"),
    ("One bedroom. A sofa. The sofa is in the living room.", "B H K L W", "L1 has 1 sofa"),
]  # fmt: skip
THEY_MUST_NOT = [
    ("My husband snores. Two bedrooms please, and they must not be next to each other! One bathroom, one kitchen, one "
     "living room, all from the hall.", "B2 H K L W", "apart B1 B2"),
    ("Two bedrooms, one bathroom. The bedrooms must not be next to each other.", "B2 H K L W", "apart B1 B2"),
    ("Two bedrooms, but they should not adjoin each other. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("We need two bedrooms and they should be far from each other. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("Two bedrooms; they may not share a wall with each other. One bathroom.", "B2 H K L W", "apart B1 B2"),
    ("Two bathrooms, but they should not be side by side. Two bedrooms.", "B2 H K L W2", "apart W1 W2"),
]  # fmt: skip
ON_THE_BALCONY = [
    ("In my ideal home there is one bedroom, one bathroom, one kitchen, one living room and one balcony. You can go to "
     "the balcony only from the bedroom. On the balcony there are two chairs and a table.", "B H K L W Y",
     "B1Y1, Y1 has 2 balcony_chair, Y1 has 1 balcony_table"),
    ("A flat with one bedroom and a balcony. There are two chairs and a small table on the balcony.", "B H K L W Y",
     "Y1 has 2 balcony_chair, Y1 has 1 balcony_table"),
    ("A flat with one bedroom and a balcony with a table and four chairs.", "B H K L W Y",
     "Y1 has 4 balcony_chair, Y1 has 1 balcony_table"),
    ("Two bedrooms. On the terrace we want a table with six chairs.", "B2 H K L W Y",
     "Y1 has 6 balcony_chair, Y1 has 1 balcony_table"),
    ("Zwei Schlafzimmer und ein Balkon. Auf dem Balkon stehen ein Tisch und zwei Stühle.", "B2 H K L W Y",
     "Y1 has 2 balcony_chair, Y1 has 1 balcony_table"),
    ("Deux chambres et un balcon. Sur le balcon, une table et deux chaises.", "B2 H K L W Y",
     "Y1 has 2 balcony_chair, Y1 has 1 balcony_table"),
    ("Dos dormitorios y una terraza. En la terraza hay una mesa y cuatro sillas.", "B2 H K L W Y",
     "Y1 has 4 balcony_chair, Y1 has 1 balcony_table"),
]  # fmt: skip
OFF_WITH = [
    ("We foster children. Four bedrooms; two bathrooms, both off the hallway, neither of them ensuite; a living room; "
     "a dining room with doors to the kitchen and to the living room; and a utility room off the kitchen with a "
     "washing machine and a dryer. The kitchen has its own door to the hall too.", "B4 D H K L U W2",
     "K1U1, U1 has 1 washing_machine, U1 has 1 dryer, D1K1, D1L1, H1K1"),
    ("Two bedrooms, one bathroom and a utility room off the kitchen with a washing machine.", "B2 H K L U W",
     "K1U1, U1 has 1 washing_machine, !K1 has 1 washing_machine"),
    ("Two bedrooms and a study off the living room with two desks and a bookshelf.", "B2 H K L S W",
     "L1S1, S1 has 2 desk, S1 has 1 bookshelf"),
    ("One bedroom, a balcony off the living room with two balcony chairs.", "B H K L W Y",
     "L1Y1, Y1 has 2 balcony_chair"),
    ("There is a guest toilet off the hallway with a washing machine. Two bedrooms, one bathroom.", "B2 H K L W2",
     "H1W1, W1 has 1 washing_machine"),
]  # fmt: skip

test_the_other_rooms_open_off_it = as_meant(OFF_IT)

test_between_it_and_another_room = as_meant(BETWEEN_IT)

test_the_flat_is_with_rooms = as_meant(IS_WITH)

test_furniture_of_a_room_named_before_it = as_meant(STANDS_IN)

test_it_should_be_there_and_be_there_too = as_meant(AND_BE)

test_also_off_the_same_room = as_meant(ALSO)

test_things_that_are_put_there = as_meant(THERE)

test_one_does_not_and_has_another = as_meant(DOES_NOT)

test_in_one_there_is_and_in_another_there_is_not = as_meant(THERE_IS)

test_a_bureau_among_furniture_is_a_desk = as_meant(BUREAU)

test_german_verbs_stand_last = as_meant(VERB_LAST)

test_rooms_face_between_two_sides = as_meant(DIAGONAL)

test_a_thing_that_is_told_of_again_is_one = as_meant(AGAIN)

test_they_must_not_be_next_to_each_other = as_meant(THEY_MUST_NOT)

test_what_stands_on_the_balcony = as_meant(ON_THE_BALCONY)

test_a_new_room_off_another_has_what_it_is_told_with = as_meant(OFF_WITH)

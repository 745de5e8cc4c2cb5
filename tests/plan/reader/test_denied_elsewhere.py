"""What is denied by nowhere, neither and walls left out, and words that are no rooms."""

from sentences.facts import as_meant

HEADED = [
    ("Long-horizon laundry task. One-bedroom flat with a utility room that holds a washing machine and a dryer; "
     "keep the utility room away from the bedroom.", "B H K L U W",
     "U1 has 1 dryer, U1 has 1 washing_machine, apart U1 B1"),
    ("Cleaning task. A two-bedroom flat with a utility room.", "B2 H K L U W", ""),
    ("Laundry benchmark: two-bedroom flat, one bathroom, utility room off the hallway.", "B2 H K L U W", "H1U1"),
    ("Kitchen scenario. A one-bedroom flat with a separate kitchen.", "B H K L W", ""),
    ("Bathroom-cleaning episode. Two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("Long-horizon kitchen task: a flat with two bedrooms and a kitchen next to the living room.", "B2 H K L W",
     "K1L1"),
    ("Laundry tasks only. A studio with a utility room.", "K L U W", ""),
]  # fmt: skip
NOWHERE = [
    ("Our base is wheelchair-sized: nowhere should the hallway be narrower than 150 cm, and the living room should "
     "be no smaller than 25 m². 2 bedrooms, 1 bathroom.", "B2 H K L W", "at_least H1 width 1.5, at_least L1 25"),
    ("Two bedrooms. The corridor must nowhere be less than 1.4 m wide.", "B2 H K L W", "at_least H1 width 1.4"),
    ("Two bedrooms. At no point should the hallway be narrower than 120 cm.", "B2 H K L W", "at_least H1 width 1.2"),
    ("Two bedrooms. The hall shouldn't be narrower than 1.3 m anywhere.", "B2 H K L W", "at_least H1 width 1.3"),
    ("Two bedrooms; nowhere may the corridor be wider than 1.5 m.", "B2 H K L W", "at_most H1 width 1.5"),
    ("Two bedrooms; a hallway that is nowhere narrower than 1.2 m.", "B2 H K L W", "at_least H1 width 1.2"),
]  # fmt: skip
WANT_NOT = [
    ("I want not balcony, but I want one laundry room. Two bedroom, one bathroom please.", "B2 H K L U W", ""),
    ("I want not a study. Two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("We need not dining room, we need one storage room. Two bedroom.", "B2 H K L T W", ""),
    ("We want not a balcony but a storage room. Two bedrooms.", "B2 H K L T W", ""),
    ("I don't want balcony, I want not study too. One bedroom.", "B H K L W", ""),
    ("Please make not balcony. Two bedroom flat.", "B2 H K L W", ""),
]  # fmt: skip
STOREYS = [
    ("A two-bedroom flat over two storeys with a lift, one bathroom and a storage room off the hallway.",
     "B2 H K L T W", ""),
    ("A flat on two storeys with three bedrooms, one bathroom and a store room off the kitchen.", "B3 H K L T W",
     "K1T1"),
    ("A two-storey home, two bedrooms, one bathroom and a storage off the hallway.", "B2 H K L T W", "H1T1"),
    ("Two bedrooms, stairs to a second storey, a storage room and a lift.", "B2 H K L T W", ""),
    ("A house over three storeys with two bedrooms, a pantry off the kitchen.", "B2 H K L T W", "K1T1"),
    ("A two-bedroom flat over two storeys, one bathroom.", "B2 H K L W", ""),
]  # fmt: skip
THINGS = [
    ("Für die WG: drei Schlafzimmer, eine Küche, ein Bad, kein Wohnzimmer, und im Flur ein Schuhschrank.", "B3 H K W",
     "H1 has 1 shoe_cabinet"),
    ("Zwei Schlafzimmer, ein Bad, im Flur eine Garderobe.", "B2 H K L W", "H1 has 1 coat_rack"),
    ("Zwei Schlafzimmer, im Flur zwei Schuhschränke.", "B2 H K L W", "H1 has 2 shoe_cabinet"),
    ("Two bedrooms, a shoe cabinet in the hallway.", "B2 H K L W", "H1 has 1 shoe_cabinet"),
    ("Deux chambres, une salle de bains, dans l'entrée un meuble à chaussures.", "B2 H K L W", "H1 has 1 shoe_cabinet"),
    ("Dos dormitorios, un baño, en el pasillo un zapatero.", "B2 H K L W", "H1 has 1 shoe_cabinet"),
    ("两室一卫，走廊里放一个鞋柜。", "B2 H K L W", "H1 has 1 shoe_cabinet"),
]  # fmt: skip
CLOSE_BY = [
    ("一间卧室、一间书房、客厅、厨房和卫生间。书房12平方米，紧挨着卧室；客厅朝南。", "B H K L S W",
     "S1=12, adjacent S1 B1, orientation L1 south"),
    ("两室一厅一卫，厨房紧挨着客厅。", "B2 H K L W", "K1L1"),
    ("一间卧室、一间书房和卫生间。书房紧挨卧室。", "B H K L S W", "adjacent S1 B1"),
    ("两间卧室，一个卫生间。卫生间紧邻卧室。", "B2 H K L W", ""),
    ("一间卧室、一间书房、客厅、厨房和卫生间。书房10平方米，挨着卧室。", "B H K L S W", "S1=10, adjacent S1 B1"),
    ("一间卧室、客厅、厨房和卫生间。厨房8平方米，挨着卫生间；客厅朝东。", "B H K L W",
     "K1=8, adjacent K1 W1, orientation L1 east"),
]  # fmt: skip
WALL = [
    ("Please leave out the wall between kitchen and living room, we want them open to each other. In the kitchen "
     "an island with four stools. Two bedrooms, one bathroom.", "B2 H K L W",
     "K1 has 1 island, K1 has 4 stool, K1~L1, K1L1"),
    ("Leave out the wall between the kitchen and the living room. Two bedrooms.", "B2 H K L W",
     "K1~L1, !no_door K1 L1"),
    ("Two bedrooms. Skip the wall between kitchen and dining room.", "B2 D H K L W", "D1~K1, !no_door K1 D1"),
    ("Two bedrooms. We don't want a wall between the kitchen and the living room; they should be open to each "
     "other.", "B2 H K L W", "K1~L1, !no_door K1 L1"),
    ("Two bedrooms. Please take out the wall between living room and kitchen.", "B2 H K L W", "K1~L1, !no_door K1 L1"),
    ("Two bedrooms. Please leave out the door between the kitchen and the living room.", "B2 H K L W", "no_door K1 L1"),
]  # fmt: skip
NO_QUEREMOS = [
    ("Hola, buscamos un piso de tres dormitorios y dos baños, uno de ellos dentro del dormitorio principal. El "
     "salón debe tener al menos 25 m². No queremos balcón.", "B3 H K L W2", "at_least L1 25, B1W1"),
    ("Dos dormitorios y un baño. No queremos terraza.", "B2 H K L W", ""),
    ("Buscamos un piso de dos dormitorios. No necesitamos despacho ni balcón.", "B2 H K L W", ""),
    ("Un piso de dos dormitorios, un baño. No hace falta comedor.", "B2 H K L W", ""),
    ("Piso de dos dormitorios; no queremos despacho, pero sí un balcón.", "B2 H K L W Y", ""),
    ("Dos dormitorios y un baño; no quiero trastero.", "B2 H K L W", ""),
]  # fmt: skip
NEITHER = [
    ("Two bedrooms and one bathroom please. Neither bedroom should be next to the kitchen, and the kitchen should "
     "be at the back of the flat.", "B2 H K L W", "apart B1 K1, apart B2 K1, position K1 back"),
    ("Two bedrooms, one bathroom. Neither of the bedrooms should be next to the kitchen.", "B2 H K L W",
     "apart B1 K1, apart B2 K1"),
    ("Two bedrooms. Neither bedroom may adjoin the living room.", "B2 H K L W", "apart B1 L1, apart B2 L1"),
    ("Two bedrooms, two bathrooms. Neither bathroom should be beside the kitchen.", "B2 H K L W2",
     "apart W1 K1, apart W2 K1"),
    ("Two bedrooms. Neither bedroom should face the north.", "B2 H K L W", ""),
    ("Three bedrooms, one bathroom. None of the bedrooms should be next to the kitchen.", "B3 H K L W",
     "apart B1 K1, apart B2 K1, apart B3 K1"),
]  # fmt: skip
HAS_GOT = [
    ("Please make a home for my grandparents. It has one bedroom and one bathroom. It hasn't got a study, but it "
     "has got a balcony. You go to the balcony from the bedroom. On the balcony there are two balcony chairs.",
     "B H K L W Y", "Y1 has 2 balcony_chair, B1Y1"),
    ("The flat hasn't got a balcony, but it's got a study. One bedroom.", "B H K L S W", ""),
    ("It hasn't got a dining room. Two bedrooms and one bathroom.", "B2 H K L W", ""),
    ("My flat has got two bedrooms and hasn't got a balcony.", "B2 H K L W", ""),
    ("Two bedrooms. The flat has not got a study.", "B2 H K L W", ""),
    ("Two bedrooms. We haven't got a utility room, but we have got a storage room.", "B2 H K L T W", ""),
    ("It hasn't a study, but it has a balcony. One bedroom.", "B H K L W Y", ""),
]  # fmt: skip
NO_BATH = [
    ("A flat for my dad, who uses a wheelchair: one bedroom of at least 16 m², one bathroom of at least 7 m² with a "
     "shower and no bath, a living room and a kitchen. The building must have a lift.", "B H K L W",
     "at_least B1 16, at_least W1 7, W1 has 1 shower, W1 has 0 bath"),
    ("One bedroom, a kitchen, a living room and a bathroom with a shower but no bath.", "B H K L W",
     "W1 has 1 shower, W1 has 0 bath"),
    ("Two bedrooms. The bathroom has a shower and a toilet but no bath.", "B2 H K L W",
     "W1 has 1 shower, W1 has 1 toilet, W1 has 0 bath"),
    ("A flat with one bedroom and one bathroom with a walk-in shower, no bath.", "B H K L W", "W1 has 0 bath"),
    ("Two bedrooms, one bathroom with a bath and no shower.", "B2 H K L W", "W1 has 1 bath, W1 has 0 shower"),
]  # fmt: skip
TO_THE_OFFICE = [
    ("Could you plan a home for my sister and me? We each want our own bedroom with our own bathroom opening off it. "
     "Plus a guest toilet off the hall, a kitchen and a living room. No study, we both go to the office.",
     "B2 H K L W3", "B1W1, B2W2, H1W3"),
    ("Two bedrooms, no study: we go to the office every day.", "B2 H K L W", ""),
    ("Two bedrooms. We don't need a study because my wife works at the office.", "B2 H K L W", ""),
    ("One bedroom. No gym, I go to the gym.", "B H K L W", ""),
    ("Two bedrooms. I work in an office downtown, so no study.", "B2 H K L W", ""),
    ("Two bedrooms and an office. You go to the office from the living room.", "B2 H K L S W", "L1S1"),
    ("Two bedrooms, an office where I work.", "B2 H K L S W", ""),
]  # fmt: skip
LARGEST_AND = [
    ("We evaluate manipulation in kitchens. Sample a one-bedroom flat with one bathroom, a kitchen and a living room. "
     "The kitchen is the largest room of the flat and has an island, a dishwasher, an oven and a hob.", "B H K L W",
     "order K1 largest, K1 has 1 island, K1 has 1 dishwasher, K1 has 1 oven, K1 has 1 hob"),
    ("We study navigation in hallways. A two-bedroom flat.", "B2 H K L W", ""),
    ("The bedroom is the smallest room of the flat and has a single bed. One bedroom.", "B H K L W",
     "order B1 smallest, B1 has 1 single_bed"),
    ("We test rearrangement in bathrooms. Give me a flat with two bedrooms and one bathroom.", "B2 H K L W", ""),
    ("Two bedrooms. The living room is the biggest room in the home and has two sofas and a piano.", "B2 H K L W",
     "order L1 largest, L1 has 2 sofa, L1 has 1 piano"),
]  # fmt: skip

test_a_room_in_the_name_of_a_task_is_none = as_meant(HEADED)

test_nowhere_denies_a_limit = as_meant(NOWHERE)

test_what_one_wants_not = as_meant(WANT_NOT)

test_storeys_are_no_stores = as_meant(STOREYS)

test_shoe_cabinets_in_five_languages = as_meant(THINGS)

test_close_by_in_chinese = as_meant(CLOSE_BY)

test_a_wall_that_is_left_out = as_meant(WALL)

test_no_queremos = as_meant(NO_QUEREMOS)

test_neither_bedroom_is_next_to_it = as_meant(NEITHER)

test_has_not_got = as_meant(HAS_GOT)

test_a_bathroom_with_a_shower_and_no_bath = as_meant(NO_BATH)

test_an_office_that_one_goes_to_is_no_study = as_meant(TO_THE_OFFICE)

test_rooms_that_a_study_is_about_are_none = as_meant(LARGEST_AND)

"""Rooms told by their place in a list or behind a relation, by their owners, and by who goes from one to another."""

from sentences.facts import as_meant

LAST_TWO = [
    ("Sim-to-real replica of our test flat: a living room (26 m²) with an open kitchen (9 m²), a bedroom (13 m²), a "
     "bathroom (5 m²) and a storage room (3 m²), the last two next to each other.", "B H K L T W",
     "adjacent W1 T1, K1~L1, L1=26, K1=9, B1=13, W1=5, T1=3"),
    ("A living room, a kitchen, a bedroom (13 m²), a bathroom (5 m²) and a utility room (4 m²), the last two adjacent.",
     "B H K L U W", "adjacent W1 U1, B1=13, W1=5, U1=4"),
    ("Living room (24 m²), kitchen (10 m²), bedroom (14 m²), study (9 m²), bathroom (5 m²); the first two next to each "
     "other.", "B H K L S W", "adjacent L1 K1, S1=9"),
    ("A bedroom, a living room, a kitchen 9 m², a bathroom 5 m² and a storage room 3 m², the last two side by side.",
     "B H K L T W", "adjacent W1 T1"),
    ("Two bedrooms; a kitchen, a bathroom and a pantry, the last two far from each other.", "B2 H K L T W",
     "apart W1 T1"),
    ("Three bedrooms and two bathrooms, the last two bedrooms next to each other.", "B3 H K L W2", ""),
]  # fmt: skip
HEADED = [
    ("rooms: living room 25 m², kitchen 10 m², bedroom A 14 m², bedroom B 10 m², bathroom 5 m²\nmust share a wall: "
     "bedroom A and bathroom\nmust not share a wall: bedroom B and kitchen", "B2 H K L W",
     "adjacent B1 W1, apart B2 K1, !apart W1 B2, !apart W1 K1, B1=14"),
    ("Two bedrooms, one bathroom.\nmust be adjacent: kitchen and living room\nmust not be adjacent: bathroom and "
     "kitchen", "B2 H K L W", "adjacent K1 L1, apart W1 K1, !adjacent W1 K1"),
    ("Two bedrooms, a study.\nshare a wall: study and bathroom", "B2 H K L S W", "adjacent S1 W1"),
    ("rooms: bedroom A, bedroom B, kitchen, living room, bathroom\nmust not share a wall: bedroom A and kitchen\nmust "
     "share a wall: bedroom B and bathroom", "B2 H K L W", "adjacent B2 W1, apart B1 K1"),
    ("Two bedrooms, a study.\nadjacent: kitchen and living room, study and bathroom", "B2 H K L S W",
     "adjacent K1 L1, adjacent S1 W1"),
]  # fmt: skip
BEHIND_A_COMMA = [
    ("Agent plan, step 3: apartment with 2 bedrooms; bedroom 1 = 16 m²; bedroom 2 = 12 m²; 1 bathroom, to the east of "
     "the kitchen.", "B2 H K L W", "position W1 K1 east, B1=16, B2=12"),
    ("Two bedrooms; one bathroom, to the north of the living room.", "B2 H K L W", "position W1 L1 north"),
    ("2 bedrooms; 1 study, west of the living room; 1 bathroom.", "B2 H K L S W", "position S1 L1 west"),
    ("bedroom 1 = 16 m²; bedroom 2 = 12 m²; 1 kitchen, to the south of bedroom 1.", "B2 H K L W",
     "position K1 B1 south"),
]  # fmt: skip
ALL_IN_ONE = [
    ("There are three of us, and each wants a bedroom with its own bathroom. Kitchen and living room all in one.",
     "B3 H K L W3", "K1~L1, B1W1, B2W2, B3W3"),
    ("Two bedrooms, one bathroom. The kitchen and the living room are all in one.", "B2 H K L W", "K1~L1"),
    ("Two bedrooms, one bathroom, kitchen and lounge all in one room.", "B2 H K L W", "K1~L1"),
    ("Two bedrooms. Living, dining and cooking all in one.", "B2 D H K L W", "D1~K1, D1~L1"),
    ("Two bedrooms. The kitchen, dining room and living room should be all one space.", "B2 D H K L W",
     "D1~K1, D1~L1"),
    ("Two bedrooms, a living room, dining room and kitchen, all in one.", "B2 D H K L W", "D1~K1, D1~L1"),
]  # fmt: skip
OFF_A_HALL = [
    ("Point-and-click adventure: the bathroom lies between the two bedrooms and is entered from both, and a guest "
     "toilet is off the hall near the entrance. Plus a kitchen and a living room.", "B2 H K L W2",
     "near W2 entrance, !near H1 entrance, B1W1, B2W1"),
    ("Two bedrooms, one bathroom. A guest toilet is off the hall near the entrance.", "B2 H K L W2",
     "near W2 entrance, !near H1 entrance"),
    ("Two bedrooms. The study is off the hallway near the front door.", "B2 H K L S W",
     "near S1 entrance, !near H1 entrance, H1S1"),
    ("Two bedrooms, one bathroom and a storage room, which is off the hall close to the entrance.", "B2 H K L T W",
     "near T1 entrance, !near H1 entrance"),
]  # fmt: skip
STRAIGHT = [
    ("A 2BR scene where the robot can go from the kitchen straight into the living room, and neither bedroom borders "
     "the kitchen.", "B2 H K L W", "K1L1, !K1~L1, apart B1 K1, apart B2 K1"),
    ("Two bedrooms, one bathroom. You can walk from the kitchen directly into the living room.", "B2 H K L W",
     "K1L1, !K1~L1"),
    ("Two bedrooms, one bathroom. One should be able to get from the bedroom straight to the bathroom.", "B2 H K L W",
     "B1W1"),
    ("Two bedrooms. From the kitchen I want to walk straight into the living room.", "B2 H K L W", "K1L1, !K1~L1"),
    ("Two bedrooms. The agent must be able to walk from the dining room straight into the kitchen.", "B2 D H K L W",
     "D1K1, !D1~K1"),
    ("Two bedrooms. You step from the living room directly onto the balcony.", "B2 H K L W Y", "L1Y1"),
]  # fmt: skip
ANEW_WITH = [
    ("Subject: flat for two flatmates\n\nTwo bedrooms of 14 m² each, a kitchen of 9, sorry, 11 m² with a balcony off "
     "it, one bathroom, and a living room with two sofas.", "B2 H K L W Y", "K1Y1, !L1Y1, K1=11, L1 has 2 sofa"),
    ("Two bedrooms, a kitchen of 9, no, 12 m² with a pantry, one bathroom.", "B2 H K L T W", "K1=12, K1T1"),
    ("Two bedrooms, a living room of 20, sorry, 24 m² with a balcony off it and a bathroom.", "B2 H K L W Y",
     "L1=24, L1Y1"),
    ("One bedroom of 12, I mean 14 m² with a desk, one bathroom.", "B H K L W", "B1=14, B1 has 1 desk"),
]  # fmt: skip
KEEP_OURS = [
    ("Mum is moving in with us. She needs a bedroom with an en suite shower room; we keep ours, and the family "
     "bathroom stays off the hallway. No study any more, please.", "B2 H K L W2", "B2W1, H1W2, B1H1, B2H1"),
    ("Grandma lives with us. She gets a bedroom of 14 m² next to the bathroom; we keep ours.", "B2 H K L W",
     "B2=14, adjacent B2 W1"),
    ("My father is coming to live with us. He needs a bedroom near the entrance, and we keep our own. One bathroom.",
     "B2 H K L W", "near B2 entrance"),
    ("Our son is back. He needs a bedroom with a desk; we keep ours. One bathroom, and no study any more.",
     "B2 H K L W", "B2 has 1 desk"),
    ("Dad needs a bedroom of 12 m²; we keep our own. One bathroom.", "B2 H K L W", "B2=12"),
    ("We are done with working from home: no study any more. Two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("Two bedrooms. We need no balcony any longer.", "B2 H K L W", ""),
]  # fmt: skip
RIVALS = [
    ("NPC household: the detective has one bedroom, her lodger has another, and the lodger's bedroom is smaller than "
     "the detective's. One bathroom, a kitchen and a living room.", "B2 H K L W", "order B2 B1 smaller"),
    ("The captain has a bedroom, the cook has another, and the captain's bedroom is larger than the cook's. One "
     "bathroom.", "B2 H K L W", "order B1 B2 larger"),
    ("The wizard has one bedroom, his apprentice has another; the apprentice's bedroom is smaller than the wizard's.",
     "B2 H K L W", "order B2 B1 smaller"),
    ("Two bedrooms: the nurse's bedroom must be smaller than the doctor's, and the doctor's bedroom has a balcony.",
     "B2 H K L W Y", "order B2 B1 smaller, B1Y1"),
    ("Two bedrooms: the landlord's bedroom is larger than the tenant's.", "B2 H K L W", "order B1 B2 larger"),
]  # fmt: skip

test_the_last_two_of_a_list = as_meant(LAST_TWO)

test_relations_that_head_a_line = as_meant(HEADED)

test_a_side_of_another_room_behind_a_comma = as_meant(BEHIND_A_COMMA)

test_all_in_one = as_meant(ALL_IN_ONE)

test_off_a_hall_near_the_entrance = as_meant(OFF_A_HALL)

test_from_one_room_straight_into_another = as_meant(STRAIGHT)

test_an_area_said_anew_before_what_the_room_has = as_meant(ANEW_WITH)

test_her_room_beside_ours = as_meant(KEEP_OURS)

test_whose_of_two_bedrooms_is_larger = as_meant(RIVALS)

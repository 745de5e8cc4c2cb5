"""Rooms among those counted before: whose they are, how large, and what is next to them."""

from sentences.facts import as_meant

EACH_CHILD = [
    ("Mum, dad, Lea (4) and Tom (9): one bedroom for us, one for each of the kids, and two bathrooms, both off the "
     "hallway.", "B3 H K L W2", ""),
    ("Mum, Dad, Anna (3) and Ben (6): a bedroom for us, one for each child, and one bathroom.", "B3 H K L W", ""),
    ("We are two adults with Max (5), Mia (7) and Leo (9): one bedroom for us and one for each of the kids. Two "
     "bathrooms.", "B4 H K L W2", ""),
    ("One bedroom for us, one for each of our children, Tim and Eva. One bathroom.", "B3 H K L W", ""),
    ("One bedroom for the parents, one each for the kids, two bathrooms off the hallway.", "B3 H K L W2", "H1W1, H1W2"),
    ("A bedroom for me, and one for each of my daughters. One bathroom.", "B3 H K L W", ""),
]  # fmt: skip
FLATMATES = [
    ("I sleep by day, so my bedroom should face north; my flatmate's bedroom should face south. One bathroom. We "
     "also want friendly neighbours.", "B2 H K L W", "orientation B1 north, orientation B2 south"),
    ("My bedroom should face west and my roommate's bedroom east. One bathroom.", "B2 H K L W",
     "orientation B1 west, orientation B2 east"),
    ("I want my bedroom at the back and my brother's bedroom near the entrance. One bathroom.", "B2 H K L W",
     "position B1 back, near B2 entrance"),
    ("My room faces the south, my housemate's room faces the north. One bathroom.", "B2 H K L W",
     "orientation B1 south, orientation B2 north"),
    ("My bedroom is next to the bathroom, my flatmate's bedroom next to the kitchen. One bathroom.", "B2 H K L W",
     "adjacent B1 W1, adjacent B2 K1"),
    ("Two bedrooms: my bedroom should be 14 m² and my flatmate's bedroom 12 m².", "B2 H K L W", "B1=14, B2=12"),
]  # fmt: skip
AGAIN_SIZED = [
    ("2x bedroom, 1x bathroom, 1x kitchen, 1x living room, 1x hallway. Kitchen 9 m², bedrooms 12 m² and 10 m², "
     "bathroom at most 5 m².", "B2 H K L W", "B1=12, B2=10, K1=9, at_most W1 5"),
    ("3x bedroom, 2x bathroom, 1x kitchen, 1x living room. Bedrooms 14 m², 12 m² and 10 m².", "B3 H K L W2",
     "B1=14, B2=12, B3=10"),
    ("2x bedroom, 1x bathroom. Bathroom 5 m², bedrooms 13 m² and 11 m².", "B2 H K L W", "B1=13, B2=11, W1=5"),
    ("2 bedrooms, 1 bathroom, 1 kitchen. Kitchen 8 m², bedrooms 12 and 10 m².", "B2 H K L W", "B1=12, B2=10, K1=8"),
    ("1x kitchen, 2x bedroom, 2x bathroom. Bathrooms 6 m² and 4 m².", "B2 H K L W2", "W1=6, W2=4"),
    ("2 x bedroom, 1 x bathroom, 1 x kitchen. Kitchen: 9 m². Bedrooms: 14 m² and 12 m².", "B2 H K L W",
     "B1=14, B2=12, K1=9"),
]  # fmt: skip
HERS = [
    ("Hello, I saw your advert. My husband and I are after a flat with two bedrooms, sorry, three, because my "
     "mother is moving in with us, and one bathroom. Mum's bedroom has to be next to the bathroom.", "B3 H K L W",
     "adjacent B3 W1"),
    ("We want a flat with two bedrooms, sorry, three, since my father lives with us, and one bathroom. Dad's "
     "bedroom has to be near the entrance.", "B3 H K L W", "near B3 entrance"),
    ("A flat with three bedrooms because grandma lives with us, and one bathroom. Grandma's room should be next to "
     "the bathroom.", "B3 H K L W", "adjacent B3 W1"),
    ("Three bedrooms, one bathroom. Mum's bedroom has to be next to the bathroom.", "B3 H K L W", "adjacent B3 W1"),
    ("My wife and I need two bedrooms, no, three, as our son comes too, and one bathroom.", "B3 H K L W", ""),
    ("We are looking for three, sorry, four bedrooms, because my aunt is moving in, and two bathrooms.", "B4 H K L W2",
     ""),
]  # fmt: skip
MAKE_IT = [
    ("Hi, it's me again about the plans. So the kitchen, we said ten square metres, no, let's make it twelve, and "
     "the living room stays at twenty-five square metres. Two bedrooms and one bathroom, that's still right. "
     "Thanks, bye!", "B2 H K L W", "K1=12, L1=25"),
    ("Two bedrooms. The kitchen, we said 10 square metres, no, make it 12.", "B2 H K L W", "K1=12"),
    ("Two bedrooms. For the living room we said 20 m², but let's make it 24.", "B2 H K L W", "L1=24"),
    ("Two bedrooms. The bathroom was to have five square metres; let's make that six.", "B2 H K L W", "W1=6"),
    ("Two bedrooms; kitchen nine square metres, no, let's say eleven, and the living room stays at thirty square "
     "metres.", "B2 H K L W", "K1=11, L1=30"),
    ("Two bedrooms. The kitchen has 8 m², no wait, let's make it ten.", "B2 H K L W", "K1=10"),
]  # fmt: skip
SHARED = [
    ("We are looking for three bedrooms and one bathroom. Our two boys share a bedroom, with a bunk bed and two "
     "desks in it, and our daughter gets her own. The boys' bedroom should be larger than our daughter's.",
     "B3 H K L W", "B3 has 1 bunk_bed, B3 has 2 desk, order B3 B2 larger"),
    ("Three bedrooms, one bathroom. The two girls share a bedroom and our son gets his own.", "B3 H K L W", ""),
    ("We want three bedrooms. The boys share one, with a bunk bed in it, and our daughter has her own.", "B3 H K L W2",
     "B3 has 1 bunk_bed"),
    ("Three bedrooms, one bathroom. Our two boys share a bedroom, our daughter has her own bedroom. The boys' "
     "bedroom should be larger than our daughter's.", "B3 H K L W", "order B3 B2 larger"),
    ("Two bedrooms, one bathroom. Our two kids share a bedroom with two single beds in it.", "B2 H K L W",
     "B2 has 2 single_bed"),
    ("Two bedrooms; grandma's bedroom should be smaller than our son's.", "B2 H K L W", "order B2 B1 smaller"),
]  # fmt: skip
DESCRIBED = [
    ("You asked who sleeps where: my parents sleep in the bedroom with the en suite, Tom in the bedroom next to "
     "the kitchen and Lily in the third bedroom. Two bathrooms altogether.", "B3 H K L W2", "adjacent B2 K1, B1W1"),
    ("Three bedrooms, two bathrooms. We sleep in the bedroom with the en suite, Max in the bedroom next to the "
     "kitchen and Ida in the third bedroom.", "B3 H K L W2", "B1W1, adjacent B2 K1"),
    ("Two bedrooms. My parents sleep in the main bedroom, I in the bedroom next to the bathroom.", "B2 H K L W",
     "adjacent B2 W1"),
    ("Three bedrooms, one bathroom. We sleep in the main bedroom, our son in the bedroom next to the kitchen and "
     "our daughter in the bedroom next to the bathroom.", "B3 H K L W", "adjacent B2 K1, adjacent B3 W1"),
    ("Three bedrooms, two bathrooms: the bedroom with the en suite, the bedroom next to the kitchen, and the third "
     "bedroom.", "B3 H K L W2", "B1W1, adjacent B2 K1"),
    ("Three bedrooms, two bathrooms. The parents have the bedroom with the en suite, the girls the bedroom "
     "opposite the kitchen.", "B3 H K L W2", "B1W1, opposite B2 K1"),
]  # fmt: skip
THATS_ALL = [
    ("I love having breakfast in the morning sun, so the kitchen should face east. The living room should face "
     "west. Two bedrooms, one bathroom, that's all.", "B2 H K L W", "orientation K1 east, orientation L1 west"),
    ("Two bedrooms, one bathroom, thanks, that's all.", "B2 H K L W", ""),
    ("The kitchen should face south. Two bedrooms, one bathroom, that is all.", "B2 H K L W", "H1K1"),
    ("Kitchen, bathroom and bedroom, that's all.", "B K W", ""),
]  # fmt: skip
ONE_ROOM = [
    ("Single-room environment: a kitchen of 14 m2 with an island and three stools.", "K",
     "K1 has 1 island, K1 has 3 stool, K1=14"),
    ("One-room scene: a bathroom of 6 m² with a washing machine.", "W", "W1=6, W1 has 1 washing_machine"),
    ("Single-room scene, a bedroom of 15 m² with a double bed and a desk.", "B", "B1=15, B1 has 1 desk"),
    ("One room only: a kitchen, 12 m², with a dining table.", "K", "K1=12, K1 has 1 dining_table"),
    ("A single room: a living room of 20 m2 with a sofa.", "L", "L1=20"),
    ("I want an environment of a single room, a kitchen of 10 m2.", "K", "K1=10"),
]  # fmt: skip
OPEN_TO = [
    ("A flat with two bedrooms and a dining room open to the living room.", "B2 D H K L W", "D1~L1, B1H1, B2H1"),
    ("A flat with two bedrooms and a kitchen open to the living room.", "B2 H K L W", "K1~L1, B1H1, B2H1"),
    ("Three bedrooms, two bathrooms and a kitchen open to the living room.", "B3 H K L W2", "K1~L1, B2H1, H1W2"),
]  # fmt: skip
STRAIGHT = [
    ("We don't need a hallway: the entrance can open straight into the living room. Two bedrooms, one bathroom.",
     "B2 K L W", "B1L1, L1W1"),
    ("Two bedrooms. The kitchen opens directly onto the living room.", "B2 H K L W", "K1L1"),
    ("Quiero que el baño no dé al salón. Dos dormitorios.", "B2 H K L W", "no_door W1 L1"),
]  # fmt: skip
ROUGHLY = [
    ("Two bedrooms, one bathroom, a living room of roughly 20 and a kitchen of roughly 10 square metres.", "B2 H K L W",
     "L1=20, K1=10"),
    ("Two bedrooms of about 14 and 11 m², a kitchen of around 9.", "B2 H K L W", "B1=14, B2=11, K1=9"),
    ("There should be nothing but a bed and a desk in the guest room. Two bedrooms.", "B2 H K L W",
     "B2 has 1 desk, B2 has 1 double_bed"),
]  # fmt: skip
NOT_SMALL = [
    ("I want a flat with a living room, not too small, say 22 square metres, and two bedrooms.", "B2 H K L W",
     "L1=22, !all=22"),
    ("Two bedrooms. The living room should be spacious, say 22 square metres.", "B2 H K L W", "L1=22"),
    ("The flat has two bedroom. In first bedroom is one double bed, in second bedroom are two single beds.",
     "B2 H K L W", "B1 has 1 double_bed, B2 has 2 single_bed"),
]  # fmt: skip
NEAR_ENTRANCE = [
    ("Two bedrooms - no, wait, three, the twins want a room each now. One bathroom for all of us and a guest WC "
     "near the entrance, both off the hall. Kitchen and living room as well.", "B3 H K L W2",
     "near W2 entrance, !near W1 entrance, !near B2 entrance, !near B3 entrance, H1W1, H1W2"),
    ("Three bedrooms, since the boys want a room each. One bathroom for everybody and a toilet near the front door.",
     "B3 H K L W2", "near W2 entrance, !near B2 entrance, !near B3 entrance"),
    ("Two bedrooms, one bathroom for the family and a study close to the entrance.", "B2 H K L S W",
     "near S1 entrance, !near B1 entrance"),
    ("Three bedrooms, and the girls get a room each. A bathroom for the five of us and a guest toilet at the entrance.",
     "B3 H K L W2", "near W2 entrance, !near B2 entrance, !near B3 entrance"),
    ("Two bedrooms for our two sons. One bathroom for all and a store near the front door.", "B2 H K L T W",
     "near T1 entrance, !near W1 entrance, !near B1 entrance, !near B2 entrance"),
]  # fmt: skip
ZU_JE = [
    ("Senioren-WG: vier Schlafzimmer zu je 14 m², zwei Bäder, beide nur vom Flur aus, eine Küche, ein Wohnzimmer mit "
     "Balkon. Der Balkon geht nach Süden.", "B4 H K L W2 Y",
     "H1W1, H1W2, B1=14, B2=14, B3=14, B4=14, L1Y1, orientation Y1 south"),
    ("Drei Schlafzimmer mit je 12 m², zwei Bäder, beide nur vom Flur aus zugänglich.", "B3 H K L W2",
     "H1W1, H1W2, B1=12, B2=12, B3=12"),
    ("Three bedrooms of 12 m² each, two bathrooms, both from the hall only, a kitchen and a living room.",
     "B3 H K L W2", "H1W1, H1W2, B1=12, B2=12, B3=12"),
    ("Drei Schlafzimmer zu je 13 m² und zwei Bäder, beide vom Flur aus.", "B3 H K L W2", "H1W1, H1W2, B1=13, B3=13"),
    ("Trois chambres de 12 m² chacune, deux salles de bains, toutes deux accessibles seulement depuis le couloir.",
     "B3 H K L W2", "H1W1, H1W2, B1=12, B2=12, B3=12"),
]  # fmt: skip
TABLES = [
    ("| Room | Area (m²) |\n|---|---|\n| Hallway | 7 |\n| Living room | 22 |\n| Kitchen | 9.5 |\n| Bedroom 1 | 13 |\n"
     "| Bedroom 2 | 11 |\n| Bathroom | 5.5 |", "B2 H K L W", "H1=7, L1=22, K1=9.5, B1=13, B2=11, W1=5.5"),
    ("Plan this flat:\n\n| Space | Size [sqm] |\n| :--- | ---: |\n| Living room | 24 |\n| Kitchen | 10 |\n"
     "| Bedroom | 14 |\n| Bathroom | 6 |\n| Hall | 5 |", "B H K L W", "L1=24, K1=10, B1=14, W1=6, H1=5"),
    ("| room | m2 |\n|------|----|\n| kitchen | 8 |\n| living room | 20 |\n| bedroom 1 | 12 |\n| bedroom 2 | 10 |\n"
     "| bathroom | 5 |", "B2 H K L W", "K1=8, L1=20, B1=12, B2=10, W1=5"),
    ("Room | Area\n--- | ---\nLiving room | 21 m²\nKitchen | 9 m²\nBedroom | 13 m²\nBathroom | 5 m²\n", "B H K L W",
     "L1=21, K1=9, B1=13, W1=5"),
    ("| Raum | Fläche (m²) |\n|---|---|\n| Flur | 6 |\n| Wohnzimmer | 23 |\n| Küche | 9 |\n| Schlafzimmer | 14 |\n"
     "| Bad | 6 |", "B H K L W", "H1=6, L1=23, K1=9, B1=14, W1=6"),
    ("| Room | Count |\n|---|---|\n| Bedroom | 3 |\n| Bathroom | 2 |\n| Kitchen | 1 |\n| Living room | 1 |",
     "B3 H K L W2", ""),
    ("| Room | m² | Faces |\n|:--|--:|--|\n| Living room | 24 | south |\n| Kitchen | 9 | east |\n| Bedroom | 13 | - |\n"
     "| Bathroom | 5 | - |", "B H K L W", "L1=24, K1=9, B1=13, W1=5, orientation L1 south, orientation K1 east"),
    ("Build me this:\n| Name | Area |\n| --- | --- |\n| Living room | 20 |\n| Kitchen | 8 |\n| Bedroom | 12 |\n"
     "| Bathroom | 4 |\nThe kitchen is open to the living room.", "B H K L W", "L1=20, K1=8, B1=12, W1=4, K1~L1"),
    ("| # | Room | Area (sqm) |\n|---|---|---|\n| 1 | Living room | 22 |\n| 2 | Kitchen | 10 |\n| 3 | Bedroom | 13 |\n"
     "| 4 | Bathroom | 5 |", "B H K L W", "L1=22, K1=10, B1=13, W1=5"),
]  # fmt: skip
LINES = [
    ("living_room: 25 m², faces south\nkitchen: 9 m², faces north\nbedroom: 13 m², faces east\nbathroom: 5 m²\n"
     "hallway: 6 m²", "B H K L W",
     "L1=25, K1=9, B1=13, W1=5, H1=6, orientation L1 south, orientation K1 north, orientation B1 east, H1W1, B1H1"),
    ("living room: 20 m2, facing west\nkitchen: 8 m2, facing east\nbedroom: 12 m2\nbathroom: 4 m2\nhall: 5 m2",
     "B H K L W", "L1=20, H1=5, orientation L1 west, orientation K1 east"),
    ("- living room: 22 m², looks south\n- kitchen: 9 m², next to the living room\n- bedroom: 12 m²\n"
     "- bathroom: 5 m²\n- hallway: 7 m²", "B H K L W", "L1=22, orientation L1 south, K1L1, H1=7"),
    ("Kitchen: 10 sqm, faces east. Living room: 24 sqm, faces south. Bedroom: 13 sqm, faces north. Bathroom: 5 sqm.",
     "B H K L W", "orientation K1 east, orientation L1 south, orientation B1 north, W1=5"),
    ("Wohnzimmer: 24 m², nach Süden\nKüche: 10 m², nach Norden\nSchlafzimmer: 14 m²\nBad: 6 m²\nFlur: 6 m²",
     "B H K L W", "L1=24, orientation L1 south, orientation K1 north, H1=6"),
    ("Living room - 22 m², facing south\nKitchen - 9 m², facing east\nBedroom - 12 m², facing north\nBathroom - 5 m²",
     "B H K L W", "L1=22, W1=5, orientation L1 south, orientation K1 east, orientation B1 north"),
]  # fmt: skip
EACH_OF_TWO = [
    ("A home for my mother and me. We each need a bedroom with a bathroom of our own.", "B2 H K L W2", "B1W1, B2W2"),
    ("A flat for my brother and me: each of us wants a bedroom with an ensuite.", "B2 H K L W2", "B1W1, B2W2"),
    ("Plan something for my friend and me. We each get our own bedroom with our own shower room. A guest toilet off "
     "the hall.", "B2 H K L W3", "B1W1"),
    ("It is for my cousin and me, and we each want our own bedroom with its own bathroom.", "B2 H K L W2",
     "B1W1, B2W2"),
]  # fmt: skip
ENSUITE_THINGS = [
    ("Principal bedroom with a dressing room reached only from it and an ensuite with a bath, a shower and two "
     "washbasin vanities. A second bedroom, a family bathroom off the hall, a kitchen, a living room.",
     "B2 C H K L W2", "B1C1, B1W1, W1 has 2 vanity, W1 has 1 bath, W1 has 1 shower, H1W2"),
    ("Two bedrooms, the first with an ensuite with a bath and two vanities. One family bathroom.", "B2 H K L W2",
     "B1W1, W1 has 2 vanity, W1 has 1 bath"),
    ("A flat with one bedroom and a bathroom with two washbasins.", "B H K L W", "W1 has 2 vanity"),
    ("One bedroom; the bathroom has two basin vanities and a bath.", "B H K L W", "W1 has 2 vanity, W1 has 1 bath"),
    ("One bedroom; the bathroom gets a vanity unit and a washbasin vanity.", "B H K L W", "W1 has 2 vanity"),
]  # fmt: skip
WET_WALL = [
    ("Both bedrooms at the back of the flat, the living room at the front. One bathroom and one kitchen, which share a "
     "wet wall. The flat must not be larger than 75 m².", "B2 H K L W",
     "adjacent W1 K1, position B1 back, position B2 back, position L1 front, at_most home 75"),
    ("Two bedrooms. The kitchen and the bathroom share one wet wall.", "B2 H K L W", "adjacent K1 W1"),
    ("Two bedrooms; the bathroom shares its wet wall with the kitchen.", "B2 H K L W", "adjacent W1 K1"),
    ("One bedroom. The bathroom and the kitchen should have a common wall.", "B H K L W", "adjacent W1 K1"),
    ("Two bedrooms. Kitchen and bathroom must share a plumbing wall.", "B2 H K L W", "adjacent K1 W1"),
    ("Two bedrooms. Bathroom and kitchen back onto the same wet wall.", "B2 H K L W", "adjacent W1 K1"),
    ("Two bedrooms and two bathrooms which share a wet wall.", "B2 H K L W2", "adjacent W1 W2"),
    ("Zwei Schlafzimmer. Küche und Bad teilen sich eine Installationswand.", "B2 H K L W", "adjacent K1 W1"),
]  # fmt: skip

test_one_for_each_of_the_kids = as_meant(EACH_CHILD)

test_mine_and_my_flatmates = as_meant(FLATMATES)

test_areas_of_rooms_counted_before = as_meant(AGAIN_SIZED)

test_whose_room_is_told_is_among_those_counted = as_meant(HERS)

test_areas_said_anew_in_words = as_meant(MAKE_IT)

test_children_share_one_of_those_counted = as_meant(SHARED)

test_bedrooms_told_by_what_is_next_to_them = as_meant(DESCRIBED)

test_thats_all_ends_what_is_asked = as_meant(THATS_ALL)

test_a_scene_of_a_single_room = as_meant(ONE_ROOM)

test_one_room_of_a_list_is_open_to_another = as_meant(OPEN_TO)

test_straight_into = as_meant(STRAIGHT)

test_of_roughly = as_meant(ROUGHLY)

test_areas_behind_remarks_and_verbs_before_furniture = as_meant(NOT_SMALL)

test_a_bathroom_for_all_of_us_and_another_near_the_entrance = as_meant(NEAR_ENTRANCE)

test_both_from_the_hall_alone = as_meant(ZU_JE)

test_rows_of_tables = as_meant(TABLES)

test_lines_with_a_side_behind_the_area = as_meant(LINES)

test_my_sister_and_me_we_each_want_one = as_meant(EACH_OF_TWO)

test_two_washbasin_vanities_are_two = as_meant(ENSUITE_THINGS)

test_a_wet_wall_that_two_rooms_share = as_meant(WET_WALL)

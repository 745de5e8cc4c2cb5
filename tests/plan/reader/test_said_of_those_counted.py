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

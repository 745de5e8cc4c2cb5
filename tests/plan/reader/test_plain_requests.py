"""What users ask for in the plainest words: who sleeps where, reasons, shared baths, rooms for helpers, sizes."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

REASONS = [
    ("The bedrooms should be far from the living room because we often have guests late.", "B2 H K L W",
     "apart B1 L1, apart B2 L1"),
    ("One-bedroom flat; the study should be next to the bedroom because our neighbours have parties", "B H K L S W",
     "adjacent S1 B1"),
]  # fmt: skip

test_a_reason_takes_nothing_from_what_is_asked = as_meant(REASONS)

ONE_ROOM = [
    ("Two-room apartment, with a combined living and sleeping room, kitchen and a bath with shower.", "K L W",
     "L1 has 1 double_bed, W1 has 1 shower"),
    ("Flat with a living-bedroom, kitchen and bath.", "K L W", "L1 has 1 double_bed"),
    ("One room for living and sleeping, a kitchen and a bathroom.", "K L W", "L1 has 1 double_bed"),
    ("Wohnung mit Wohn-/Schlafzimmer, Küche und Bad.", "K L W", "L1 has 1 double_bed"),
    ("Appartement avec séjour-chambre, cuisine et salle d'eau.", "K L W", "L1 has 1 double_bed"),
    ("Two bedrooms and a living-sleeping room, kitchen, bath.", "B2 H K L W", "L1 has 1 double_bed"),
    ("Flat with living and sleeping areas, two bedrooms.", "B2 H K L W", "!L1 has 1 double_bed"),
    ("The kitchen should be between the living room and bedroom.", "B H K L W", "!L1 has 1 double_bed"),
    ("Studio with a sleeping corner, a kitchenette and a shower room.", "K L W",
     "L1 has 1 double_bed, !unread sleeping, !unread corner"),
    ("Studio with a sleeping area and a bathroom.", "K L W", "L1 has 1 double_bed"),
    ("Un studio avec un coin nuit, un coin cuisine et une salle d'eau.", "K L W", "!unread coin, !unread nuit"),
    ("Ein Studio mit Schlafecke, Küchenzeile und Duschbad.", "K L W", "!unread schlafecke, !unread kuchenzeile"),
    ("Un estudio con zona de dormir, cocina americana y baño.", "K L W", "!unread zona"),
    ("单间公寓，有睡眠区、厨房和卫生间。", "K L W", "!unread 区"),
]  # fmt: skip

test_rooms_to_live_and_sleep_in = as_meant(ONE_ROOM)

NOTHING = [
    ("Our budget is small, we'd like something with two bedrooms, thanks a lot!", "B2 H K L W",
     "!unread something, !unread lot"),
    ("It is a big house for family of six people, have four bedrooms and three bathrooms.", "B4 H K L W3",
     "!unread people"),
]  # fmt: skip

test_what_means_nothing_is_not_told = as_meant(NOTHING)

THINGS = [
    ("A flat of two bedrooms with an island.", "B2 H K L W", "K1 has 1 island, !B1 has 1 island"),
    ("Un appartement de deux chambres avec un îlot central.", "B2 H K L W", "K1 has 1 island"),
    ("Un piso de dos dormitorios con una isla de cocina y un horno.", "B2 H K L W", "K1 has 1 island, K1 has 1 oven"),
    ("A flat of two bedrooms with a desk.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
]  # fmt: skip

test_furniture_of_a_home_stands_in_rooms_it_is_for = as_meant(THINGS)

SLEEPERS = [
    ("The parents sleep in the big bedroom and the three boys sleep in the other one.", "B2 H K L W", "!unread boys"),
    ("The parents sleep in the large bedroom, the two girls sleep in the small one.", "B2 H K L W", "B2=8.25"),
    ("Two bedrooms: my wife and I sleep in one and our three boys sleep in the other.", "B2 H K L W", "!unread boys"),
    ("Two bedrooms: the parents sleep in one and the two kids sleep in the other.", "B2 H K L W", "!unread kids"),
    ("Three bedrooms. My husband and I have the biggest, our son has the second one, and our daughters share the "
     "third.", "B3 H K L W2", ""),
    ("Die Eltern schlafen im großen Schlafzimmer, die zwei Jungs im kleinen.", "B2 H K L W", "!unread jungs"),
    ("Les parents dorment dans la grande chambre et les trois enfants dans la petite.", "B2 H K L W",
     "!unread enfants"),
    ("Los padres duermen en el dormitorio grande y los tres niños en el pequeño.", "B2 H K L W", "!unread ninos"),
    ("父母睡主卧，两个孩子睡次卧。", "B2 H K L W", "!unread 孩"),
    ("三室一厅，父母睡主卧，孩子睡小房间，奶奶睡客房。", "B3 H K L W2", "!unread 奶"),
]  # fmt: skip

test_who_sleeps_where = as_meant(SLEEPERS)


@pytest.mark.parametrize(("prompt", "children"), [
    ("The parents sleep in the big bedroom and the three boys sleep in the other one.", [None, 3]),
    ("Two bedrooms: the parents sleep in one and the two kids sleep in the other.", [None, 2]),
    ("Los padres duermen en el dormitorio grande y los tres niños en el pequeño.", [None, 3]),
    ("父母睡主卧，两个孩子睡次卧。", [None, 2]),
])  # fmt: skip
def test_children_are_counted_where_they_sleep(prompt: str, children: list[int | None]) -> None:
    assert [room.children for room in read(prompt).rooms if room.type == "bedroom"] == children

HELPERS = [
    ("A flat for a family of four with a guest room.", "B4 H K L W2", "B4=11"),
    ("A flat for a family of four with a maid's room.", "B4 H K L W2", "B4=8"),
    ("Eine Wohnung für eine vierköpfige Familie mit Gästezimmer.", "B4 H K L W2", ""),
    ("A flat for three students with a guest room.", "B4 H K L W2", ""),
    ("A flat for an elderly couple and a room for a caregiver.", "B2 H K L W", "!unread caregiver"),
    ("Home for an elderly couple with separate bedrooms, one accessible bathroom and a room for a caregiver.",
     "B3 H K L W", "unread accessible, !unread caregiver"),
    ("Two bedrooms and a room for a live-in carer.", "B3 H K L W2", "!unread live"),
    ("Zwei Schlafzimmer und ein Zimmer für die Pflegerin.", "B3 H K L W2", "!unread pflegerin"),
    ("Deux chambres et une chambre pour l'aide-soignante.", "B3 H K L W2", "!unread soignante"),
    ("Dos dormitorios y una habitación para la cuidadora.", "B3 H K L W2", "!unread cuidadora"),
    ("A room for toys and two bedrooms.", "B2 H K L S W", "!unread toys"),
]  # fmt: skip

test_guests_and_helpers_sleep_beside_those_who_live_there = as_meant(HELPERS)

BESIDE = [
    ("La chambre des parents a sa propre salle de bain, et les deux enfants partagent une chambre à côté.",
     "B2 H K L W2", "B1W1, H1W2, adjacent B2 B1, !unread cote"),
    ("La chambre principale a sa propre salle de bain, et les deux enfants partagent une chambre.", "B2 H K L W2",
     "B1W1, H1W2"),
    ("Das Elternschlafzimmer hat ein eigenes Bad, das Kinderzimmer liegt direkt daneben.", "B2 H K L W2",
     "B1W1, adjacent B2 B1"),
    ("The parents' bedroom has its own bathroom and the nursery is next door.", "B2 H K L W2", "adjacent B2 B1"),
    ("El dormitorio principal tiene baño propio y el cuarto de los niños está al lado.", "B2 H K L W2",
     "adjacent B2 B1"),
    ("Ein Wohnzimmer mit Balkon, daneben die Küche, und zwei Schlafzimmer.", "B2 H K L W Y", "K1L1, L1Y1, !K1Y1"),
    ("A living room with a large balcony, next to it the kitchen, and two bedrooms.", "B2 H K L W Y",
     "K1L1, L1Y1, !K1Y1"),
    ("Un salon avec balcon, à côté la cuisine, et deux chambres.", "B2 H K L W Y", "K1L1, L1Y1, !K1Y1"),
    ("Un salón con balcón, al lado la cocina, y dos dormitorios.", "B2 H K L W Y", "K1L1, L1Y1, !K1Y1"),
    ("Ein Schlafzimmer mit Bad, daneben ein Arbeitszimmer.", "B H K L S W", "adjacent S1 B1, !adjacent S1 W1"),
    ("A hall, a bedroom, next to it a bathroom, and a kitchen.", "B H K L W", "adjacent W1 B1"),
]  # fmt: skip

test_beside_which_room = as_meant(BESIDE)

CHILDREN = [
    ("The master bedroom has its own bathroom; the children share the other bathroom.", "B3 H K L W2", "B1W1, H1W2"),
    ("El dormitorio principal tiene baño propio y vestidor; los niños comparten el otro baño.", "B3 C H K L W2",
     "B1C1, B1W1, H1W2, !unread ninos"),
    ("Das Elternschlafzimmer hat ein eigenes Bad, die Kinder teilen sich das andere Bad.", "B3 H K L W2", "B1W1"),
    ("Three bedrooms. The master has its own bathroom; the kids share the other bathroom.", "B3 H K L W2", "B1W1"),
    ("The master bedroom has an ensuite. The kids should have a bathroom near their rooms.", "B3 H K L W2",
     "adjacent W2 B2, adjacent W2 B3"),
    ("A home for a family with kids.", "B3 H K L W2", "!unread kids"),
    ("Un appartement pour une famille avec des enfants.", "B3 H K L W2", ""),
    ("A family with a baby.", "B2 H K L W", ""),
    ("Wohnung für eine vierköpfige Familie: Wohnzimmer 25 m², Küche 12 m², zwei Kinderzimmer je 12 m², kein "
     "Esszimmer.", "B3 H K L W2", "B2=12, B3=12, L1=25, K1=12"),
]  # fmt: skip

test_children_live_with_their_parents = as_meant(CHILDREN)

BETWEEN = [
    ("A bedroom in the north-east corner, a kitchen in the south-west, and a living room in between.", "B H K L W",
     "position B1 north_east, adjacent L1 B1, adjacent L1 K1"),
    ("The bathroom is between the kitchen and the bedroom.", "B H K L W",
     "adjacent W1 K1, adjacent W1 B1, H1W1, !K1W1, !B1W1"),
    ("The kitchen is at the front, the bedroom at the back, and the bathroom in between.", "B H K L W",
     "adjacent W1 K1, adjacent W1 B1, !K1W1"),
    ("A living room, a kitchen, two bedrooms and a bathroom in between.", "B2 H K L W", "B1W1, B2W1"),
    ("Two-bedroom flat, the bathroom lies between the two bedrooms.", "B2 H K L W", "B1W1, B2W1"),
]  # fmt: skip

test_what_lies_between = as_meant(BETWEEN)

WHICH = [
    ("The kitchen which is open to the living room, has 12 m²", "K L", "K1=12, K1~L1"),
    ("One-bedroom flat. The bathroom which is next to the kitchen has 6 m².", "B H K L W", "W1=6, adjacent W1 K1"),
    ("The bedroom which has a balcony is 15 m². Two bedrooms.", "B2 H K L W Y", "B1=15, Y1=5"),
    ("The living room that faces south is 30 m². Two bedrooms.", "B2 H K L W", "L1=30, !all=30"),
    ("A flat with a living room which is next to a kitchen which has 12 m².", "B2 H K L W", "K1=12"),
    ("Die Küche, die zum Wohnzimmer offen ist, hat 12 m².", "K L", "K1=12, K1~L1"),
    ("La cuisine, qui est ouverte sur le salon, fait 12 m².", "K L", "K1=12"),
    ("La cocina, que está abierta al salón, tiene 12 m².", "K L", "K1=12"),
]  # fmt: skip

test_a_size_behind_a_relative_clause = as_meant(WHICH)

LISTS = [
    ("living 25, kitchen 10, bedroom 14, bath 5, storage 2", "B H K L T W", "L1=25, K1=10, B1=14, W1=5, T1=2"),
    ("Flat: bedroom 12, bedroom 10, kitchen 8, living 20, wc 2, bath 5, hall 3.", "B2 H K L W2",
     "B1=12, B2=10, K1=8, L1=20, W1=2, W2=5, H1=3"),
    ("Flat: living room 24, kitchen 8, 2 bedrooms 12, bath 4, storage 2.", "B2 H K L T W", "B1=12, B2=12, T1=2"),
    ("Three bedrooms 12, 11 and 10, kitchen 9.", "B3 H K L W2", "B1=12, B2=11, B3=10, K1=9"),
    ("Rooms: living 22 kitchen 8 bedroom 12 bath 4 balcony 3.", "B H K L W Y", "L1=22, K1=8, B1=12, W1=4, Y1=3"),
    ("bedroom 2 bath 2 living 25 storage 2", "B2 H K L T2 W2", "L1=25"),
    ("bedroom 2, bathroom 1, kitchen 1", "B2 H K L W", ""),
    ("living 25, kitchen 10, bedroom 2, bath 2", "B2 H K L W2", "L1=25, K1=10"),
    ("2 bed 1 bath 1 living 1 balcony", "B2 H K L W Y", ""),
]  # fmt: skip

test_numbers_in_lists_of_rooms = as_meant(LISTS)

OTHERS = [
    ("Three bedrooms and three bathrooms: the master has an ensuite, the others share two.", "B3 H K L W3",
     "B1W1, H1W2, H1W3"),
    ("Four bedrooms: one has its own bathroom, the others share two bathrooms.", "B4 H K L W3", "B1W1, H1W2, H1W3"),
    ("Four bedrooms: one has its own bathroom, the others share two.", "B4 H K L W3", "!B2B3"),
    ("Five bedrooms, the master has an ensuite, the other four share two bathrooms.", "B5 H K L W3", "H1W2, H1W3"),
    ("Vier Schlafzimmer, eines hat ein eigenes Bad, die anderen drei teilen sich zwei Bäder.", "B4 H K L W3",
     "B1W1, H1W2, H1W3"),
    ("Quatre chambres, la chambre principale a sa propre salle de bain, les autres partagent deux salles de bains.",
     "B4 H K L W3", "B1W1, H1W2, H1W3"),
    ("Cuatro dormitorios, el principal tiene baño propio y los demás comparten dos baños.", "B4 H K L W3", "B1W1"),
]  # fmt: skip

test_baths_that_the_others_share = as_meant(OTHERS)

DOORS = [
    ("Every room has two doors. A two-bedroom flat.", "B2 H K L W",
     "at_least L1 doors 2, at_least K1 doors 2, at_least B1 doors 2, at_least B2 doors 2"),
    ("A two-bedroom flat, each room connects to two others.", "B2 H K L W", "at_least L1 doors 2, at_least B2 doors 2"),
    ("A two-bedroom flat; each room should have doors to two other rooms.", "B2 H K L W", "at_least B1 doors 2"),
    ("A two-bedroom flat, every room has a door to the hall.", "B2 H K L W", "!at_least B1 doors 2"),
]  # fmt: skip

test_doors_of_every_room = as_meant(DOORS)

BABIES = [
    ("Our bedroom and the baby's are next to each other.", "B2 H K L W", "adjacent B1 B2"),
    ("We need our bedroom, the baby's, a bathroom and a kitchen.", "B2 H K L W", "!unread baby's"),
    ("Two bedrooms: ours 16 m², the baby's 9 m².", "B2 H K L W", "B1=16, B2=9"),
    ("My son's and my daughter's rooms are next to each other.", "B2 H K L W", "adjacent B1 B2"),
]  # fmt: skip

test_rooms_of_babies = as_meant(BABIES)


@pytest.mark.parametrize(("prompt", "told"), [
    ("Un appartement, le couloir ne doit pas faire plus de 5 m de long, la cuisine au maximum 10 m².",
     ["couloir au plus 5 m de long", "cuisine au plus 10 m²"]),
    ("Un piso, la cocina no debe medir más de 10 m² y el baño está al lado del dormitorio.",
     ["cocina como máximo 10 m²", "baño junto a dormitorio"]),
    ("Die Küche mindestens 9 m², zwei Schlafzimmer.", ["Küche mindestens 9 m²"]),
    ("厨房至少10平方米，两个卧室。", ["厨房 至少 10 m²"]),
    ("The kitchen at least 9 m², the hall no longer than 5 m, two bedrooms.",
     ["hall no longer than 5 m", "kitchen at least 9 m²"]),
])  # fmt: skip
def test_requirements_are_told_in_the_language_of_their_prompt(prompt: str, told: list[str]) -> None:
    assert [asked.text for asked in read(prompt).requirements] == told

ONE_EACH = [
    ("1 bedroom, 1 bathroom", "B H K L W", ""), ("One bedroom and one bathroom.", "B H K L W", ""),
    ("1 bathroom, 1 bedroom", "B H K L W", ""), ("1 Schlafzimmer, 1 Bad", "B H K L W", ""),
    ("1 bedroom", "B H K L W", ""), ("One bedroom.", "B H K L W", ""), ("A bedroom.", "B", ""), ("bedroom", "B", ""),
    ("1 bedroom of 14 m2", "B", "B1=14"), ("One bedroom with a double bed", "B", "B1 has 1 double_bed"),
    ("1 bedroom, 1 bathroom, nothing else", "B W", ""), ("A bedroom and a bathroom.", "B W", ""),
]  # fmt: skip

test_numbers_of_bedrooms_and_bathrooms_are_of_a_home = as_meant(ONE_EACH)


@pytest.mark.parametrize("prompt", ["wheelchair accessible flat", "energy efficient passive house"])
def test_one_english_word_for_a_home_is_enough(prompt):
    assert {"bedroom", "kitchen"} <= {room.type for room in read(prompt).rooms} and read(prompt).unread

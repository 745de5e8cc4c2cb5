"""What is counted, limited or told of whom behind what it is said of: totals, owners, ways out, whose room."""

from sentences.facts import as_meant

ALL_OFF_IT = [
    ("I'd like a landing with two bedrooms and one bathroom all opening off it, and a living room.", "B2 H K L W",
     "B1H1, H1W1, !B1L1, !L1W1"),
    ("A hallway at least 7 m long, with three bedrooms, one bathroom, the kitchen and the living room all opening off "
     "it.", "B3 H K L W", "at_least H1 length 7, H1W1, H1K1, B1H1, B3H1, H1L1, !K1L1"),
    ("A corridor 1.4 m wide, with two bedrooms, the bathroom and the kitchen all leading off it.", "B2 H K L W",
     "H1W1, H1K1, !K1W1"),
    ("A central hall, with the kitchen, the living room, the bathroom and two bedrooms all accessible from it.",
     "B2 H K L W", "H1W1, H1K1, !B1W1"),
    ("I want a long hallway and two bedrooms, one bathroom and the kitchen all opening off it.", "B2 H K L W",
     "B1H1, B2H1, H1K1, H1W1, !B1K1"),
    ("A living room with the kitchen, two bedrooms and the bathroom all opening off it, no hallway.", "B2 K L W",
     "B1L1, B2L1, K1L1, L1W1, !B1W1"),
]
COUNTED_BEHIND = [
    ("My grandmother lives with us, so her bedroom should be near the entrance. In total we need three bedrooms, one "
     "bathroom and one separate toilet.", "B3 H K L W2", "near B1 entrance"),
    ("Our son is a teenager, so his bedroom should be far from the living room. Altogether we need three bedrooms.",
     "B3 H K L W2", "apart B1 L1"),
    ("His room should be next to the study. All in all we need three bedrooms, two bathrooms and a study.",
     "B3 H K L S W2", ""),
]
HERS = [
    ("Three bedrooms. Her bedroom has a desk.", "B3 H K L W2", "B1 has 1 desk"),
    ("Three bedrooms. Her bedroom must have its own bathroom.", "B3 H K L W2", "B1W1"),
    ("Three bedrooms. His bedroom has 14 m2, her bedroom has 12 m2.", "B3 H K L W2", "B1=14, B2=12"),
    ("Four bedrooms. His bedroom must have at least 14 m².", "B4 H K L W2", "at_least B1 14"),
    ("Two bedrooms. We have a son, his bedroom needs a desk.", "B2 H K L W", "B1 has 1 desk"),
    ("A bedroom for us and a bedroom for our daughter. Her bedroom should face south.", "B2 H K L W",
     "orientation B2 south"),
]
EACH_THEIR_OWN = [
    ("Three siblings, each with a bedroom of her own; two bathrooms.", "B3 H K L W2", ""),
    ("A couple who sleep in a double bed in the master bedroom, and two children, each in a single bed in a bedroom of "
     "their own. One bathroom, one kitchen, one living room.", "B3 H K L W",
     "B1 has 1 double_bed, B2 has 1 single_bed, B3 has 1 single_bed"),
    ("Flat for a couple with two children, each child has a single bed in its own bedroom. One bathroom.",
     "B3 H K L W", "B2 has 1 single_bed, B3 has 1 single_bed"),
    ("Flat for a couple and two children, each in a bedroom of their own. One bathroom.", "B3 H K L W", ""),
    ("Two roommates, each of whom has a bedroom with its own en suite bathroom; no other bathroom.", "B2 H K L W2",
     "B1W1, B2W2, !H1W1, !H1W2"),
    ("Three flatmates, each of whom has a bedroom with a desk. One bathroom.", "B3 H K L W",
     "B1 has 1 desk, B2 has 1 desk, B3 has 1 desk"),
    ("Four friends, each of whom gets a bedroom; two bathrooms.", "B4 H K L W2", ""),
    ("Two friends, each with a bedroom and an en suite bathroom of their own.", "B2 H K L W2", "B1W1, B2W2"),
]
OUT_ON_IT = [
    ("There are two bedrooms and a balcony, which you enter from the kitchen.", "B2 H K L W Y", "K1Y1, B1H1, !L1Y1"),
    ("Two bedrooms and a balcony. From the kitchen one should be able to go out onto it.", "B2 H K L W Y",
     "K1Y1, !B1Y1, !B1K1"),
    ("A flat with 2 bedrooms, 1 bathroom and a balcony. I want to go out on it from the kitchen.", "B2 H K L W Y",
     "K1Y1, !L1Y1"),
    ("2 bedrooms and a balcony. You should step out onto it from the bedroom.", "B2 H K L W Y", "B1Y1, !L1Y1"),
    ("2 bedrooms and a balcony that we can go out on from the kitchen.", "B2 H K L W Y", "K1Y1, !L1Y1"),
    ("Two bedrooms and a terrace. We go out to it from the living room and from the kitchen.", "B2 H K L W Y",
     "K1Y1, L1Y1"),
    ("Two bedrooms, a balcony and a study. You get to it from the hall.", "B2 H K L S W Y", "L1Y1, H1S1, !H1Y1"),
]
SHARED_ROOMS = [
    ("Each of the two children sleeps in a single bed in a room of their own; the parents sleep in the master bedroom.",
     "B3 H K L W2", "B2 has 1 single_bed, B3 has 1 single_bed"),
    ("Two bedrooms. The girls share one of them, and in it we need a bunk bed.", "B2 H K L W",
     "B2 has 1 bunk_bed, !B1B2"),
    ("Two bedrooms. The baby sleeps with us, so put a double bed and a cot in the master bedroom. The older two share "
     "the second bedroom, there we want a bunk bed. One bathroom.", "B2 H K L W",
     "B1 has 1 double_bed, B1 has 1 cot, B2 has 1 bunk_bed, !B1 has 1 bunk_bed, !B1B2"),
    ("Two bedrooms. The kids share the second bedroom, there we need two single beds.", "B2 H K L W",
     "B2 has 2 single_bed, !B1B2"),
    ("Three bedrooms. The two older ones share one bedroom, and there they need a bunk bed.", "B3 H K L W2",
     "B3 has 1 bunk_bed, !B1B3, !B2B3"),
]
OF_THE_HOME = [
    ("A minimum of 60 and a maximum of 75 m2, two bedrooms.", "B2 H K L W", "at_least home 60, at_most home 75"),
    ("60 m2 at least and 75 m2 at most, two bedrooms.", "B2 H K L W", "at_least home 60, at_most home 75"),
    ("Annotators reported 540 sq ft for this one-bedroom apartment; the kitchen is off the hallway.", "B H K L W",
     "all=50.17, H1K1"),
    ("45 square metres for our one-bedroom home. The bedroom has 12 m².", "B H K L W", "all=45, B1=12"),
    ("The flat should have at least 60 and at most 75 square metres, with two bedrooms.", "B2 H K L W",
     "at_least home 60, at_most home 75, !unread 60"),
    ("Two bedrooms, total area min 60 max 75 m2.", "B2 H K L W", "at_least home 60, at_most home 75"),
    ("Two bedrooms. The home should be no smaller than 70 and no larger than 85 square metres.", "B2 H K L W",
     "at_least home 70, at_most home 85"),
    ("Two bedrooms, the kitchen at least 9 and at most 12 m².", "B2 H K L W",
     "at_least K1 9, at_most K1 12, !at_most home 12"),
]
OFF_THE_HALL_THAT = [
    ("Two bedrooms. The pantry borders the kitchen.", "B2 H K L T W", "adjacent T1 K1"),
    ("A utility room off the hallway, sharing a wall with the bathroom; two bedrooms.", "B2 H K L U W",
     "adjacent U1 W1, H1U1"),
    ("A study, off the hall, that faces south; one bedroom.", "B H K L S W", "orientation S1 south, H1S1"),
    ("Three bedrooms, one bathroom, and a storage room off the hallway that shares a wall with the kitchen.",
     "B3 H K L T W", "adjacent T1 K1, H1T1, !adjacent H1 K1"),
    ("A study on the corridor that faces south, and two bedrooms.", "B2 H K L S W", "orientation S1 south, H1S1"),
    ("Two bedrooms, a pantry off the hall which touches the kitchen.", "B2 H K L T W", "adjacent T1 K1, H1T1"),
]

test_all_off_it = as_meant(ALL_OFF_IT)
test_counted_behind = as_meant(COUNTED_BEHIND)
test_hers = as_meant(HERS)
test_each_their_own = as_meant(EACH_THEIR_OWN)
test_out_on_it = as_meant(OUT_ON_IT)
test_shared_rooms = as_meant(SHARED_ROOMS)
test_of_the_home = as_meant(OF_THE_HOME)
test_off_the_hall_that = as_meant(OFF_THE_HALL_THAT)

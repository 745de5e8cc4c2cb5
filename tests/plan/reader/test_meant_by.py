"""Rooms meant by `hers`, `off it too`; one for each child among those counted; where nobody comes in."""

from sentences.facts import as_meant

AMONG = [
    ("Three bedrooms, one for us and one for each of our two daughters, a single bathroom off the hall.", "B3 H K L W",
     "H1W1"),
    ("Four bedrooms, one for my wife and me, one for each of our three children. Two bathrooms.", "B4 H K L W2", ""),
    ("Three bedrooms, one for me and one for each of my two sons.", "B3 H K L W2", ""),
    ("Three bedrooms, one for each of our two daughters and one for us.", "B3 H K L W2", ""),
    ("Three bedrooms - ours and one for each of the two kids.", "B3 H K L W2", ""),
    ("We need three bedrooms, one for each of our two daughters and the third for guests.", "B3 H K L W2", ""),
    ("Two bedrooms, one for each of our two sons.", "B2 H K L W", ""),
    ("Three bedrooms, one for us and a room for each of our two daughters.", "B3 H K L W2", ""),
    ("Three bedrooms, one for us, one each for our two daughters.", "B3 H K L W2", ""),
    ("A flat with three bedrooms. One is for us, and there is one for each of our two sons.", "B3 H K L W2", ""),
    ("Four bedrooms: our own, and one for each of our three kids.", "B4 H K L W2", ""),
    ("Three bedrooms, one for us and one for each of the boys.", "B3 H K L W2", ""),
    ("Drei Schlafzimmer, eins für uns und je eins für unsere zwei Töchter.", "B3 H K L W2", ""),
    ("Trois chambres, une pour nous et une pour chacune de nos deux filles.", "B3 H K L W2", ""),
    ("Tres dormitorios, uno para nosotros y uno para cada una de nuestras dos hijas.", "B3 H K L W2", ""),
    ("A bedroom for us and one for each of our two daughters. One bathroom.", "B3 H K L W", ""),
    ("Two bedrooms for us and guests, plus one for each of our two daughters. One bathroom.", "B4 H K L W", ""),
]  # fmt: skip
HERS = [
    ("Grandma's bedroom should be next to the bathroom, and the kids' bedroom away from hers.", "B2 H K L W",
     "adjacent B1 W1, apart B2 B1"),
    ("Two bedrooms: the parents' bedroom near the bathroom, and the kids' room far from theirs.", "B2 H K L W",
     "adjacent B1 W1, apart B2 B1"),
    ("Grandpa's room faces north, and the guest room is next to his. Two bedrooms.", "B2 H K L W",
     "orientation B1 north, adjacent B2 B1"),
    ("Grandma's bedroom is beside the kitchen; the kids' room must not be next to hers.", "B2 H K L W",
     "adjacent B1 K1, apart B2 B1"),
    ("Mum's room is close to the bathroom and my room opposite hers. Two bedrooms.", "B2 H K L W",
     "adjacent B2 W1, opposite B1 B2"),
    ("The parents' bedroom faces south, the kids' bedroom is next to theirs.", "B2 H K L W",
     "orientation B1 south, adjacent B2 B1"),
    ("My grandmother's bedroom is near the bathroom. The guest room should be as far as possible from hers.",
     "B2 H K L W", "adjacent B1 W1, apart B2 B1"),
    ("My son's room should be far away from mine. Two bedrooms.", "B2 H K L W", "apart B2 B1"),
]  # fmt: skip
NOBODY = [
    ("There are two bathrooms but only one bedroom. Nobody comes into a bathroom from the bedroom; both bathrooms have "
     "the door in the hall.", "B H K L W2", "H1W1, H1W2, !B1W1, !B1W2"),
    ("Two bathrooms, one bedroom. You don't enter a bathroom from the bedroom; both have their door in the hall.",
     "B H K L W2", "H1W1, H1W2, !B1W1"),
    ("Two bathrooms and two bedrooms. No bathroom is entered from a bedroom; both bathrooms have their doors on the "
     "hall.", "B2 H K L W2", "H1W1, H1W2"),
    ("Two bedrooms, two bathrooms. One cannot get into a bathroom from a bedroom.", "B2 H K L W2", "H1W1, H1W2"),
    ("No one walks into a bathroom from a bedroom. Two bedrooms and two bathrooms.", "B2 H K L W2", "H1W1, H1W2"),
    ("You never come into a bathroom straight from a bedroom. Two bedrooms, two bathrooms.", "B2 H K L W2",
     "H1W1, H1W2"),
    ("Neither bathroom is entered from the bedroom. One bedroom, two bathrooms.", "B H K L W2", "H1W1, H1W2"),
    ("Nobody enters the bathroom from the bedroom; it has its door in the hall. One bedroom.", "B H K L W",
     "H1W1, no_door W1 B1"),
    ("A flat with one bedroom. Nobody gets into the kitchen through the bedroom.", "B H K L W", "no_door K1 B1, B1H1"),
    ("Both bathrooms have the door in the hall. Two bedrooms, two bathrooms.", "B2 H K L W2", "H1W1, H1W2"),
    ("Two bathrooms, two bedrooms; neither bathroom opens off a bedroom.", "B2 H K L W2", "H1W1, H1W2"),
    ("No bedroom leads to a bathroom. Two bedrooms, two bathrooms.", "B2 H K L W2", "H1W1, H1W2"),
    ("Nobody walks through the bedroom to reach the bathroom. A flat with one bedroom.", "B H K L W",
     "H1W1, no_door B1 W1"),
    ("No guest gets into the bathroom from a bedroom. Two bedrooms, one bathroom.", "B2 H K L W",
     "no_door W1 B1, no_door W1 B2"),
    ("You can't walk from a bedroom into a bathroom. Two bedrooms, two bathrooms.", "B2 H K L W2", "H1W1, H1W2"),
    ("It must not be possible to enter a bathroom from a bedroom. Two bedrooms, two bathrooms.", "B2 H K L W2",
     "H1W1, H1W2"),
    ("None of the bathrooms has a door to a bedroom. Two bedrooms, two bathrooms.", "B2 H K L W2", "H1W1, H1W2"),
    ("Both bathrooms have their door on the corridor, none in a bedroom. Two bedrooms.", "B2 H K L W2", "H1W1, H1W2"),
    ("The bathrooms have their doors in the corridor. Two bedrooms, two bathrooms.", "B2 H K L W2", "H1W1, H1W2"),
]  # fmt: skip
OFF_IT = [
    ("A flat for four students: four bedrooms off one corridor, two bathrooms off it too, and a kitchen off it as "
     "their only shared room; no living room.", "B4 H K W2", "H1K1, H1W1, H1W2"),
    ("Four bedrooms off one corridor, two bathrooms off it too.", "B4 H K L W2", "H1W1, H1W2"),
    ("Four bedrooms off the hallway, two bathrooms off it as well, and the living room off it.", "B4 H K L W2",
     "H1W1, H1W2, H1L1"),
    ("Three bedrooms off a corridor and two bathrooms off it.", "B3 H K L W2", "H1W1, H1W2"),
    ("Two bedrooms off the corridor, and off it also two bathrooms and the kitchen.", "B2 H K L W2",
     "H1W1, H1W2, H1K1"),
    ("Three bedrooms open off the corridor, two bathrooms off the same corridor, the kitchen off it too.",
     "B3 H K L W2", "H1W1, H1W2, H1K1, !K1W1"),
    ("Two bedrooms on the hall; the bathroom is on it too.", "B2 H K L W", "H1W1, !B1W1"),
    ("Three bedrooms along one hallway, two bathrooms along it too, a kitchen off it.", "B3 H K L W2",
     "H1W1, H1W2, H1K1"),
    ("Two bedrooms off the hall, two bathrooms off it also, the kitchen off the living room.", "B2 H K L W2",
     "H1W1, H1W2, K1L1"),
    ("Two bedrooms off the hall, a kitchen with a table, a pantry off it. One bathroom.", "B2 H K L T W", "K1T1"),
    ("There is one corridor. Off it are three bedrooms and two bathrooms.", "B3 H K L W2", "H1W1, H1W2"),
    ("A hallway with three bedrooms off it, two bathrooms off it and the living room off it.", "B3 H K L W2",
     "H1W1, H1W2, H1L1, !L1W1"),
    ("Two bedrooms off a corridor; the kitchen and the living room are off it too. A flat with one bathroom.",
     "B2 H K L W", "H1K1, H1L1, !B1K1"),
    ("A flat with two bedrooms off the hall, a living room with a kitchen off it.", "B2 H K L W", "K1L1"),
]  # fmt: skip

test_one_for_each_child_is_among_those_counted = as_meant(AMONG)

test_hers_is_the_room_of_whom_was_spoken = as_meant(HERS)

test_nobody_comes_in_from_there = as_meant(NOBODY)

test_off_it_too_is_off_the_corridor = as_meant(OFF_IT)

"""Two doors or limits of one room, what looks on a side, rooms replaced or spoken of by `it`, instruments played."""

from sentences.facts import as_meant

TWO_DOORS = [
    ("The bathroom has two doors, one in the bedroom and one in the corridor. One bedroom.", "B H K L W",
     "B1W1, H1W1"),
    ("The bathroom have two door, one in bedroom and one in corridor. One bedroom only.", "B H K L W", "B1W1, H1W1"),
    ("Kitchen with two doors, one to the hall, the other into the living room. One bedroom, one bathroom.",
     "B H K L W", "H1K1, K1L1"),
]
TWO_LIMITS = [
    ("Two bedrooms, corridor at least 1.5 metres wide and no longer than 6 metres.", "B2 H K L W",
     "at_least H1 width 1.5, at_most H1 length 6, !at_most B1 length 6"),
    ("Two bedrooms, hallway not wider than 1.4 m but at least 1.2 m wide, one bathroom.", "B2 H K L W",
     "at_most H1 width 1.4, at_least H1 width 1.2"),
]
EVERY_DOOR = [
    ("2 bed 2 bath, every door from the hallway.", "B2 H K L W2", "H1W1, H1W2, B1H1, H1K1, !B1W1"),
    ("Two bedrooms, two bathrooms; all doors open onto the corridor.", "B2 H K L W2", "H1W1, H1W2, !B1W1"),
]
LOOKS_ON = [
    ("Kitchen need window on the east side, living room on the west side. Two bedrooms.", "B2 H K L W",
     "orientation K1 east, orientation L1 west, !position L1 west"),
    ("The study has a window to the north, the bedroom to the south. One bathroom, kitchen, living room.",
     "B H K L S W", "orientation S1 north, orientation B1 south"),
    ("Two bedrooms. One of them must face the courtyard on the north.", "B2 H K L W",
     "orientation B1 north, !position B1 north"),
    ("Two bedrooms. The living room looks onto the garden in the south.", "B2 H K L W",
     "orientation L1 south, !unread looks"),
    ("Two bedrooms, the living room facing the street on the west side.", "B2 H K L W", "orientation L1 west"),
]
AT_THE_ENTRANCE = [
    ("Grandpa moves in with us. He needs a bedroom on the side of the entrance and a toilet of his own.",
     "B2 H K L W2", "near B2 entrance, B2W1, H1W2"),
    ("Two bedrooms; the kitchen is on the entrance side.", "B2 H K L W", "near K1 entrance"),
    ("Two bedrooms. The living room should be on the side away from the entrance.", "B2 H K L W",
     "apart L1 entrance"),
]
IT = [
    ("A table for eight in the dining room; it should be open to the kitchen. Two bedrooms.", "B2 D H K L W",
     "D1~K1"),
    ("The living room faces south. It should be open to the kitchen. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("The study is small. It should be open to the living room. Two bedrooms.", "B2 H K L S W", "L1S1, !L1~S1"),
]
OTHERWISE = [
    ("Replace the dining room by a study; two bedrooms, kitchen, lounge, one bathroom.", "B2 H K L S W", ""),
    ("A room for living and sleeping, a kitchen corner and a shower room.", "K L W", "L1 has 1 double_bed"),
    ("My wife teaches piano. A study, one bedroom, a piano in the living room.", "B H K L S W",
     "L1 has 1 piano"),
    ("Living room: two bookshelves, one floor lamp, three armchairs. One bedroom, one bathroom, kitchen.", "B H K L W",
     "L1 has 1 floor_lamp, L1 has 2 bookshelf"),
    ("A living room of 20 m2, a kitchen half that, and two bedrooms.", "B2 H K L W", "L1=20, K1=10"),
    ("Two bedrooms; kitchen 8 m2, living room twice that.", "B2 H K L W", "K1=8, L1=16, !unread twice"),
]

test_every_door = as_meant(EVERY_DOOR)
test_two_doors = as_meant(TWO_DOORS)
test_two_limits = as_meant(TWO_LIMITS)
test_looks_on_a_side = as_meant(LOOKS_ON)
test_on_the_side_of_the_entrance = as_meant(AT_THE_ENTRANCE)
test_it_is_the_room_before = as_meant(IT)
test_said_otherwise = as_meant(OTHERWISE)

SHARED = [
    ("Three bedrooms. The master has an ensuite, the other two share one.", "B3 H K L W2", "B1W1, H1W2, !B2B3"),
]  # fmt: skip

test_what_they_share_is_no_bedroom = as_meant(SHARED)

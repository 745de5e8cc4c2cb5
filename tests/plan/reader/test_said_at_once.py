"""Who shares a room and who sleeps with the parents, rooms told of behind others, corners and storeys."""

from sentences.facts import as_meant

SLEEPS_WITH_US = [
    ("We are a family with three kids; two of them share a room and the baby sleeps in ours. We also need a pantry "
     "off the kitchen.", "B2 H K L T W", "B1H1, B2H1, K1T1"),
    ("We have three children, two of them share a room and the youngest sleeps with us.", "B2 H K L W", "B1H1, B2H1"),
    ("Family with four kids: two share a room, the eldest has her own, the baby sleeps in our bedroom.",
     "B3 H K L W2", ""),
    ("We have three sons: two of them share, the youngest has his own room.", "B3 H K L W2", ""),
]  # fmt: skip
OWN_ROOMS = [
    ("We are students, four peoples, everyone wants own room, two bathrooms from the corridor, one common kitchen and "
     "no living room please", "B4 H K W2", "H1W1, H1W2, H1K1, B3H1, B4H1, !B1W1, !unread students, !unread four"),
    ("We are friends, three persons, each needs own bedroom, one bathroom from the hall.", "B3 H K L W", "H1W1"),
    ("Three bedrooms, two bathrooms from the corridor.", "B3 H K L W2", "H1W1, H1W2"),
]  # fmt: skip

test_who_sleeps_with_the_parents_has_no_room = as_meant(SLEEPS_WITH_US)
test_each_of_those_counted_has_a_room = as_meant(OWN_ROOMS)

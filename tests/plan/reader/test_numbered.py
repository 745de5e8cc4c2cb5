"""Bedrooms told apart by numbers: whose en suites there are, who shares, and what furniture is whose."""

from sentences.facts import as_meant

SENTENCES = [
    ("bedroom 1 with en suite, bedroom 2 and 3 share the bath", "B3 H K L W2", "B1W1, H1W2"),
    ("Three bedrooms. Bedroom 1 and bedroom 2 with en suites, bedroom 3 uses the hall bathroom.", "B3 H K L W3",
     "B1W1, B2W2, H1W3"),
    ("Bedroom 1, bedroom 2 and bedroom 3 with en suites.", "B3 H K L W3", "B1W1, B2W2, B3W3"),
    ("Bedroom 1 & 2 with balconies, three bedrooms.", "B3 H K L W2 Y2", "B1Y1, B2Y2"),
    ("Bedroom 1 (en suite), bedroom 2 (en suite), bedroom 3 and 4 with a shared bathroom.", "B4 H K L W3",
     "B1W1, B2W2, !B3W3"),
    ("Four bedrooms: 1 and 2 have an en suite each, 3 and 4 share a bathroom.", "B4 H K L W3", "B1W1, B2W2, !B3W3"),
    ("Four bedrooms. No. 1 has an en suite, nos. 2 and 3 share a jack-and-jill, no. 4 uses the family bathroom.",
     "B4 H K L W3", "B1W1, B2W2, B3W2, H1W3, !unread no 4"),
    ("Three bedrooms: 1 has an en suite, 2 have balconies.", "B3 H K L W2 Y2", "B1W1"),
    ("Three bedrooms - #1 faces south, #2 and #3 face north.", "B3 H K L W2",
     "orientation B1 south, orientation B2 north, orientation B3 north, !B1B2, !B1B3"),
    ("Three bedrooms, two of which have en suites.", "B3 H K L W3", "B1W1, B2W2, H1W3"),
    ("Two bedrooms, number 1 off the hall with a double bed and number 2 with a desk.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 desk"),
    ("Two bedrooms: the first off the hall with a double bed, the second with a desk.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 desk, !B1B2"),
    ("Six bedrooms, four bathrooms (bedrooms 1, 2 and 3 have an en suite each, the fourth bathroom is off the "
     "hallway).", "B6 H K L W4", "B1W1, B2W2, B3W3, H1W4"),
    ("One bedroom will do, but we need two studies. One study faces north, the other faces east.", "B H K L S2 W",
     "orientation S1 north, orientation S2 east"),
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)

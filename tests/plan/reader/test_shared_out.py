"""Furniture that is said of no room of several: every bedroom has a bed, and one of what there are as many of."""

from sentences.facts import as_meant

SENTENCES = [
    ("A two-bedroom flat. One double bed and two single beds.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("A three-bedroom flat with a double bed and two single beds.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 single_bed, B3 has 1 single_bed"),
    ("A two-bedroom flat with four single beds.", "B2 H K L W", "B1 has 2 single_bed, B2 has 2 single_bed"),
    ("A three-bedroom house. We need a bunk bed and two double beds.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 double_bed, B3 has 1 bunk_bed"),
    ("Two bedrooms, the second with a single bed. A double bed is needed, too.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 single_bed, !B2 has 1 double_bed"),
    ("Zwei Schlafzimmer, ein Doppelbett und zwei Einzelbetten.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("A two-bedroom flat with two wardrobes.", "B2 H K L W", "B1 has 1 wardrobe, B2 has 1 wardrobe"),
    ("The kids share a room, but they need two single beds. Our bedroom should be far from theirs.", "B2 H K L W",
     "B2 has 2 single_bed, apart B1 B2"),
    ("A two-bedroom flat with a study and two desks.", "B2 H K L S W", "S1 has 2 desk, !B1 has 1 desk"),
    ("A two-bedroom flat with one desk and three wardrobes.", "B2 H K L W", "B1 has 1 desk, B1 has 3 wardrobe"),
    ("A studio with one double bed and two single beds.", "K L W", "L1 has 1 double_bed, L1 has 2 single_bed"),
]  # fmt: skip

test_each_bedroom_has_its_own = as_meant(SENTENCES)

SIZED = [
    ("A three-bedroom flat. Each of the two smaller bedrooms has a bunk bed and the big one a double bed.",
     "B3 H K L W2", "B1 has 1 double_bed, B2 has 1 bunk_bed, B3 has 1 bunk_bed, !B1 has 1 bunk_bed"),
    ("A three-bedroom flat. Both smaller bedrooms have a desk, the largest has a double bed.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 desk, B3 has 1 desk, !B1 has 1 desk"),
    ("A four-bedroom flat. Each of the smaller bedrooms has a single bed.", "B4 H K L W2",
     "B2 has 1 single_bed, B3 has 1 single_bed, B4 has 1 single_bed, !B1 has 1 single_bed"),
    ("Two small bedrooms and a large one. Both small bedrooms have a desk.", "B3 H K L W2",
     "B1=10.5, B2=8.85, B1 has 1 desk, B2 has 1 desk, !B3 has 1 desk"),
    ("Three bedrooms of 10, 14 and 12 m². The two smaller bedrooms have a desk.", "B3 H K L W2",
     "B1 has 1 desk, B3 has 1 desk, !B2 has 1 desk"),
    ("A three-bedroom flat. Each small bedroom has a desk.", "B3 H K L W2",
     "B1 has 1 desk, B2 has 1 desk, B3 has 1 desk"),
    ("A three-bedroom flat. The large bedrooms have a desk.", "B3 H K L W2",
     "B1 has 1 desk, B2 has 1 desk, B3 has 1 desk"),
]  # fmt: skip

test_the_smaller_ones_have_theirs = as_meant(SIZED)

SHORT = [
    ("A three-bedroom flat. Each of the two smaller bedrooms has a bunk bed and the big one a double.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 bunk_bed, B3 has 1 bunk_bed"),
    ("A two-bedroom flat. The big one has a double and the small one two singles.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("A two-bedroom flat. The main bedroom has a king, the second a double.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 1 double_bed"),
    ("A two-bedroom flat. One bedroom has a double and the other two singles.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Two double bedrooms and a single.", "B3 H K L W2", ""),
]  # fmt: skip

test_a_double_is_a_bed = as_meant(SHORT)

LIKEWISE = [
    ("My room has a desk, and so does my sister's. One bathroom.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("A two-bedroom flat. My room has two desks; so does my brother's room.", "B2 H K L W",
     "B1 has 2 desk, B2 has 2 desk"),
    ("A two-bedroom flat. My room has a desk, my sister's too.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 desk, !unread sister's"),
    ("A two-bedroom flat. My room has a desk and my sister's has a wardrobe.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 wardrobe, !B2 has 1 desk"),
]  # fmt: skip

test_so_does_hers = as_meant(LIKEWISE)

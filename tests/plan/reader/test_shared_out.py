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
    ("A two-bedroom flat with two desks.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("A two-bedroom flat with a study and two desks.", "B2 H K L S W", "S1 has 2 desk, !B1 has 1 desk"),
    ("A two-bedroom flat with one desk and three wardrobes.", "B2 H K L W", "B1 has 1 desk, B1 has 3 wardrobe"),
    ("A studio with one double bed and two single beds.", "K L W", "L1 has 1 double_bed, L1 has 2 single_bed"),
]  # fmt: skip

test_each_bedroom_has_its_own = as_meant(SENTENCES)

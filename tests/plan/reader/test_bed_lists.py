"""Beds that are counted for a home are shared out among its bedrooms: lists of kinds, bare counts, who sleeps there."""

from sentences.facts import as_meant

LISTED = [
    ("Two bedrooms. Beds: one double, two singles.", "B2 H K L W", "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("2 bedrooms. Beds: 1 double, 2 single.", "B2 H K L W", "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Three bedrooms, one bathroom; beds: 2x double, 1x single", "B3 H K L W",
     "B1 has 1 double_bed, B2 has 1 double_bed, B3 has 1 single_bed"),
    ("Flat with two bedrooms; beds: king in the main bedroom, two twins in the second.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed, !unread king"),
    ("Two bedrooms (one double bed, two single beds).", "B2 H K L W", "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Three bedrooms with a double bed, two single beds and a bunk bed.", "B3 H K L W2",
     "B1 has 1 double_bed, !B2 has 1 double_bed, B2 has 1 bunk_bed"),
    ("Two-bedroom apartment, sleeps four: one double bed and two single beds.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed, !unread sleeps"),
    ("Two bedrooms with a double bed each.", "B2 H K L W", "B1 has 1 double_bed, B2 has 1 double_bed"),
    ("Two bedrooms with a double bed and a desk.", "B2 H K L W", "B2 has 1 double_bed, B2 has 1 desk"),
]
BARE = [
    ("Two-bedroom flat with three beds.", "B2 H K L W", "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("2BR/1BA, 3 beds.", "B2 H K L W", "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("A two bedroom flat; in total there should be three beds.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Three bedrooms with four beds.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 double_bed, B3 has 2 single_bed, !B3 has 4 double_bed"),
    ("One-bedroom flat with two beds.", "B H K L W", "B1 has 2 single_bed"),
    ("3 beds, 2 baths.", "B3 H K L W2", ""),
    ("2 bedrooms, each with two beds.", "B2 H K L W", "!B2 has 1 double_bed"),
    ("Three bedrooms, one of them with two beds.", "B3 H K L W2", "!B2 has 1 double_bed, !B3 has 2 single_bed"),
    ("Two-bedroom flat that sleeps up to five people. One bathroom.", "B2 H K L W", "!unread sleeps, !unread people"),
]

test_beds_by_kind = as_meant(LISTED)
test_beds_without_a_kind = as_meant(BARE)

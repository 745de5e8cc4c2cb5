"""Rooms that are larger or smaller than others by a part that is said, and those compared with what was named last."""

from sentences.facts import as_meant

BY_A_PART = [
    ("Two bedrooms. The living room is a third larger than the kitchen, which is 15 m2.", "B2 H K L W",
     "K1=15, L1=20, !order L1 K1 larger"),
    ("Two bedrooms. The living room is one fifth bigger than the main bedroom. Main bedroom 15 m2.", "B2 H K L W",
     "B1=15, L1=18"),
    ("Two bedrooms. The bathroom is a quarter smaller than the kitchen of 8 m2.", "B2 H K L W",
     "K1=8, W1=6, !order W1 K1 smaller"),
    ("Two bedrooms. The bathroom is 25 % smaller than the kitchen of 8 m2.", "B2 H K L W", "W1=6"),
    ("The first bedroom has 16 m2, the second is a quarter smaller. One bathroom.", "B2 H K L W", "B1=16, B2=12"),
    ("One bedroom of 15 m² and another a fifth smaller; a kitchen of 10 m².", "B2 H K L W", "B1=15, B2=12, K1=10"),
    ("Two bedrooms. The kitchen has 12 m² and the living room is 50% larger.", "B2 H K L W", "K1=12, L1=18"),
]
THAN_THE_LAST = [
    ("Two bedrooms. The kitchen is 12 m2, the living room a third larger than that.", "B2 H K L W", "K1=12, L1=16"),
    ("Kitchen 12 m², living room twice as large, two bedrooms.", "B2 H K L W", "K1=12, L1=24"),
    ("Kitchen of 12 m², a living room twice the size, two bedrooms, one bathroom.", "B2 H K L W", "K1=12, L1=24"),
    ("Two bedrooms; the living room has 24 m2 and the kitchen is half as large, the bathroom 5 m2.", "B2 H K L W",
     "L1=24, K1=12, W1=5"),
    ("Two bedrooms. Living room of 24 m2, kitchen one third of it.", "B2 H K L W", "L1=24, K1=8"),
    ("Two bedrooms. Living room of 24 m2, kitchen a third of its size.", "B2 H K L W", "L1=24, K1=8"),
    ("Two bedrooms; the living room is larger than that of our neighbours.", "B2 H K L W", "unread neighbours"),
    ("A third larger than that: the living room. Two bedrooms.", "B2 H K L W", ""),
    ("Bigger than that, please: two bedrooms.", "B2 H K L W", ""),
]

test_larger_by_a_part = as_meant(BY_A_PART)
test_compared_with_what_was_named_last = as_meant(THAN_THE_LAST)

"""Advertisements, learners and sums: what stands beside the counts of rooms is of those rooms."""

from sentences.facts import as_meant

ADVERTISED = [
    ("Flat offering two double bedrooms, master with en suite shower room, kitchen and one bathroom.", "B2 H K L W2",
     "B1W1, H1W2"),
    ("Three double bedrooms, main bedroom with dressing room, one bathroom.", "B3 C H K L W", "B1C1"),
    ("Double bedroom, second bedroom ideal as nursery or home office, kitchen, living room, one bathroom.",
     "B2 H K L W", "!unread ideal"),
    ("Two bedrooms, the second perfect for use as a study. One bathroom.", "B2 H K L W", "!unread perfect"),
    ("Arranged around a central hallway: on the left the living room and kitchen, on the right two bedrooms.",
     "B2 H K L W", "position L1 left, position K1 left, position B1 right, position B2 right, !position H1 left"),
]
SUMS = [
    ("2 bedrooms (12 + 10 m²), kitchen 9 m², one bathroom, living room.", "B2 H K L W", "B1=12, B2=10, K1=9"),
    ("Two bedrooms, one is 14 and the other 10. One bathroom, kitchen, living room.", "B2 H K L W", "B1=14, B2=10"),
    ("The flat has 2 bedrooms the one is 14 and the other is 10.", "B2 H K L W", "B1=14, B2=10"),
    ("Two bedrooms, one with two beds and the other with a cot.", "B2 H K L W", "B1 has 2 double_bed, B2 has 1 cot"),
]
LEARNT = [
    ("Three bedroom, one bathroom, kitchen, but living room is not need.", "B3 H K W", ""),
    ("Please no door from kitchen in the bedroom! Flat with one bedroom.", "B H K L W", "no_door K1 B1"),
    ("Three bedrooms please, and the smallest should become an office; two bathrooms.", "B2 H K L S W2", ""),
    ("A laundry room between kitchen and bathroom. Two bedrooms.", "B2 H K L U W", "adjacent U1 K1, adjacent U1 W1"),
]
PEOPLE = [
    ("Our twins are fifteen and each wants a room; ours should be next to the bathroom. One bathroom.", "B3 H K L W",
     "adjacent B1 W1, !unread twins"),
    ("Grandpa moves in with us. He needs a bedroom with a desk. One bathroom.", "B2 H K L W", "B2 has 1 desk"),
    ("We have three boys; the two little ones share, the eldest has his own room. Two bathrooms, one for us alone.",
     "B3 H K L W2", ""),
    ("Mum is moving in with us. She needs a bedroom; we keep ours. One bathroom.", "B2 H K L W", ""),
]

test_advertisements = as_meant(ADVERTISED)
test_areas_of_some = as_meant(SUMS)
test_slips_of_learners = as_meant(LEARNT)
test_people_told_of = as_meant(PEOPLE)

"""People who are spoken of again: `one for us … our bedroom`, `my son needs a bedroom, his bedroom …`, `she`."""

from sentences.facts import as_meant

ONE_FOR_US = [
    ("Three bedrooms: one for us, one for grandpa and one for the kids. One bathroom is entered from our bedroom, "
     "another one off the hallway.", "B3 H K L W2", "B1W1, H1W2"),
    ("Two bedrooms: one for us and one for the kids. One bathroom, entered from our bedroom.", "B2 H K L W", "B1W1"),
    ("Two bedrooms: one for me and one for my brother. My bedroom has a balcony.", "B2 H K L W Y", "B1Y1"),
    ("We need two bedrooms; one is for us, the other is for our son. Our bedroom should be off the hallway.",
     "B2 H K L W", "B1H1"),
    ("Three bedrooms: one for my wife and me, one for each of our two sons. The master bedroom has a balcony.",
     "B3 H K L W2 Y", "B1Y1, !unread three"),
    ("Three bedrooms: one for us, one for my mother and one for the baby. Our bedroom should be next to the baby's.",
     "B3 H K L W2", "adjacent B1 B3, !unread baby's"),

]
HIS = [
    ("My son needs a bedroom, his bedroom should face south. We need one too.", "B2 H K L W",
     "orientation B2 south, B2=11"),
    ("My son needs a bedroom; his bedroom should be far from the living room.", "B2 H K L W", "apart B2 L1, B2=11"),
    ("We need one bedroom. My mother needs a bedroom near the entrance, and her bedroom should have its own bathroom.",
     "B2 H K L W2", "near B2 entrance, B2W1"),
    ("Our daughter gets her own bedroom. Her room needs a desk and a single bed.", "B2 H K L W",
     "B2 has 1 desk, B2 has 1 single_bed, B2=11"),
    ("A bedroom for us and a bedroom for our son. His bedroom should face south.", "B2 H K L W",
     "orientation B2 south"),
]
SHE = [
    ("We have a daughter. She needs a bedroom, her bedroom should be next to ours.", "B2 H K L W",
     "adjacent B2 B1, !unread daughter"),
    ("We have an eight-year-old daughter. She needs a bedroom with a desk.", "B2 H K L W", "B2 has 1 desk, B2=11"),
    ("We have a son of 5, he gets a bedroom of 12 m².", "B2 H K L W", "B2=12"),
    ("My mother lives with us. She needs a bedroom near the entrance with its own bathroom.", "B2 H K L W2",
     "near B2 entrance, B2W1, H1W2"),
]

test_one_for_us_is_ours = as_meant(ONE_FOR_US)
test_his_bedroom_is_that_of_whom_one_was_told = as_meant(HIS)
test_she_is_the_one_that_people_have = as_meant(SHE)

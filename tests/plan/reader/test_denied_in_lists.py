"""What lists deny, the open kitchen among it, and what is said to be all."""

from sentences.facts import as_meant

SENTENCES = [
    ("Two bedrooms. I don't want an open kitchen or a balcony.", "B2 H K L W", "H1K1, !K1~L1"),
    ("Two bedrooms. We don't need an open-plan kitchen or a study.", "B2 H K L W", "H1K1, !K1~L1"),
    ("Two bedrooms, no open-plan kitchen or balcony.", "B2 H K L W", "H1K1, !unread no open-plan"),
    ("I don't want an en suite, an open kitchen or a balcony. I do want two bedrooms.", "B2 H K L W", "H1K1, !K1~L1"),
    ("A studio without an open kitchen.", "K L W", "K1L1, !K1~L1"),
    ("A studio, not open plan.", "K L W", "K1L1, !K1~L1"),
    ("We hate open kitchens and don't like balconies. Two bedrooms.", "B2 H K L W", "H1K1, !K1~L1"),
    ("We don't need a dining room, a study, or a second bathroom. Three bedrooms.", "B3 H K L W", ""),
    ("Two bedrooms, no balcony, a study and a utility room.", "B2 H K L S U W", ""),
    ("For our benchmark I want just a kitchen, 4 m x 3.5 m, with a fridge and an oven.", "K",
     "K1 has 1 fridge, K1 has 1 oven, dimension K1 4 x 3.5"),
    ("Just a bathroom with a shower and a washing machine.", "W", "W1 has 1 shower, W1 has 1 washing_machine"),
    ("Only a living room with a sofa and two armchairs, nothing else.", "L", "L1 has 1 sofa, L1 has 2 armchair"),
    ("only a bedroom and a bath", "B W", ""),
    # "or" denies nothing by itself
    ("A living room with a sofa and a tv or a bookcase.", "L", "L1 has 1 sofa, L1 has 1 tv"),
    ("Just a balcony would be nice. Two bedrooms.", "B2 H K L W Y", ""),
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)

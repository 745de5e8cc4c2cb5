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
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)

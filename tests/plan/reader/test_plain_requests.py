"""What users ask for in the plainest words: who sleeps where, reasons, shared baths, rooms for helpers, sizes."""

from sentences.facts import as_meant

REASONS = [
    ("The bedrooms should be far from the living room because we often have guests late.", "B2 H K L W",
     "apart B1 L1, apart B2 L1"),
    ("One-bedroom flat; the study should be next to the bedroom because our neighbours have parties", "B H K L S W",
     "adjacent S1 B1"),
]  # fmt: skip

test_a_reason_takes_nothing_from_what_is_asked = as_meant(REASONS)

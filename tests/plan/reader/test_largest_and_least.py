"""The largest of its kind, what is at least as large as another room, and as large as several together."""

from sentences.facts import as_meant

LARGEST = [
    ("A three-bedroom flat. The first bedroom is the largest.", "B3 H K L W2",
     "order B1 B2 larger, order B1 B3 larger, !order B1 largest, B1=14"),
    ("A three-bedroom flat. The second bedroom is the largest one and faces south.", "B3 H K L W2",
     "order B2 B1 larger, order B2 B3 larger, B2=14, B1=11.8, orientation B2 south"),
    ("A three-bedroom flat, where bedroom 2 is the smallest.", "B3 H K L W2",
     "order B2 B1 smaller, order B2 B3 smaller, B2=9.5, B3=11.8"),
    ("Three bedrooms: the third one is the largest, the second faces south.", "B3 H K L W2",
     "order B3 B1 larger, order B3 B2 larger, orientation B2 south"),
    ("Two bedrooms of 12 and 14 m². The second bedroom is the largest.", "B2 H K L W",
     "order B2 B1 larger, B1=12, B2=14"),
    ("A two-bedroom flat. The kitchen is the largest.", "B2 H K L W", "order K1 largest"),
    ("A three-bedroom flat. The first bedroom is the largest room.", "B3 H K L W2", "order B1 largest"),
]  # fmt: skip

test_the_largest_of_a_kind = as_meant(LARGEST)

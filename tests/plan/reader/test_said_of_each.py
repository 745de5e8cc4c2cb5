"""Who of several people has a room, said behind a dash or a colon, and where those sleep who have children."""

from sentences.facts import as_meant

SENTENCES = [
    ("two kids - each gets their own room", "B2 H K L W", ""),
    ("Two kids – they each get their own room. One bathroom.", "B2 H K L W", "!unread two kids"),
    ("Two kids, they each get their own room. One bathroom.", "B2 H K L W", "!unread two kids"),
    ("We have three children — each child gets their own bedroom.", "B4 H K L W2", ""),
    ("A flat for us and our two kids - each gets their own bedroom.", "B3 H K L W2", ""),
    ("Me and two flatmates: everybody has their own bedroom.", "B3 H K L W2", ""),
    ("Flat for a couple and three kids: the boys share, the girl has her own room.", "B3 H K L W2", ""),
    ("A house for two adults and three children. Parents' bedroom with en suite; each child gets their own bedroom; "
     "plus a family bathroom.", "B4 H K L W2", "B1W1, H1W2"),
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)

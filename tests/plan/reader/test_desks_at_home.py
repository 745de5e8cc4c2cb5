"""Where those who work at home have their desks, and what is said of desks, which wins."""

from sentences.facts import as_meant

test_places_of_desks = as_meant([
    # rooms that are open, by how much floor there is
    ("flat of 90 m2 for two people who work at home", "B H K L S2 W", "S1 has 1 desk, S2 has 1 desk"),
    ("flat of 84 m2 for two people who work at home", "B H K L S W", "S1 has 2 desk"),
    ("flat of 65 m2 for a couple who both work from home", "B H K L W", "B1 has 1 desk, L1 has 1 desk"),
    ("flat of 62 m2, I work from home", "B H K L S W", "S1 has 1 desk"),
    ("flat of 55 m2, I work from home", "B H K L W", "B1 has 1 desk"),
    ("flat for a couple, both work from home; the kitchen should be large", "B H K L S W", "S1 has 2 desk"),
    ("flat for a couple, both work from home, no study", "B H K L W", "B1 has 1 desk, L1 has 1 desk"),
    ("a family with two children; the parents work at home", "B3 H K L S W2", "S1 has 2 desk"),
    ("two people work from home, 80 m2", "B H K L S W", "S1 has 2 desk"),
    # studies: large enough for two unless somebody says how large; one each where there are two
    ("two-bedroom flat, we both work from home, study of 6 m2", "B2 H K L S W", "S1 has 1 desk, B2 has 1 desk, S1=6"),
    ("two-bedroom flat, we both work from home, study of 9 m2", "B2 H K L S W", "S1 has 2 desk, S1=9"),
    ("two-bedroom flat with a small study, we both work from home", "B2 H K L S W", "S1 has 2 desk, S1=8.5"),
    ("two-bedroom flat with a study, 60 m2, we both work from home", "B2 H K L S W", "S1 has 2 desk, S1=8.5, all=60"),
    ("one bedroom and two home offices for a couple who work from home", "B H K L S2 W",
     "S1 has 1 desk, S2 has 1 desk"),
    # bedrooms: those that nobody needs, never a child's; of those who share a flat each has his own
    ("two-bedroom flat for a couple with a baby, my wife works from home and so do I", "B2 H K L W",
     "B1 has 1 desk, L1 has 1 desk, !B2 has 1 desk"),
    ("four-bedroom flat for a family with two kids, both parents work from home", "B4 H K L W2",
     "B4 has 1 desk, B1 has 1 desk"),
    ("three flatmates who all work from home, three-bedroom flat", "B3 H K L W2",
     "B1 has 1 desk, B2 has 1 desk, B3 has 1 desk"),
    # what is said of desks wins
    ("two-bedroom flat, we both work from home and need a desk each", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
    ("two-bedroom flat, we both work from home, with a desk for either of us", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 desk"),
    ("two-bedroom flat with a study with a desk, we both work from home", "B2 H K L S W", "S1 has 1 desk"),
    ("two-bedroom flat with two desks in the living room, we both work from home", "B2 H K L W", "L1 has 2 desk"),
    ("flat for a couple who both work from home, with two desks", "B H K L S W", "S1 has 2 desk"),
    ("flat for a couple who both work from home, with an office corner in the living room", "B H K L W",
     "L1 has 1 desk"),
    ("two-bedroom flat. Child's bedroom needs a desk. My wife works from home.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 desk"),
    ("one-bedroom flat. I work from home in the living room.", "B H K L W", "L1 has 1 desk, !B1 has 1 desk"),
    ("one-bedroom flat with a living room where I can work from home", "B H K L W", "L1 has 1 desk"),
    ("My wife works from home and needs a desk in the bedroom. One-bedroom flat.", "B H K L W", "B1 has 1 desk"),
    ("two-bedroom flat with a room to work from home", "B2 H K L S W", "S1 has 1 desk"),
    ("3 bedroom flat, one of the bedrooms is used as my home office since I work from home", "B3 H K L W2",
     "B1 has 1 desk, use B1 study"),
    ("We both work from home so we each need a study. One bedroom.", "B H K L S2 W", "S1 has 1 desk, S2 has 1 desk"),
    ("Two-bedroom flat. Both of us work from home, one in the bedroom and one in the living room.", "B2 H K L W",
     "B1 has 1 desk, L1 has 1 desk, !B2 has 1 desk"),
    ("A couple with a toddler; I work from home and he's at the office. Two bedrooms.", "B2 H K L W", "B1 has 1 desk"),
    ("two-bedroom flat; we rarely work from home", "B2 H K L W", "!B2 has 1 desk, !unread work, !unread rarely"),
    ("flat for two programmers who work from home", "B2 H K L S W", "S1 has 2 desk, !unread two"),
    ("a robot that works at home; two-bedroom flat", "B2 H K L W", "unread works"),
])  # fmt: skip

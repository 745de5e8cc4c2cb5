"""Where a list of rooms goes on behind a clause said of one of them, and doors told as ways that somebody takes."""

from sentences.facts import as_meant

SENTENCES = [
    # the list goes on behind the clause
    ("Two bedrooms, a bathroom between them that opens to both, living room, kitchen, storage room.", "B2 H K L T W",
     "B1W1, B2W1, !K1W1, !L1W1, !T1W1, H1T1"),
    ("Two bedrooms, a bathroom between the two which opens to both of them, a living room and a kitchen.",
     "B2 H K L W", "B1W1, B2W1, !B1B2, !B1L1, !B1K1"),
    ("one bedroom, living room that opens to the kitchen, bathroom, and a study with a desk", "B H K L S W",
     "K1~L1, H1W1, H1S1, S1 has 1 desk, !L1S1, !L1W1"),
    ("bedroom, hall that leads to the living room, kitchen and bathroom", "B H K L W", "H1L1, H1K1, H1W1"),
    ("A bedroom, a bathroom that is off the bedroom, a kitchen, a living room.", "B H K L W", "B1W1, !B1K1, !B1L1"),
    ("The living room opens to the kitchen and the hallway. Two bedrooms.", "B2 H K L W", "K1L1, H1L1, !K1~L1"),
    # a new room of which more is said
    ("Two bedrooms. Add a home office that is accessible only from the second bedroom, and a terrace accessible from "
     "both the living room and the kitchen.", "B2 H K L S W Y", "B2S1, L1Y1, K1Y1, !S1Y1, !H1S1"),
    ("Two bedrooms. A pantry that opens off the kitchen and a terrace next to the living room.", "B2 H K L T W Y",
     "K1T1, adjacent Y1 L1, !T1Y1"),
    ("Two bedrooms. There is a study that opens off the living room and a balcony reached from the kitchen.",
     "B2 H K L S W Y", "L1S1, K1Y1, !S1Y1"),
    # the last of a list opens off another
    ("Zweizimmerwohnung mit offener Küche, Abstellraum und einem Balkon am Schlafzimmer.", "B H K L T W Y",
     "B1Y1, H1T1, !B1T1"),
    ("One bedroom, open kitchen, storage room and a balcony off the bedroom.", "B H K L T W Y", "B1Y1, H1T1, !B1T1"),
    ("2 bedrooms, kitchen, bathroom and one balcony accessible from the living room", "B2 H K L W Y",
     "L1Y1, H1W1, !L1W1"),
    ("Appartement avec deux chambres, cuisine, cellier et un balcon accessible depuis le salon.", "B2 H K L T W Y",
     "L1Y1, !L1T1"),
    ("Three bedrooms each with its own bathroom, plus a guest toilet and two balconies off the living room.",
     "B3 H K L W4 Y2", "L1Y1, L1Y2, H1W4, !L1W4"),
    ("A kitchen, a bathroom and two balconies off the living room, one bedroom.", "B H K L W Y2",
     "L1Y1, L1Y2, !L1W1, !K1L1"),
    ("A kitchen, a living room, a bathroom and two bedrooms off the hallway.", "B2 H K L W", "B1H1, B2H1, H1W1, H1K1"),
    # arrows lead from the head of their line
    ("entry hall -> guest toilet, living room, kitchen; living room -> dining room (open), terrace; corridor off the "
     "living room -> 2 bedrooms, family bathroom", "B2 D H2 K L W2 Y", "B1H2, B2H2, H2W2, D1~L1, L1Y1, !B1L1"),
    ("hall -> living room -> kitchen; hall -> bedroom, bathroom", "B H K L W", "H1L1, K1L1, B1H1, H1W1, !H1K1"),
    # ways
    ("The robot enters a hallway, passes through the living room to reach the kitchen, and both bedrooms open off the "
     "hallway.", "B2 H K L W", "H1L1, K1L1, B1H1, B2H1, !H1K1"),
    ("Two bedrooms. You walk through the living room to get to the kitchen.", "B2 H K L W", "K1L1, H1L1, !H1K1"),
    ("Two bedrooms. To get to the kitchen you walk through the living room.", "B2 H K L W", "K1L1, H1L1, !H1K1"),
    ("Two bedrooms. To reach the study, you have to pass through the main bedroom.", "B2 H K L S W", "B1S1, !H1S1"),
    ("Two bedrooms. The agent goes from the hallway through the living room into the kitchen.", "B2 H K L W",
     "H1L1, K1L1, !H1K1, !B1L1"),
    ("From the hall you go through the living room to the kitchen. One bedroom.", "B H K L W", "H1L1, K1L1, !H1K1"),
    ("Two bedrooms. The player crosses the kitchen to get to the pantry.", "B2 H K L T W", "K1T1, !H1T1"),
    ("One passes through the dining room to reach the kitchen. Two bedrooms.", "B2 D H K L W", "D1K1, !H1K1"),
    ("One bedroom, and a balcony you reach from the kitchen.", "B H K L W Y", "K1Y1, !L1Y1"),
    ("Two bedrooms, a pantry you enter through the kitchen, a study.", "B2 H K L S T W", "K1T1, !K1S1"),
    ("Two bedrooms, a terrace that you step onto from the main bedroom.", "B2 H K L W Y", "B1Y1, !L1Y1"),
    ("Two bedrooms, a study one can enter from the living room.", "B2 H K L S W", "L1S1, !H1S1"),
    ("Two bedrooms. The study is through the living room.", "B2 H K L S W", "L1S1"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

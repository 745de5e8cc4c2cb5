"""What rooms a clause is said of: `its area`, `and the bedroom on the east side`, `between them`, `one suite`."""

from sentences.facts import as_meant

OF = [
    ("Two bedrooms, no open kitchen, I can't stand the smell of frying in the lounge.", "B2 H K L W", "H1K1, !K1~L1"),
    ("Zwei Schlafzimmer, keine offene Küche, ich mag keinen Kochgeruch im Wohnzimmer.", "B2 H K L W",
     "H1K1, unread kochgeruch"),
    ("Dos dormitorios, sin cocina abierta, odio el olor a comida en el salón.", "B2 H K L W", "H1K1"),
    ("Two bedrooms; the study must be near the entrance and its size should be at least 8 m2.", "B2 H K L S W",
     "at_least S1 8, near S1 entrance"),
    ("The kitchen is next to the bathroom. Its area should be 10 m2. Two bedrooms.", "B2 H K L W", "K1=10"),
    ("Ein Schlafzimmer. Das Arbeitszimmer soll neben dem Bad liegen und seine Fläche soll höchstens 9 m² betragen.",
     "B H K L S W", "at_most S1 9, adjacent S1 W1"),
    ("Una habitación. El despacho debe estar junto al baño y su superficie no debe superar 9 m².", "B H K L S W",
     "at_most S1 9"),
    ("Une chambre. Le bureau doit être à côté du salon et sa surface ne doit pas dépasser 9 m².", "B H K L S W",
     "at_most S1 9"),
    ("Three bedrooms. Put the pantry beside the kitchen and the bathroom in the north.", "B3 H K L T W",
     "adjacent T1 K1, position W1 north, !adjacent T1 W1"),
    ("Drei Schlafzimmer, der Hauswirtschaftsraum neben der Küche und das Bad im Norden.", "B3 H K L U W",
     "adjacent U1 K1, position W1 north, !adjacent U1 W1"),
    ("Tres dormitorios, el lavadero junto a la cocina y el dormitorio principal al este.", "B3 H K L U W2",
     "position B1 east, !adjacent U1 B1"),
    ("A flat: one bedroom for us and one for my mother. Both rooms must be far from each other.", "B2 H K L W",
     "apart B1 B2"),
    ("A flat: one bedroom for us, one for the baby. The two rooms should be next to each other.", "B2 H K L W",
     "adjacent B1 B2"),
    ("Two bedrooms; the kitchen should back onto the bathroom.", "B2 H K L W", "adjacent K1 W1, !K1W1"),
    ("Zwei Schlafzimmer. Das Bad liegt Rücken an Rücken mit der Küche.", "B2 H K L W", "adjacent W1 K1"),
    ("Two bedrooms at the back and a bathroom between them.", "B2 H K L W", "B1W1, B2W1"),
    ("Deux chambres et une salle de bains entre elles.", "B2 H K L W", "B1W1, B2W1"),
    ("Deux chambres et une salle de bains entre les deux, cuisine au nord.", "B2 H K L W", "B1W1, B2W1, !K1W1"),
    ("Zwei Schlafzimmer und dazwischen das Bad.", "B2 H K L W", "B1W1, B2W1"),
    ("Three bedrooms including one suite with its bathroom, and a family bathroom.", "B3 H K L W2", "B1W1, H1W2"),
    ("Quatre chambres dont une suite parentale avec sa salle d'eau, une salle de bains commune.", "B4 H K L W2",
     "B1W1, H1W2"),
    ("Tres dormitorios, uno de ellos una suite con su baño, y un baño para los otros dos.", "B3 H K L W2", "B1W1"),
    ("The kitchen and the living room and the dining room face south. Two bedrooms.", "B2 D H K L W",
     "orientation K1 south, orientation L1 south, orientation D1 south"),
    ("El salón y la cocina y el comedor en un solo espacio, dos dormitorios.", "B2 D H K L W", "D1~K1, D1~L1"),
    ("Dos dormitorios y dos baños y el salón y la cocina juntos.", "B2 H K L W2", "K1~L1"),
]  # fmt: skip
ONE_WAY = [
    ("Deux chambres, la cuisine n'est accessible que depuis le salon.", "B2 H K L W", "K1L1, !H1K1"),
    ("On n'accède au bureau que par le salon. Deux chambres.", "B2 H K L S W", "L1S1, !H1S1"),
    ("Piso de dos dormitorios. Al lavadero solo se accede por la cocina.", "B2 H K L U W", "K1U1, !H1U1"),
    ("Al baño de invitados solo se llega desde el recibidor; tres dormitorios y un baño.", "B3 H K L W2", ""),
    ("Un despacho al que solo se entra por el salón, y dos dormitorios.", "B2 H K L S W", "L1S1, !H1S1"),
    ("Two bedrooms; nobody gets into the study except through the living room.", "B2 H K L S W", "L1S1, !H1S1"),
    ("Two bedrooms, a pantry that you enter by the kitchen.", "B2 H K L T W", "K1T1, !H1T1"),
    ("Una cocina y un salón que den al norte y dos dormitorios que den al sur.", "B2 H K L W",
     "orientation K1 north, orientation L1 north, orientation B1 south, orientation B2 south"),
]  # fmt: skip
LEARNT = [
    ("Three bedrooms. The kitchen must be the most small room.", "B3 H K L W2", "order K1 smallest"),
    ("Bedroom are three, bathroom is two. Balcony in living room.", "B3 H K L W2 Y", ""),
    ("Three bedrooms, the biggest must be most far from the entrance.", "B3 H K L W2", "apart B1 entrance"),
    ("My home: bedroom is two, size is 13 m2 and 10 m2.", "B2 H K L W", "B1=13, B2=10"),
]  # fmt: skip

test_clauses_are_said_of_their_rooms = as_meant(OF)
test_one_way_in = as_meant(ONE_WAY)
test_learners = as_meant(LEARNT)

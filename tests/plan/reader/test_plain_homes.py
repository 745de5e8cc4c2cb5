"""Plain requests for homes: where one comes in, whose baths and balconies are whose, limits without units."""

from sentences.facts import as_meant

STRAIGHT_IN = [
    ("You enter the flat directly into the living room, with the kitchen to the left and the bedroom to the right.",
     "B K L W", "position K1 left, position B1 right, B1L1, K1L1"),
    ("A one-bedroom flat where the entrance is in the living room.", "B K L W", ""),
    ("One enters the flat through the living room. One bedroom.", "B K L W", ""),
    ("The front door opens into the living room. Three bedrooms off a corridor.", "B3 H K L W2", ""),
    ("You can walk from the kitchen directly into the living room. Two bedrooms.", "B2 H K L W", "K1L1"),
]  # fmt: skip

test_one_comes_straight_into_a_room = as_meant(STRAIGHT_IN)

WHOSE = [
    ("Two bathrooms: one with a bathtub for the family and one with only a shower for the guests.", "B2 H K L W2",
     "W1 has 1 bath, W2 has 1 shower, H1W1, H1W2, !unread guests"),
    ("A two-bedroom flat for me and my flatmate with one bathroom each and a shared kitchen-living room.",
     "B2 H K L W2", "B1W1, B2W2, K1~L1"),
    ("There are two balconies, one for the kitchen and one for the bedroom.", "B H K L W Y2", "K1Y1, B1Y2, !L1Y1"),
    ("Two walk-in closets, one for each bedroom. Two bedrooms.", "B2 C2 H K L W", "B1C1, B2C2"),
    ("Vom Flur aus kommt man in alle Zimmer, nur das Bad ist vom Schlafzimmer aus zugänglich.", "B H K L W",
     "B1W1, H1K1, !H1W1"),
    ("Every room opens off the hall, only the bathroom is accessible from the bedroom.", "B H K L W", "B1W1, !H1W1"),
    ("Les toilettes sont séparées de la salle de bain et la buanderie se trouve à côté de la cuisine.",
     "B2 H K L U W2", "adjacent U1 K1, !adjacent W1 K1, !adjacent W2 K1"),
    ("El aseo está separado del baño. Dos dormitorios.", "B2 H K L W2", ""),
    ("All rooms should have windows except the bathroom and the storage.", "B2 H K L T W", "unread windows, !T1W1"),
    ("A gym room with a treadmill, a home cinema and a wine cellar next to the kitchen.", "B2 H K L S2 W",
     "unread wine cellar, !adjacent S2 K1"),
]  # fmt: skip

test_whose_it_is = as_meant(WHOSE)

LIMITS = [
    ("The bathroom should be at least 6 square meters and the kitchen between 8 and 10.", "K W",
     "at_least W1 6, at_least K1 8, at_most K1 10, K1=9, W1=6"),
    ("The total area should be between 70 and 80 square meters, with the living room taking up at least 25.",
     "B2 H K L W", "at_least home 70, at_most home 80, at_least L1 25"),
    ("Living room 25 m2, kitchen between 8 and 10, two bedrooms.", "B2 H K L W", "at_least K1 8, at_most K1 10"),
    ("A flat of 80 m², the living room at least 25, the kitchen no more than 10, two bedrooms.", "B2 H K L W",
     "all=80, at_least L1 25, at_most K1 10"),
    ("A flat of 80 m² with at least 2 bedrooms and a kitchen.", "B2 H K L W", "all=80"),
    ("A flat of 80 m² with a living room with at least 3 windows.", "B2 H K L W", "!L1=3"),
    ("Eine Dreizimmerwohnung mit Küche, Bad und Balkon, ungefähr 75 Quadratmeter.", "B2 H K L W Y",
     "all=75, !unread ungefahr"),
]  # fmt: skip

test_limits_without_a_unit = as_meant(LIMITS)

"""The commonest ways of saying one thing in five languages: dimensions, ranges, rooms of guests, politeness."""

from sentences.facts import however_said

SAID: dict[tuple[str, str], list[str]] = {
    ("B2 H K L W", "dimension B1 4 x 3"): [
        "Two bedrooms, the main one 4 x 3 m.", "Two bedrooms; the main bedroom is 4 by 3 metres.",
        "Two bedrooms, master bedroom 4m x 3m.",
        "Two bedrooms. The main bedroom should be 4 m long and 3 m wide.",
        "Two bedrooms, the main bedroom measures 4 × 3 m.", "Zwei Schlafzimmer, das Elternschlafzimmer 4 x 3 m.",
        "Zwei Schlafzimmer, das Elternschlafzimmer ist 4 m lang und 3 m breit.",
        "Deux chambres, la chambre principale de 4 x 3 m.",
        "Deux chambres, la chambre principale fait 4 m sur 3 m.",
        "Dos dormitorios, el dormitorio principal de 4 x 3 m.",
        "Dos dormitorios, el dormitorio principal mide 4 m por 3 m.", "两室，主卧4米乘3米。",
    ],
    ("B2 H K L W", "L1=18.58"): [
        "Two bedrooms, a 200 sq ft living room.", "Two bedrooms, living room 200 sqft.",
        "Two bedrooms, living room of 200 square feet.", "Two bedrooms, living room: 200 ft².",
        "Two bedrooms; the living room should be 200 sq. ft.",
    ],
    ("B2 H K L W", "all=83.61"): [
        "Two bedrooms, 900 sq ft.", "A 900 square foot flat with two bedrooms.", "Two bedrooms, 900 sqft total.",
        "Two-bedroom apartment, about 900 square feet.",
    ],
    ("B2 H K L W", "at_least home 70, at_most home 80"): [
        "Two bedrooms, 70 to 80 m2.", "Two bedrooms, between 70 and 80 m² in total.",
        "A two-bedroom flat of 70-80 sqm.", "A two-bedroom flat, somewhere between 70 and 80 square metres.",
        "Zwei Schlafzimmer, 70 bis 80 m².", "Eine Wohnung mit zwei Schlafzimmern und 70-80 m².",
        "Un appartement de deux chambres de 70 à 80 m².", "Deux chambres, entre 70 et 80 m².",
        "Un piso de dos dormitorios de 70 a 80 m².", "Dos dormitorios, entre 70 y 80 m².", "两室，70到80平米。",
    ],
    ("B3 H K L W2", "B1=12, B2=12, B3=12"): [
        "Three bedrooms of 12 m2 each.", "Three bedrooms, each 12 m².", "Three 12 m² bedrooms.",
        "Three bedrooms, 12 m² each.", "Three bedrooms with 12 sqm each.",
        "Three bedrooms. Each bedroom is 12 m².", "Three bedrooms; every bedroom should have 12 m².",
        "Three bedrooms à 12 m².", "Drei Schlafzimmer à 12 m².", "Drei Schlafzimmer mit je 12 m².",
        "Drei Schlafzimmer, jedes 12 m².", "Drei Schlafzimmer von jeweils 12 m².",
        "Trois chambres de 12 m² chacune.", "Trois chambres de 12 m².", "Tres dormitorios de 12 m² cada uno.",
        "Tres dormitorios de 12 m².", "三个卧室，每个12平米。", "三个12平方米的卧室。",
    ],
    ("B3 H K L W2", ""): [
        "Two bedrooms and a guest room.", "Two bedrooms plus a guest bedroom.", "Two bedrooms and a spare room.",
        "Two bedrooms and a room for guests.", "Two bedrooms and an extra bedroom for visitors.",
        "Zwei Schlafzimmer und ein Gästezimmer.", "Zwei Schlafzimmer und ein Zimmer für Gäste.",
        "Deux chambres et une chambre d'amis.", "Deux chambres et une chambre pour les invités.",
        "Dos dormitorios y una habitación de invitados.", "Dos dormitorios y un cuarto para invitados.",
        "两个卧室，一个客房。",
    ],
    ("B2 H K L S W", "use S1 bedroom"): [
        "Two bedrooms and a study that also serves as a guest room.",
        "Two bedrooms and an office that doubles as a guest room.",
        "Two bedrooms and a study which can be used as a guest room.", "Two bedrooms, an office/guest room.",
        "Two bedrooms, a study that is also the guest room.",
        "Zwei Schlafzimmer und ein Arbeitszimmer, das auch als Gästezimmer dient.",
        "Deux chambres et un bureau qui sert aussi de chambre d'amis.",
        "Dos dormitorios y un despacho que también sirve de habitación de invitados.",
        "两个卧室，一个书房兼客房。",
    ],
    ("B2 H K L T W", "adjacent T1 K1 or K1T1"): [
        "Two bedrooms and a pantry next to the kitchen.", "Two bedrooms, a pantry off the kitchen.",
        "Two bedrooms, kitchen with pantry.", "Two bedrooms; the kitchen has a pantry.",
        "Zwei Schlafzimmer, eine Speisekammer neben der Küche.", "Zwei Schlafzimmer, Küche mit Speisekammer.",
        "Deux chambres, un cellier à côté de la cuisine.", "Deux chambres, cuisine avec cellier.",
        "Dos dormitorios, una despensa al lado de la cocina.", "Dos dormitorios, cocina con despensa.",
        "两室，厨房旁边有储藏室。",
    ],
}  # fmt: skip

test_it_is_read_however_it_is_said = however_said(SAID)

"""Openings without a door between two rooms, and sides of the entrance before their rooms, in five languages."""

from sentences.facts import as_meant

OPEN = [
    ("Two bedrooms; kitchen and dining room have an opening without a door between them.", "B2 D H K L W", "D1~K1"),
    ("Two bedrooms, the lounge and the dining room having opening without door in between.", "B2 D H K L W", "D1~L1"),
    ("Three bedrooms, the kitchen and the dining room open to each other, a bath and a study.", "B3 D H K L S W",
     "D1~K1"),
    ("Put the dining room between kitchen and lounge, open to the lounge but with a door to the kitchen. One bedroom.",
     "B D H K L W", "D1~L1, D1K1, H1K1, !K1L1"),
    ("Zwei Schlafzimmer; zwischen Küche und Esszimmer eine Öffnung ohne Tür.", "B2 D H K L W", "D1~K1"),
    ("Zwei Schlafzimmer; Küche und Esszimmer sind zueinander offen.", "B2 D H K L W", "D1~K1, !unread zueinander"),
    ("Deux chambres; une ouverture sans porte entre la cuisine et la salle à manger.", "B2 D H K L W", "D1~K1"),
    ("Deux chambres; la cuisine et le salon sont ouverts l'un sur l'autre.", "B2 H K L W", "K1~L1"),
    ("Dos dormitorios; la cocina y el comedor con un hueco sin puerta entre ellos.", "B2 D H K L W", "D1~K1"),
    ("两间卧室，厨房和餐厅之间有开口没有门。", "B2 D H K L W", "D1~K1"),
]  # fmt: skip
SIDES = [
    ("Appartement d'une chambre. À droite en entrant, le salon ; à gauche, la cuisine.", "B H K L W",
     "position L1 entrance right, position K1 entrance left"),
    ("Una habitación. A la izquierda al entrar, la cocina; a la derecha, el salón.", "B H K L W",
     "position K1 entrance left, position L1 entrance right"),
    ("Ein Schlafzimmer. Links beim Reinkommen die Küche; rechts das Wohnzimmer.", "B H K L W",
     "position K1 entrance left, position L1 entrance right"),
    ("One bedroom. On the left as you enter, the kitchen; on the right, the living room.", "B H K L W",
     "position K1 entrance left, position L1 entrance right"),
]  # fmt: skip

test_openings_without_a_door = as_meant(OPEN)
test_sides_before_their_rooms = as_meant(SIDES)

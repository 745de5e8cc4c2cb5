"""What stands apart from its room, neighbours in other verbs, limits and doors in five languages, rooms of families."""

from sentences.facts import as_meant

NEIGHBOURS = [
    ("One bedroom, one living room. The bathroom and the kitchen must not be neighbours.", "B H K L W", "apart W1 K1"),
    ("Two bedrooms. There must be no common wall between the bedrooms.", "B2 H K L W", "apart B1 B2"),
    ("Two bedrooms; no shared wall between kitchen and bathroom.", "B2 H K L W", "apart K1 W1"),
    ("Zwei Schlafzimmer. Die Schlafzimmer sollen nicht nebeneinander liegen.", "B2 H K L W", "apart B1 B2"),
    ("Zwei Schlafzimmer, Küche und Bad sollen aneinander grenzen.", "B2 H K L W", "adjacent K1 W1"),
    ("Dos dormitorios; la cocina y el baño no deben estar juntos.", "B2 H K L W", "apart K1 W1"),
    ("Two bedrooms; at the back the kitchen, and beside it a storage room.", "B2 H K L T W",
     "position K1 back, adjacent T1 K1"),
    ("One bedroom and beside it a bathroom with a shower. A living room, a kitchen.", "B H K L W", "adjacent W1 B1"),
    ("Two bedrooms and a living room; no room larger than the living room.", "B2 H K L W", "order L1 largest"),
]  # fmt: skip
LIMITS = [
    (f"{home} {clause}", "B2 H K L W", f"{limit}, !unread largo")
    for home, clauses in (
        ("Dos dormitorios.", (("El pasillo no puede medir más de 4 metros de largo.", "at_most H1 length 4"),
                              ("El pasillo no puede ser más estrecho de 1,2 m.", "at_least H1 width 1.2"),
                              ("El pasillo tiene que medir al menos 1,2 metros de ancho.", "at_least H1 width 1.2"),
                              ("La cocina no debe medir menos de 10 m2.", "at_least K1 10"))),
        ("Deux chambres.", (("Le couloir ne doit pas faire plus de 4 m de long.", "at_most H1 length 4"),
                            ("Le couloir doit mesurer au moins 1,2 m de large.", "at_least H1 width 1.2"))),
        ("Zwei Schlafzimmer.", (("Der Flur soll nicht mehr als 4 m lang sein.", "at_most H1 length 4"),)),
    )
    for clause, limit in clauses
]  # fmt: skip
DOORS = [
    ("Ein Schlafzimmer, ein Wohnzimmer. Das Bad soll vom Flur und vom Schlafzimmer aus erreichbar sein.", "B H K L W",
     "B1W1, H1W1"),
    ("Une chambre, un salon, une salle de bains accessible depuis la chambre et le couloir.", "B H K L W",
     "B1W1, H1W1"),
    ("Un dormitorio, un salón. Al baño se entra tanto desde el dormitorio como desde el pasillo.", "B H K L W",
     "B1W1, H1W1"),
    ("一间卧室，一个客厅，卫生间从卧室和走廊都能进。", "B H K L W", "B1W1, H1W1"),
    ("Zwei Schlafzimmer. Vom Elternschlafzimmer soll man direkt auf den Balkon kommen.", "B2 H K L W Y", "B1Y1"),
    ("Two bedrooms, one bathroom, a lounge that faces south and leads to a balcony, a kitchen, and a store room.",
     "B2 H K L T W Y", "L1Y1, H1K1, H1T1, orientation L1 south"),
    ("Two bedrooms, one bathroom, a larder off the kitchen, and kitchen and sitting room without a door between them.",
     "B2 H K L T W", "no_door K1 L1"),
]  # fmt: skip
PEOPLE = [
    ("My three mates and I each get a room.", "B4 H K L W2", ""),
    ("The four of us each get our own room.", "B4 H K L W2", ""),
    ("Home for a family of three; the kids room has a desk.", "B2 H K L W", "B2 has 1 desk"),
    ("A family with twins and a teenager: the twins share a room, the teenager has her own room.", "B3 H K L W2", ""),
    ("Three bedrooms. One bathroom is off the hall and the master has a private one.", "B3 H K L W2", "B1W2"),
    ("The kitchen is open to the living room, which faces west and gets a piano. Two bedrooms.", "B2 H K L W",
     "L1 has 1 piano, orientation L1 west"),
]  # fmt: skip
RELATIVES = [
    (f"{home} mit zwei Kindern, {clause}.", "B2 H K L W", "")
    for home in ("Familie", "Wohnung für ein Paar", "Wir sind ein Paar")
    for clause in ("die sich ein Zimmer teilen", "die sich das Schlafzimmer teilen", "die ein Zimmer teilen")
]


test_neighbours_in_other_verbs = as_meant(NEIGHBOURS)
test_limits_in_other_languages = as_meant(LIMITS)
test_doors_told_together_or_in_a_list = as_meant(DOORS)
test_rooms_of_people_and_what_they_have = as_meant(PEOPLE)
test_relative_clauses_that_end_with_their_verb = as_meant(RELATIVES)

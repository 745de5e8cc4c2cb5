"""Who shares a room and who sleeps with the parents, rooms told of behind others, corners and storeys."""

from sentences.facts import as_meant, however_said

SLEEPS_WITH_US = [
    ("We are a family with three kids; two of them share a room and the baby sleeps in ours. We also need a pantry "
     "off the kitchen.", "B2 H K L T W", "B1H1, B2H1, K1T1"),
    ("We have three children, two of them share a room and the youngest sleeps with us.", "B2 H K L W", "B1H1, B2H1"),
    ("Family with four kids: two share a room, the eldest has her own, the baby sleeps in our bedroom.",
     "B3 H K L W2", ""),
    ("We have three sons: two of them share, the youngest has his own room.", "B3 H K L W2", ""),
]  # fmt: skip
OWN_ROOMS = [
    ("We are students, four peoples, everyone wants own room, two bathrooms from the corridor, one common kitchen and "
     "no living room please", "B4 H K W2", "H1W1, H1W2, H1K1, B3H1, B4H1, !B1W1, !K1W1, !unread students"),
    ("We are friends, three persons, each needs own bedroom, one bathroom from the hall.", "B3 H K L W", "H1W1"),
    ("Three bedrooms, two bathrooms from the corridor.", "B3 H K L W2", "H1W1, H1W2"),
]  # fmt: skip
CORNERS = [
    ("Casa de dos plantas con piscina, cuatro dormitorios, dos baños y un despacho en la esquina noreste",
     "B4 H K L S W2", "position S1 north_east, !position S1 corner, unread dos plantas, unread piscina, "
     "!unread noreste, !L1 has 2 plant"),
    ("Vivienda con dos plantas, dos dormitorios; el salón con dos plantas y un sofá.", "B2 H K L W",
     "L1 has 2 plant, unread dos plantas"),
    ("Piso de un dormitorio. La cocina está en la esquina suroeste.", "B H K L W", "position K1 south_west"),
    ("Appartement deux chambres, le salon dans l'angle sud-ouest.", "B2 H K L W", "position L1 south_west"),
    ("Appartement deux chambres, le bureau dans le coin nord-est.", "B2 H K L S W", "position S1 north_east"),
    ("Zwei Schlafzimmer, das Arbeitszimmer in der Südostecke.", "B2 H K L S W", "position S1 south_east"),
    ("Zwei Schlafzimmer, die Küche in der nordwestlichen Ecke.", "B2 H K L W", "position K1 north_west"),
]  # fmt: skip
DOORS_BETWEEN = [
    ("Two bedrooms, one bathroom. There should be a door between the kitchen and the dining room but none between the "
     "kitchen and the hallway.", "B2 D H K L W", "D1K1, no_door K1 H1, !adjacent W1 K1, !adjacent W1 D1, !K1L1"),
    ("Two bedrooms, one bathroom. There must be doors between the kitchen and the dining room.", "B2 D H K L W",
     "D1K1, !adjacent W1 K1"),
    ("Deux chambres, une salle de bain. Il doit y avoir une porte entre la cuisine et la salle à manger.",
     "B2 D H K L W", "D1K1, !B1K1, !B1D1, !unread porte, !unread avoir"),
    ("Dos dormitorios, un baño. Debe haber una puerta entre la cocina y el comedor.", "B2 D H K L W",
     "D1K1, !B1K1, !unread puerta, !unread haber"),
    ("Zwei Schlafzimmer, ein Bad. Es soll eine Tür zwischen Küche und Esszimmer geben.", "B2 D H K L W",
     "D1K1, !B1K1, !unread tur, !unread geben"),
    ("Zwei Schlafzimmer, ein Bad. Zwischen Küche und Esszimmer soll eine Tür sein.", "B2 D H K L W",
     "D1K1, !B1K1, !unread tur"),
]  # fmt: skip
SUITES = [
    ("Une maison avec quatre chambres dont une suite parentale avec dressing et salle de bain, une autre salle de bain "
     "pour les enfants, et un garage.", "B4 C H K L W2", "B1W1, B1C1, H1W2, unread garage"),
    ("Quatre chambres dont une suite parentale avec salle de bain, une salle de bain pour les enfants.",
     "B4 H K L W2", "B1W1, H1W2"),
    ("A master suite with bathroom, two bedrooms, another bathroom.", "B3 H K L W2", "B1W1, H1W2"),
    ("Three bedrooms including a master suite with bathroom, and a guest toilet.", "B3 H K L W3", "B1W1, H1W2"),
]  # fmt: skip
LIVE_WITH = [
    ("Vivo con mi madre y mi hermano, cada uno necesita su dormitorio. El baño tiene que estar al lado del cuarto de "
     "mi madre y el lavadero debe tener puerta a la cocina.", "B3 H K L U W",
     "adjacent W1 B1, !adjacent W1 B2, K1U1, !H1U1, !adjacent W1 U1, "
     "!adjacent W1 K1, !unread vivo, !unread madre, !unread puerta"),
    ("I live with my mother and my brother, each needs a bedroom. One bathroom.", "B3 H K L W", "H1W1, !unread live"),
    ("I live with my mother and my brother, each needs a bedroom. My mother's room is next to the bathroom, my "
     "mother's room has a balcony. One bathroom.", "B3 H K L W Y", "adjacent B1 W1, !adjacent B2 W1, B1Y1, !B2Y1"),
    ("Dos dormitorios. El cuarto de mi madre está cerca de la entrada.", "B2 H K L W", "!unread madre"),
    ("Un dormitorio; la cocina tiene que tener acceso a la terraza.", "B H K L W Y", "K1Y1"),
]  # fmt: skip
BIGGEST_FOR = [
    ("The flat has three bedrooms; the biggest one is for my parents and has a walk-in closet, the other two are for "
     "me and my brother. One bathroom for all of us.", "B3 C H K L W",
     "order B1 B2 larger, order B1 B3 larger, B1C1, H1W1"),
    ("Three bedrooms, the biggest is for us.", "B3 H K L W2", "order B1 B2 larger, order B1 B3 larger"),
    ("Two bedrooms; the smallest one is for guests.", "B2 H K L W", "order B2 B1 smaller, !unread guests"),
]  # fmt: skip
OPEN_WITH = [
    ("I want make apartment for 2 persons with 1 sleeping room, 1 bath, kitchen is open with salon", "B H K L W",
     "K1~L1, K1L1, B1H1, H1W1, H1L1"),
    ("Two bedrooms, the kitchen should be open with the dining room.", "B2 D H K L W", "D1~K1"),
]  # fmt: skip
NEAR_LAST = [
    ("We are looking for a house with four bedrooms, two of them with ensuite bathrooms, plus a family bathroom and a "
     "guest toilet next to the front door.", "B4 H K L W4", "near W4 entrance, !near W3 entrance"),
    ("Two bedrooms plus a study and a storage room near the entrance.", "B2 H K L S T W",
     "near T1 entrance, !near S1 entrance"),
    ("The study and the guest toilet should be near the entrance. Two bedrooms.", "B2 H K L S W2",
     "near S1 entrance, near W1 entrance"),
]  # fmt: skip
SMALL_TALK = {
    ("B2 H K L S W", "S1 has 2 desk, S1 has 1 bookshelf"): (
        "Hello, could you please draw me a flat with two bedrooms and a home office? I would be grateful if the office "
        "had two desks and a bookcase. Many thanks, Anna",
    ),
    ("B D H K L W2", "D1~L1"): (
        "Dear Sir or Madam, please prepare a one-bedroom apartment. The dining room should be open to the living room. "
        "One bathroom and a guest WC.",
    ),
    ("B2 H K L W", "B1H1, B2H1"): (
        "Könnten Sie mir bitte eine Dreizimmerwohnung planen? Vielen Dank!",
        "Buenas tardes, ¿podrían hacerme un plano de una casa con dos habitaciones y un baño? Muchas gracias.",
        "Bonjour, il nous faut un appartement avec deux chambres. Merci, Luc",
        "My wife and I live with our son, who needs his own bedroom. One bathroom.",
    ),
    ("B H K L W", "orientation L1 west"): (
        "Good morning, I would like to order a plan for my mother, who lives alone. She needs one bedroom and a living "
        "room facing west please.",
    ),
    ("B2 H K L W3", "B1W1, B2W2"): (
        "Una casa con dos habitaciones, cada una con su propio baño, y un aseo para las visitas.",
    ),
    ("B H K L S W", "at_most H1 length 4"): (
        "One bedroom, one bathroom, a study. The whole apartment must stay under 70 m2, and the hallway should be no "
        "longer than 4 m.",
    ),
    ("B3 H K L W", "B1H1"): ("Three bedrooms, one bathroom, thanks, Ben",),
    ("B3 H K L W Y", "B1H1"): ("Three bedrooms, one bathroom, thanks, balcony",),
}  # fmt: skip

test_who_sleeps_with_the_parents_has_no_room = as_meant(SLEEPS_WITH_US)
test_each_of_those_counted_has_a_room = as_meant(OWN_ROOMS)
test_corners_have_a_point_of_the_compass_and_homes_no_plants = as_meant(CORNERS)
test_a_door_that_there_should_be_is_said_of_no_room_before = as_meant(DOORS_BETWEEN)
test_the_bathroom_of_a_suite_is_not_another_one = as_meant(SUITES)
test_who_lives_with_others_has_a_room_beside_theirs = as_meant(LIVE_WITH)
test_the_biggest_bedroom_is_of_those_it_is_for = as_meant(BIGGEST_FOR)
test_a_kitchen_is_open_with_what_it_is_open_to = as_meant(OPEN_WITH)
test_the_last_of_what_comes_on_top_is_near_the_entrance = as_meant(NEAR_LAST)
test_small_talk_is_not_told = however_said(SMALL_TALK)

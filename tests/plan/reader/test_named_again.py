"""Rooms named by what was told before, and what is instead of what: `besides my own bedroom`, `sondern`."""

from sentences.facts import as_meant

AGAIN = [
    ("Besides my own bedroom I need one small room with a single bed for my niece, and a bathroom next to my bedroom.",
     "B2 H K L W", "B2 has 1 single_bed, adjacent W1 B1"),
    ("Besides our bedroom we need two rooms for the boys; a bathroom next to our bedroom.", "B3 H K L W",
     "adjacent W1 B1"),
    ("Apart from our bedroom we need one room for guests.", "B2 H K L W", ""),
    ("Neben meinem eigenen Schlafzimmer brauche ich ein kleines Zimmer mit Etagenbett für die Enkel.", "B2 H K L W",
     "B2 has 1 bunk_bed"),
    ("En plus de ma chambre, il me faut une petite chambre pour mon neveu.", "B2 H K L W", ""),
    ("Además de mi dormitorio necesito una habitación pequeña para mi nieto.", "B2 H K L W", ""),
    ("除了我的卧室，我还需要一间小房间。", "B2 H K L W", ""),
    ("Maison pour un couple et un fils : la chambre du fils au nord, celle du couple au sud.", "B2 H K L W",
     "position B1 south, position B2 north"),
    ("Casa para una pareja y la abuela: el cuarto de la abuela cerca de la entrada, el de la pareja al fondo.",
     "B2 H K L W", "near B2 entrance, position B1 back"),
    ("House for a couple and grandma: grandma's room near the entrance, the couple's at the back.", "B2 H K L W",
     "near B2 entrance, position B1 back"),
    ("Pareja con un niño: nuestro dormitorio y el del niño juntos, un baño.", "B2 H K L W", "adjacent B1 B2"),
    ("Unser Schlafzimmer soll nicht an das Zimmer des Sohnes grenzen; ein Bad.", "B2 H K L W", "apart B1 B2"),
    ("One bedroom, a bathroom with a tub right next to it, a kitchen and a living room.", "B H K L W",
     "adjacent W1 B1"),
    ("Two bedrooms, one bathroom, kitchen, a study with a bath next to it.", "B2 H K L S W2", "adjacent W2 S1"),
    ("Ein Schlafzimmer, direkt daneben ein Bad, eine Küche.", "B H K L W", "adjacent W1 B1, !unread daneben"),
    ("Une chambre, une salle de bains juste à côté, un salon.", "B H K L W", "adjacent W1 B1"),
    ("Un dormitorio, un baño justo al lado, un salón.", "B H K L W", "adjacent W1 B1"),
    ("Two bedrooms and a cellar.", "B2 H K L W", "unread cellar"),
]  # fmt: skip
SAID_OF = [
    ("Two bedrooms; the study is accessible from the living room and at least 8 m².", "B2 H K L S W",
     "L1S1, at_least S1 8"),
    ("Zwei Schlafzimmer; das Arbeitszimmer ist vom Wohnzimmer aus erreichbar und mindestens 8 m² groß.",
     "B2 H K L S W", "L1S1, at_least S1 8"),
    ("Deux chambres; le bureau est accessible depuis le salon et fait au moins 8 m².", "B2 H K L S W",
     "L1S1, at_least S1 8"),
    ("Dos dormitorios; el despacho es accesible desde el salón y mide al menos 8 m².", "B2 H K L S W",
     "L1S1, at_least S1 8"),
    ("Quiero que el dormitorio dé al este y la cocina al oeste; un baño.", "B H K L W",
     "orientation B1 east, orientation K1 west"),
    ("Una habitación, un baño y un despacho que no pase de 8 m².", "B H K L S W", "at_most S1 8, !unread pase"),
    ("Lounge is largest room, two bedrooms, kitchen, bath.", "B2 H K L W", "order L1 largest"),
    ("Two bedrooms with a study table in the second bedroom.", "B2 H K L W", "B2 has 1 desk"),
]  # fmt: skip
INSTEAD = [
    ("Unser Schlafzimmer soll nicht neben dem Bad liegen, sondern neben dem Arbeitszimmer.", "B H K L S W",
     "adjacent B1 S1, apart B1 W1, !unread sondern"),
    ("Das Bad soll nicht an die Küche grenzen, sondern an das Schlafzimmer.", "B H K L W",
     "adjacent W1 B1, apart W1 K1"),
    ("Deux chambres; le bureau ne donne pas sur le couloir mais sur le salon.", "B2 H K L S W", "L1S1, !H1S1"),
    ("Dos dormitorios; el despacho no da al pasillo sino al salón.", "B2 H K L S W", "L1S1, !H1S1"),
    ("Two bedrooms. The study has only one door, to the living room.", "B2 H K L S W", "L1S1, at_most S1 doors 1"),
    ("Zwei Schlafzimmer. Das Arbeitszimmer hat nur eine Tür, zum Wohnzimmer.", "B2 H K L S W",
     "L1S1, at_most S1 doors 1"),
    ("Deux chambres. Le bureau n'a qu'une porte, vers le salon.", "B2 H K L S W", "L1S1, at_most S1 doors 1"),
    ("Dos dormitorios. El despacho tiene una sola puerta, al salón.", "B2 H K L S W", "L1S1, at_most S1 doors 1"),
    ("Three bedrooms, a dressing room between the main bedroom and the en suite that one walks through, a family "
     "bathroom.", "B3 C H K L W2", "B1C1, C1W1, H1W2, !B1W1, !H1W1"),
    ("A bedroom, kitchen, living room, and to the bedroom one goes through living room.", "B H K L W", "B1L1, !B1H1"),
    ("A house for parents with twins; the twins share a room of 14 m², the parents' bedroom must be far from them.",
     "B2 H K L W", "apart B1 B2"),
]  # fmt: skip

test_rooms_named_again = as_meant(AGAIN)
test_what_a_clause_is_said_of = as_meant(SAID_OF)
test_one_instead_of_the_other = as_meant(INSTEAD)

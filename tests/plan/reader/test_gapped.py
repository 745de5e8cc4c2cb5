"""What a clause says without its noun: other doors, `but now without`, whose a bathroom is, for whom rooms are."""

from sentences.facts import as_meant

SENTENCES = [
    # a bedroom for each of the people
    ("A flat for three PhD students with a bedroom for each, and one bathroom.", "B3 H K L W", ""),
    ("Four colleagues live here, a bedroom for each of them, two bathrooms.", "B4 H K L W2", ""),
    ("House for five people with one bedroom each, two bathrooms.", "B5 H K L W2", ""),
    ("Apartment for three nurses, each with a bedroom, and a bathroom.", "B3 H K L W", ""),
    ("A flat for four interns, a bedroom for everyone, and two bathrooms.", "B4 H K L W2", ""),
    ("A flat for three doctoral students: a bedroom per person, one bathroom.", "B3 H K L W", ""),
    # rooms by whom they are for
    ("We need a parents room, two rooms for the kids, two bathrooms and a kitchen.", "B3 H K L W2", ""),
    ("We need one room for her, one bedroom for us and one for our son. One bathroom.", "B3 H K L W", ""),
    ("A flat. One bedroom for us, one room for each of our two kids, one bathroom.", "B3 H K L W", ""),
    ("A flat. A bedroom for me, a room for my daughter, a bathroom.", "B2 H K L W", ""),
    ("Three rooms for the children, one bedroom for us, a bathroom.", "B4 H K L W", ""),
    ("Two bedrooms are for the kids. One is for us. Two bathrooms.", "B3 H K L W2", ""),
    ("A room for my mother near the entrance, two bedrooms for us and one bathroom.", "B3 H K L W", "near B3 entrance"),
    # whose it is, as a key with its value
    ("bedrooms: 3; bathrooms: 2; ensuite: master bedroom; study: no", "B3 H K L W2", "B1W1, H1W2"),
    ("bedrooms: 3; bathrooms: 2; ensuite: bedroom 1", "B3 H K L W2", "B1W1, H1W2"),
    ("bedrooms: 2, bathrooms: 2, en-suite: main bedroom, kitchen: separate", "B2 H K L W2", "B1W1, H1W2"),
    ("bedrooms: 3\nbathrooms: 2\nensuite bathroom: master", "B3 H K L W2", "B1W1, H1W2"),
    ("bedrooms: 3; bathrooms: 1; walk-in closet: master bedroom", "B3 C H K L W", "B1C1"),
    ("bedrooms: 2; bathrooms: 1; balcony: living room", "B2 H K L W Y", "L1Y1"),
    # an opening has no wall and no door
    ("The living room flows into the dining room without a wall between them. Two bedrooms, kitchen, bathroom.",
     "B2 D H K L W", "D1~L1"),
    ("The kitchen flows into the living room with no wall between them. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("The kitchen is open to the dining room without a door between them. Two bedrooms, bathroom.", "B2 D H K L W",
     "D1~K1"),
    ("The living room opens onto the kitchen without a wall between them. Two bedrooms.", "B2 H K L W", "K1~L1"),
    ("The kitchen merges into the living room, with no wall between the two. Two bedrooms.", "B2 H K L W",
     "K1~L1"),
    ("Kitchen and living room are one space, no wall between them. Two bedrooms.", "B2 H K L W", "K1~L1"),
    # another door
    ("The kitchen has a door to the hallway and another one to the dining room. Two bedrooms, bathroom, living room.",
     "B2 D H K L W", "D1K1, H1K1"),
    ("The kitchen has a door to the hallway and another to the dining room. Two bedrooms, bathroom, living room.",
     "B2 D H K L W", "D1K1, H1K1"),
    ("The kitchen has a door to the hallway and a second one to the dining room. Two bedrooms, a living room.",
     "B2 D H K L W", "D1K1, H1K1"),
    ("The kitchen has one door to the hallway and one to the dining room. Two bedrooms, a living room.",
     "B2 D H K L W", "D1K1, H1K1"),
    ("The kitchen has a door to the hallway, the dining room has one to the living room. Two bedrooms.",
     "B2 D H K L W", "D1L1, H1K1"),
    ("A flat. The bathroom has a door to the hallway and another door to the bedroom. One bedroom.", "B H K L W",
     "B1W1, H1W1"),
    # things that go into rooms, rooms within rooms
    ("A flat. One bedroom. A bed and a desk go in the bedroom, a sofa goes into the living room.", "B H K L W",
     "L1 has 1 sofa, B1 has 1 desk"),
    ("A flat. One bedroom. A sofa goes in the living room, a desk goes in the bedroom.", "B H K L W",
     "L1 has 1 sofa, B1 has 1 desk"),
    ("A flat. One bedroom. A sofa and a piano go into the living room.", "B H K L W", "L1 has 1 sofa, L1 has 1 piano"),
    ("One bedroom and a living room, which also contains the kitchen.", "B H K L W", "K1~L1"),
    ("One bedroom and a living room that contains the kitchen.", "B H K L W", "K1~L1"),
    ("One bedroom, a bathroom. The living room also includes the kitchen.", "B H K L W", "K1~L1"),
    # beside what was spoken of
    ("The living room in the south-west corner; the kitchen north of it; one bedroom.", "B H K L W",
     "position K1 L1 north"),
    ("The living room in the south, the kitchen north of it. Two bedrooms.", "B2 H K L W", "position K1 L1 north"),
    ("A flat. The bedroom in the east; the bathroom south of it.", "B H K L W", "position W1 B1 south"),
    ("The kitchen is in the north. The living room is south of it. Two bedrooms.", "B2 H K L W",
     "position L1 K1 south"),
    # a closet between
    ("Two bedrooms, two bathrooms. The main bedroom has a walk-in closet through which you get to its ensuite.",
     "B2 C H K L W2", "B1C1, C1W1, !B1W1"),
    ("Two bedrooms, two bathrooms. The main bedroom has a dressing room that leads to its ensuite.", "B2 C H K L W2",
     "B1C1, C1W1, !B1W1"),
    ("Two bedrooms, two bathrooms. The main bedroom has a walk-in closet, from which you reach the ensuite.",
     "B2 C H K L W2", "B1C1, C1W1, !B1W1"),
    ("Two bedrooms, two bathrooms. The main bedroom is far from the entrance and has a walk-in closet through which "
     "you get to its ensuite.", "B2 C H K L W2", "B1C1, C1W1, !B1W1, apart B1 entrance"),
    ("Two bedrooms, one bathroom. The main bedroom is near the entrance and has a balcony.", "B2 H K L W Y",
     "B1Y1, near B1 entrance"),
    # one of those counted
    ("Une maison avec quatre chambres, dont une suite parentale avec dressing et salle de bain, une deuxième salle de "
     "bain et un bureau.", "B4 C H K L S W2", "B1C1, B1W1"),
    ("Four bedrooms, including a master suite with closet and bathroom, and a second bathroom.", "B4 C H K L W2",
     "B1C1, B1W1"),
    ("Trois chambres, dont une suite parentale, et une salle de bain.", "B3 H K L W2", "B1W1"),
    ("Vier Schlafzimmer, davon ein Elternschlafzimmer mit Ankleide.", "B4 C H K L W2", "B1C1"),
    # taken back behind
    ("First I wanted a flat with balcony, but now without. Two bedrooms.", "B2 H K L W", "!L1Y1"),
    ("I wanted a flat with a study, but now without one. Two bedrooms.", "B2 H K L W", ""),
    ("First with a balcony, but now without it. Two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("I had planned a balcony, now without. Two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("A flat with a terrace, no, without. Two bedrooms.", "B2 H K L W", ""),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)


OTHERWISE = [
    ("Two bedrooms, one with a balcony and one without.", "B2 H K L W Y", ""),
    ("Two bathrooms: one off the hallway, the other next to the kitchen. Two bedrooms.", "B2 H K L W2", ""),
    ("A flat with two bedrooms for two people, one bathroom.", "B2 H K L W", ""),
    ("A three-room flat for us: three rooms for us and a kitchen.", "B2 H K L W", ""),
    ("Two bedrooms. The kitchen is next to the living room with no door between them.", "B2 H K L W", "!K1~L1"),
    ("Two bedrooms with a desk each, one bathroom.", "B2 H K L W", "B1 has 1 desk, B2 has 1 desk"),
]  # fmt: skip

test_what_only_looks_alike_is_read_as_it_was = as_meant(OTHERWISE)


BRIEFLY = [
    # with nothing said before
    ("No bathtub, a shower instead. Two bedrooms.", "B2 H K L W", "W1 has 0 bath, W1 has 1 shower"),
    # what rooms are to one another, and to what is said behind
    ("Two bedrooms opposite each other near the entrance.", "B2 H K L W",
     "opposite B1 B2, near B1 entrance, near B2 entrance, !adjacent B1 B2"),
    ("Two bedrooms next to each other next to the bathroom.", "B2 H K L W",
     "adjacent B1 B2, adjacent B1 W1, adjacent B2 W1"),
    ("Two bedrooms, the living room the largest.", "B2 H K L W", "order L1 largest"),
    ("One bedroom, a hall which the kitchen opens onto.", "B H K L W", "H1K1"),
    ("Kitchen/living room, two bedrooms.", "B2 H K L W", "K1~L1"),
    ("Two bedrooms, a balcony; forget the balcony.", "B2 H K L W", ""),
]  # fmt: skip

test_what_is_said_in_few_words = as_meant(BRIEFLY)

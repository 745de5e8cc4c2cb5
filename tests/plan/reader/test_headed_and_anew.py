"""Places that head their rooms, rooms said anew under another name or number, and what `it` is of a way."""

from sentences.facts import as_meant

SENTENCES = [
    # places that head a list
    ("The flat has two bedrooms. On the north side: kitchen and bathroom. On the south side: living room and both "
     "bedrooms.", "B2 H K L W", "position K1 north, position W1 north, position L1 south, position B2 south"),
    ("North: kitchen, bathroom; south: living room, bedroom.", "B H K L W", "position W1 north, position B1 south"),
    ("Left: kitchen, bathroom. Right: bedroom, living room.", "B H K L W", "position K1 left, position L1 right"),
    # another room in the place of one
    ("One bedroom, a bathroom and a storage room. No wait, make the storage room a utility room.", "B H K L U W", ""),
    ("Two bedrooms and a pantry off the kitchen. Actually, change the pantry to a laundry room.", "B2 H K L U W",
     "K1U1"),
    ("Three bedrooms, living room and kitchen. Turn the third bedroom into a study.", "B2 H K L S W", ""),
    # another number
    ("two bedrooms, actually three, but one bathroom is enough.", "B3 H K L W", ""),
    ("Two bedrooms and one bathroom. Scratch that, two bathrooms.", "B2 H K L W2", ""),
    ("One bathroom. Two bedrooms, sorry, three.", "B3 H K L W", ""),
    ("I need actually three bedrooms and two bathrooms", "B3 H K L W2", ""),
    # a study that is work and no room
    ("For a rearrangement study: 3 bedrooms, one shared bathroom", "B3 H K L W", ""),
    ("A flat for a fetch study. Two bedrooms and a study.", "B2 H K L S W", ""),
    # doors
    ("Two bedrooms, kitchen, dining room, living room. The dining room lies between the kitchen and the living room, "
     "and there is no door between the kitchen and the hallway.", "B2 D H K L W", "D1K1, D1L1, !K1L1, !H1K1"),
    ("Living room, kitchen, two bedrooms and bathroom, with no more than five doors off the hallway.", "B2 H K L W",
     "at_most H1 doors 5"),
    ("You come in the corridor; from the corridor you go to two bedrooms and the bathroom; at the end of the corridor "
     "is the living room, and from it you go to the kitchen.", "B2 H K L W", "K1L1, H1L1, !H1K1"),
    ("Piso de dos dormitorios con cocina abierta al salón, un baño y una terraza en el dormitorio principal.",
     "B2 H K L W Y", "B1Y1, H1W1, !L1Y1"),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)


ONE_ROOM = [
    # which of several has it
    ("Three bedrooms, two bathrooms. The one in the corridor has a bathtub.", "B3 H K L W2",
     "H1W1, W1 has 1 bath, !H1 has 1 bath"),
    ("The bathroom next to the kitchen has a bathtub. Two bedrooms, two bathrooms.", "B2 H K L W2",
     "W1 has 1 bath, adjacent W1 K1"),
    ("Four bedrooms, each pair of bedrooms shares a bathroom.", "B4 H K L W2", "B1W1, B2W1, B3W2, B4W2"),
    ("House for two families, each family has two bedrooms.", "B4 H K L W2", ""),
    ("Two bedrooms 4 x 3.5 and 3 x 3 m.", "B2 H K L W", "dimension B1 4 x 3.5, dimension B2 3 x 3"),
    ("Flat with the bedrooms two, 12 m2 each.", "B2 H K L W", "B1=12, B2=12"),
    ("A flat. Bedroom window to the west. One bedroom, one bathroom.", "B H K L W", "orientation B1 west"),
    ("4 cells of 6 m2, a corridor, a guard room, and a bathroom.", "H W", "!all=6, unread cells, unread 6 m2"),
    # both, all but one, between
    ("Das Esszimmer liegt zwischen Küche und Wohnzimmer und ist zu beiden offen. Ein Schlafzimmer.", "B D H K L W",
     "D1~K1, D1~L1"),
    ("Two bedrooms. The dining room is between the kitchen and the living room and open to both.", "B2 D H K L W",
     "D1~K1, D1~L1"),
    ("Un piso con un salón al que dan todas las habitaciones menos el baño. Dos dormitorios.", "B2 H K L W",
     "B1L1, B2L1, !L1W1, !unread menos"),
    ("Two bedrooms on the left, kitchen and living room on the right, a bathroom in between.", "B2 H K L W",
     "position B2 left, position L1 right, position W1 centre, !L1W1"),
    # taken back
    ("Two bathrooms. Wait no, one bathroom. Two bedrooms.", "B2 H K L W", ""),
    ("Two bedrooms and a balcony. Scratch that, no balcony.", "B2 H K L W", ""),
    ("Three bedrooms, a study. Scratch the study.", "B3 H K L W2", "!unread scratch"),
]  # fmt: skip

test_so_are_rooms_of_several = as_meant(ONE_ROOM)


TYPED = [
    # doors said in passing
    ("Three sleeping rooms, one bath, living room with exit to the terrace.", "B3 H K L W Y", "L1Y1, !B1Y1, !W1Y1"),
    ("I want that the kitchen is not open, and that from the kitchen you can go out on the balcony. One bedroom.",
     "B H K L W Y", "K1Y1, !L1Y1"),
    ("Two bedrooms; a door connects them.", "B2 H K L W", "B1B2, H1L1"),
    ("Flat with two bedrooms connected to each other, kitchen, living room.", "B2 H K L W", "B1B2, !B1K1, !B1L1"),
    ("Two bedrooms and a bathroom. The bedrooms are connected to each other.", "B2 H K L W", "B1B2"),
    ("Bedroom, bathroom, kitchenette, all opening into one central living room.", "B K L W", "B1L1, L1W1, K1L1"),
    # neighbours and sizes
    ("A 3-bedroom apartment where the two smaller bedrooms share a wall with each other but not with the master "
     "bedroom.", "B3 H K L W2", "adjacent B2 B3, apart B2 B1, apart B3 B1"),
    ("The robot starts in the living room, which should be the largest room; add two bedrooms.", "B2 H K L W",
     "order L1 largest"),
    ("Quiero una casa con dos habitaciones y cocina independiente de 10 metros.", "B2 H K L W", "K1=10"),
    ("Flat with a bedroom of sixteen meters square.", "B H K L W", "B1=16"),
    # rooms and what is none
    ("We are family with two kids, they sleep in same room. Flat with bathroom and separate toilet, please.",
     "B2 H K L W2", ""),
    ("Small flat for a student, everything in one room apart from the bathroom.", "K L W", "K1~L1"),
    ("A flat with one bedroom, one living room which is also the dining room, kitchen and bathroom.", "B D H K L W",
     "D1~L1"),
    ("Make me a flat so enemies can chase the player: one bedroom, the kitchen connects to the hallway.", "B H K L W",
     "!K1 has 1 chair"),
    ("House: the entrance hall, to the right the kitchen, to the left the living room, straight on two bedrooms and a "
     "bathroom.", "B2 H K L W", "position L1 left, !position B1 left, !position W1 left, unread ahead"),
]  # fmt: skip

test_so_is_what_others_typed = as_meant(TYPED)

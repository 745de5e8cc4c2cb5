"""Sentences as people type them: cut words, dorm rooms, homes of one, tables by their guests, rooms told twice."""

from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SHORT = [
    ("3 bed 2 bath, approx 1,200 sq ft.", "B3 H K L W2", "all=111.48, !unread appro"),
    ("Two bedrooms, approx 5 windows.", "B2 H K L W", "!unread appro"),
    *[(f"{home} {about} 80 m², 2 {rooms}", "B2 H K L W", f"all=80, !unread {about.rstrip('.')}")
      for about in ("c.", "ca.", "circa", "approx", "approx.", "roughly", "env.", "aprox.", "rd.")
      for home, rooms in (("flat,", "bedrooms"), ("Wohnung,", "Schlafzimmer"))],
    ("Piso de 60 metros, un dormitorio", "B H K L W", "all=60"),
    ("apartment, 70 meter, 2 bedroom", "B2 H K L W", "all=70"),
    ("Two bedrooms. The hallway is 10 metres long at most.", "B2 H K L W", "at_most H1 length 10"),
    ("3ZKB mit Tageslichtbad und Gäste-WC, 85 m²", "B2 H K L W2", "all=85"),
    ("3 ZKBB", "B2 H K L W Y", ""),
    ("Wohnung für zwei mit Essecke, 2 Schlafzimmer", "B2 D H K L W", ""),
    ("we need flat 3 sleeping room, 2 toilet", "B3 H K L W2", ""),
    ("3 bedrooms, 2 bathrooms, 2 toilets", "B3 H K L W4", ""),
    ("apartment 100m2: living 30, kitchen 12, 2x bedroom 14, bath 6, hall 8", "B2 H K L W", "B1=14, B2=14, H1=8"),
    ("Zimmer 1: 15 m², Zimmer 2: 12 m², Küche 8 m², Bad 4 m²", "B H K L W", "L1=15, B1=12"),
    ("2 ambientes con balcón", "B H K L W Y", ""),
    ("casa de 3 recámaras, 2 baños y medio", "B3 H K L W3", ""),
    ("studio with a murphy bed", "K L W", "L1 has 1 double_bed"),
]  # fmt: skip
HALLS = [
    ("Two bedrooms, wide corridors.", "B2 H K L W", ""),
    ("two-bedroom flat with long corridors", "B2 H K L W", "!unread long"),
    ("two-bedroom flat with narrow hallways", "B2 H K L W", ""),
    ("two-bedroom flat with two hallways", "B2 H2 K L W", ""),
    ("Zwei Schlafzimmer, breite Flure.", "B2 H K L W", ""),
    ("Zwei Schlafzimmer, langer Flur.", "B2 H K L W", "!unread langer"),
    ("Deux chambres, de larges couloirs.", "B2 H K L W", ""),
    ("Dos dormitorios, pasillos anchos.", "B2 H K L W", "!unread anchos"),
    ("dos dormitorios, sin pasillo largo", "B2 H K L W", "at_most H1 length 6"),
    ("Flat with 1.5 m wide hallway, two bedrooms", "B2 H K L W", "at_least H1 width 1.5"),
]
TOLD_AGAIN = [
    ("Wohnung mit 3 Zimmern, Küche, Bad, Balkon, ca. 80 qm, Balkon vom Wohnzimmer aus.", "B2 H K L W Y", "L1Y1"),
    ("Two bedrooms, balcony, balcony from the living room.", "B2 H K L W Y", "L1Y1"),
    ("deux chambres, balcon, balcon depuis le salon", "B2 H K L W Y", "L1Y1"),
    ("Two bedrooms, a balcony off the kitchen and another balcony off the living room.", "B2 H K L W Y2", ""),
    ("Make apartment. 3 bedroom. 1 is master bedroom.", "B3 H K L W2", ""),
    ("3 room flat, one room used as office", "B H K L S W", "!unread used as"),
    ("4 bedroom flat, smallest bedroom is the study", "B3 H K L S W2", ""),
    ("piso de tres habitaciones, una de ellas despacho", "B2 H K L S W", ""),
    ("trois chambres dont une en bureau", "B2 H K L S W", ""),
    ("四室两厅，一间做书房", "B3 D H K L S W2", ""),
    ("2-Zimmer-Wohnung mit Wohnküche und Arbeitszimmer", "B H K L S W", ""),
    ("Das Wohnzimmer 25 m², dazu ein Schlafzimmer mit 15 m² und ein Bad.", "B H K L W", "H1W1, B1=15"),
    ("Wohnung: man kommt nur durchs Wohnzimmer ins Schlafzimmer", "B H K L W", "B1L1"),
    ("Ein Arbeitszimmer mit Tür zum Flur, ein Schlafzimmer und eine Küche", "B H K L S W", "H1S1"),
    ("flat with living room where is the kitchen inside, and two sleeping rooms", "B2 H K L W", "K1~L1"),
]
SEVERAL = [
    ("house with 2 bedrooms left, 2 bedrooms right", "B4 H K L W2",
     "position B1 left, position B2 left, position B3 right, position B4 right"),
    ("Haus mit den Schlafzimmern im Norden", "B2 H K L W", "position B1 north, position B2 north"),
    ("Wohnung, die Schlafzimmer im Norden", "B2 H K L W", "position B1 north, position B2 north"),
    ("casa con las habitaciones al norte", "B2 H K L W", "position B1 north, position B2 north"),
    ("Wohnung für ein Paar, getrennte Schlafzimmer", "B2 H K L W", ""),
    ("Wohnung mit drei getrennten Schlafzimmern", "B3 H K L W2", ""),
    ("WG mit vier gleich großen Zimmern und großer Küche", "B4 H K L W2", "!unread vier"),
    ("flat with a twin bedroom and a double bedroom", "B2 H K L W", "B1 has 2 single_bed"),
    ("2 bedroom flat for 3 students, one room is shared by two", "B2 H K L W", "B1 has 2 single_bed, !B1B2"),
    ("1 bedroom flat, bathroom accessible from both bedroom and hall", "B H K L W", "B1W1, H1W1"),
    ("small house 2 room 1 kitchen 1 toilet 1 hall", "B H K L W", ""),
    ("需要两个卫生间，其中一个在主卧", "B H K L W2", "B1W1"),
    ("3er-WG mit großer Küche", "B3 H K L W2", ""),
    ("game level: flat, 4 locked rooms off one hallway", "B3 H K L W2", "!unread 4"),
    ("小两居，60平米", "B2 H K L W", "all=60, !unread 居"),
]  # fmt: skip
PEOPLE = [
    (f"{home} for two {who}, {own}.", "B2 H K L W2", f"B1W1, B2W2, !unread {who}")
    for home in ("Apartment", "Flat")
    for who in ("roommates", "students")
    for own in ("each with their own bathroom", "who each have their own bathroom")
] + [
    ("Apartment for two roommates, each with their own bathroom, sharing a kitchen and living area.", "B2 H K L W2",
     "B1W1, B2W2, !unread two"),
    *[(f"{home}, {study}", "B H K L S W", "")
      for home, study in (("apartment for myself", "a study"), ("I live alone", "a kitchen and a study"),
                          ("flat for someone living alone", "a study"), ("a flat for one", "a study"),
                          ("Wohnung für mich allein", "Arbeitszimmer"), ("appartement pour moi seule", "bureau"),
                          ("appartement pour une personne seule", "bureau"), ("piso para una sola persona", "despacho"),
                          ("独居女生的公寓", "书房"))],
    ("一个适合独居程序员的小公寓，要有书房和开放式厨房。", "B H K L S W", "K1~L1, !unread 适, !unread 独"),
    ("flat for me and my wife, a study", "B H K L S W", ""),
    ("Wohnung für mich und meine Frau", "B H K L W", "!unread frau"),
    ("flat with a guest room", "B2 H K L W", ""),
    ("flat for a retired couple, both with their own bedroom", "B2 H K L W", ""),
    ("flat for my parents and me, they need a bathroom near their room", "B2 H K L W", "adjacent W1 B1"),
    ("Familie mit zwei Kindern, Kinderzimmer nebeneinander, Elternschlafzimmer", "B3 H K L W2", "adjacent B2 B3"),
    ("给一家四口设计一套100平米的房子，两个孩子各有一间房", "B3 H K L W2", "all=100"),
    ("make me a dorm room for 2 students with private bathroom", "B W", "B1W1, B1 has 2 single_bed"),
    ("Student room with kitchenette and private bath, 18 sqm", "B K W", "all=18, B1W1"),
    ("three student rooms and a shared kitchen", "B3 H K L W2", ""),
]  # fmt: skip
SEATS = [
    ("A flat with one bedroom, a dining room for 10.", "B D H K L W",
     "D1 has 10 chair, D1 has 1 dining_table, !unread 10"),
    ("Wohnung mit einem Schlafzimmer, Esszimmer für 8 Personen.", "B D H K L W", "D1 has 8 chair"),
    ("appartement, une chambre, salle à manger pour 8", "B D H K L W", "D1 has 8 chair"),
    ("piso, un dormitorio, comedor para 8", "B D H K L W", "D1 has 8 chair"),
]  # fmt: skip
SHOWERS = [(f"Flat with one bedroom, {said}.", "B H K L W", "W1 has 1 shower, W1 has 0 bath")
           for said in ("no bath only shower", "no bathtub, just a shower", "only a shower, no bath")]
EACH = [
    (f"{who}, {each}.", "B2 H K L W2", "B1W1, B2W2")
    for who, eachs in (
        ("A flat for two flatmates", ("each with an ensuite bedroom", "each with their own bedroom and bathroom",
                                      "each with their own bedroom and ensuite bathroom")),
        ("A flat for my mother and me", ("each with her own bedroom and bathroom",)),
        ("Eine Wohnung für meine Schwester und mich", ("jede mit eigenem Schlafzimmer und eigenem Bad",)),
        ("Un appartement pour ma mère et moi", ("chacune avec sa chambre et sa salle de bains",)),
        ("Un piso para mi madre y para mí", ("cada una con su dormitorio y su baño",)),
    ) for each in eachs
]
_BEDS = "B1 has 1 double_bed, B2 has 2 single_bed, B2 has 1 desk, !B1 has 2 single_bed, !B1 has 1 desk"
IN_ONE = [
    ("Two-bedroom flat: in the main one a double bed, in the other two single beds and a desk.", "B2 H K L W", _BEDS),
    ("Piso de dos dormitorios: en el principal una cama doble, en el otro dos camas individuales y un escritorio.",
     "B2 H K L W", _BEDS),
    ("Deux chambres: dans la grande un lit double, dans la petite deux lits simples et un bureau.", "B2 H K L W",
     _BEDS),
    ("Three bedrooms: in the main one a double bed, in the other two bedrooms a desk.", "B3 H K L W2",
     "B1 has 1 double_bed, !B1 has 1 desk"),
]
APART = [
    ("One bedroom in the west and one bedroom in the east.", "B2 H K L W", "position B1 west, position B2 east"),
    ("One bedroom facing south, one bedroom facing north, and the living room between them.", "B2 H K L W",
     "orientation B1 south, orientation B2 north"),
    ("Appartement avec une grande chambre à l'ouest, une petite chambre à l'est.", "B2 H K L W",
     "position B1 west, position B2 east"),
    ("Ein großes Schlafzimmer im Westen, ein kleines Schlafzimmer im Osten.", "B2 H K L W",
     "position B1 west, position B2 east"),
    ("Un dormitorio grande al oeste, un dormitorio pequeño al este.", "B2 H K L W",
     "position B1 west, position B2 east"),
]


def test_a_home_between_two_doors_is_no_wish_of_theirs() -> None:
    """`bathroom between them` leads to both, whatever is said before and after it."""
    said = read("two bedrooms, both at least 12 m², bathroom between them, no hallway")
    assert {("bathroom_1", "bedroom_1"), ("bathroom_1", "bedroom_2")} <= {(link[0], link[1]) for link in said.links}


test_cut_words_and_counts = as_meant(SHORT)
test_hallways_without_a_number_are_one = as_meant(HALLS)
test_rooms_told_again_or_as_others = as_meant(TOLD_AGAIN)
test_rooms_of_which_there_are_several = as_meant(SEVERAL)
test_people_and_where_they_sleep = as_meant(PEOPLE)
test_seats_of_dining_rooms = as_meant(SEATS)
test_each_of_two_has_rooms = as_meant(EACH)
test_what_is_in_one_is_not_in_the_other = as_meant(IN_ONE)
test_rooms_at_two_sides_are_two = as_meant(APART)
test_no_bath_but_a_shower_is_of_a_bathroom = as_meant(SHOWERS)

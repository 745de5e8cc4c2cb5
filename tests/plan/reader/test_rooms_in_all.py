"""How many rooms a home is to have in all: those that are named, and no hallway beside them unsaid."""

from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("A flat with exactly 6 rooms: living room, kitchen, two bedrooms, a bathroom and a study.", "B2 K L S W",
     "B1L1, L1W1"),
    ("Six rooms in all, no more: living room, kitchen, two bedrooms, bathroom, hallway.", "B2 H K L W", ""),
    ("Two bedrooms and a study, six rooms in total.", "B2 K L S W", ""),
    ("Two bedrooms, a kitchen, a living room and a bathroom, that makes five rooms in total, not one more.",
     "B2 K L W", ""),
    ("No more than 6 rooms: living room, kitchen, two bedrooms, bathroom and study.", "B2 K L S W", ""),
    ("Six rooms no more no less: kitchen, lounge, bath, bedroom, bedroom, office.", "B2 K L S W", ""),
    ("exactly 6 rooms incl. hallway: living, kitchen, bath, 2 bedrooms, hallway", "B2 H K L W", ""),
    ("Exactly 6 rooms, two bedrooms, and a balcony.", "B2 H K L W Y", ""),
    ("Genau sechs Räume: Wohnzimmer, Küche, zwei Schlafzimmer, Bad, Arbeitszimmer.", "B2 K L S W", ""),
    ("Insgesamt sechs Räume: Wohnzimmer, Küche, zwei Schlafzimmer, Bad und Flur.", "B2 H K L W", ""),
    ("Exactement six pièces : salon, cuisine, deux chambres, salle de bain, bureau.", "B2 K L S W", ""),
    ("Exactamente seis habitaciones: salón, cocina, dos dormitorios, baño y despacho.", "B2 K L S W", ""),
    ("总共六个房间：客厅、厨房、两个卧室、卫生间、书房。", "B2 K L S W", ""),
    # not all of them named
    ("Exactly six rooms.", "B2 H K L W", ""),
    ("A flat with exactly four rooms.", "B K L W", ""),
    ("A home with exactly eight rooms.", "B3 H K L W2", ""),
    ("There must be exactly 7 rooms, two of them bedrooms.", "B2 H K L S W", ""),
    # numbers of main rooms, and of rooms of a type
    ("A four-room flat.", "B3 H K L W2", ""),
    ("A flat with 5 rooms.", "B4 H K L W2", ""),
    ("Three bedrooms in total and two bathrooms in all.", "B3 H K L W2", ""),
    ("Exactly two bedrooms.", "B2 H K L W", ""),
]  # fmt: skip

test_no_room_is_added_unsaid = as_meant(SENTENCES)


def test_a_number_that_cannot_be_had_is_told() -> None:
    program = read("A flat with exactly three rooms: kitchen, bathroom, bedroom, living room, hallway.")
    assert len(program.rooms) == 5
    assert any("there are 5 rooms" in entry for entry in program.unread)

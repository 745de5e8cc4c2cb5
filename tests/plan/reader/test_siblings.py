"""Whose of several children's rooms is whose, rooms of everybody's own, rooms of flatmates that are alike."""

import pytest
from sentences.facts import as_meant, rooms

from apartgen.stages.plan.reader import read

FAMILIES = [
    ("A family with three children; the two boys share, the girl has her own room, the baby sleeps with us.", [2, 1]),
    ("We have two sons and a daughter, the sons sleep together.", [2, 1]),
    ("Two boys and a girl; the sons sleep together, the daughter alone.", [2, 1]),
    ("We are a couple with four kids: the two older girls share, the two boys share.", [2, 2]),
    ("A couple with two boys and a baby; the boys share, the baby sleeps in our room.", [2]),
    ("Our twins sleep together, the baby stays with us.", [2]),
    ("Three kids: eldest has his own room, the two little ones share.", [2, 1]),
    ("My two sons share, my daughter gets her own, and the baby is in with us.", [2, 1]),
    ("Meine Söhne schlafen zusammen, die Tochter hat ihr eigenes Zimmer.", [2, 1]),
    ("Nos deux fils dorment ensemble, notre fille a sa propre chambre.", [2, 1]),
    ("Deux garçons qui partagent une chambre et une fille qui a sa propre chambre.", [2, 1]),
    ("Tres hijos: los dos chicos comparten, la niña tiene su propia habitación y el bebé duerme con nosotros.", [2, 1]),
    ("两个儿子睡一间，女儿单独一间。", [2, 1]),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "sleep"), FAMILIES)
def test_children_sleep_as_told(prompt: str, sleep: list[int]) -> None:
    program = read(prompt)
    bedrooms = [room.children for room in program.rooms if room.type == "bedroom"]
    assert (bedrooms, program.unread) == ([None, *sleep], [])


SENTENCES = [
    # everybody has a room
    ("We are a family of five and everyone has their own room.", "B4 H K L W2", "!unread everyone"),
    ("A family of four, every kid with a room of their own.", "B3 H K L W2", "!unread kid"),
    ("We're 3 people and all of us want a separate bedroom.", "B3 H K L W2", ""),
    ("Home for 6 people, one room per person.", "B6 H K L W3", ""),
    ("For five people, nobody shares a room.", "B5 H K L W3", ""),
    ("WG mit vier Leuten, jeder hat sein eigenes Zimmer.", "B4 H K L W2", ""),
    ("Una familia de cinco, cada uno tiene su propia habitación.", "B4 H K L W2", ""),
    ("Somos cuatro y cada uno necesita su habitación.", "B4 H K L W2", ""),
    ("一家五口，每个人都有自己的房间。", "B4 H K L W2", ""),
    ("A flat for five people.", "B4 H K L W2", ""),
    # alike
    ("Three roommates, their bedrooms should be the same size.", "B3 H K L W2", "B1=11.77, B2=11.77, B3=11.77"),
    ("Three flatmates need equally sized bedrooms.", "B3 H K L W2", "B1=11.77, B2=11.77, B3=11.77"),
    ("Zwei Mitbewohner, ihre Schlafzimmer sollen gleich groß sein.", "B2 H K L W", "B1=12.9, B2=12.9"),
    ("Familie mit zwei Kindern, die Kinderzimmer sollen gleich groß sein.", "B3 H K L W2", "B1=14, B2=11, B3=11"),
    ("Trois chambres, les deux chambres d'enfants de même taille.", "B3 H K L W2", "B1=14, B2=11, B3=11"),
    ("两个室友，他们的卧室要一样大。", "B2 H K L W", "B1=12.9, B2=12.9"),
    # parents beside children and guests
    ("A flat with three kids' rooms and two baths.", "B4 H K L W2", ""),
    ("A house with 2 kids rooms and a guest room.", "B4 H K L W2", ""),
    ("We need a flat with a room for each of our two kids.", "B3 H K L W2", ""),
    ("A bedroom for each of our three children, an open kitchen.", "B4 H K L W2", ""),
    ("We want two children's rooms, a kitchen and a living room.", "B3 H K L W2", ""),
    ("给我们一套有两间儿童房的房子。", "B3 H K L W2", ""),
    ("Vivienda con dos dormitorios infantiles.", "B3 H K L W2", ""),
    ("Two bedrooms: one kids' room and one guest room.", "B2 H K L W", ""),
    ("A three-bedroom flat with two kids' rooms.", "B3 H K L W2", ""),
]  # fmt: skip

test_rooms_are_as_many = as_meant(SENTENCES)


def test_flatmates_are_no_children() -> None:
    program = read("Five people, a bedroom for each.")
    assert rooms(program) == "B5 H K L W3"
    assert all(room.children is None for room in program.rooms)

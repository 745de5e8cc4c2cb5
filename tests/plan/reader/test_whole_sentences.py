"""Sentences with the whole programme that an architect would write: rooms, doors, owners, and what else is asked.

Rooms, then doors that are not the hall's, then the rooms that are not off the hall where there is one, then the rest:
`K1~L1` is open without a wall, `W1<B1` belongs to it, `B1=12` has so many square metres.
"""

import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

SHORT = {
    "living_room": "L", "kitchen": "K", "dining_room": "D", "bedroom": "B", "bathroom": "W", "hallway": "H",
    "study": "S", "utility": "U", "storage": "T", "closet": "C", "balcony": "Y",
}  # fmt: skip
SENTENCES = [
    ("One-bedroom flat with a living room which is also used as a dining room and study.",
     "B H K L W", "", "", "use L1 dining_room, use L1 study"),
    ("Two-bedroom flat with a study used as a guest room.",
     "B2 H K L S W", "", "", "use S1 bedroom"),
    ("A flat with a living room and a kitchen. The bedrooms are 12 and 14 m².",
     "B2 H K L W", "", "", "B1=12, B2=14"),
    ("A flat with a living room and a kitchen. The bedrooms are 12 m².",
     "B2 H K L W", "", "", "B1=12, B2=12"),
    ("Living room, kitchen, hall, then a bedroom, then a bathroom, nothing else.",
     "B H K L W", "B1W1", "W1", "W1<B1"),
    ("A flat: living room, kitchen, hall, bedrooms: 4, bathroom: 4.",
     "B4 H K L W", "", "", "W1=4"),
    ("A flat with bedroom: 3, bathroom: 2, living room, kitchen.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1"),
    ("A living room, a kitchen, a bedroom with a bathroom, a study and a hall.",
     "B H K L S W", "", "", ""),
    ("Three bedrooms, master 16 m², a bathroom.",
     "B3 H K L W", "", "", "B1=16"),
    ("Three bedrooms, master with ensuite, and a family bathroom.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1"),
    ("Each bedroom has a balcony. A living room, three bedrooms, a kitchen.",
     "B3 H K L W2 Y3", "B1W1 B1Y1 B2Y2 B3Y3", "W1 Y1 Y2 Y3", "W1<B1, Y1<B1, Y2<B2, Y3<B3"),
    ("A living room. Every bedroom has its own bathroom. Two bedrooms.",
     "B2 H K L W2", "B1W1 B2W2", "W1 W2", "W1<B1, W2<B2"),
    ("Three bedrooms; the third is a guest room of 10 m².",
     "B3 H K L W2", "B1W1", "W1", "W1<B1, B3=10"),
    ("A two-bedroom flat, the bathroom next to the kitchen and the living room in the corner.",
     "B2 H K L W", "", "", "position L1 corner, adjacent W1 K1, adjacent W1 L1"),
    ("Living room, kitchen, bedroom one, study/bedroom two, bathroom.",
     "B2 H K L W", "", "", "use B2 study"),
    ("A flat of two bedrooms with no second bathroom.",
     "B2 H K L W", "", "", ""),
    ("A flat with two bathrooms, three bedrooms and no third bathroom.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1"),
    ("Bedrooms far from the entrance and a kitchen next to it.",
     "B2 H K L W", "", "", "apart B1 entrance, apart B2 entrance, near K1 entrance"),
    ("In the corner the kitchen, in the middle the living room, two bedrooms.",
     "B2 H K L W", "", "", "position K1 corner, position L1 centre"),
    ("The living room of 30 m² is the largest room. Two bedrooms.",
     "B2 H K L W", "", "", "order L1 largest, L1=30"),
    ("The kitchen is the smallest room of a two-bedroom flat.",
     "B2 H K L W", "", "", "order K1 smallest"),
    ("A house with seve bedrooms and thre bathrooms.",
     "B7 H K L W3", "B1W1 B2W2", "W1 W2", "W1<B1, W2<B2"),
    ("Two-bedroom flat. Both bedrooms have a balcony.",
     "B2 H K L W Y2", "B1Y1 B2Y2", "Y1 Y2", "Y1<B1, Y2<B2"),
    ("Two-bedroom flat. The bedrooms have a balcony.",
     "B2 H K L W Y2", "B1Y1 B2Y2", "Y1 Y2", "Y1<B1, Y2<B2"),
    ("Three bedrooms. Two of them have a balcony.",
     "B3 H K L W2 Y2", "B1W1 B1Y1 B2Y2", "W1 Y1 Y2", "W1<B1, Y1<B1, Y2<B2"),
    ("Three bedrooms. One of them has an ensuite, the others share a bathroom.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1"),
    ("Two-bedroom flat. Neither bedroom has its own bathroom.",
     "B2 H K L W", "", "", ""),
    ("A kitchen open to the living room, a bedroom and a bathroom, nothing else.",
     "B K L W", "B1L1 K1L1 L1W1", "", "L1~K1"),
    ("Half of the 80 m² is the living room. Two bedrooms.",
     "B2 H K L W", "", "", "L1=40, all=80"),
    ("A living room of 20 m² and a bedroom two thirds its size.",
     "B L", "B1L1", "", "L1=20, B1=13.33"),
    ("The kitchen is to the left of the living room in a one-bedroom flat.",
     "B H K L W", "", "", "position K1 L1 left"),
    ("One-bedroom flat; left of the bathroom is the kitchen.",
     "B H K L W", "", "", "position K1 W1 left"),
    ("One-bedroom flat; north of the living room is the balcony.",
     "B H K L W Y", "L1Y1", "Y1", "position Y1 L1 north"),
    ("A bedroom for the parents and one for the kids.",
     "B2 H K L W", "", "", "unread parents"),
    ("Kitchen, dining and living areas flow into each other. Two bedrooms.",
     "B2 D H K L W", "D1K1 D1L1", "K1 D1", "K1~D1, L1~D1"),
    ("Living room and kitchen in one open space, two bedrooms.",
     "B2 H K L W", "K1L1", "K1", "L1~K1"),
    ("Off the kitchen a pantry. A two-bedroom flat.",
     "B2 H K L T W", "K1T1", "T1", ""),
    ("From the landing: two bedrooms, a bathroom. A living room and a kitchen.",
     "B2 H K L W", "", "", ""),
    ("The bathroom is not connected to the hall but to the bedroom. One-bedroom flat.",
     "B H K L W", "B1W1", "W1", "W1<B1, no_door W1 H1"),
    ("A one-bedroom flat; the bathroom is reached from the hallway and not from the bedroom.",
     "B H K L W", "", "", "no_door W1 B1"),
    ("A one-bedroom flat; you enter the kitchen through the living room.",
     "B H K L W", "K1L1", "K1", ""),
    ("A bedroom with a dressing room, which leads to the en suite; a living room, a kitchen and a guest toilet.",
     "B C H K L W2", "B1C1 C1W1", "W1 C1", "W1<C1, C1<B1"),
    ("A one-bedroom flat with a piano in the living room and a desk.",
     "B H K L W", "", "", "L1 has 1 piano, L1 has 1 desk"),
    ("A two-bedroom flat with five objects in the living room.",
     "B2 H K L W", "", "", "L1 has 5"),
    ("Wohnung mit zwei Schlafzimmern, Bad und Gästezimmer.",
     "B3 H K L W", "", "", ""),
    ("Appartement avec deux chambres, un salon et une cuisine ouverte.",
     "B2 H K L W", "K1L1", "K1", "L1~K1"),
    ("Piso de dos dormitorios con un baño y un aseo.",
     "B2 H K L W2", "", "", ""),
    ("A corridor behind the living room leads to two bedrooms. A kitchen and a bathroom.",
     "B2 H K L W", "", "", ""),
    ("Two-bedroom flat with no extra bathroom.",
     "B2 H K L W", "", "", ""),
    ("A two-bedroom flat without a separate kitchen.",
     "B2 H K L W", "K1L1", "K1", "L1~K1"),
    ("Three-bedroom flat; two bedrooms of 10 m² each.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1, B1=10, B2=10"),
    ("A four-bedroom house: the master bedroom has an ensuite and a dressing room, the other three share a bathroom.",
     "B4 C H K L W2", "B1C1 B1W1", "W1 C1", "W1<B1, C1<B1"),
    ("Three bedrooms of 10, 12 and 14 m², living room 25 m².",
     "B3 H K L W2", "B1W1", "W1", "W1<B1, L1=25, B1=10, B2=12, B3=14"),
    ("A flat with bedroom A 14 m², bedroom B 10 m², living room, kitchen, bathroom.",
     "B2 H K L W", "", "", "B1=14, B2=10"),
    ("Bedroom 1: 14 m², bedroom 2: 11 m², kitchen: 9 m², living room: 22 m², bathroom: 5 m².",
     "B2 H K L W", "", "", "L1=22, K1=9, B1=14, B2=11, W1=5"),
    ("Kitchen 12, living room 24, bedroom 14, bathroom 6.",
     "B H K L W", "", "", "L1=24, K1=12, B1=14, W1=6"),
    ("2BHK, 80 m².",
     "B2 H K L W", "", "", "all=80"),
    ("A 3b2b apartment of 95 sqm.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1, all=95"),
    ("A T3 of 65 m².",
     "B2 H K L W", "", "", "all=65"),
    ("Un appartement de 60 m² avec une chambre, un séjour avec cuisine ouverte et un balcon.",
     "B H K L W Y", "K1L1 L1Y1", "K1 Y1", "L1~K1, all=60"),
    ("Ein Haus mit vier Schlafzimmern, zwei Bädern und einem Arbeitszimmer.",
     "B4 H K L S W2", "B1W1", "W1", "W1<B1"),
    ("Drei-Zimmer-Wohnung mit Balkon.",
     "B2 H K L W Y", "L1Y1", "Y1", ""),
    ("Una casa con tres dormitorios, dos baños, un salón comedor y una terraza.",
     "B3 D H K L W2 Y", "B1W1 D1L1 L1Y1", "D1 W1 Y1", "L1~D1, W1<B1"),
    ("三室两厅两卫，带阳台",
     "B3 D H K L W2 Y", "B1W1 D1K1 D1L1 L1Y1", "D1 W1 Y1", "W1<B1"),
    ("A living room with a balcony, a bedroom with its own bathroom, a kitchen and a guest WC.",
     "B H K L W2 Y", "B1W1 L1Y1", "W1 Y1", "W1<B1"),
    ("One-bedroom flat, the kitchen must not be next to the bathroom.",
     "B H K L W", "", "", "apart K1 W1"),
    ("One-bedroom flat, the bedroom far from the kitchen.",
     "B H K L W", "", "", "apart B1 K1"),
    ("One-bedroom flat; the only way into the bathroom is from the bedroom.",
     "B H K L W", "B1W1", "W1", "W1<B1"),
    ("A two-bedroom flat; the bathroom opens off both the hall and the main bedroom.",
     "B2 H K L W", "B1W1", "", ""),
    ("The kitchen has two doors, one to the hall and one to the living room. One-bedroom flat.",
     "B H K L W", "K1L1", "", ""),
    ("A one-bedroom flat; the living room opens to the balcony and leads to the kitchen.",
     "B H K L W Y", "K1L1 L1Y1", "K1 Y1", ""),
    ("A one-bedroom flat; the kitchen, which opens off the living room, leads to a utility room.",
     "B H K L U W", "K1L1 K1U1", "K1 U1", ""),
    ("The bedrooms are off the hall, as is the bathroom. Two-bedroom flat with a living room and a kitchen.",
     "B2 H K L W", "", "", ""),
    ("A two-bedroom flat in which all rooms open off the hallway.",
     "B2 H K L W", "", "", ""),
    ("A living room that all other rooms open onto, with two bedrooms and a kitchen.",
     "B2 K L W", "B1L1 B2L1 K1L1 L1W1", "", ""),
    ("A two-bedroom flat, living room facing south, bedrooms facing east.",
     "B2 H K L W", "", "", "orientation L1 south, orientation B1 east, orientation B2 east"),
    ("Two-bedroom flat with a home office and a laundry.",
     "B2 H K L S U W", "", "", ""),
    ("A two-bedroom flat, the hall at least 1.2 m wide.",
     "B2 H K L W", "", "", "at_least H1 width 1.2"),
    ("A kitchen 3 m by 4 m, a bedroom 4 x 3.5 m, a bathroom.",
     "B H K L W", "", "", "dimension K1 3 x 4, dimension B1 4 x 3.5, K1=12, B1=14"),
    ("A one-bedroom flat of 700 square feet.",
     "B H K L W", "", "", "all=65.03"),
    ("A four-room flat with two bathrooms.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1"),
    ("A flat with several bedrooms.",
     "B3 H K L W2", "B1W1", "W1", "W1<B1"),
    ("A flat with a couple of bedrooms and one and a half bathrooms.",
     "B2 H K L W2", "", "", ""),
    ("A bedsit with a kitchenette.",
     "K L W", "K1L1 L1W1", "", "L1~K1, L1 has 1 double_bed"),
    ("One-bedroom flat with a separate toilet.",
     "B H K L W2", "", "", ""),
    ("A one-bedroom flat with two desks in the bedroom, a sofa and three bookshelves in the living room.",
     "B H K L W", "", "", "L1 has 1 sofa, L1 has 3 bookshelf, B1 has 2 desk"),
    ("A one-bedroom flat with no television.",
     "B H K L W", "", "", "L1 has 0 tv"),
]


def short(of: str) -> str:
    kind, _, number = of.rpartition("_")
    return SHORT[kind] + number if kind in SHORT else of


def said(program: Program) -> set[str]:
    """All that is neither room nor door, but for areas."""
    asked = [[r.kind, short(r.of), r.to and short(r.to), r.value] for r in program.requirements]
    every = [" ".join(str(part) for part in one if part is not None) for one in asked]
    every += [f"{short(b)}~{short(a)}" for a, b in program.open_links]
    every += [f"{short(r.id)}<{short(r.private_to)}" for r in program.rooms if r.private_to]
    every += [f"{short(o.room)} has {o.count} {o.category}" for o in program.objects]
    every += [f"{short(room)} has {count}" for room, count in program.counts.items()]
    return {*every, *(f"unread {entry.split(' (')[0]}" for entry in program.unread)}


@pytest.mark.parametrize("prompt, rooms, doors, behind, rest", SENTENCES)
def test_the_programme_of_a_sentence(prompt: str, rooms: str, doors: str, behind: str, rest: str) -> None:
    program = read(prompt)
    kinds = [short(room.id)[0] for room in program.rooms]
    assert " ".join(f"{k}{kinds.count(k)}" if kinds.count(k) > 1 else k for k in sorted({*kinds})) == rooms
    links = {"".join(sorted((short(a), short(b)))) for a, b in program.links}
    hall = {link for link in links if "H1" in link}
    assert links - hall == {*doors.split()}
    off = {short(room.id) for room in program.rooms} - {*behind.split(), "H1"} if "H" in kinds else set()
    assert {link.replace("H1", "") for link in hall} == off
    areas = dict(entry.split("=") for entry in rest.split(", ") if "=" in entry)
    assert said(program) == {entry for entry in rest.split(", ") if entry and "=" not in entry}
    found = {short(room.id): room.area for room in program.rooms} | {"all": program.total_area}
    assert {name: found[name] for name in areas} == {name: float(area) for name, area in areas.items()}
    if "all" in areas:
        assert sum(room.area or 0 for room in program.rooms) == pytest.approx(float(areas["all"]), abs=0.05)

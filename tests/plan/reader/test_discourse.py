"""Who `she` is and whose `mine`: rooms that pronouns mean; what is far,
sold, said of the old home; numbers with parts."""

from itertools import product

import pytest
from sentences.facts import as_meant, facts, rooms

from apartgen.stages.plan.reader import read

WHOSE = [
    ("My husband snores. His room should be as far from mine as the flat allows, and the bathroom next to mine.",
     "B2 H K L W", "apart B2 B1, adjacent W1 B1"),
    ("My wife and I are taking in Grandma. Her bedroom must be next to the bathroom. Ours can go anywhere.",
     "B2 H K L W", "adjacent B2 W1, !adjacent B1 W1"),
    ("Gran is coming to live with my wife, our son and me. Her room should be near the entrance. Our boy gets his own "
     "room.", "B3 H K L W2", "near B2 entrance"),
    ("There's my partner and me, a teenage son, and my partner's mother. Keep her room away from the living room. "
     "His can be right beside it.", "B3 H K L W2", "apart B2 L1, adjacent B3 B2"),
    ("My son is fourteen, so keep his room away from mine. One bathroom.", "B2 H K L W", "apart B2 B1"),
    ("My daughter has her desk in the study; my sister sleeps in the second bedroom. Two bedrooms.", "B2 H K L S W",
     "S1 has 1 desk"),
]  # fmt: skip
THERE = [
    ("Two bedrooms. The baby's room is small, and we need a crib in it.", "B2 H K L W", "B2 has 1 cot, !B1 has 1 cot"),
    ("Our son gets the other bedroom, and he'd love a desk in there. Two bedrooms.", "B2 H K L W",
     "B2 has 1 desk, !L1 has 1 desk"),
    ("One bedroom, and a utility room close to the front door, with a shower in it.", "B H K L U W", "U1 has 1 shower"),
    ("One bedroom. The balcony must face south. A small table and two chairs on it.", "B H K L W Y",
     "Y1 has 2 balcony_chair, Y1 has 1 balcony_table"),
    ("A flat with one bedroom and a study next to my bedroom. A door between the two would be great, but you should "
     "be able to get in from the hall too.", "B H K L S W", "B1S1, H1S1"),
    ("A flat with one bedroom. Bathroom with a door from the bedroom in addition to the one from the hall.",
     "B H K L W", "B1W1, H1W1"),
]  # fmt: skip
COMMON = [
    ("Two bedrooms. I don't want bedroom 2 anywhere near bedroom 1.", "B2 H K L W", "apart B2 B1, !adjacent B2 B1"),
    ("Two bedrooms. The study is nowhere near the kitchen.", "B2 H K L S W", "apart S1 K1"),
    ("Two bedrooms. Windows of the living room to the south, of both bedrooms to the north.", "B2 H K L W",
     "orientation L1 south, orientation B1 north, orientation B2 north"),
    ("One bedroom, 55 square metres at the very most.", "B H K L W", "at_most home 55"),
    ("One bedroom. When I come in, I want kitchen is on the left and living room is on the right.", "B H K L W",
     "position K1 entrance left, position L1 entrance right"),
    ("One bedroom. The bathroom is to the left as you come in.", "B H K L W", "position W1 entrance left"),
    ("A flat with one bedroom, bathroom without bath, only shower.", "B H K L W", "W1 has 1 shower, W1 has 0 bath"),
    ("One bedroom. I can't climb into a bathtub any more, so a shower, please.", "B H K L W", "!W1 has 1 bath"),
    ("Two bedrooms and a bathroom that I get into from my bedroom, with a shower, no bath.", "B2 H K L W",
     "W1 has 1 shower, W1 has 0 bath"),
    ("I sew curtains for a living. One bedroom.", "B H K L W", "!L1 has 2 curtain"),
    ("One bedroom. We sold the piano last year.", "B H K L W", "!L1 has 1 piano"),
    ("Our flat now has two bedrooms and a tiny kitchen. In the new one we want three bedrooms.", "B3 H K L W2", ""),
    ("Two bedrooms, a laundry room beside the kitchen with a washing machine", "B2 H K L U W",
     "U1 has 1 washing_machine, !K1 has 1 washing_machine"),
    ("One bedroom. We cook all day, so make the kitchen large, with an island, and open to the living room.",
     "B H K L W", "K1~L1, K1 has 1 island"),
    ("One bedroom. The kitchen at least 18 m2.", "B H K L W", "at_least K1 18"),
    ("One bedroom. The kitchen needs an island and a pantry you walk into straight from it.", "B H K L T W", "K1T1"),
    ("A flat with one bedroom, a terrace I can step onto from both the living room and the bedroom.", "B H K L W Y",
     "B1Y1, L1Y1"),
    ("Two bedrooms, one bathroom, a bunk bed in the girls' and a cot in our bedroom.", "B2 H K L W",
     "B2 has 1 bunk_bed, B1 has 1 cot"),
    ("One bedroom. From the bedroom into a dressing room and from there into the bathroom.",
     "B C H K L W", "B1C1, C1W1"),
    ("One bedroom. The kitchen is entered from the living room, not from the hall.", "B H K L W",
     "K1L1, no_door K1 H1"),
    ("Two bedrooms. Not make door between kitchen and living room.", "B2 H K L W", "no_door K1 L1"),
    ("One bedroom. Mine looks out west. My bedroom at the back, with its window facing north.", "B H K L W",
     "orientation B1 north"),
    ("3间卧室，2个卫生间", "B3 H K L W2", ""),
    ("一居室，阳台从卧室出去", "B H K L W Y", "B1Y1"),
    ("Two bedrooms. My bedroom must be across from the bathroom and no less than 15 m2.", "B2 H K L W",
     "at_least B1 15, opposite B1 W1, !at_least home 15"),
    ("Two bedrooms, living room not above 14 m2, and the whole apartment has to stay within 50 m2.", "B2 H K L W",
     "at_most L1 14, at_most home 50"),
    ("One bedroom. Storage room off the hallway, near the entrance.", "B H K L T W", "near T1 entrance"),
    ("Two bedrooms. Seen from the entrance, the study is on the left and the kitchen on the right.", "B2 H K L S W",
     "position S1 entrance left, position K1 entrance right"),
    ("A flat with one bedroom, plus a small study where I can practise, well away from the bedroom.", "B H K L S W",
     "apart S1 B1"),
    ("One bedroom. Balcony from the kitchen please.", "B H K L W Y", "K1Y1"),
    ("Zwei Schlafzimmer. In die Speisekammer soll man von der Küche aus kommen.", "B2 H K L T W", "K1T1"),
    ("Dos dormitorios. Al lavadero, con lavadora y secadora, se entra por la cocina.", "B2 H K L U W", "K1U1"),
    ("三卧一卫，主卧朝南", "B3 H K L W", "orientation B1 south"),
    ("三间卧室。儿子房间里放一张书桌。一个卫生间", "B3 H K L W", "B3 has 1 desk"),
    ("两室一厅，有阳台，洗衣机放在阳台上", "B2 H K L W Y", "Y1 has 1 washing_machine"),
    ("Zwei Schlafzimmer, die Küche weit weg davon, weil wir um sechs in der Küche klappern.", "B2 H K L W", ""),
]  # fmt: skip

test_whose_room_it_is = as_meant(WHOSE)

test_where_there_is = as_meant(THERE)

test_what_anybody_writes = as_meant(COMMON)

SIZED = ("Flat with two bedrooms and {a} m2 {r}", "The {r} is {a} m2. Two bedrooms.",
         "Two bedrooms, {r} {a} m2, total 80 m2",
         "{r}: {a} m2\nbedrooms: 2", "A two-bedroom flat. The {r} should be at least {a} m2.",
         "Two bedrooms. The {r} must be {a} m wide.",
         "The {r} measures {a} x 3 m and there are two bedrooms")  # fmt: skip


@pytest.mark.parametrize(
    ("sentence", "room"), list(product(SIZED, ("bathroom", "kitchen", "living room", "hallway", "study")))
)
def test_a_number_with_a_part_says_of_sizes_only(sentence: str, room: str) -> None:
    """`the bathroom is 4.5 m2` is no four bathrooms."""
    for whole, parted in (("4", "4.5"), ("2", "2.5"), ("5", "5,5")):
        assert rooms(read(sentence.format(r=room, a=parted))) == rooms(read(sentence.format(r=room, a=whole)))


def test_a_size_behind_is_its_rooms() -> None:
    found = read("A flat with one bedroom. The bathroom is 4.5 m2.")
    assert rooms(found) == "B H K L W" and "W1=4.5" in facts(found)

"""What no room has, what another room has as well, alike rooms, children told again, sides and rooms said anew."""

import pytest
from sentences.facts import as_meant, rooms

from apartgen.stages.plan.reader import read

NOWHERE = [
    ("Two bedrooms. No tv anywhere.", "B2 H K L W", "L1 has 0 tv, B1 has 0 tv, B2 has 0 tv"),
    ("One-bedroom flat, no television anywhere.", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
    ("One-bedroom flat without a tv anywhere.", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
    ("One-bedroom flat. We don't want any rugs anywhere.", "B H K L W", "L1 has 0 rug, B1 has 0 rug"),
    ("One-bedroom flat, nowhere a television.", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
    ("One-bedroom flat, no plants in the whole flat.", "B H K L W", "L1 has 0 plant, B1 has 0 plant"),
    ("One-bedroom flat; there should be no tv in the flat.", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
    ("One-bedroom flat, no mirrors in the home.", "B H K L W", "B1 has 0 mirror, L1 has 0 mirror"),
    ("One-bedroom flat. No room has a television.", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
    ("One-bedroom flat with no rugs in any of the rooms.", "B H K L W", "L1 has 0 rug, B1 has 0 rug"),
    ("One-bedroom flat, not a single tv in the home.", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
]  # fmt: skip

SAME = [
    ("Two bedrooms. A desk and two chairs in the study, the same in the main bedroom.", "B2 H K L S W",
     "S1 has 1 desk, B1 has 1 desk, B1 has 2 chair"),
    ("Two bedrooms. The first bedroom has a wardrobe and a desk, the same in the second bedroom.", "B2 H K L W",
     "B1 has 1 wardrobe, B2 has 1 wardrobe, B1 has 1 desk, B2 has 1 desk"),
    ("Two armchairs in the living room and the same in the bedroom. One-bedroom flat.", "B H K L W",
     "L1 has 2 armchair, B1 has 2 armchair"),
    ("One bedroom. A bookcase in the living room; the same in the bedroom.", "B H K L W",
     "L1 has 1 bookshelf, B1 has 1 bookshelf"),
    ("One-bedroom flat with a tv in the living room and another in the bedroom.", "B H K L W",
     "L1 has 1 tv, B1 has 1 tv"),
    ("One-bedroom flat with a tv in the living room and one in the bedroom too.", "B H K L W",
     "L1 has 1 tv, B1 has 1 tv"),
    ("One bedroom. The living room has a rug and a lamp, the bedroom has the same.", "B H K L W",
     "L1 has 1 rug, B1 has 1 rug"),
    ("One bedroom. There is a rug in the living room; ditto in the bedroom.", "B H K L W",
     "L1 has 1 rug, B1 has 1 rug"),
    ("Two bedrooms. The small bedroom has a desk and a bed; the same goes for the large bedroom.", "B2 H K L W",
     "B1 has 1 desk, B2 has 1 desk"),
    ("One-bedroom flat. A desk in the bedroom, and the same in the living room.", "B H K L W",
     "L1 has 1 desk, B1 has 1 desk"),
]  # fmt: skip

OPEN = [
    ("Two bedrooms. A dining room that is open to the kitchen.", "B2 D H K L W", "D1~K1"),
    ("Two bedrooms. A living room which is open to the kitchen.", "B2 H K L W", "K1~L1"),
    ("One bedroom and a room that is open to the kitchen.", "B H K L W", "K1~L1"),
    ("A room open to the kitchen, one bedroom and a bathroom.", "B H K L W", "K1~L1"),
    ("One bedroom, a bathroom and a big room that opens to the kitchen.", "B H K L W", "K1~L1"),
    ("Two bedrooms, and one large room which is open to the kitchen.", "B2 H K L W", "K1~L1"),
    ("I want a bright room opening to the kitchen, one bedroom and one bathroom.", "B H K L W", "K1~L1"),
    ("One bedroom, one bathroom, one room open to the kitchen with a sofa.", "B H K L W", "K1~L1"),
    ("A spacious room that should be open onto the kitchen, two bedrooms and a bathroom.", "B2 H K L W", "K1~L1"),
    ("Two bedrooms. A study that is open to the living room.", "B2 H K L S W", "L1S1"),
]  # fmt: skip

CHILDREN = [
    ("We have three children: two of them share, the eldest has her own.", "B3 H K L W2", ""),
    ("We are a couple with three kids; two of them share a room, the oldest has his own.", "B3 H K L W2", ""),
    ("A family with three children. Two share, one has their own room.", "B3 H K L W2", ""),
    ("Two kids, one room for both.", "B2 H K L W", ""),
    ("Two children, one bedroom for both of them, and one for us.", "B2 H K L W", ""),
    ("Our two boys share one room.", "B2 H K L W", ""),
    ("Three children in two rooms, and our bedroom.", "B3 H K L W2", ""),
    ("Family of four, one room for the two children.", "B2 H K L W", ""),
    ("We have two daughters, one room for both of them.", "B2 H K L W", ""),
    ("Parents and three kids: the two little ones share, the eldest sleeps alone.", "B3 H K L W2", ""),
]  # fmt: skip

EACH = [
    ("We both work at home: a home office each, so two studies. One bedroom.", "B H K L S2 W", ""),
    ("One bedroom and a study each, that is two studies.", "B H K L S2 W", ""),
    ("My wife and I want a home office each, so two studies. Two bedrooms.", "B2 H K L S2 W", ""),
    ("A study each for my wife and me, one bedroom.", "B H K L S2 W", ""),
    ("A bathroom each, so two bathrooms. Two bedrooms.", "B2 H K L W2", ""),
    ("My brother and I: a bedroom each, so two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("We want a balcony each, i.e. two balconies. Two bedrooms.", "B2 H K L W Y2", ""),
]  # fmt: skip

ANEW = [
    ("Two bedrooms. The bathroom faces north, no, south.", "B2 H K L W", "orientation W1 south, !orientation W1 north"),
    ("Two bedrooms. The kitchen is in the east, sorry, in the west.", "B2 H K L W",
     "position K1 west, !position K1 east"),
    ("Two bedrooms. The living room faces east - no, west.", "B2 H K L W", "orientation L1 west, !orientation L1 east"),
    ("Two bedrooms, the balcony faces south, actually west.", "B2 H K L W Y",
     "orientation Y1 west, !orientation Y1 south"),
    ("Two bedrooms. Kitchen on the north side, no wait, the south side.", "B2 H K L W",
     "position K1 south, !position K1 north"),
    ("Two bedrooms. The study faces north, I mean south.", "B2 H K L S W",
     "orientation S1 south, !orientation S1 north"),
    ("One bedroom and a study. On reflection the study should be a second bedroom.", "B2 H K L W", ""),
    ("One bedroom and a study. On second thoughts, the study should be a second bedroom.", "B2 H K L W", ""),
    ("A flat with one bedroom and a dining room. Thinking about it, the dining room should be a study.", "B H K L S W",
     ""),
    ("Two bedrooms and a pantry. Actually, the pantry should be a utility room.", "B2 H K L U W", ""),
    ("Two bedrooms and a study. On reflection, the study should rather be a third bedroom.", "B3 H K L W2", ""),
    ("One bedroom, one study. Come to think of it, the study had better be a second bedroom.", "B2 H K L W", ""),
]  # fmt: skip

ALIKE = ["One bedroom flat; all rooms have the same size.", "Two bedrooms, all rooms the same size.",
         "A two-bedroom flat in which all rooms are of equal size.", "One bedroom flat, every room is the same size.",
         "Two bedrooms; all the rooms should be equally big.", "Two-bedroom flat, all rooms of the same size.",
         "Two-bedroom flat. All rooms are equally large.", "Two-bedroom flat. All rooms have equal areas.",
         "Two-bedroom flat, rooms all the same size.",
         "Two-bedroom flat. The rooms are all equal in size."]  # fmt: skip

test_what_is_nowhere_is_in_no_room = as_meant(NOWHERE)
test_another_room_has_the_same = as_meant(SAME)
test_a_room_open_to_the_kitchen_is_lived_in = as_meant(OPEN)
test_children_who_share_are_told_once = as_meant(CHILDREN)
test_one_each_and_the_sum = as_meant(EACH)
test_what_is_said_anew_holds = as_meant(ANEW)


@pytest.mark.parametrize("prompt", ALIKE)
def test_all_rooms_that_one_lives_in_are_alike(prompt: str) -> None:
    program = read(prompt)
    lived = {r.area for r in program.rooms if r.type in ("living_room", "bedroom")}
    assert len(lived) == 1, (rooms(program), lived)

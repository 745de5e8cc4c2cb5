"""Rooms told off from others (`another` of two, `a bathroom for each`), and doors told beside the point."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read

SENTENCES = [
    # another of those counted
    ("Two bathrooms, one inside the bedroom, another next to the kitchen.", "B H K L W2", "B1W1, adjacent W2 K1, H1W2"),
    ("Two bathrooms, one in the main bedroom, another next to the second bedroom.", "B2 H K L W2",
     "B1W1, adjacent W2 B2"),
    ("Two baths: one in the master, another on the hall; three bedrooms.", "B3 H K L W2", "B1W1, H1W2"),
    ("Three bedrooms and two bathrooms. One is inside the master bedroom, another one is off the corridor.",
     "B3 H K L W2", "B1W1, H1W2"),
    ("Two bedrooms, one facing south, another facing north.", "B2 H K L W",
     "orientation B1 south, orientation B2 north"),
    ("Two balconies, one off the kitchen, another off the living room. One bedroom.", "B H K L W Y2", "K1Y1, L1Y2"),
    ("Two bathrooms. Put one in the master bedroom and one off the hall. Two bedrooms.", "B2 H K L W2", "B1W1, H1W2"),
    # one for each, for the other two, for none
    ("Two bedrooms, one bathroom for each.", "B2 H K L W2", "B1W1, B2W2"),
    ("One bathroom per bedroom, three bedrooms.", "B3 H K L W3", "B1W1, B2W2"),
    ("A house with three bedrooms and a balcony for each bedroom.", "B3 H K L W2 Y3", "B1Y1, B2Y2, B3Y3"),
    ("A bathroom for each of the three bedrooms, plus a guest toilet.", "B3 H K L W4", "B1W1, B2W2, B3W3, H1W4"),
    ("Three bedrooms, two bathrooms. The first bathroom belongs to the master bedroom, the second is for the other "
     "two.", "B3 H K L W2", "B1W1, H1W2"),
    ("Three bedrooms. None of them is ensuite. Two bathrooms.", "B3 H K L W2", "H1W1, H1W2"),
    ("None of the three bedrooms is ensuite, two bathrooms on the corridor.", "B3 H K L W2", "H1W1, H1W2"),
    ("Two bedrooms, neither with its own bathroom.", "B2 H K L W", "H1W1"),
    ("Two bedrooms, neither of which has a private bath, one bathroom off the hall.", "B2 H K L W", "H1W1"),
    ("Two-bedroom flat. One bedroom has a double bed, the other two single beds.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("Three bedrooms. One bedroom has a double bed, the other two single beds.", "B3 H K L W2",
     "B1 has 1 double_bed, B2 has 1 single_bed, B3 has 1 single_bed"),
    # doors told beside the point
    ("A flat with two bedrooms. A balcony whose only entrance is from the kitchen.", "B2 H K L W Y", "K1Y1"),
    ("A flat with two bedrooms. A pantry that can be reached just from the kitchen.", "B2 H K L T W", "K1T1, !H1T1"),
    ("A flat with one bedroom. The living room is entered through the kitchen only.", "B H K L W", "K1L1, !H1L1"),
    ("A flat with one bedroom. The study is behind the living room and is entered from there.", "B H K L S W",
     "L1S1, !H1S1"),
    ("A flat with one bedroom. From inside the kitchen you can walk into a storage room.", "B H K L T W", "K1T1"),
    ("A flat with one bedroom. The laundry room has no door to the hallway, you go in from the kitchen.", "B H K L U W",
     "K1U1, !H1U1"),
    ("A flat with one bedroom. Next to the bedroom comes a storage room, with a door between the two.", "B H K L T W",
     "B1T1"),
    ("One bedroom. The living room leads to the kitchen, the kitchen to a pantry and a balcony.", "B H K L T W Y",
     "K1L1, K1T1, K1Y1"),
    ("A flat with one bedroom. There shouldn't be any door between the kitchen and the living room.", "B H K L W",
     "no_door K1 L1"),
    ("One big living room with kitchen inside and two small bedrooms.", "B2 H K L W", "K1~L1"),
    ("A flat with one bedroom; the kitchen is only connected to the living room via an open passage.", "B H K L W",
     "K1~L1"),
    # rooms of people, of other sizes
    ("A big bedroom and a small one, kitchen, bathroom.", "B2 H K L W", ""),
    ("One large bedroom and two smaller ones, two bathrooms.", "B3 H K L W2", ""),
    ("The parents sleep in the big bedroom, the children share the small one. One bathroom.", "B2 H K L W", ""),
    ("A room for my mother, a room for my daughter, and our bedroom. One bathroom.", "B3 H K L W", ""),
    ("The parents' room is 15 m2 and the children's two rooms are 10 m2 each. One bath.", "B3 H K L W",
     "B1=15, B2=10, B3=10"),
    ("Three bedrooms, one is for the kids. The kids' room is next to the bathroom. One bath.", "B3 H K L W",
     "adjacent B3 W1"),
    ("The twins get the room beside ours. Two bedrooms, one bath.", "B2 H K L W", "adjacent B2 B1"),
    ("The bedroom of the kids is next to the bathroom, ours is far from it. Two bedrooms.", "B2 H K L W",
     "adjacent B2 W1, apart B1 W1"),
    ("The living room faces south, the kitchen north and the bedroom east. A one-bedroom flat.", "B H K L W",
     "orientation L1 south, orientation K1 north, orientation B1 east"),
    # one room said twice, directions said again
    ("Two-bedroom unit; the second bathroom is a half bath located near the entrance.", "B2 H K L W2",
     "near W2 entrance, H1W2"),
    ("One bedroom has a balcony, the other has a walk-in closet. Two bedrooms, one bath.", "B2 C H K L W Y",
     "B1Y1, B2C1"),
    ("The bedrooms lie to the east of the hallway, the living room and the kitchen to the west. Two bedrooms.",
     "B2 H K L W", "position B1 H1 east, position L1 H1 west, position K1 H1 west"),
    ("To the right of the entrance is the kitchen, to the left the bathroom. Two bedrooms.", "B2 H K L W",
     "position K1 entrance right, position W1 entrance left"),
    ("Living room in the SW corner, kitchen in the NE corner, two bedrooms.", "B2 H K L W",
     "position K1 north_east, position L1 south_west"),
    ("A flat with one bedroom. The living room isn't connected to the hallway; you get there through the kitchen.",
     "B H K L W", "K1L1, !H1L1"),
    ("A living room that also has the kitchen, one bedroom and a bathroom.", "B H K L W", "K1~L1"),
    # to each other, not far from, larger than usual
    ("Two bedrooms. The bedrooms have a door to each other.", "B2 H K L W", "B1B2"),
    ("A flat with two bedrooms that are linked to one another, one bath.", "B2 H K L W", "B1B2"),
    ("Two bedrooms at opposite ends of the flat.", "B2 H K L W", "apart B1 B2"),
    ("Two bedrooms. The kitchen is not far from the entrance.", "B2 H K L W", "near K1 entrance"),
    ("Two bedrooms. The bathroom must not be near the entrance.", "B2 H K L W", "apart W1 entrance"),
    ("A kitchen that must be the smallest room, two bedrooms and a bath.", "B2 H K L W", "order K1 smallest"),
    ("Two bedrooms, a study we don't need.", "B2 H K L W", ""),
    ("Three bedrooms, a study. Drop the study.", "B3 H K L W2", ""),
    # taken back and denied
    ("A two-bedroom flat with a study. Sorry, I meant a dining room, not a study.", "B2 D H K L W", ""),
    ("Two bedrooms; skip the balcony and the study.", "B2 H K L W", ""),
    ("Two bedrooms. The kitchen is the room closest to the front door.", "B2 H K L W", "near K1 entrance"),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "wanted", "told"), SENTENCES)
def test_the_programme_is_as_meant(prompt: str, wanted: str, told: str) -> None:
    program = read(prompt)
    assert rooms(program) == wanted
    said = facts(program)
    entries = [entry for entry in told.split(", ") if entry]
    assert {entry for entry in entries if entry[0] != "!"} <= said
    assert not {entry[1:] for entry in entries if entry[0] == "!"} & said


OTHERWISE = [
    ("Four bedrooms, one of them with its own bathroom for the grandparents, another bathroom for the others.",
     "B4 H K L W2", ""),
    ("Two bedrooms, one with a desk, and another bedroom for guests.", "B3 H K L W2", ""),
    ("The hallway leads to the kitchen only, the living room to two bedrooms. A flat.", "B2 H K L W", "H1K1, B1L1"),
    ("Two bedrooms. Both the living room and the kitchen have a balcony.", "B2 H K L W Y2", "K1Y2, L1Y1"),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "wanted", "told"), OTHERWISE)
def test_what_only_looks_alike_is_read_as_it_was(prompt: str, wanted: str, told: str) -> None:
    test_the_programme_is_as_meant(prompt, wanted, told)

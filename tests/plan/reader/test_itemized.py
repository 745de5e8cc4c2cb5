"""Labels with numbers, keys with `no`, headings of rooms counted before, and imperatives, as agents write them."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

LABELS = [
    ("Task: generate a 3-bedroom flat. Constraint 1: one bathroom, off the hallway. Constraint 2: the living room is "
     "the largest room.", "B3 H K L W", "H1W1, order L1 largest"),
    ("Requirement 1: two bedrooms. Requirement 2: one bathroom. Requirement 3: kitchen at least 10 m2.", "B2 H K L W",
     "at_least K1 10, H1W1"),
    ("Rule 1: three bedrooms; Rule 2: two bathrooms; Rule 3: bathroom 2 is off the hallway.", "B3 H K L W2", "H1W2"),
    ("C1: two bedrooms. C2: one bathroom. C3: kitchen next to the living room.", "B2 H K L W", "adjacent K1 L1"),
    ("Step 1) add two bedrooms. Step 2) add one bathroom. Step 3) connect the bathroom to the hallway.", "B2 H K L W",
     "H1W1, !B1W1"),
    ("Constraint A: two bedrooms. Constraint B: one bathroom off the hallway.", "B2 H K L W", "H1W1, !unread b"),
    ("(1) two bedrooms (2) one bathroom (3) open kitchen", "B2 H K L W", "K1~L1, !B1W1"),
]  # fmt: skip
DENIED_KEYS = [
    ("Requirement #1 - two bathrooms. Requirement #2 - three bedrooms, study: no.", "B3 H K L W2", "B1W1, !W1W2"),
    ("rooms: 2 bedrooms, 1 bathroom; balcony: n/a; study: absent", "B2 H K L W", "!unread absent"),
    ("bedrooms 2 | bathrooms 2 (1 ensuite, 1 off hallway) | laundry yes | study no | total 960 sqft", "B2 H K L U W2",
     "B1W1, H1W2, all=89.19"),
    ("bedrooms 2, bathrooms 1, study no, balcony yes", "B2 H K L W Y", ""),
    ("Bedrooms: 2. Study: not needed. Balcony: not required.", "B2 H K L W", ""),
    ("bedrooms 2 | bathrooms 1 | balcony none | storage yes | dining room no", "B2 H K L T W", ""),
]
WIDTHS = [
    ("bedrooms: 2; bathrooms: 1; hallway: min width 1.3 m", "B2 H K L W", "at_least H1 width 1.3"),
    ("bedrooms: 2; hallway: max length 6 m; living room: width min 4 m", "B2 H K L W",
     "at_most H1 length 6, at_least L1 width 4"),
    ("2 bedrooms, corridor with a min. width of 1.4 m", "B2 H K L W", "at_least H1 width 1.4"),
    ("2 bedrooms, 1 bathroom. Hallway minimum width: 1.2 m.", "B2 H K L W", "at_least H1 width 1.2"),
]
HEADINGS = [
    ("rooms: bedroom, bathroom, kitchen, living room\nbedroom: double bed\nkitchen: table, 4 chairs", "B H K L W",
     "B1 has 1 double_bed, K1 has 4 chair"),
    ("layout: 1 bedroom, 1 bathroom\nliving room: 1 sofa\nbedroom: 1 double bed, 2 nightstands", "B H K L W",
     "B1 has 1 double_bed, B1 has 2 nightstand, L1 has 1 sofa"),
    ("rooms: 1 bedroom, 1 bathroom, 1 study\nstudy: 1 desk\nbathroom: 1 bathtub\nbedroom: 1 double bed",
     "B H K L S W", "S1 has 1 desk, W1 has 1 bath, B1 has 1 double_bed"),
    ("2 bedrooms; 1 bathroom; 1 study; study: desk, bookshelf; bathroom: shower", "B2 H K L S W",
     "S1 has 1 desk, W1 has 1 shower"),
    ("bedrooms: 1\nbathrooms: 1\nbedroom: 14 m2, faces south\nhallway: yes", "B H K L W",
     "B1=14, orientation B1 south"),
]
IMPERATIVES = [
    ("Place two bedrooms. Do not connect the kitchen to the living room.", "B2 H K L W",
     "no_door K1 L1, !K1L1, !no_door B1 K1"),
    ("Two bedrooms. Connect the kitchen and the dining room.", "B2 D H K L W", "D1K1, B1H1"),
    ("Two bedrooms. Attach bathroom 2 to bedroom 1. Two bathrooms.", "B2 H K L W2", "B1W2, H1W1"),
    ("Add 3 bedrooms. Add 2 bathrooms. Connect bathroom 1 to bedroom 1. Connect bathroom 2 to the hallway.",
     "B3 H K L W2", "B1W1, H1W2, !H1W1, !W1W2"),
    ("Add 2 bedrooms. Add 2 bathrooms. Connect bathroom 1 to the hallway. Connect bathroom 2 to bedroom 1.",
     "B2 H K L W2", "H1W1, B1W2, !H1W2, !W1W2"),
    ("2 bedrooms. Connect the kitchen to the living room.", "B2 H K L W", "K1L1, B1H1, !B1K1"),
    ("2 bedrooms, 2 bathrooms. Link bathroom 1 with bedroom 1, link bathroom 2 with bedroom 2.", "B2 H K L W2",
     "B1W1, B2W2, !H1W2"),
]  # fmt: skip

test_labels = as_meant(LABELS)
test_denied_keys = as_meant(DENIED_KEYS)
test_widths = as_meant(WIDTHS)
test_headings = as_meant(HEADINGS)
test_imperatives = as_meant(IMPERATIVES)


@pytest.mark.parametrize("head", ["Constraint 1: ", "Rule #2: ", "Step 3) ", "Condition 4 - ", "Requirement (5): "])
def test_a_label_says_nothing(head: str) -> None:
    assert read(f"{head}a flat with two bedrooms.").rooms == read("A flat with two bedrooms.").rooms

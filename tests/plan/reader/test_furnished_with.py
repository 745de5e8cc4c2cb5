"""Words that count no furniture, sizes of whom they are said, and what is told because no plan has it."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("One bedroom with a four-poster bed, a kitchen, a bathroom.", "B H K L W", "B1 has 1 double_bed"),
    ("Two bedrooms, the main one with a four poster.", "B2 H K L W", "B1 has 1 double_bed, !unread poster"),
    ("Drei Zimmer, im Schlafzimmer ein Himmelbett.", "B2 H K L W", "B1 has 1 double_bed"),
    ("A two-bedroom flat with a three-seater sofa in the living room.", "B2 H K L W", "L1 has 1 sofa, !unread seater"),
    ("One bedroom, in-unit laundry closet, kitchen, bathroom.", "B H K L U W", ""),
    ("Two bedrooms and a washer/dryer closet.", "B2 H K L U W", ""),
    ("Un appartement avec une chambre et un bureau avec deux tables de travail.", "B H K L S W", "S1 has 2 desk"),
    ("One bedroom. Put a microwave on the kitchen counter and a lamp in the study.", "B H K L S W",
     "K1 has 1 microwave, S1 has 1 table_lamp, !S1 has 1 kitchen_base"),
    ("One bedroom, bath 4 meters, kitchen 9 meters.", "B H K L W", "W1=4, K1=9"),
    ("A master bedroom with bathroom inside, kitchen, living room, balcony.", "B H K L W Y", "B1W1, !H1W1"),
    ("One bedroom, a kitchen barely big enough to turn around in, a bathroom.", "B H K L W", "K1=6"),
    ("The kitchen is hardly large enough for a stove. Two bedrooms.", "B2 H K L W", "K1=6.75, K1 has 1 oven"),
    ("Master bedroom (bathroom inside), second bedroom, kitchen.", "B2 H K L W2", "B1W1"),
    # sizes stand with their own room
    ("Three bedrooms. The third bedroom: 9' x 10'6\". Terrace off the living room.", "B3 H K L W2 Y",
     "dimension B3 2.74 x 3.2, L1Y1, !B3L1"),
    ("2 bedrooms, kitchen 100 sqft total house maybe 90 meter square.", "B2 H K L W", "area K1 9.29, all=90"),
    ("A living room of 200 sq ft, whole apartment 65 m2, one bedroom, one bath.", "B H K L W", "area L1 18.58, all=65"),
    ("Two-bedroom flat, 100 sqm total.", "B2 H K L W", "all=100"),
]  # fmt: skip

test_words_mean_one_thing = as_meant(SENTENCES)

TOLD = [
    "every door should be open", "all doors must be left open", "keep the doors closed",
    "a living room with a sofa bed", "a kitchen with a small table", "a pull-out couch in the study",
]  # fmt: skip


@pytest.mark.parametrize("said", TOLD)
def test_what_no_plan_has_is_told(said: str) -> None:
    assert read(f"A two-bedroom flat. {said.capitalize()}.").unread

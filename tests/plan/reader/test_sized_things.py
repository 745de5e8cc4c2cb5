"""Sizes of furniture, doors and windows and doors that stand open: told with the reason, and of no room."""

import pytest
from sentences.facts import as_meant, rooms

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("Two bedrooms, a bed of 160 x 200 cm in the main bedroom.", "B2 H K L W",
     "B1 has 1 double_bed, B1=14, unread 160 x 200 cm"),
    ("Two bedrooms with a 180 cm bed.", "B2 H K L W", "B1 has 1 double_bed, unread 180 cm"),
    ("Two bedrooms; a desk of 120 by 60 cm in the study.", "B2 H K L S W", "S1 has 1 desk, S1=9"),
    ("Two bedrooms; sofa 2x1 m in the living room.", "B2 H K L W", "L1 has 1 sofa, unread 2x1 m, !dimension L1 2 x 1"),
    ("Two bedrooms; windows 1.2 m wide.", "B2 H K L W", "unread 1.2 m wide"),
    ("Two bedrooms; door height 2.1 m.", "B2 H K L W", "unread 2.1 m"),
    ("Two bedrooms; all furniture lower than 1.5 m.", "B2 H K L W", "unread lower than 1.5 m"),
    ("Zwei Schlafzimmer, ein Bett 160x200 im Schlafzimmer.", "B2 H K L W", "B1 has 1 double_bed, unread 160x200"),
    ("Deux chambres, une table de 2 m de long dans le salon.", "B2 H K L W", "L1 has 1 dining_table"),
    ("Dos dormitorios, sofá de 2 metros de largo.", "B2 H K L W", "unread 2 metros de largo"),
    ("两室，沙发长2米。", "B2 H K L W", "L1 has 1 sofa, unread 2米"),
    # of rooms
    ("Two bedrooms, a kitchen 3 m wide and a living room of 4 x 5 m with a sofa.", "B2 H K L W", "dimension L1 4 x 5"),
    ("Two bedrooms; a living room with a sofa, 4 x 5 m.", "B2 H K L W", ""),
    ("A bedroom with a bed of 12 m2 and a study.", "B S", ""),
]  # fmt: skip

test_sizes_are_of_things = as_meant(SENTENCES)

OPEN = ("every door should be open", "all doors open", "with open doors", "Doors: open", "all doors are half open",
        "no closed doors", "please leave every door open so that the robot can pass", "no door may be closed",
        "doors wide open everywhere", "jede Tür soll offen stehen", "mit offenen Türen",
        "chaque porte doit être ouverte", "cada puerta debe estar abierta", "每扇门都是开的")  # fmt: skip


@pytest.mark.parametrize("said", OPEN)
def test_open_doors_are_told(said: str) -> None:
    program = read(f"Two bedrooms; {said}.")
    assert rooms(program) == "B2 H K L W"
    assert any("whether doors stand open" in entry for entry in program.unread)

"""Furniture in the room that it is told of, or that has such things; corners and windows that it stands by."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.beside_things import WHY

SENTENCES = [
    # in clauses of their own
    ("Two bedrooms. The bathroom should be reachable from the hallway, and I need a dining table with four chairs.",
     "B2 H K L W", "K1 has 1 dining_table, K1 has 4 chair, !W1 has 4 chair"),
    ("One bedroom. The bathroom has a washing machine, and I need a dining table with two chairs.", "B H K L W",
     "W1 has 1 washing_machine, K1 has 1 dining_table, K1 has 2 chair"),
    ("Dos dormitorios. El baño debe estar junto al pasillo, y necesito una mesa de comedor con cuatro sillas.",
     "B2 H K L W", "K1 has 1 dining_table, K1 has 4 chair"),
    ("Two bedrooms, bathroom near the entrance. I need a dining table for four with chairs.", "B2 H K L W",
     "K1 has 4 chair"),
    ("The baby's room is small, and we need a cot in it. Two bedrooms.", "B2 H K L W", "B2 has 1 cot"),
    ("One bedroom, a kitchen, a study with a desk with a lamp.", "B H K L S W", "S1 has 1 desk, S1 has 1 table_lamp"),
    # of bathrooms alone
    ("One-bedroom flat, separate kitchen with room for a table, and please no bathtub, just a walk-in shower.",
     "B H K L W", "K1 has 1 dining_table, W1 has 0 bath, W1 has 1 shower"),
    ("Two bedrooms; a living room with a TV, a bathtub, a shower.", "B2 H K L W", "W1 has 1 bath, W1 has 1 shower"),
    ("一室一厅，厨房有餐桌，不要浴缸，要淋浴。", "B H K L W", "K1 has 1 dining_table, W1 has 0 bath, W1 has 1 shower"),
    ("One bedroom, a kitchen with a table, and a bathtub please.", "B H K L W", "W1 has 1 bath"),
    # of the room told before
    ("两室一厅，次卧给孩子住，要有书桌和书架。", "B2 H K L W", "B2 has 1 desk, B2 has 1 bookshelf"),
    ("三室一厅，次卧给老人住，需要放一张单人床和衣柜。", "B3 H K L W2", "B2 has 1 single_bed, B2 has 1 wardrobe"),
    ("两室一厅，次卧是儿童房，里面要有书桌和书架。", "B2 H K L W", "B2 has 1 desk, B2 has 1 bookshelf"),
    ("两室一厅，主卧带阳台，要有书桌。", "B2 H K L W Y", "B1 has 1 desk"),
    ("两室一厅，厨房和餐厅相连，要有餐桌。", "B2 D H K L W", "D1 has 1 dining_table"),
    ("Two bedrooms. The second one is for our son, with a desk and a bookshelf.", "B2 H K L W",
     "B2 has 1 desk, B2 has 1 bookshelf"),
    # in tasks
    ("Task: fetch mug from kitchen and place on desk in study. One bedroom, a kitchen and a study. Mug on the kitchen "
     "counter, desk against the window.", "B H K L S W", "S1 has 1 desk, !K1 has 1 desk"),
    ("The robot has to carry a plate from the dishwasher to the table in the dining room. Two bedrooms, dining room "
     "with a table.", "B2 D H K L W", "D1 has 1 dining_table"),
    ("Two bedrooms and a study. Desk against the window, mug on the kitchen counter.", "B2 H K L S W",
     "S1 has 1 desk, !K1 has 1 desk"),
    # desks, sofas
    ("Un petit studio de 25 m2, lit une place, bureau devant la fenêtre, coin cuisine.", "K L W",
     "L1 has 1 single_bed, L1 has 1 desk"),
    ("Un petit studio, lit simple, bureau, coin cuisine avec frigo.", "K L W", "L1 has 1 desk"),
    ("Un studio, bureau et lit, coin cuisine.", "K L W", "L1 has 1 desk, L1 has 1 double_bed"),
    ("Un studio avec un bureau séparé.", "K L S W", "!L1 has 1 desk"),
    ("Deux chambres, un bureau sous la fenêtre du salon.", "B2 H K L W", "L1 has 1 desk"),
    ("Deux chambres et un bureau.", "B2 H K L S W", ""),
    ("One-bedroom flat, living room with a sectional sofa.", "B H K L W", "L1 has 1 corner_sofa, !L1 has 1 sofa"),
    # none in any room
    ("One-bedroom flat, no rugs.", "B H K L W", "L1 has 0 rug, B1 has 0 rug, H1 has 0 rug"),
    ("One-bedroom apartment; exclude: television, carpet", "B H K L W", "L1 has 0 tv, B1 has 0 tv, B1 has 0 rug"),
    ("一室一厅，不要电视。", "B H K L W", "L1 has 0 tv, B1 has 0 tv"),
    ("Two bedrooms, two bathrooms, no bathtub.", "B2 H K L W2", "W1 has 0 bath, W2 has 0 bath"),
    ("Two bedrooms with no TVs, living room with a TV.", "B2 H K L W", "L1 has 1 tv, B1 has 0 tv, B2 has 0 tv"),
    ("Two bedrooms, no rug in the living room.", "B2 H K L W", "L1 has 0 rug, !B1 has 0 rug"),
    ("One bedroom and a study. The study has a desk but no wardrobe.", "B S", "S1 has 1 desk, S1 has 0 wardrobe"),
    # places of rooms
    ("Two bedrooms, a kitchen in the middle.", "B2 H K L W", "position K1 centre"),
    ("Three bedrooms, a hallway in the middle, kitchen with a table in the middle.", "B3 H K L W2",
     "position H1 centre, !position K1 centre, unread in the middle"),
]  # fmt: skip

test_things_are_in_their_rooms = as_meant(SENTENCES)

PLACED = [
    ("Two bedrooms, living room with a grey sofa in the corner and a TV.", "in the corner", "1 sofa in living_room_1"),
    ("Two bedrooms, kitchen with an island in the middle.", "in the middle", "1 island in kitchen_1"),
    ("Two bedrooms, living room with a plant by the window.", "by the window", "1 plant in living_room_1"),
    ("Two bedrooms, living room with a rug in the centre.", "in the centre", "1 rug in living_room_1"),
    ("Two bedrooms, a rug in the middle of the living room.", "in the middle", "1 rug in living_room_1"),
    ("Two bedrooms, in the corner of the living room stands a sofa.", "in the corner", "1 sofa in living_room_1"),
    ("Two bedrooms, a dining table in the centre of the home.", "in the centre of the home",
     "1 dining_table in kitchen_1"),
    ("Zwei Schlafzimmer, Küche mit einer Kücheninsel in der Mitte.", "in der mitte", "1 island in kitchen_1"),
    ("Zwei Schlafzimmer, Teppich in der Mitte des Wohnzimmers.", "in der mitte", "1 rug in living_room_1"),
    ("Deux chambres, un tapis au milieu du salon.", "au milieu", "1 rug in living_room_1"),
    ("Dos dormitorios, salón con un sofá en la esquina.", "en la esquina", "1 sofa in living_room_1"),
    ("两室一厅，客厅角落放一张沙发。", "角落", "1 sofa in living_room_1"),
    ("两室一厅，书桌靠窗。", "靠窗", "1 desk in bedroom_1"),
]  # fmt: skip


@pytest.mark.parametrize(("prompt", "place", "thing"), PLACED)
def test_places_of_furniture_are_told(prompt: str, place: str, thing: str) -> None:
    program = read(prompt)
    assert any(told.startswith(f"{place} ({WHY}") for told in program.unread), program.unread
    assert thing in [f"{o.count} {o.category} in {o.room}" for o in program.objects]
    assert program.requirements == []

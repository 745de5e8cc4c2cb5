"""Children by names and ages, what is whose, things counted behind their name, doors told of one room."""

from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("Two sharers: a bedroom each of 13 m², the two as far apart as the plan allows, one bathroom.", "B2 H K L W",
     "B1=13, B2=13, apart B1 B2"),
    ("Three flatmates, all students: a bedroom each of 11 m² with a desk, one bathroom.", "B3 H K L W",
     "B1=11, B3=11, B1 has 1 desk, B3 has 1 desk"),
    ("Not a studio! A one-bedroom flat of 50 m².", "B H K L W", "all=50"),
    ("We don't want a studio but a one-bedroom flat.", "B H K L W", ""),
    ("We have twins of six who share a room with a bunk bed and two desks. Our own bedroom is next to theirs.",
     "B2 H K L W", "B2 has 1 bunk_bed, B2 has 2 desk, adjacent B1 B2"),
    ("Our twins, aged 4, share a room. One bathroom.", "B2 H K L W", ""),
    ("Three kids, each with a bedroom of their own, plus ours. A family bathroom off the hall.", "B4 H K L W", "H1W1"),
    ("Emma (9) and Noah (5) each have their own bedroom with a single bed; we parents have one with a double bed.",
     "B3 H K L W2", "B1 has 1 double_bed, B2 has 1 single_bed, B3 has 1 single_bed"),
    ("Lena (7), Paul (5) and Tim (2) share one bedroom with a bunk bed; our bedroom has a double bed.", "B2 H K L W",
     "B2 has 1 bunk_bed, B1 has 1 double_bed"),
    ("Kitchen (9), bath (5), bedroom (12) with a desk.", "B H K L W", "K1=9, W1=5, B1=12, B1 has 1 desk"),
    ("Two children's bedrooms and ours. The kids' bathroom has a door from each of the children's rooms and none from "
     "the hall.", "B3 H K L W", "B2W1, B3W1, !H1W1"),
    ("A one-bedroom flat with two ways into the bathroom, one door from the bedroom and one from the hallway.",
     "B H K L W", "B1W1, H1W1"),
    ("Drop the second bathroom from your usual three-bedroom house; I only want one.", "B3 H K L W", "H1W1"),
    ("We need a flat without any hallway: one bedroom and the bathroom have their doors to the living room, and the "
     "kitchen is open to it.", "B K L W", "B1L1, L1W1, K1~L1, !B1K1"),
    ("Rugs: two in the living room, one in each bedroom. Two bedrooms.", "B2 H K L W",
     "L1 has 2 rug, B1 has 1 rug, B2 has 1 rug"),
    ("Chairs: six in the dining room, two in the kitchen. One bedroom.", "B D H K L W",
     "D1 has 6 chair, K1 has 2 chair, !unread six"),
    ("The kitchen has three doors: to the hall, to the dining room and to the utility room. Two bedrooms, one bath, a "
     "living room.", "B2 D H K L U W", "H1K1, D1K1, K1U1, D1L1"),
    ("Lidar occlusion study: two bedrooms, A and B, of which B is half the size of A; one bathroom.", "B2 H K L W", ""),
    ("A small home study: 8 m². One bedroom, living room, kitchen.", "B H K L S W", "S1=8"),
    ("Two bedrooms, the second entered only through the first. One bathroom.", "B2 H K L W", "B1B2, B1H1, !B2H1"),
    ("One bedroom flat. The kitchen must not be open to the living room.", "B H K L W", "!no_door K1 L1, !K1~L1"),
    ("One bedroom flat. The kitchen must not open onto the living room.", "B H K L W", "no_door K1 L1"),
    ("机器人测试用房，70平方米：一间卧室、一间书房、客厅、厨房、卫生间。", "B H K L S W", "all=70"),
]  # fmt: skip

test_it_is_read_as_meant = as_meant(SENTENCES)


def test_comparisons_hold_together() -> None:
    program = read("Two bedrooms, A and B, of which B is half the size of A; the living room is twice the size of A.")
    areas = {room.id: room.area or 0 for room in program.rooms}
    assert round(areas["bedroom_2"] / areas["bedroom_1"], 2) == 0.5
    assert round(areas["living_room_1"] / areas["bedroom_1"], 2) == 2


def test_comparisons_that_cannot_hold_leave_rooms_of_a_size() -> None:
    said = "Bedroom 1 is twice the size of bedroom 2, bedroom 2 is three times the size of bedroom 1."
    program = read(f"Two bedrooms. {said}")
    assert all(4 < (room.area or 0) < 60 for room in program.rooms)

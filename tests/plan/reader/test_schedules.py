"""Schedules of rooms with places and sizes, homes with nothing else, and requests in few words."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SCHEDULES = [
    ("Bathroom: NW corner, 2 x 3 m. Kitchen: NE corner, 3 x 4 m. Bedroom: south, 4 x 4 m. Living "
     "room: centre, 5 x 6 m.",
     "B H K L W", "dimension W1 2 x 3, dimension K1 3 x 4, dimension B1 4 x 4, dimension L1 5 x 6, "
     "position W1 north_west,"
     " position K1 north_east, position B1 south, position L1 centre"),
    ("Bathroom: in the NW corner. 7 x 12 ft. Kitchen: in the NE corner. 10 x 8 ft. One bedroom: in "
     "the south. 12 x 15 ft.",
     "B H K L W", "dimension W1 2.13 x 3.66, dimension K1 3.05 x 2.44, dimension B1 3.66 x 4.57"),
    ("Bathroom: north-west, 6 m². Kitchen: north-east, 9 m². Bedroom: south, 14 m².", "B H K L W", "W1=6, K1=9, B1=14"),
    ("Two-bedroom flat. Living room: sofa, TV, 28 m². Kitchen: dishwasher, 10 m². Bedroom 1: double bed, desk, 14 m². "
     "Bedroom 2: 11 m², bunk bed.", "B2 H K L W", "L1=28, K1=10, B1=14, B2=11, L1 has 1 sofa, B1 has 1 desk"),
    ("Two bedrooms. Kitchen: next to the living room, 9 m²", "B2 H K L W", "K1=9, adjacent K1 L1"),
    ("Küche: Nordost, 9 m². Schlafzimmer: Süden, 14 m². Bad: Norden, 5 m².", "B H K L W",
     "K1=9, B1=14, W1=5, position K1 north_east, position B1 south, position W1 north"),
    ("Cuisine : au nord, 9 m². Chambre : au sud, 14 m². Salon : à l'ouest, 25 m².", "B H K L W", "K1=9, B1=14, L1=25"),
    ("Bedrooms: 2, 12 m² each. Bathroom: 1, 5 m².", "B2 H K L W", "B1=12, B2=12, W1=5"),
    ("The flat has a bathroom. Its size is 5 m². There is one bedroom. Its size is 12 m².", "B H K L W", "W1=5, B1=12"),
    ("Two bedrooms. The bathroom is a decent size. The size is about 3 x 3 m.", "B2 H K L W", "dimension W1 3 x 3"),
    ("Two bedrooms. The bathroom is the northernmost room.", "B2 H K L W", "position W1 north"),
    ("Two-bedroom flat. Its size is 60 m².", "B2 H K L W", "all=60"),
]  # fmt: skip
NOTHING_ELSE = [
    ("studio, nothing else", "K L W", "K1~L1"),
    ("studio unit, tiny balcony, nothing else", "K L W Y", "L1Y1"),
    ("studio with kitchen and bathroom, nothing else", "K L W", ""),
    ("two-bedroom flat, nothing else", "B2 H K L W", ""),
    ("two-bedroom flat with a balcony, nothing else", "B2 H K L W Y", "L1Y1"),
    ("two bedrooms and a bath, nothing else", "B2 W", ""),
    ("one bedroom, a living room, a kitchen and a bathroom, nothing else", "B K L W", ""),
]
TERSE = [
    ("2 bedroom 1 bath. kitchen = 2x bathroom, living = biggest room", "B2 H K L W", "order L1 largest"),
    ("No door kitchen<->hall! Kitchen only via dining room, dining off the living. 2 bedrooms, 1 bath off the hall",
     "B2 D H K L W", "no_door K1 H1, D1K1, !H1K1"),
    ("two bedrooms, storage shares a wall w/ kitchen but no door between them", "B2 H K L T W",
     "adjacent T1 K1, no_door T1 K1"),
    ("I don't want that the bathroom has common wall with the kitchen. There is two bedrooms in the "
     "flat.", "B2 H K L W",
     "apart W1 K1"),
    ("One bedroom. We would hate to have a door straight from the kitchen to the bathroom.", "B H K L W", "!K1W1"),
    ("Two-bedroom home with a study. The study must be apart from both bedrooms.", "B2 H K L S W",
     "apart S1 B1, apart S1 B2"),
    ("I work from home, so my bedroom is also my office. Please only one bedroom and no extra room.", "B H K L W",
     "use B1 study"),
    ("My bedroom window must look to the east. I need only this one bedroom.", "B H K L W", "orientation B1 east"),
    ("Flat with one bedroom. Washing machine in the bathroom, and in bedroom I want a wardrobe.", "B H K L W",
     "B1 has 1 wardrobe"),
    ("living room dead centre of the floorplan, 2 bedrooms", "B2 H K L W", "position L1 centre"),
    ("Three bedrooms and two bathrooms. Doors of both bathrooms must be in the hallway.", "B3 H K L W2", "H1W1, H1W2"),
    ("I need two bedroom. In first one stand a double bed, in second one two single beds.", "B2 H K L W",
     "B1 has 1 double_bed, B2 has 2 single_bed"),
    ("2br/1ba. living windows west, bedroom windows (both) east", "B2 H K L W",
     "orientation L1 west, orientation B1 east, orientation B2 east"),
    ("We are three students sharing a place. We each want a bedroom of 12 m², one bathroom is fine.", "B3 H K L W",
     "B1=12, B2=12, B3=12"),
    ("four bedrooms and three bathrooms, exactly one of which is ensuite", "B4 H K L W3", "B1W1, H1W2, H1W3"),
    ("a bedroom with minimum 15 m2 and a bathroom with maximum 6 m2. Also a kitchen and a living room.", "B H K L W",
     "H1W1, at_least B1 15, at_most W1 6"),
    ("Our experiments take place in the kitchen, so it should measure 4 x 5 m. Otherwise: one "
        "bedroom, one bathroom, and a "
     "living room in which a dining table stands.", "B H K L W", "dimension K1 4 x 5, L1 has 1 dining_table"),
    ("The only bedroom has two exits, one to the hallway and one to the balcony, and the balcony can also be reached "
     "from the living room. One bathroom.", "B H K L W Y", "B1Y1, L1Y1, B1H1"),
    ("For me a hallway is lost space, I do not want one. The bedroom and the bathroom go from the living room, and the "
     "kitchen is open to it.", "B K L W", "B1L1, L1W1, K1~L1"),
    ("args: beds=2, baths=1, no_door=(kitchen, living room), adjacent=(bedroom 1, bathroom)", "B2 H K L W",
     "no_door K1 L1, adjacent B1 W1"),
    ("Inputs -> bedrooms: 2, bathrooms: 1. Size ordering -> living room larger than bedroom 1; the bathroom is the "
     "smallest room.", "B2 H K L W", "order L1 B1 larger, order W1 smallest, H1W1"),
    ("Four bedrooms, two bathrooms that both open from the hallway, and a laundry room.", "B4 H K L "
        "U W2", "H1U1, H1W2"),
    ("one bedroom, a library twice as large as that bedroom, a bathroom, a kitchen, a living room", "B H K L S W", ""),
    ("studio with a desk and a single bed in the room and a shower in the bathroom", "K L W", "L1 has 1 single_bed"),
    ("two-bedroom flat: the kitchen is opposite the bathroom, and the two bedrooms are opposite one another",
     "B2 H K L W", "opposite B1 B2, opposite K1 W1, !opposite K1 B1"),
    ("Render this:\n| room | m2 |\n| living room | 28 |\n| kitchen | 11 |\n| bedroom 1 | 16 |\n| bathroom | 6 |",
     "B H K L W", "L1=28, K1=11, B1=16, W1=6"),
]  # fmt: skip

test_schedules = as_meant(SCHEDULES)

test_nothing_else = as_meant(NOTHING_ELSE)

test_few_words = as_meant(TERSE)


@pytest.mark.parametrize("prompt", ["kitchen = 2x bathroom. 2 bedrooms", "2 bedrooms. kitchen = 2 x bathroom"])
def test_ratios_with_signs(prompt: str) -> None:
    areas = {room.id: room.area or 0.0 for room in read(prompt).rooms}
    assert areas["kitchen_1"] == pytest.approx(2 * areas["bathroom_1"], rel=0.01)


@pytest.mark.parametrize(
    "prompt", ["hacker's studio", "a ranger's cabin, two bedrooms", "property with two bedrooms, wardrobe included"]
)
def test_words_that_are_no_slips(prompt: str) -> None:
    things = {thing.category for thing in read(prompt).objects}
    assert not things & {"stool", "oven"}

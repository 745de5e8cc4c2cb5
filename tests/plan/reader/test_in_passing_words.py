"""Items of YAML, exclusions in a list, rooms that may open off another, ways told by steps, `it` behind a contrast."""

from sentences.facts import as_meant

ITEMS = [
    ("rooms:\n  - type: bedroom\n    count: 2\n    area: 12\n  - type: bathroom\n  - type: living_room\n    area: 24\n"
     "  - type: kitchen", "B2 H K L W", "B1=12, B2=12, L1=24, !all=12"),
    ("spec: {beds: 3, baths: 2, ensuite_for: bedroom_1, hall_width_min: 1.2}", "B3 H K L W2",
     "B1W1, at_least H1 width 1.2"),
    ("Exclude: study, balcony. Include: 2 bedrooms, 1 bathroom, utility room (adjacent to kitchen).", "B2 H K L U W",
     "adjacent U1 K1"),
]
UNKNOWN = [
    ("A flat with a big fluffy bathroom and one bedroom.", "B H K L W", "W1=6.5, unread fluffy, !unread big"),
    ("Two zorbly bedrooms and a quirky study.", "B2 H K L S W", "unread zorbly, !unread two"),
]  # fmt: skip

test_what_stands_before_an_unknown_word_is_said_of_the_room = as_meant(UNKNOWN)

OPEN_OFF = [
    ("No more than two rooms may open off the living room; two bedrooms, one bathroom.", "B2 H K L W",
     "at_most L1 doors 2"),
    ("At least three rooms must be reached from the hallway. Two bedrooms, one bathroom.", "B2 H K L W",
     "at_least H1 doors 3"),
]
WAYS = [
    ("We'd like to get from the kitchen straight onto the terrace, and from the living room as well. Two bedrooms.",
     "B2 H K L W Y", "K1Y1, L1Y1"),
    ("One-bedroom flat; from the bedroom you step into the bathroom.", "B H K L W", "B1W1"),
    ("The guest toilet must not be next to the dining room, but it should be close to the front door. Three bedrooms, "
     "one bathroom, a dining room.", "B3 D H K L W2", "apart W1 D1, near W1 entrance, !near D1 entrance"),
]
BEDS = [
    ("My office must have two desks and no bed; the bedroom a double bed. One bathroom.", "B H K L S W",
     "S1 has 2 desk, B1 has 1 double_bed"),
    ("Two bedrooms. Laundry in the bathroom: washing machine and dryer there.", "B2 H K L W",
     "W1 has 1 washing_machine, W1 has 1 dryer"),
]

test_items_of_programs = as_meant(ITEMS)
test_rooms_that_open_off_another = as_meant(OPEN_OFF)
test_ways_by_steps = as_meant(WAYS)
test_things_that_are_no_rooms = as_meant(BEDS)

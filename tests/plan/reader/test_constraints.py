"""Limits and places as programs note them, and rooms that are named with their size before they are counted."""

from sentences.facts import as_meant

LIMITS = [
    ("min_area(kitchen)=9, max_area(bathroom)=6, bedrooms=2, bathrooms=1", "B2 H K L W",
     "at_least K1 9, at_most W1 6, !unread min"),
    ("rooms: bed x2, bath x1, living, kitchen | hallway min clear width 1.25 m", "B2 H K L W",
     "at_least H1 width 1.25"),
    ("min kitchen area: 9 m2; 2 bedrooms", "B2 H K L W", "at_least K1 9, !unread min"),
    ("kitchen area >= 9; 2 bedrooms", "B2 H K L W", "at_least K1 9, !unread at least"),
    ("Two bedrooms, one bathroom. width(hallway) >= 1.2", "B2 H K L W", "at_least H1 width 1.2"),
    ("min. width of the corridor 1.2 m; bedrooms: 2", "B2 H K L W", "at_least H1 width 1.2"),
    ("max corridor length: 5 m; two bedrooms", "B2 H K L W", "at_most H1 length 5"),
    ("kitchen area in [9, 12] m2; 2 bedrooms", "B2 H K L W", "at_least K1 9, at_most K1 12"),
    ("bedrooms: 2; area of living room in range 20-25 m2", "B2 H K L W", "at_least L1 20, at_most L1 25"),
]
PLACES = [
    ("Front: living room and kitchen. Back: both bedrooms. Middle: bathroom.", "B2 H K L W",
     "position L1 front, position K1 front, position B1 back, position B2 back, position W1 centre"),
    ("2 bedrooms, 1 bath. North: kitchen; south: living room and the balcony", "B2 H K L W Y",
     "position K1 north, position L1 south, position Y1 south"),
    ('{"bedrooms": 2, "bathrooms": 1, "living_room": {"area": 26, "faces": "south"}}', "B2 H K L W",
     "L1=26, orientation L1 south"),
    ('{"bedrooms": 2, "living_room": {"orientation": "west", "area": 26}}', "B2 H K L W",
     "L1=26, orientation L1 west"),
]
COUNTED_AFTERWARDS = [
    ("Bathroom at most 6 m2, two bedrooms, one bathroom.", "B2 H K L W", "at_most W1 6"),
    ("Kitchen 9 m2, bathroom 5 m2, living room 20 m2; two bedrooms, one bathroom.", "B2 H K L W", "W1=5"),
    ("Bedroom north of bathroom. Kitchen, living room. One bedroom, one bathroom.", "B H K L W",
     "position B1 W1 north"),
    ("Two bedrooms, bathroom, one bathroom en suite to the main bedroom.", "B2 H K L W2", "B1W2"),
    ("Bedroom, kitchen, living room, bathroom and one bedroom for guests.", "B2 H K L W", ""),
]

test_limits_of_programs = as_meant(LIMITS)
test_places_of_programs = as_meant(PLACES)
test_rooms_counted_after_they_are_named = as_meant(COUNTED_AFTERWARDS)

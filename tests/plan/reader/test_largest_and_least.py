"""The largest of its kind, what is at least as large as another room, and as large as several together."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

LARGEST = [
    ("A three-bedroom flat. The first bedroom is the largest.", "B3 H K L W2",
     "order B1 B2 larger, order B1 B3 larger, !order B1 largest, B1=14"),
    ("A three-bedroom flat. The second bedroom is the largest one and faces south.", "B3 H K L W2",
     "order B2 B1 larger, order B2 B3 larger, B2=14, B1=11.8, orientation B2 south"),
    ("A three-bedroom flat, where bedroom 2 is the smallest.", "B3 H K L W2",
     "order B2 B1 smaller, order B2 B3 smaller, B2=9.5, B3=11.8"),
    ("Three bedrooms: the third one is the largest, the second faces south.", "B3 H K L W2",
     "order B3 B1 larger, order B3 B2 larger, orientation B2 south"),
    ("Two bedrooms of 12 and 14 m². The second bedroom is the largest.", "B2 H K L W",
     "order B2 B1 larger, B1=12, B2=14"),
    ("A two-bedroom flat. The kitchen is the largest.", "B2 H K L W", "order K1 largest"),
    ("A three-bedroom flat. The first bedroom is the largest room.", "B3 H K L W2", "order B1 largest"),
]  # fmt: skip

test_the_largest_of_a_kind = as_meant(LARGEST)

AT_LEAST = [
    ("A two-bedroom flat with a kitchen at least as large as the bathroom.", "B2 H K L W",
     "order K1 W1 larger, K1=9, W1=5, !unread at least"),
    ("A two-bedroom flat. The living room is at least the size of the main bedroom.", "B2 H K L W",
     "order L1 B1 larger, L1=25.5, !unread at least"),
    ("A two-bedroom flat. The bathroom should be at most as large as the kitchen.", "B2 H K L W",
     "order W1 K1 smaller, !unread at most"),
    ("A two-bedroom flat. The kitchen is as large as or larger than the bathroom.", "B2 H K L W",
     "order K1 W1 larger, !unread or larger"),
    ("A two-bedroom flat. The dining room is as big as the kitchen or bigger.", "B2 D H K L W",
     "order D1 K1 larger, !unread or bigger"),
    ("A two-bedroom flat. The living room should be at least twice as large as the kitchen.", "B2 H K L W",
     "!unread at least, K1=9, L1=25.5"),
    ("Two bedrooms, the living room at least three times as large as the kitchen.", "B2 H K L W",
     "!unread at least, K1=8.75, L1=26.24"),
    ("Two bedrooms. The kitchen is at most half as large as the living room.", "B2 H K L W", "K1=9, L1=25.5"),
    ("Kitchen 15 m2, living room at least twice as large as the kitchen, one bedroom.", "B H K L W", "L1=30"),
    ("One bedroom. The living room is no more than twice the size of the kitchen.", "B H K L W", "K1=9.17, L1=18.33"),
    ("Zwei Schlafzimmer. Das Wohnzimmer ist mindestens doppelt so groß wie die Küche.", "B2 H K L W", "K1=9, L1=25.5"),
    ("Ein Bad. Das Schlafzimmer ist mindestens anderthalbmal so groß wie das Arbeitszimmer.", "B H K L S W",
     "S1=9, B1=14, !unread anderthalbmal"),
    ("Deux chambres. Le salon fait au moins le double de la cuisine.", "B2 H K L W", "!unread au moins, L1=25.5"),
    ("Dos dormitorios. El salón debe medir al menos el triple que la cocina.", "B2 H K L W", "K1=8.75"),
    ("Dos dormitorios. El salón es al menos el triple de grande que la cocina.", "B2 H K L W", "K1=8.75"),
    ("A two-bedroom flat. The bathroom must not be bigger than the kitchen.", "B2 H K L W",
     "order W1 K1 smaller, !order W1 K1 larger, K1=9, W1=5"),
    ("A two-bedroom flat. The second bedroom is not as large as the kitchen.", "B2 H K L W", "order B2 K1 smaller"),
    ("Two bedrooms, neither smaller than the kitchen.", "B2 H K L W", "order B1 K1 larger, order B2 K1 larger, K1=9"),
    ("A two-bedroom flat. The second bedroom is no smaller than the kitchen.", "B2 H K L W",
     "order B2 K1 larger, B2=11.8, K1=9"),
    ("Ein Wohnzimmer, zwei Schlafzimmer. Das Bad ist nicht größer als die Küche.", "B2 H K L W",
     "order W1 K1 smaller"),
    ("Dos dormitorios, un baño y una cocina. La cocina no es más pequeña que el baño.", "B2 H K L W",
     "order K1 W1 larger, B1=14"),
    ("A two-bedroom flat. The bathroom should not be smaller than 6 m².", "B2 H K L W", "at_least W1 6"),
]  # fmt: skip

test_at_least_as_large = as_meant(AT_LEAST)

TOGETHER = [
    "A two-bedroom flat whose living room is as large as both bedrooms together.",
    "A two-bedroom flat. The living room is as large as the two bedrooms combined.",
    "A two-bedroom flat of 80 m². The living room is as large as both bedrooms together.",
    "Two bedrooms of 12 and 10 m². The living room is as large as both bedrooms together.",
    "A three-bedroom flat with a living room the size of all bedrooms put together.",
]


@pytest.mark.parametrize("prompt", TOGETHER)
def test_as_large_as_several_together(prompt: str) -> None:
    rooms = read(prompt).rooms
    living, *beds = [sum(r.area or 0 for r in rooms if r.type == kind) for kind in ("living_room", "bedroom")]
    assert living == pytest.approx(sum(beds), rel=0.01)


def test_as_large_as_two_rooms_together() -> None:
    program = read("A two-bedroom flat. The living room is as big as the kitchen and the bathroom together.")
    areas = {room.id: room.area or 0 for room in program.rooms}
    assert areas["living_room_1"] == pytest.approx(areas["kitchen_1"] + areas["bathroom_1"], rel=0.01)
    assert areas["kitchen_1"] > areas["bathroom_1"]

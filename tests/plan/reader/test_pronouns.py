"""What `it` stands for where rooms open onto it, and verbs that are left out."""

import pytest

from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("text, hub, others", [
    ("The living room is the centre of the flat: the kitchen, the study, the balcony and a short corridor all open "
     "onto it. The corridor ends in two bedrooms and a bathroom.", "living_room_1",
     {"kitchen_1", "study_1", "balcony_1", "hallway_1"}),
    ("Kitchen in the middle: to its left the dining room, to its right the living room, both open to it. Hall with two "
     "bedrooms and a bathroom off the living room.", "kitchen_1", {"dining_room_1", "living_room_1"}),
])
def test_rooms_open_onto_it(text: str, hub: str, others: set[str]) -> None:
    program = read(text)
    pairs = {frozenset(pair) for pair in [*program.links, *program.open_links]}
    assert {next(iter(pair - {hub})) for pair in pairs if hub in pair} >= others


@pytest.mark.parametrize("text, room, owner", [
    ("Living room, kitchen, bathroom, bedroom. A study behind the kitchen.", "study_1", "kitchen_1"),
    ("A flat with a living room and a kitchen, and a study behind the living room.", "study_1", "living_room_1"),
    ("Two-bedroom flat. There is a storage room behind the kitchen.", "storage_1", "kitchen_1"),
])
def test_a_room_behind_another_is_entered_from_it(text: str, room: str, owner: str) -> None:
    assert [set(pair) - {room} for pair in read(text).links if room in pair] == [{owner}]


@pytest.mark.parametrize(
    ("prompt", "link"),
    [
        ("One-bedroom flat. The hall leads to the kitchen (11 m²) and a study.", ("hallway_1", "study_1")),
        ("One-bedroom flat: the foyer serves the living room, the corridor the bedroom.", ("bedroom_1", "hallway_2")),
        ("Drei Zimmer: ein Wohnzimmer, von dem aus man in die Küche kommt.", ("kitchen_1", "living_room_1")),
    ],
)
def test_doors_said_in_few_words(prompt: str, link: tuple[str, str]) -> None:
    assert link in read(prompt).links

"""How many objects a room gets, from what rooms of its type and area held."""

from dataclasses import replace

import numpy as np
import pytest
from layout.rooms_for_tests import some_rooms

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.layout.rooms import UNKNOWN, Rooms
from apartgen.stages.layout.sample import count_table, draw_counts

BEDROOM = ROOM_TYPES.index("bedroom")
EDGES = [0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 21, 25, 30, 36, 45]
"""Of the classes of area: the first holds rooms below 2 m², the last those from 45 m² on."""


def squares(areas: list[float]) -> Rooms:
    """Bedrooms of these areas, of which nothing is known or asked."""
    rooms = some_rooms(len(areas))
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], np.float32)
    rooms.polygon[:, :4] = np.sqrt(np.array(areas, np.float32))[:, None, None] / 2 * corners
    return replace(rooms, type=np.full(len(areas), BEDROOM), count=np.full(len(areas), UNKNOWN))


@pytest.mark.parametrize(
    ("area", "at"), [(1.0, 0), (1.99, 0), (2.01, 1), (11.9, 9), (12.1, 10), (44.9, 17), (99.0, 18)])
def test_rooms_are_counted_in_their_class_of_area(area: float, at: int) -> None:
    table = np.array(count_table(squares([area]), np.array([4])))
    assert table.shape[:2] == (len(ROOM_TYPES), len(EDGES)) and table.sum() == 1
    assert table[BEDROOM, at, 4] == 1


@pytest.mark.parametrize("at", [0, 1, 9, 10, 17, 18])
def test_a_room_gets_as_many_as_rooms_of_its_class_had(at: int) -> None:
    """Of a record in which rooms of class k held k objects, a class further counts e⁻³ as much."""
    table = np.zeros((len(ROOM_TYPES), len(EDGES), 25), int)
    table[BEDROOM, np.arange(len(EDGES)), np.arange(len(EDGES))] = 100
    upper = [*EDGES[1:], 60][at]
    n = 1500
    rooms = squares([(EDGES[at] + upper) / 2] * n)
    lanes = [np.random.default_rng(seed) for seed in range(n)]
    drawn = draw_counts(rooms, table.tolist(), lanes, np.zeros(n, bool))
    weight = np.exp(-3.0 * np.abs(np.arange(len(EDGES)) - at))
    likely = weight / weight.sum()
    share = np.bincount(drawn, minlength=len(EDGES)) / n
    assert np.abs(share - likely).max() < 4 * np.sqrt(0.25 / n)
    assert share.argmax() == at


def test_homes_draw_from_the_fuller_rooms() -> None:
    """A quarter of the record's rooms, the emptiest, serve rooms by themselves only."""
    table = np.zeros((len(ROOM_TYPES), len(EDGES), 25), int)
    table[BEDROOM, 9, 1:9] = 100
    n = 2000
    rooms = squares([11.0] * n)
    for home, counts in ((False, range(1, 9)), (True, range(3, 9))):
        lanes = [np.random.default_rng(seed) for seed in range(n)]
        drawn = draw_counts(rooms, table.tolist(), lanes, np.full(n, home))
        assert set(drawn.tolist()) == set(counts)
        assert np.abs(np.bincount(drawn)[list(counts)] / n - 1 / len(counts)).max() < 4 * np.sqrt(0.14 / n)


def test_what_is_known_and_asked_is_kept() -> None:
    table = np.zeros((len(ROOM_TYPES), len(EDGES), 25), int)
    table[BEDROOM, 9, 5] = 1
    rooms = squares([11.0] * 3)
    rooms.count[:] = [7, UNKNOWN, UNKNOWN]
    rooms.wanted[2, :8] = 1
    lanes = [np.random.default_rng(seed) for seed in range(3)]
    assert draw_counts(rooms, table.tolist(), lanes, np.zeros(3, bool)).tolist() == [7, 5, 8]

"""What stands on what, and how far things are from walls, in cases by hand."""

import numpy as np
import pytest
from rooms_for_tests import some_rooms

from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.projection.standing import Item, rests_on
from apartgen.stages.space.boxes import Boxes

CHEST = Item("chest", np.array([0.0, 0.0, 0.4]), np.array([0.5, 1.0, 0.8]), np.pi / 2)
"""Turned: 1 m along x, .5 m along y, its top at .8 m."""


@pytest.mark.parametrize("x, y, bottom, stands", [
    (0.3, 0.1, 0.8, True), (0.49, 0.0, 0.8, True),
    (0.3, 0.1, 1.0, False),  # above it, in the air
    (0.3, 0.1, 0.0, False),  # in it, on the floor
    (2.0, 0.1, 0.8, False),  # as high as its top, elsewhere
    (0.1, 0.3, 0.8, False),  # beyond its narrow side
    (0.6, 0.0, 0.8, False),
])
def test_a_lamp_stands_on_a_chest_when_level_and_above_it(x: float, y: float, bottom: float, stands: bool) -> None:
    lamp = Item("table_lamp", np.array([x, y, bottom + 0.2]), np.array([0.2, 0.2, 0.4]), 0.0)
    assert rests_on(lamp, CHEST) is stands


def test_backs_are_as_far_from_the_walls_within_a_room_and_beyond() -> None:
    """Backs 1 m before the near wall, on it, 5 cm beyond it, and 3 and 4 cm beyond both walls of a corner."""
    rooms = some_rooms(1)
    rooms.polygon[0] = np.nan
    rooms.polygon[0, :4] = [[0, 0], [4, 0], [4, 3], [0, 3]]
    backs = np.array([[2.0, 1.0], [2.0, 0.0], [2.0, -0.05], [-0.03, -0.04]])
    center = np.column_stack([backs + [0.0, 0.25], np.full(4, 0.5)])
    found = Boxes(center, np.tile([0.5, 0.4, 1.0], (4, 1)), np.full(4, np.pi / 2))
    assert space_of(rooms, 0).behind(found) == pytest.approx([1.0, 0.0, 0.05, 0.05])

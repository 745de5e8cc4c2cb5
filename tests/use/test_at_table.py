"""Chairs are drawn back to be sat on: how near a wall may be behind one."""

import pytest
from lived_in import NORTH, SOUTH, room, thing

from apartgen.stages import use


@pytest.mark.parametrize("behind, free", [(0.0, False), (0.2, False), (0.24, True), (0.3, True), (0.45, True)])
def test_a_chair_is_drawn_back_by_a_third_of_a_metre_of_which_most_is_free(behind: float, free: bool) -> None:
    """Three fifths of the floor from 2 to 35 cm behind it are 20 cm: up to 22 cm behind it."""
    table, chair = (0.8, 1.2, 0.74), (0.5, 0.45, 0.9)
    y = behind + chair[0] / 2
    here = room("dining_room", 4.0, 4.0, thing("dining_table", 2.0, y + 0.7, NORTH, table),
                thing("chair", 2.0, y, NORTH, chair, id="back"), thing("chair", 2.0, y + 1.4, SOUTH, chair, id="front"))
    found = [fault.objects[0] for fault in use.faults(here) if fault.name == "chair cannot be drawn back"]
    assert found == ["back"] * (not free)

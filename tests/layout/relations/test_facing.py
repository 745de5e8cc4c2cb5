"""Two at a table sit across from one another, else side by side, and leave floor to who cooks."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import facing, followers
from apartgen.stages.layout.relations.standing import BROKEN

TABLE, CHAIR = (0.8, 1.2, 0.75), (0.46, 0.44, 0.9)


def seat(x: float, y: float) -> np.ndarray:
    """A chair at the table in the middle of the room, which is long along y, looking at it."""
    ends = abs(y) > 0.6
    return box(CHAIR, x, y, -np.sign(y) * np.pi / 2 if ends else np.pi * (x > 0))


NORTH, SOUTH, EAST, WEST = seat(0, 0.72), seat(0, -0.72), seat(0.52, 0.3), seat(-0.52, 0.3)


@pytest.mark.parametrize("one, two, good", [
    (NORTH, SOUTH, facing.FACING), (EAST, WEST, facing.FACING), (EAST, seat(0.52, -0.3), facing.BESIDE),
    (NORTH, EAST, facing.CORNER), (EAST, seat(-0.52, -0.3), facing.FACING),
])
def test_the_second_of_two_sits_across_from_the_first(one: np.ndarray, two: np.ndarray, good: float) -> None:
    there = room()
    there.add("dining_table", box(TABLE, 0, 0))
    there.add("chair", one)
    assert followers.fit(there, "chair", two, ["bin"]) == good
    assert followers.fit(there, "chair", two, ["chair"]) == 1, "of three and more it isn't asked"


def test_the_first_of_two_sits_where_the_other_will_sit_across() -> None:
    """West of the table is a wall."""
    there = room()
    there.add("dining_table", box(TABLE, -2 + 0.42, 0))
    at = np.array([-2 + 0.42, 0, 0, 0, 0, 0, 0], np.float32)
    assert followers.fit(there, "chair", NORTH + at, ["chair"]) == facing.FACING
    assert followers.fit(there, "chair", EAST + at, ["chair"]) < facing.FACING


@pytest.mark.parametrize("x, y, fits", [(0.0, 0.0, True), (-2 + 0.42, 0.0, True), (-2 + 0.42, -2 + 0.62, False)])
def test_a_table_for_two_is_not_put_where_they_sit_round_its_corner(x: float, y: float, fits: bool) -> None:
    """Free, along a wall, in a corner where one long side and one end are left; each long side has a place for one."""
    small = box((0.8, 1.1, 0.75), x, y)
    there = room(4.0, 4.0)
    assert (followers.fit(there, "dining_table", small, ["chair"] * 2) == 1) == fits


@pytest.mark.parametrize("far, good", [(1.0, False), (1.5, True)])
def test_who_cooks_passes_behind_a_seat(far: float, good: bool) -> None:
    """From the edge of the table to the front of the cooker."""
    there = room(5.0, 5.0)
    there.add("oven", box((0.6, 0.6, 0.9), 0.4 + far + 0.3, 0.3, np.pi))
    there.add("dining_table", box(TABLE, 0, 0))
    assert (there.prices("chair", EAST[None], strict=True)[0] < BROKEN) == good
    assert there.prices("chair", NORTH[None], strict=True)[0] < BROKEN

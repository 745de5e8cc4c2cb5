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


GROUP = {"sofa": box((0.9, 2.0, 0.8), 0, 2.0, -np.pi / 2), "coffee_table": box((1.1, 0.6, 0.4), 0, 0.9),
         "tv_stand": box((0.4, 1.4, 0.5), 0, -2.28, np.pi / 2)}
"""A sofa at the north wall of a room of 5 by 5 m, its low table, the screen at the south wall."""
ARMCHAIR = box((0.8, 0.75, 0.8), 1.55, 0.9, np.pi)
"""East of the low table, looking at it."""


def group(without: str = "") -> facing.Furniture:
    there = room(5.0, 5.0)
    for name, place in GROUP.items():
        if name != without:
            there.add(name, place)
    return there


def test_most_armchairs_are_turned_towards_the_screen_from_the_low_table() -> None:
    rng, there = np.random.default_rng(0), group()
    made = np.array([facing.askew(there, "armchair", ARMCHAIR, rng) for _ in range(300)])
    turned = made[:, 2] != ARMCHAIR[2]
    assert 0.55 < turned.mean() < 0.75, "9 of 13"
    assert len(np.unique(made[turned], axis=0)) == 1 and (made[~turned] == ARMCHAIR).all()
    turn = made[turned][0, 2] - np.pi
    # West is ahead, the screen 3.18 m farther south and 1.55 m farther west: left of who looks west.
    assert turn == pytest.approx(min(np.arctan2(3.18, 1.55) / 2, np.radians(35)), abs=1e-6)
    assert (facing.askew(there, "chair", ARMCHAIR, np.random.default_rng(0)) == ARMCHAIR).all()


def test_a_second_armchair_is_turned_as_the_first_is() -> None:
    across = ARMCHAIR * np.array([-1, 1, 0, 1, 1, 1, 1], np.float32)
    for seed in range(8):
        there, rng = group(), np.random.default_rng(seed)
        first = facing.askew(there, "armchair", ARMCHAIR, rng)
        there.add("armchair", first)
        second = facing.askew(there, "armchair", across, rng)
        assert (first[2] == ARMCHAIR[2]) == (second[2] == across[2])


def test_without_a_screen_one_looks_at_those_on_the_sofa() -> None:
    farther = ARMCHAIR + np.array([0.15, 0, 0, 0, 0, 0, 0], np.float32)
    found = [facing.askew(group("tv_stand"), "armchair", farther, np.random.default_rng(seed))[2] for seed in range(9)]
    assert -np.arctan2(1.1, 1.7) / 2 - 1e-6 < min(found) - np.pi < -np.radians(8) and max(found) == np.float32(np.pi)


def test_what_is_behind_a_turned_armchair_is_no_nearer() -> None:
    """Its back at the east wall: all its corners stay as far from it as the back was. No table keeps it at hand."""
    at_wall = ARMCHAIR + np.array([2.5 - 1.55 - 0.41, 0, 0, 0, 0, 0, 0], np.float32)
    there = group("coffee_table")
    made = [facing.askew(there, "armchair", at_wall, np.random.default_rng(seed)) for seed in range(9)]
    turned = [one for one in made if one[2] != at_wall[2]]
    assert turned
    for x, _, yaw, depth, width, *_ in turned:
        assert x + (depth * abs(np.cos(yaw)) + width * abs(np.sin(yaw))) / 2 == pytest.approx(2.49, abs=1e-4)


def test_an_armchair_is_not_turned_into_what_stands_beside_it() -> None:
    there = group()
    there.add("bookshelf", box((0.3, 1.2, 2.0), 1.55, 0.9 - 0.375 - 0.02 - 0.15, np.pi / 2))
    there.add("sideboard", box((0.4, 1.2, 0.8), 1.55, 0.9 + 0.375 + 0.02 + 0.2, -np.pi / 2))
    assert all((facing.askew(there, "armchair", ARMCHAIR, np.random.default_rng(seed)) == ARMCHAIR).all()
               for seed in range(9))

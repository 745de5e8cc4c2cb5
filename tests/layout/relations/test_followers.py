"""Leaders are put where their followers will find places."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import followers

TABLE, BED, DESK = (0.9, 1.4, 0.75), (2.0, 1.6, 0.5), (0.6, 1.2, 0.75)


@pytest.mark.parametrize("y, chairs, fits", [
    (0.4, 4, True), (0.4, 6, True),     # free all round
    (1.3, 2, True), (1.3, 4, True),     # a long table whose end is near the wall
    (1.3, 6, False),                    # which leaves no place at that end
])
def test_a_table_stands_where_its_chairs_do(y: float, chairs: int, fits: bool) -> None:
    assert followers.fit(room(), "dining_table", box(TABLE, 0, y), ["chair"] * chairs + ["plant"]) == fits


def test_a_table_along_a_wall_has_no_place_for_those_at_the_wall() -> None:
    at_wall = box(TABLE, -2 + 0.46, 0.4)
    assert not followers.fit(room(), "dining_table", at_wall, ["chair"] * 6)
    assert followers.fit(room(), "dining_table", at_wall, ["chair"] * 4), "one side and both ends"


@pytest.mark.parametrize("x, stands, fits", [(0.0, 2, True), (0.0, 0, True), (0.95, 2, False), (0.95, 0, False)])
def test_a_bed_of_two_leaves_both_its_sides(x: float, stands: int, fits: bool) -> None:
    """Its head at the north wall; .25 m is left beside it at one side, whether nightstands come or not."""
    assert followers.fit(room(), "double_bed", box(BED, x, 0.98, -np.pi / 2), ["nightstand"] * stands) == fits


def test_a_nightstand_that_nobody_gets_to_is_none() -> None:
    """Between the bed and a wall there is place for it, but none to stand before its drawer."""
    narrow = box(BED, 4.0 / 2 - 0.8 - 0.5, 0.98, -np.pi / 2)
    assert not followers.fit(room(), "double_bed", narrow, ["nightstand"] * 2)


def test_a_desk_faces_where_one_sits() -> None:
    facing = box(DESK, 0, 1.68, -np.pi / 2)
    assert followers.fit(room(), "desk", facing, ["office_chair"])
    there = room()
    there.add("wardrobe", box((0.6, 1.8, 2.1), 0, 0.85, -np.pi / 2))
    assert not followers.fit(there, "desk", facing, ["office_chair"])


@pytest.mark.parametrize("y, tables, fits", [(0.0, 1, True), (1.0, 1, False), (1.0, 0, True)])
def test_a_sofa_leaves_the_floor_before_it_to_its_low_table(y: float, tables: int, fits: bool) -> None:
    """It looks north; at the latter place .55 m are left before it."""
    assert followers.fit(room(), "sofa", box((0.9, 2.0, 0.8), 0, y, np.pi / 2), ["coffee_table"] * tables) == fits


@pytest.mark.parametrize(
    "depth, clothes, fits", [(4.0, ["wardrobe"], True), (2.9, ["wardrobe"], False), (2.9, [], True)])
def test_a_bed_leaves_a_wall_to_a_wardrobe_of_two(depth: float, clothes: list[str], fits: bool) -> None:
    """A bed in the middle of a room of 3 m: .9 m before its foot are too little for a wardrobe and its doors, and
    beside it there are .7 m."""
    bed = box(BED, 0, depth / 2 - 1.02, -np.pi / 2)
    assert followers.fit(room(3.0, depth), "double_bed", bed, clothes) == fits


@pytest.mark.parametrize("width, fits", [(3.6, True), (2.4, False)])
def test_a_bed_of_one_leaves_a_wall_to_a_smaller_wardrobe(width: float, fits: bool) -> None:
    """Beside a bed in the middle of the end wall are 1.35 m, or .75 m, which are too little to stand before it."""
    bed = box((2.0, 0.9, 0.5), 0, 2.9 / 2 - 1.02, -np.pi / 2)
    assert followers.fit(room(width, 2.9), "single_bed", bed, ["wardrobe"]) == fits


@pytest.mark.parametrize("width, fits", [(3.0, True), (4.0, True), (6.5, False)])
def test_a_sofa_leaves_a_wall_before_it_to_the_television(width: float, fits: bool) -> None:
    """Where that is no farther off than one watches from."""
    sofa = box((0.9, 2.0, 0.8), 0.46 - width / 2, 0.5)
    assert followers.fit(room(width, 4.0), "sofa", sofa, ["tv_stand"]) == fits
    assert followers.fit(room(width, 4.0), "sofa", sofa, [])


def test_others_lead_nothing() -> None:
    assert followers.fit(room(), "wardrobe", box((0.6, 1.8, 2.1), 0, 0), ["chair", "nightstand"])

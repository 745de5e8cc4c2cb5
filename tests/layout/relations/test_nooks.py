"""Ways to the seats of a sofa round a corner, in a room of 7 x 4 m about the origin, in cases by hand."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import nooks
from apartgen.stages.layout.relations.standing import BROKEN

DEEP, WIDE, LOW = 1.45, 2.4, (0.7, 1.4, 0.4)
"""The seats end .48 m before the sofa's front."""


def sofa(end: float) -> np.ndarray:
    """It looks east from the west wall, its chaise in the north, its other end so far from the south wall."""
    return box((DEEP, WIDE, 0.8), -3.5 + DEEP / 2, -2 + end + WIDE / 2)


def low(end: float, aside: float) -> np.ndarray:
    """Its low table, .21 m before the chaise, so far to the north of its middle."""
    return box(LOW, -3.5 + DEEP + 0.21 + LOW[0] / 2, -2 + end + WIDE / 2 + aside)


@pytest.mark.parametrize("end, aside, shut", [
    (0.01, -0.28, True),  # .23 m between the table and the wall
    (0.01, -0.2, True), (0.01, -0.1, False), (0.01, 0.0, False),  # .36 m, less what is nothing yet, are enough
    (0.3, -0.4, False),  # .41 m
    (0.5, -0.7, False),  # past the sofa's own end
])
def test_one_gets_past_the_low_table_or_the_end_of_the_sofa(end: float, aside: float, shut: bool) -> None:
    names, there = ["corner_sofa"], sofa(end)[None]
    space = room(7.0, 4.0).space
    assert nooks.shut("coffee_table", low(end, aside)[None], names, there, space).tolist() == [shut]
    assert not nooks.shut("coffee_table", low(end, aside)[None], ["sofa"], there, space).any(), "no nook"
    assert not nooks.shut("coffee_table", low(end, aside)[None], [], there[:0], space).any()


@pytest.mark.parametrize("name, seat, shut", [
    ("chest", True, True), ("chest", False, False), ("plant", True, True), ("chair", True, False), ("rug", True, False),
])
def test_nothing_takes_the_last_way(name: str, seat: bool, shut: bool) -> None:
    """Past the table an armchair stands, or not; what comes next stands past the end of the sofa."""
    there = room(7.0, 4.0)
    there.add("corner_sofa", sofa(0.9))
    there.add("coffee_table", low(0.9, -0.28))
    if seat:
        there.add("armchair", box((0.8, 0.8, 0.85), -1.4, -2 + 0.9 + WIDE / 2 - 0.28 - 0.7 - 0.3 - 0.4, np.pi / 2))
    last = box((0.4, 0.8, 0.9), -3.5 + 0.97 + 0.25, -2 + 0.9 - 0.25 - 0.2, np.pi / 2)
    assert nooks.shut(name, last[None], there.names, there.boxes, there.space).tolist() == [shut]
    assert not nooks.shut(name, last[None], there.names[:1], there.boxes[:1], there.space).any(), "there is no table"


def test_a_low_table_is_rather_left_out_than_put_where_it_shuts_seats_in() -> None:
    there = room(7.0, 4.0)
    there.add("corner_sofa", sofa(0.01))
    some = np.stack([low(0.01, -0.28), low(0.01, 0.0)])
    assert (there.prices("coffee_table", some) >= BROKEN).tolist() == [True, False]

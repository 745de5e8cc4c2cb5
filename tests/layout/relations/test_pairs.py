"""The same stands at both sides of a bed of two."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import pairs
from apartgen.stages.layout.relations.standing import Furniture

STAND, SMALL = (0.42, 0.46, 0.52), (0.38, 0.38, 0.55)


def bedroom(bed: str = "double_bed", *more: tuple[str, np.ndarray]) -> Furniture:
    """A bed at the west wall, a nightstand north of it, a small table south of it."""
    there = room(4.0, 4.0)
    for name, one in ((bed, box((2.0, 1.6, 0.5), -0.99, 0.1)), ("nightstand", box(STAND, -1.78, 1.18)), *more,
                      ("side_table", box(SMALL, -1.8, -0.94))):
        there.add(name, one)
    return there


def matched(there: Furniture, fixed: int = 0) -> Furniture:
    return pairs.matched(there, fixed, room(4.0, 4.0).fork)


def test_a_small_table_at_one_side_is_one_at_either() -> None:
    found = matched(bedroom())
    assert found.names == ["double_bed", "side_table", "side_table"]
    assert found.boxes[1] == pytest.approx(box(SMALL, -1.8, 1.14), abs=1e-5)
    assert np.array_equal(found.boxes[[0, 2]], bedroom().boxes[[0, 2]])


def test_what_is_given_what_is_elsewhere_and_what_is_no_pair_stays() -> None:
    lamp = ("floor_lamp", box((0.3, 0.3, 1.6), -1.8, 1.75))
    for there, fixed in ((bedroom(), 2), (bedroom("single_bed"), 0)):
        assert matched(there, fixed).names == there.names
    assert matched(bedroom("double_bed", lamp)).names == ["double_bed", "side_table", "floor_lamp", "side_table"]
    alone = room(4.0, 4.0)
    alone.add("nightstand", box(STAND, -1.78, 1.18))
    assert matched(alone) is alone

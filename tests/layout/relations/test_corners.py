"""Corner units are as deep as their line, and the run round the corner comes up to them."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import corners
from apartgen.stages.layout.relations.standing import Furniture

SIDE = 2.0 - 0.005
"""From the room's middle to the backs of units, m."""


def kitchen(deep: float, along: tuple[str, ...] = ("fridge", "kitchen_base")) -> tuple[list[str], list[np.ndarray]]:
    """At the east wall a corner unit 1.3 m wide in the north, an oven beside it; from its front westward, units of .6 m
    along the north wall, a hood over the first of them."""
    names = ["kitchen_corner", "oven", *along, "hood"]
    boxes = [
        box((deep, 1.3, 0.9), SIDE - deep / 2, SIDE - 0.65, np.pi),
        box((0.6, 0.6, 0.9), SIDE - 0.3, SIDE - 1.3 - 0.303, np.pi),
        *(box((0.6, 0.6, 0.9), SIDE - deep - 0.303 - 0.603 * k, SIDE - 0.3, -np.pi / 2) for k in range(len(along))),
    ]
    hood = box((0.4, 0.6, 0.6), float(boxes[2][0]), SIDE - 0.2, -np.pi / 2)
    hood[5:] += 1.5
    return names, [*boxes, hood]


def filled(names: list[str], boxes: list[np.ndarray]) -> Furniture:
    found = room()
    for name, one in zip(names, boxes, strict=True):
        found.add(name, one)
    return found


def empty() -> Furniture:
    return room()


def test_a_corner_unit_is_as_deep_as_its_line() -> None:
    names, boxes = kitchen(0.8)
    found = corners.squared(filled(names, boxes), 0, empty)
    assert found.names == names
    corner, oven, fridge, base, hood = found.boxes
    assert 0.6 <= corner[3] < 0.63 and corner[0] + corner[3] / 2 == pytest.approx(SIDE, abs=1e-3)
    assert np.allclose(oven, boxes[1])
    more = 0.8 - corner[3]
    assert fridge[0] == pytest.approx(boxes[2][0] + more, abs=1e-3) and fridge[4] == pytest.approx(0.6)
    assert hood[0] == pytest.approx(boxes[4][0] + more, abs=1e-3), "it goes with what is below it"
    assert base[4] == pytest.approx(0.6 + more, abs=1e-3)
    assert base[0] - base[4] / 2 == pytest.approx(boxes[3][0] - 0.3, abs=1e-3), "its far end stays"
    gaps = [(corner[0] - corner[3] / 2) - (fridge[0] + 0.3), (fridge[0] - 0.3) - (base[0] + base[4] / 2)]
    assert np.allclose(gaps, 0.003, atol=1e-3)


@pytest.mark.parametrize(("deep", "along", "fixed"), [
    (0.62, ("fridge", "kitchen_base"), 0),      # no deeper
    (0.8, ("fridge", "dishwasher"), 0),         # nothing that comes in other widths
    (0.8, ("fridge", "kitchen_base"), 3),       # what is given stays
])  # fmt: skip
def test_what_cannot_be_otherwise_stays(deep: float, along: tuple[str, ...], fixed: int) -> None:
    names, boxes = kitchen(deep, along)
    there = filled(names, boxes)
    assert corners.squared(there, fixed, empty) is there


def test_nothing_is_moved_into_what_stands_in_the_way() -> None:
    """A table where the fridge would open once it stood nearer the corner."""
    names, boxes = kitchen(0.8)
    assert corners.squared(filled(names, boxes), 0, empty).boxes[2][0] > boxes[2][0] + 0.1
    blocked = filled([*names, "dining_table"], [*boxes, box((0.5, 0.25, 0.75), 1.26, 0.95, 0.0)])
    found = corners.squared(blocked, 0, empty)
    assert np.allclose(found.boxes, blocked.boxes)

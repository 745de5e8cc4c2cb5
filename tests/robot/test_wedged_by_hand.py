"""Prisms over shadows: which of them stand in one another, worked out by hand."""

import numpy as np
import pytest
import shapely

from apartgen.stages.robot import wedged


def block(x, y, z, dx, dy, dz):
    """The corners of a box from its least corner."""
    return np.array([[x + i * dx, y + j * dy, z + k * dz] for i in (0, 1) for j in (0, 1) for k in (0, 1)], float)


UNIT = wedged.prisms([block(0, 0, 0, 1, 1, 1)])


@pytest.mark.parametrize(("other", "inside"), [
    (block(0.5, 0.5, 0.5, 1, 1, 1), True), (block(1.5, 0, 0, 1, 1, 1), False), (block(0, -1.5, 0, 1, 1, 1), False),
    (block(0.2, 0.2, 1.0, 0.5, 0.5, 1), False), (block(0.2, 0.2, -1.0, 0.5, 0.5, 1), False),  # upon it, below it
    (block(0.2, 0.2, 0.99, 0.5, 0.5, 1), True), (block(0.2, 0.2, -0.99, 0.5, 0.5, 1), True),
    (block(0.2, 0.2, 3.0, 0.5, 0.5, 1), False), (block(0.2, 0.2, -3.0, 0.5, 0.5, 1), False),
    (block(0.4, 0.4, 0.4, 0.1, 0.1, 0.1), True), (block(-1, -1, -1, 3, 3, 3), True),
    (block(0.9995, 0, 0, 1, 1, 1), False), (block(0.998, 0, 0, 1, 1, 1), True),  # a millimetre does no harm
])
def test_two_blocks(other, inside):
    one = wedged.prisms([other])
    assert wedged.overlap(UNIT, one) is wedged.overlap(one, UNIT) is inside


def test_one_of_many_is_enough_and_none_is_none():
    apart = [block(k, 0, 2, 0.5, 0.5, 0.5) for k in range(5)]
    assert not wedged.overlap(UNIT, wedged.prisms(apart))
    assert wedged.overlap(UNIT, wedged.prisms([*apart, block(0.5, 0.5, 0.9, 0.2, 0.2, 0.5)]))


def test_a_shadow_is_the_hull_of_the_corners_a_little_thinner():
    (shadow,), heights = wedged.prisms([block(1, 2, 3, 0.4, 0.6, 0.8)])
    assert shadow.equals_exact(shapely.box(1 + wedged.DEPTH / 2, 2 + wedged.DEPTH / 2, 1.4 - wedged.DEPTH / 2,
                                           2.6 - wedged.DEPTH / 2).normalize(), 1e-9) or shadow.area == pytest.approx(
        (0.4 - wedged.DEPTH) * (0.6 - wedged.DEPTH))
    assert heights[0].tolist() == pytest.approx([3 + wedged.DEPTH / 2, 3.8 - wedged.DEPTH / 2])

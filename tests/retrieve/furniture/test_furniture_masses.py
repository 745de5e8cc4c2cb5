"""What weighed too much once weighs what it should."""

import pytest

from apartgen.stages.retrieve import furniture
from apartgen.stages.things.categories import TABLE

KIND = TABLE["mirror"]


@pytest.mark.parametrize("size", [KIND.min, KIND.size, KIND.max])
@pytest.mark.parametrize("style", furniture.styles("mirror"))
def test_a_mirror_weighs_what_four_millimetres_of_glass_and_a_board_do(style, size):
    glass = 2500 * 0.004
    for seed in range(5):
        weight = furniture.build("mirror", style, size, seed).links[0].mass / (size[1] * size[2])
        assert 0.7 * glass < weight < 3 * glass, (seed, weight)

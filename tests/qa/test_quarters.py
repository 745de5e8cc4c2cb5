"""Quarters about a way, against the quotient of complex numbers."""

import cmath
from math import degrees, pi

import numpy as np
import pytest

from apartgen.stages.qa.kinds import direction


@pytest.mark.parametrize("seed", range(5))
def test_which_quarter_a_place_lies_in_and_how_far_into_it(seed):
    for here, there, where in np.random.default_rng(seed).uniform(-6, 6, (60, 3, 2)).tolist():
        turned = (complex(*where) - complex(*here)) / (complex(*there) - complex(*here))
        side = "left" if turned.imag > 0 else "right"
        quarter, rest = direction._quarter(here, there, where)
        assert direction.QUARTERS[int(quarter)] == f"{'ahead' if turned.real > 0 else 'behind'} to the {side}"
        assert rest == pytest.approx(degrees(cmath.phase(turned) % (pi / 2)), abs=1e-6)

"""Boxes are the prisms over their plans, vertex by vertex."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import box as rectangle

from apartgen.stages.things import solids
from apartgen.stages.things.materials import PALETTE

SIDES = st.tuples(*[st.floats(0.002, 5)] * 3)
PLACES = st.tuples(*[st.floats(-9, 9)] * 3)


@given(lo=PLACES, size=SIDES, material=st.sampled_from(sorted(PALETTE)))
def test_a_box_is_the_prism_over_its_plan(lo, size, material):
    hi = np.add(lo, size)
    plan = rectangle(lo[0], lo[1], hi[0], hi[1], ccw=False)
    ring = [*plan.exterior.coords]
    assert ring[0] == (lo[0], lo[1])
    found = solids.box(lo, hi, PALETTE[material])
    expected = solids.extruded(plan, lo[2], float(hi[2]), PALETTE[material])
    for name in ("vertices", "faces", "uv"):
        np.testing.assert_array_equal(getattr(found, name), getattr(expected, name))

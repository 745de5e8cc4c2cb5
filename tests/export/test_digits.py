"""Numbers of meshes are written as Python writes them, to the letter."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from apartgen.stages.export import _digits

USUAL = st.floats(-100, 100)
SHORT = st.builds(lambda whole, power: whole * 10.0**-power, st.integers(-10**7, 10**7), st.integers(0, 12))
TIES = st.builds(lambda whole, power: (whole + 0.5) / 10.0**power, st.integers(0, 10**6 - 1), st.integers(1, 12))
EDGES = st.builds(lambda power, ulps: float(10.0**power * (1 + ulps * 2.0**-52)), st.integers(-6, 5),
                  st.integers(-3, 3))
NUMBERS = (USUAL | SHORT | TIES | EDGES | st.floats(-1e-4, 1e-4)).filter(lambda v: abs(v) < _digits.LARGEST)


@settings(max_examples=800, deadline=None)
@given(values=st.lists(st.tuples(NUMBERS, NUMBERS), max_size=20))
def test_rows_are_those_that_python_writes(values):
    array = np.array(values, float).reshape(-1, 2)
    told = [[0.0 if abs(v) < 5e-7 else v for v in row] for row in values]
    expected = "".join(f"vt {u:.6g} {v:.6g}\n" for u, v in told)
    assert _digits.rows(np.frombuffer(b"vt", np.uint8).copy(), array).tobytes().decode() == expected


@pytest.mark.parametrize("textured", [False, True])
@given(faces=st.lists(st.tuples(*[st.integers(0, 2**40)] * 3), max_size=20))
def test_faces_count_from_one(textured, faces):
    array = np.array(faces, np.int64).reshape(-1, 3)
    corner = "{0}/{0}/{0}" if textured else "{0}//{0}"
    expected = "".join("f " + " ".join(corner.format(k + 1) for k in face) + "\n" for face in faces)
    assert _digits.triangles(array, textured).tobytes().decode() == expected

"""A table is as long as those who eat there need, where a longer one leaves them no place."""

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations.dining import smaller

LONG = (0.95, 1.8, 0.75)


@pytest.mark.parametrize("chairs, wide", [(2, 0.75), (4, 1.2), (6, 1.4)])
def test_a_smaller_table_has_its_edge_for_everyone(chairs: int, wide: float) -> None:
    """.6 m each, and .2 m more for the legs of who sits at its ends; no table is narrower than .75 m."""
    found = smaller("dining_table", box(LONG, 0, 0)[None], room(6.0, 5.0).space, ["chair"] * chairs + ["plant"])
    assert len(found) and np.allclose(found[:, 3:5], [0.85, wide])


@pytest.mark.parametrize("name, size, chairs", [
    ("dining_table", LONG, 8), ("dining_table", (0.9, 1.2, 0.75), 4), ("dining_table", LONG, 0),
    ("round_table", (1.3, 1.3, 0.75), 4), ("sofa", (0.9, 2.0, 0.8), 4)])
def test_none_is_smaller_than_it_needs_to_be(name: str, size: tuple[float, float, float], chairs: int) -> None:
    assert not len(smaller(name, box(size, 0, 0)[None], room(6.0, 5.0).space, ["chair"] * chairs))

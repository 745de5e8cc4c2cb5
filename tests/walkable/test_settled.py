"""What stood on a piece that became smaller, on a top worked out by hand."""

import handmade as h
import pytest
from populate.test_receptacles import base
from walkable.test_run import UP

from apartgen.stages.things.asset import Asset
from apartgen.stages.walkable import placing

DEEP, WIDE, HIGH = 0.4, 1.0, 0.7
BLOCK = Asset("test", "block", "coffee_table", "plain", (DEEP, WIDE, HIGH), [
    base(((-DEEP / 2, -WIDE / 2, -HIGH / 2), (DEEP / 2, WIDE / 2, HIGH / 2)))])


@pytest.mark.parametrize(("size", "held"), [
    ((0.3, 0.5, 0.2), True), ((0.5, 0.2, 0.2), False), ((0.2, 1.1, 0.2), False), ((0.5, 1.1, 0.2), False),
])
def test_what_is_longer_than_the_top_in_either_direction_is_not_held(size, held) -> None:
    table = h.thing("coffee_table", 2.0, 2.0, UP, size=(DEEP, WIDE, HIGH), id="table")
    item = h.thing("plant", 2.0, 2.0, UP, size=size, id="item").model_copy(update={"on": "table"})
    changes = placing.settled(table, table, BLOCK, [table, item])
    assert (changes is not None) is held
    if changes is not None:
        assert changes["item"].center[2] == pytest.approx(HIGH + 0.1)

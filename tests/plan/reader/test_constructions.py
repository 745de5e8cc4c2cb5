"""Constructions of grammar in several wordings each: what is left out, what is contrasted, whose a clause is."""

import pytest
from sentences.facts import facts, rooms

from apartgen.stages.plan.reader import read


@pytest.mark.parametrize("hall", ["one long hallway", "a long corridor", "a short corridor", "a narrow hallway"])
def test_a_hallway_of_some_style_is_a_hallway(hall: str) -> None:
    found = facts(read(f"A two-bedroom flat with {hall}, no wider than 1.2 m. The bathroom is off the kitchen."))
    assert {"at_most H1 width 1.2", "B1H1", "B2H1", "K1W1"} <= found
    assert rooms(read(f"A studio with {hall}.")) == "H K L W"

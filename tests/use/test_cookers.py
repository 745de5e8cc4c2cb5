"""What one cooks on: a hob, else a cooker, never an oven in a tall cabinet."""

import pytest
from lived_in import NORTH, kitchen, room, thing

from apartgen.schemas.layout import Box
from apartgen.stages import use
from apartgen.stages.use.rules import cook


def with_cooker(top: float, hood: float = 3.5) -> use.Furnished:
    """The kitchen whose hob is a cooker so high, its hood somewhere along the wall."""
    out: list[Box] = [o for o in kitchen() if o.category not in ("hob", "hood")]
    return room("kitchen", 4.2, 3.0, *out, thing("oven", 3.5, 0.31, NORTH, (0.6, 0.6, top)),
                thing("hood", hood, 0.25, NORTH))


def cooked_on(place: use.Furnished) -> list[str]:
    return [place.names[i] for i in cook.hobs(place)]


def test_hobs_come_before_cookers_and_tall_ovens_are_neither() -> None:
    assert cooked_on(room("kitchen", 4.2, 3.0, *kitchen())) == ["hob"]
    assert cooked_on(room("kitchen", 4.2, 3.0, *kitchen(), thing("oven", 2.0, 2.6, NORTH, (0.6, 0.6, 0.9)))) == ["hob"]
    assert cooked_on(with_cooker(0.9)) == ["oven"] and cooked_on(with_cooker(2.1)) == []


@pytest.mark.parametrize(("top", "hood", "fault"), [(0.9, 3.5, False), (0.9, 1.5, True)])
def test_a_hood_hangs_over_the_cooker(top: float, hood: float, fault: bool) -> None:
    assert ("hood not above the hob" in {one.name for one in use.faults(with_cooker(top, hood))}) is fault

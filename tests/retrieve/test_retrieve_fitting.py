"""Models without units are what their proportions come nearest to, at the scale of that."""

import numpy as np
import pytest

from apartgen.stages.retrieve.reading.fitting import fitted
from apartgen.stages.things.categories import TABLE

SOME = ("sofa", "wardrobe", "double_bed", "dining_table", "floor_lamp")


@pytest.mark.parametrize("unit", [1.0, 0.0254, 40.0])
@pytest.mark.parametrize("name", SOME)
def test_usual_proportions_in_any_unit_are_told_among_others(name: str, unit: float) -> None:
    found, scale = fitted(np.array(TABLE[name].size) / unit, SOME)
    assert found == name and scale == pytest.approx(unit, rel=1e-6)


def test_what_is_out_of_range_counts_more_than_what_is_unusual() -> None:
    """As deep as a nightstand is at most, as wide and as high as one is as a rule: less of a stretch than a chest."""
    size = [TABLE["nightstand"].max[0], *TABLE["nightstand"].size[1:]]
    assert fitted(np.array(size), ("nightstand", "wardrobe"))[0] == "nightstand"

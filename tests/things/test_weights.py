"""What furniture weighs: by its materials within what such things weigh."""

import numpy as np
import pytest

from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.weights import SPREAD, weight


@pytest.mark.parametrize("name", ["armchair", "sofa", "desk"])
def test_a_piece_weighs_about_what_its_materials_say_and_no_more_than_its_kind(name: str) -> None:
    """The smallest of a kind is as light as any, the largest as heavy; one of half their volume is midway."""
    kind = TABLE[name]
    assert kind.mass is not None
    least, most = (np.prod(side) for side in (kind.min, kind.max))
    middle = np.asarray(kind.min) * ((least + most) / 2 / least) ** (1 / 3)
    usual = sum(kind.mass) / 2
    found = [weight(name, middle.tolist(), share * usual) for share in (0.01, 0.5, 0.9, 1.0, 1.1, 2.0, 100.0)]
    assert found[3] == pytest.approx(usual) and (np.diff(found) > 0).all()
    assert found[2] == pytest.approx(usual * 0.9**SPREAD, rel=0.01), "a tenth lighter: so much of it"
    assert weight(name, kind.min, 1e6) <= kind.mass[1] and weight(name, kind.max, 0.0) >= kind.mass[0]
    assert weight("unheard of", kind.min, 7.5) == 7.5

"""A home is its seed's: alone, in any batch, with any number of workers it is the same."""

import numpy as np
import pytest
from handmade import plan

from apartgen.stages import layout
from apartgen.stages.layout import batch
from apartgen.stages.layout.config import LayoutConfig


def test_the_number_of_workers_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "MANY_ROOMS", 2)
    config = LayoutConfig(model="diffusion", steps=4, batch=3)
    alone = [layout.run(plan(), config, np.random.default_rng(k)) for k in (1, 2, 3)]
    for threads, order in ((1, (1, 2, 3)), (2, (3, 1, 2))):
        lanes = [np.random.default_rng(k) for k in order]
        made = layout.run_many([plan()] * 3, config.model_copy(update={"threads": threads}), lanes)
        assert [home.objects for home in made] == [alone[k - 1].objects for k in order]
    assert all(home.objects for home in alone)

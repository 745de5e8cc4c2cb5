"""Many rooms are settled by workers; what comes out does not depend on how many there are."""

import numpy as np
import pytest
from handmade import plan

from apartgen.stages import layout
from apartgen.stages.layout import batch
from apartgen.stages.layout.config import LayoutConfig


def test_the_number_of_workers_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "MANY_ROOMS", 2)
    plans = [plan(), plan()]
    made = [
        layout.run_many(plans, LayoutConfig(steps=4, batch=3, threads=n), [np.random.default_rng(k) for k in (1, 2)])
        for n in (1, 2)
    ]
    assert [home.objects for home in made[0]] == [home.objects for home in made[1]]
    assert all(home.objects for home in made[0])

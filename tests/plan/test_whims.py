"""How often the planner starts anew before requirements are relaxed."""

from types import SimpleNamespace

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.errors import Unmet
from apartgen.stages.plan import PlanConfig, solve
from apartgen.stages.plan.problem import Slack
from apartgen.stages.plan.relax import Step


def test_all_whims_are_tried_and_half_of_them_where_something_is_given_up(monkeypatch) -> None:
    """Of five, none of which any arrangement comes up to; of an odd number the larger half."""
    seen, whim = [], solve.whim
    monkeypatch.setattr(solve, "whim", lambda *given: seen.append(given[2]) or whim(*given))
    monkeypatch.setattr(solve, "ladder", lambda program: [
        Step(program, Slack()), Step(program, Slack(area=0.2)), Step(program, Slack(area=0.3), ("areas",))])
    failed = SimpleNamespace(lack=1.0, missed=lambda: ["no room for it"])
    monkeypatch.setattr(solve, "waves", lambda *_: iter([[failed]]))
    with pytest.raises(Unmet, match="no room for it"):
        solve.solve(h.program(), PlanConfig(whims=5, processes=1), np.random.default_rng(0))
    assert seen == [*range(5), *range(5), *range(3)]

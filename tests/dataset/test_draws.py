"""A home that can't be finished, or that the judge refuses, is drawn again, and its row says so."""

import json

import pytest

from apartgen import planning
from apartgen.dataset import build, home
from apartgen.requests import Request
from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages import check
from apartgen.stages.check.fault import Fault

QUICK = {"layout": {"candidates": 1}, "plan": {"enough": 1, "candidates": 1}}
ABOUT = {"stages": ["plan", "populate"], "settings": QUICK}


def asked(**settings):
    return home.Asked(Request("studio", "mine", name="mine"), 7, QUICK | settings)


@pytest.fixture
def drawn(monkeypatch):
    """Seeds of the plans that were drawn; `drawn.fail(errors)` lets the first ones fail."""
    draw, seen, errors = planning.draw, [], []

    def failing(prompt, config, seed, id=""):
        seen.append(seed)
        if len(seen) <= len(errors):
            raise errors[len(seen) - 1]
        return draw(prompt, config, seed, id)

    monkeypatch.setattr(planning, "draw", failing)
    return seen, errors


def test_what_fails_once_is_drawn_from_another_seed_and_rebuilt_from_its_row(drawn):
    seen, errors = drawn
    errors.append(Unmet("no wall for a door"))
    done = home.home(asked())
    assert done.row["certified"] and done.row["thrown_away"] == ["no wall for a door"] and done.row["seed"] == 7
    assert len(seen) == 2 and seen[0] == 7 != seen[1] == json.loads(done.line)["made"]["seed"]
    seen.clear()
    assert build.again(done.row, ABOUT).line == done.line


def test_what_is_not_refused_is_drawn_once(drawn):
    done = home.home(asked())
    assert drawn[0] == [7] and "thrown_away" not in done.row and done.row["certified"]


def test_of_what_always_fails_the_first_reason_is_told(drawn):
    seen, errors = drawn
    errors += [Unmet(f"reason {k}") for k in range(9)]
    done = home.home(asked())
    assert not done.line and done.row["error"] == "reason 0" and done.row["thrown_away"] == ["reason 1", "reason 2"]
    assert len(set(seen)) == len(seen) == home.DRAWS


@pytest.mark.parametrize("error, settings", [(BadInput("no such room"), {}),
                                             (Unmet("declined"), {"plan": {"llm": "x"}})])
def test_what_is_wrong_and_what_a_model_declines_is_not_tried_again(drawn, error, settings):
    seen, errors = drawn
    errors.append(error)
    done = home.home(asked(**settings))
    assert seen == [7] and done.row["error"] == str(error) and "thrown_away" not in done.row


def test_a_home_that_the_judge_refuses_is_taken_only_where_none_is_better(drawn, monkeypatch):
    judge, refusals = check.run, []

    def strict(body):
        return [*judge(body), *(refusals.pop() if refusals else [])]

    monkeypatch.setattr(check, "run", strict)
    fault = Fault("not-on", ("tv",), (0.0, 0.0, 0.0))
    assert fault.refuses
    refusals += [[fault], [fault]]
    done = home.home(asked())
    assert done.row["certified"] and done.row["thrown_away"] == [str(fault)] * 2 and len(drawn[0]) == 3
    drawn[0].clear()
    refusals += [[fault]] * 3
    done = home.home(asked())
    assert not done.row["certified"] and json.loads(done.line)["made"]["seed"] == 7


def test_a_row_has_every_figure_of_its_home_and_by_its_name_the_first_version():
    from apartgen import outputs
    from apartgen.schemas import artifact
    from apartgen.schemas.base import Record

    done = home.home(asked())
    body = artifact.parse(done.line, "home", Record, whole=True).body
    values = [v for v in outputs.measure(body, outputs.MetricsSettings()).values if v.of == "apartment"]
    first = {v.name: v.value for v in values[::-1]}
    found = done.row["metrics"]
    assert len(found) == len(values) and {name: found[name] for name in first} == first
    several = {v.name for v in values if v.version != "ours"} & {v.name for v in values if v.version == "ours"}
    assert {"Col_obj", "R_out"} <= several
    for v in values:
        assert v.value in (found.get(v.name), found.get(f"{v.name}/{v.version}")), v
    assert found["Col_obj"] == 0 < found["Col_obj/published"], "chairs stand under tables"

"""Where no plan has room for what a request leaves open, that is drawn anew, once; what was asked stays as it is."""

import pytest

from apartgen import planning
from apartgen.schemas.errors import Unmet
from apartgen.stages import plan

PROMPT = "a flat with two bedrooms and a kitchen of 9 m2"


def refusing(monkeypatch, times):
    tried = []
    build = plan.build

    def stubborn(program, config, rng, prompt=""):
        tried.append(program)
        if len(tried) <= times:
            raise Unmet("no plan")
        return build(program, config, rng, prompt)

    monkeypatch.setattr(plan, "build", stubborn)
    return tried


def test_what_is_left_open_is_drawn_anew_and_what_was_asked_is_kept(monkeypatch):
    tried = refusing(monkeypatch, 1)
    found, _ = planning.draw(PROMPT, planning.PlanSettings(), seed=4)
    first, second = tried
    assert first != second and found.program.rooms == second.rooms
    for program in tried:
        assert sum(room.type == "bedroom" for room in program.rooms) == 2
        assert [room.area for room in program.rooms if room.type == "kitchen"] == [9.0]


def test_it_is_tried_once_more_only(monkeypatch):
    tried = refusing(monkeypatch, 9)
    with pytest.raises(Unmet, match="no plan"):
        planning.draw(PROMPT, planning.PlanSettings(), seed=4)
    assert len(tried) == 2


def test_what_leaves_nothing_open_is_refused_at_once(monkeypatch):
    tried = refusing(monkeypatch, 9)
    monkeypatch.setattr(planning, "_drawn_anew", lambda prompt, config, rng: tried[0])
    with pytest.raises(Unmet):
        planning.draw(PROMPT, planning.PlanSettings(), seed=4)
    assert len(tried) == 1


def test_a_small_home_that_had_no_plan_has_one():
    """Of some sentences of the benchmark, each with one seed, the one that had none."""
    prompt = "Please design a cosy two bedroom home for a young couple"
    found, _ = planning.draw(prompt, planning.PlanSettings(), seed=3)
    assert sum(room.type == "bedroom" for room in found.rooms) == 2

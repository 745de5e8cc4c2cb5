"""A bed of two is as narrow as they are where no nightstand finds its place beside a wider one."""

from collections import Counter
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen import planning, settings, steps
from apartgen.stages import layout
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.relations import followers
from apartgen.stages.layout.relations.beds import NARROW, narrower
from apartgen.stages.layout.relations.sampler import Room, Sampler

WIDE = (2.1, 1.65, 0.5)


@pytest.mark.parametrize("width, strict, narrow, share", [
    (4.0, True, False, 1.0), (2.55, False, False, 0.5), (2.05, False, True, 0.25),
])
def test_a_narrow_bed_stands_where_a_wider_one_leaves_no_nightstand_a_place(
        width: float, strict: bool, narrow: bool, share: float) -> None:
    """A nightstand of .45 m beside a bed takes .5 m: with one of 1.62 m 2.12 m, with one of 1.42 m 1.92 m."""
    there, left = room(width, 4.5), ["nightstand"] * 2
    speaker: Any = SimpleNamespace(large={}, shell=None)
    made = Sampler(Room(speaker, there, (), Counter(), False, ()), np.random.default_rng(0))
    found = made._fitting(there, "double_bed", box(WIDE, 0, 0)[None], left, strict)
    assert found is not None and found[0] == "double_bed" and followers.fit(there, *found, left) >= share
    assert (found[1][4] < 1.6) == narrow


def test_places_of_a_narrow_bed_are_dense_along_walls() -> None:
    space = room(4.0, 5.0).space
    (name, found), = narrower("double_bed", box(WIDE, 0, 0)[None], space)
    assert name == "double_bed" and np.allclose(found[:, 3:5], NARROW)
    north = np.sort(found[np.abs(found[:, 2] + np.pi / 2) < 1e-3, 0])
    assert np.diff(north).max() < 0.11 and (np.abs(found[:, :2]) < [2.0, 2.5]).all()


@pytest.mark.parametrize("name, wide", [("single_bed", 1.65), ("double_bed", 1.4), ("sofa", 2.0)])
def test_nothing_else_is_made_narrow(name: str, wide: float) -> None:
    assert not narrower(name, box((2.1, wide, 0.5), 0, 0)[None], room(4.0, 5.0).space)


@pytest.mark.parametrize("name", ["0004347", "0005319"])
def test_a_small_studio_is_rather_without_a_sofa_than_without_a_bed(name: str) -> None:
    """Two of some thousand homes, in which the sofa had taken the last place for the bed."""
    asked = settings.by_stage({}, ["svg"])["plan"].model_copy(update={"processes": 1})
    plan, _ = planning.draw("a compact studio with a balcony", asked, 148000, name)
    home = layout.run(plan, LayoutConfig(), steps.lane(148000, "layout", plan))
    kinds_there = [o.category for o in home.objects if o.room == "living_room_1"]
    assert kinds_there.count("double_bed") == 1

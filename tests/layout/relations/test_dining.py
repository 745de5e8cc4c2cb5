"""A table is as long as those who eat there need, where a longer one leaves them no place."""

from collections import Counter
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rooms_for_tests import box, room

from apartgen.stages.layout.relations import followers
from apartgen.stages.layout.relations.dining import others
from apartgen.stages.layout.relations.sampler import Room, Sampler
from apartgen.stages.layout.relations.standing import Furniture

LONG = (0.95, 1.8, 0.75)


@pytest.mark.parametrize("chairs, wide", [(2, 0.75), (4, 1.2), (6, 1.4)])
@pytest.mark.parametrize("name", ["dining_table", "round_table"])
def test_another_table_has_its_edge_for_everyone(name: str, chairs: int, wide: float) -> None:
    """.6 m each, and .2 m more for the legs of who sits at its ends; no table is narrower than .75 m."""
    some = others(name, box(LONG, 0, 0)[None], room(6.0, 5.0).space, ["chair"] * chairs + ["plant"])
    (other, found), = some
    assert other == "dining_table" and len(found) and np.allclose(found[:, 3:5], [0.85, wide])


@pytest.mark.parametrize("name, size, chairs", [
    ("dining_table", LONG, 8), ("dining_table", (0.9, 1.2, 0.75), 4), ("dining_table", LONG, 0),
    ("round_table", (1.3, 1.3, 0.75), 0), ("sofa", (0.9, 2.0, 0.8), 4)])
def test_none_is_smaller_than_it_needs_to_be(name: str, size: tuple[float, float, float], chairs: int) -> None:
    assert not others(name, box(size, 0, 0)[None], room(6.0, 5.0).space, ["chair"] * chairs)


def sampler(there: Furniture, asked: tuple[str, ...] = ()) -> Sampler:
    """What furnishes such a room, in which some things were asked for."""
    speaker: Any = SimpleNamespace(large={}, shell=None)
    return Sampler(Room(speaker, there, (), Counter(asked), False, ()), np.random.default_rng(0))


@pytest.mark.parametrize("width, asked, name", [
    (6.0, (), "round_table"), (2.9, (), "dining_table"), (2.9, ("round_table",), "")])
def test_where_a_round_table_leaves_chairs_no_place_there_is_a_long_one(
        width: float, asked: tuple[str, ...], name: str) -> None:
    """Six who sit at a round table of 1.3 m take a circle of 2.9 m with chairs drawn back, at a long one 2.4 m."""
    there, left = room(width, 6.0), ["chair"] * 6
    found = sampler(there, asked)._fitting(there, "round_table", box((1.3, 1.3, 0.75), 0, 0)[None], left)
    if not name:
        assert found is None
        return
    assert found is not None and found[0] == name
    assert followers.fit(there, *found, left) == 1


@pytest.mark.parametrize("asked, found", [((), False), (("armchair",), True)])
def test_an_armchair_is_left_out_rather_than_put_where_the_table_is_to_stand(asked: tuple[str, ...],
                                                                              found: bool) -> None:
    there, left = room(3.4, 4.0), ["dining_table", *["chair"] * 6]
    chair = box((0.8, 0.8, 0.8), 0.5, 0.5)[None]
    assert followers.fit(there, "armchair", chair[0], left) < 1
    assert (sampler(there, asked)._chosen(there, "armchair", chair, np.ones(1), left=left) is not None) == found
    assert sampler(there)._chosen(there, "armchair", chair, np.ones(1)) is not None, "where no table is to come"

"""Ways are free, near the shortest, and keep away from what is beside them."""

import numpy as np
import pytest
from embodied import blocks

from stages.embodied import floor, planner, world


@pytest.fixture(scope="module")
def ground(tmp_path_factory):
    home = blocks.furnished(blocks.corridor(8, 4), blocks.block("island", 4.0, 1.2, 1.0, 2.0))
    return floor.survey(world.build(*blocks.exported(home, tmp_path_factory.mktemp("room")), moving=()))


def _cell(ground, x, y):
    return tuple(planner.cell(ground, np.array([x, y])))


def test_ways_are_free_and_evenly_spaced(ground):
    ways = planner.roadmap(ground, _cell(ground, 0.5, 0.5))
    for goal in ((7.5, 0.5), (7.0, 3.5), (2.0, 2.0)):
        path = ways.path(_cell(ground, *goal))
        assert planner.is_free(ground, path).all()
        assert path[0] == pytest.approx([0.5, 0.5], abs=0.02) and path[-1] == pytest.approx(goal, abs=0.02)
        assert np.hypot(*np.diff(path, axis=0).T).max() < 1.2 * planner.SPACING


def test_the_shortest_way_goes_round_the_island_by_a_radius(ground):
    # By hand: two tangents to circles of the robot's radius about the island's upper corners, arcs, the top side.
    a, corner, r = np.array([1.0, 0.6]), np.array([3.5, 2.2]), 0.25
    d = np.hypot(*(corner - a))
    tangent, angle = np.sqrt(d**2 - r**2), np.arctan2(*(corner - a)[::-1]) + np.arcsin(r / d)
    by_hand = 2 * (tangent + r * angle) + 1.0
    ways = planner.roadmap(ground, _cell(ground, *a))
    assert ways.shortest(_cell(ground, 7.0, 0.6)) == pytest.approx(by_hand, rel=0.01)


def test_ways_keep_further_off_than_the_shortest(ground):
    ways = planner.roadmap(ground, _cell(ground, 1.0, 0.6))
    goal = _cell(ground, 7.0, 0.6)
    path = ways.path(goal)
    length = float(np.hypot(*np.diff(path, axis=0).T).sum())
    assert ways.shortest(goal) < length < 1.2 * ways.shortest(goal)
    at = planner.cell(ground, path)
    assert ground.clearance[at[:, 0], at[:, 1]].min() > 0.25 + 0.05


def test_what_is_shut_off_is_not_reached(tmp_path):
    home = blocks.furnished(blocks.corridor(8, 2), blocks.block("wall", 4.0, 1.0, 0.3, 2.0))
    shut = floor.survey(world.build(*blocks.exported(home, tmp_path), moving=()))
    ways = planner.roadmap(shut, _cell(shut, 1.0, 1.0))
    assert ways.reached[_cell(shut, 2.0, 1.0)] and not ways.reached[_cell(shut, 6.0, 1.0)]

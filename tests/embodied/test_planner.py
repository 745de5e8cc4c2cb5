"""Ways are free, near the shortest, and keep away from what is beside them."""

import numpy as np
import pytest
from embodied import blocks

from apartgen.stages.embodied import floor, planner, world


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
        assert ground.beside(path).min() > 0.249
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


@pytest.mark.parametrize("shift", [0.0, 0.006, 0.012])
def test_ways_through_narrow_gaps_touch_nothing_wherever_the_cells_are(tmp_path, shift):
    # Two gaps of 52.5 cm one after the other, a step to the side between them.
    gaps = ((3.0, 0.5 + shift), (3.7, 1.3 - shift))
    sides = [(x, *span) for x, y in gaps for span in ((0.0, y - 0.2625), (y + 0.2625, 1.8))]
    walls = [blocks.block(f"wall_{k}", x, (lo + hi) / 2, 0.2, hi - lo) for k, (x, lo, hi) in enumerate(sides)]
    narrow = floor.survey(world.build(*blocks.exported(blocks.furnished(blocks.corridor(6, 1.8), *walls), tmp_path)))
    path = planner.roadmap(narrow, _cell(narrow, 1.0, 0.9)).path(_cell(narrow, 5.5, 0.9))
    x, y = np.concatenate([np.linspace(a, b, 10) for a, b in zip(path[:-1], path[1:], strict=True)]).T
    away = [np.hypot((np.abs(x - at) - 0.1).clip(0), (lo - y).clip(0) + (y - hi).clip(0)) for at, lo, hi in sides]
    assert np.min(away) > 0.249


def test_what_is_shut_off_is_not_reached(tmp_path):
    home = blocks.furnished(blocks.corridor(8, 2), blocks.block("wall", 4.0, 1.0, 0.3, 2.0))
    shut = floor.survey(world.build(*blocks.exported(home, tmp_path), moving=()))
    ways = planner.roadmap(shut, _cell(shut, 1.0, 1.0))
    assert ways.reached[_cell(shut, 2.0, 1.0)] and not ways.reached[_cell(shut, 6.0, 1.0)]

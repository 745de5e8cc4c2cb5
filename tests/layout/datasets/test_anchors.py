"""Distances that the furnisher goes by, what it counts as missed, and outlines, in cases by hand."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from apartgen.stages.layout.datasets import _frames, furnisher, single_rooms
from apartgen.stages.layout.datasets._furnish import anchors, dressing, kernels, runs, sleeping
from apartgen.stages.layout.datasets._furnish.legs import Leg
from apartgen.stages.layout.datasets._furnish.space import Space


def test_the_nearest_window_and_the_nearest_door_count() -> None:
    space: Any = SimpleNamespace(shape=SimpleNamespace(
        windows=np.array([[0.0, 0.0, 0, 0, 0], [4.0, 3.0, 0, 0, 0]]), doors=np.array([[0.0, 3.0, 0, 0, 0]])))
    at = np.array([[3.0, 4.0], [1.0, 0.0]])
    assert anchors.to_windows(at, space) == pytest.approx([np.sqrt(2), 1.0])
    assert anchors.to_doors(at, space) == pytest.approx([np.sqrt(10), np.sqrt(10)])


def test_points_beyond_the_walls_are_told_from_those_within() -> None:
    """An L of two metres a side: in its arm, at its inner corner, beyond that, and outside."""
    start = np.array([[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]], float)
    grid = np.array([[[1.0, 3.0], [1.9, 1.9]], [[3.0, 3.0], [-1.0, 1.0]]])
    found = kernels.walls_away(grid, start)
    assert found[0] == pytest.approx([1.0, np.hypot(0.1, 0.1)]) and (found[1] < 0).all()


def test_the_first_thing_of_a_room_that_hangs_is_not_missed() -> None:
    plan = single_rooms.draw(np.random.default_rng(1), "hallway")
    space = Space(furnisher.shape_of(plan, plan.rooms[0]), np.random.default_rng(2))
    assert space.wish("mirror", 1.0, lambda: dressing.on_wall(space, "mirror"))
    assert space.placed.name == ["mirror"] and space.missed == 0


@pytest.mark.parametrize("side, fits", [(4.0, True), (1.5, False)])
def test_a_bed_of_two_stands_in_a_bedroom_and_not_in_a_closet(side: float, fits: bool) -> None:
    """What is told is what stands there, in ten bare rooms."""
    plan = single_rooms.draw(np.random.default_rng(3), "bedroom")
    room = plan.rooms[0].model_copy(update={"polygon": [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]})
    bare = plan.model_copy(update={"rooms": [room], "openings": []})
    for seed in range(10):
        space = Space(furnisher.shape_of(bare, room), np.random.default_rng(seed))
        assert sleeping.double(space) is fits is ("double_bed" in space.placed.name)


def test_a_kitchen_bakes_in_one_place() -> None:
    """In an oven below its hob or in one at the height of eyes, over 300 runs of 5 m."""
    style, found = runs.Style(0.6, 0.9, np.array([0.35, 0.6, 0.7]), 1.4), []
    for seed in range(300):
        units = runs._units([Leg(0, 0.0, 5.0)], style, np.random.default_rng(seed), 17, False, 0)
        found.append(sum(unit.category == "oven" for unit in units))
    assert set(found) == {0, 1} and found.count(1) > found.count(0)


@pytest.mark.parametrize("size", [0.5, 5.0])
def test_outlines_however_small_turn_counter_clockwise(size: float) -> None:
    ring = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]
    assert _frames.counter_clockwise(ring) == _frames.counter_clockwise([*ring, ring[0]]) == ring
    assert _frames.counter_clockwise(ring[::-1]) == ring

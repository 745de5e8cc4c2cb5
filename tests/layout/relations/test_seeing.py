"""Compiled loops over tokens and units agree with what they stand for."""

import numpy as np
import pytest
from numpy.typing import NDArray

from apartgen.stages.layout.relations import runs, seeing
from apartgen.stages.layout.relations.tokens import WALL, Shell, seen

Floats = NDArray[np.float32]


def things(rng: np.random.Generator, n: int) -> Floats:
    return rng.uniform([-3, -3, -3, 0.1, 0.1, 0, 0.5], [3, 3, 3, 2, 2, 0.5, 2], (n, 7)).astype(np.float32)


@pytest.mark.parametrize("seed", range(4))
def test_tokens_are_seen_as_arrays_have_them(seed: int) -> None:
    rng = np.random.default_rng(seed)
    boxes, viewers, owner = things(rng, 40), things(rng, 5), rng.integers(5, size=40)
    wanted = seen(boxes[:, None], viewers[owner])[:, 0]
    assert seeing.seen(boxes, viewers, owner) == pytest.approx(wanted, abs=1e-5)


@pytest.mark.parametrize("quarter", range(4))
def test_what_continues_a_run_is_flush_with_it_or_has_its_back_to_a_wall_round_the_corner(quarter: int) -> None:
    """A unit of .6 by .8 at the middle of the wall behind it, in a room of 4 by 4."""
    yaw = quarter * np.pi / 2
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    walls = np.zeros((4, 7), np.float32)
    for k in range(4):
        walls[k, 2] = k * np.pi / 2
        walls[k, :2], walls[k, 4], walls[k, 6] = -2 * np.array([np.cos(walls[k, 2]), np.sin(walls[k, 2])]), 4, 2.6
    unit = np.array([*turn @ [-1.7, 0.0], yaw, 0.6, 0.8, 0, 0.9], np.float32)
    shell = Shell(walls, np.full(4, WALL), np.zeros((4, 2), np.float32), np.zeros(4, np.float32))
    found = runs.further("kitchen_base", runs.usual("kitchen_base")[None], ["kitchen_sink"], unit[None], shell)
    beside = runs.touching("kitchen_base", found, ["kitchen_sink"], unit[None])
    assert beside[:2].all() and len(found) == 4
    x, y = (found[:, :2] @ turn).T
    assert x[:2] + 2 == pytest.approx(found[:2, 3] / 2 + 0.0, abs=1e-5)
    assert np.abs(y[:2]) == pytest.approx((0.8 + found[:2, 4]) / 2 + runs.BETWEEN, abs=1e-5)
    assert 2 - np.abs(y[2:]) == pytest.approx(found[2:, 3] / 2 + runs.OFF, abs=1e-5)
    assert x[2:] - found[2:, 4] / 2 == pytest.approx(-1.4 + runs.BETWEEN, abs=1e-5)

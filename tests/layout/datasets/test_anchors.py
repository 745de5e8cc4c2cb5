"""Distances that the furnisher goes by, in cases by hand."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from apartgen.stages.layout.datasets._furnish import anchors, kernels


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

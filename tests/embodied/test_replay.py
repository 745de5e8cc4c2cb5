"""Replays look from where something can be seen."""

from types import SimpleNamespace

import numpy as np
import pytest
from embodied import blocks
from shapely.geometry import Point

from stages import polygons
from stages.embodied import replay


@pytest.mark.parametrize("width, level", [(6.0, True), (0.9, False)])
def test_no_wall_is_between_an_object_and_the_eye_or_it_looks_from_above(width, level):
    plan = blocks.corridor(6, width)
    at, yaw = np.array([3.0, 0.3]), np.pi / 2
    far, steep, azimuth = replay._view(SimpleNamespace(home=plan), at, yaw)
    # MuJoCo's camera looks along its azimuth.
    eye = at - far * np.cos(np.radians(steep)) * np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    assert polygons.free_floor(plan).buffer(0.03).contains(Point(eye)) and eye[1] > at[1]
    assert (steep == replay.STEEP[0]) == level and far in replay.NEAR

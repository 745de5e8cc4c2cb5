"""Boxes, cylinders, capsules and spheres of assets that are read."""

import numpy as np
import pytest
import trimesh

from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.primitives import shape
from apartgen.stages.things.asset import Material

R, H = 0.3, 0.5
SOLIDS = {
    "box": ([0.4, 0.6, 0.8], [0.4, 0.6, 0.8], 0.4 * 0.6 * 0.8),
    "cylinder": ([R, H], [2 * R, 2 * R, 2 * H], np.pi * R**2 * 2 * H),
    "capsule": ([R, H], [2 * R, 2 * R, 2 * (H + R)], np.pi * R**2 * 2 * H + 4 / 3 * np.pi * R**3),
    "sphere": ([R, H], [2 * R] * 3, 4 / 3 * np.pi * R**3),
}


@pytest.mark.parametrize("kind", SOLIDS)
def test_a_solid_is_closed_about_its_frame_and_has_its_size_and_volume(kind):
    size, extents, volume = SOLIDS[kind]
    frame = np.eye(4)
    frame[:3, 3] = 1.0, -2.0, 0.5
    piece, collider = shape(kind, np.array(size), Material("plain"), frame)
    solid = trimesh.Trimesh(piece.vertices, piece.faces)
    assert solid.is_watertight and np.allclose(collider.center, frame[:3, 3])
    assert np.allclose(solid.bounds.mean(0), frame[:3, 3]) and np.allclose(solid.extents, extents)
    assert 0.96 * volume < solid.volume < 1.0001 * volume


@pytest.mark.parametrize("bad", [0.0, -0.1, np.nan, np.inf])
@pytest.mark.parametrize("kind, at", [(kind, k) for kind, (size, _, _) in SOLIDS.items() for k in range(len(size))])
def test_any_side_that_is_no_length_is_refused(kind, at, bad):
    size = np.array(SOLIDS[kind][0])
    size[at] = bad
    with pytest.raises(Broken, match=f"a {kind} of size"):
        shape(kind, size, Material("plain"), np.eye(4))

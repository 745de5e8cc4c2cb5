"""Normal maps: they meet themselves at their edges, point out of the surface, and slope where joints are seen."""

import numpy as np
import pytest

from apartgen.stages.things import materials, relief
from apartgen.stages.things.shading import tangents


def vectors(pattern):
    """What a renderer reads out of the image."""
    return (relief.normals(pattern).astype(float) - 128) / 127.5


@pytest.mark.parametrize("pattern", sorted(relief.DEPTH))
def test_normals_are_unit_point_out_and_differ(pattern):
    found = vectors(pattern)
    assert np.abs(np.linalg.norm(found, axis=2) - 1).max() < 0.06
    assert found[..., 2].min() > 0.2 and np.abs(found[..., :2]).max() > 0.05
    assert np.abs(found[..., :2].mean((0, 1))).max() < 0.02, "it leans as a whole"


@pytest.mark.parametrize("pattern", sorted(relief.DEPTH))
def test_the_pattern_meets_itself(pattern):
    found = vectors(pattern)
    for axis in (0, 1):
        steps = np.abs(np.diff(found, axis=axis)).mean((1 - axis, 2))
        seam = np.abs(found.take(0, axis) - found.take(-1, axis)).mean()
        assert seam <= 1.1 * steps.max()


def test_a_joint_between_tiles_slopes_down_to_its_middle():
    found, shade = vectors("tile"), materials.shades("tile", 256)
    row = shade[128]
    (dark,) = np.nonzero(row < row.mean() - 20)
    first, last = dark[0], dark[dark < dark[0] + 20][-1]
    assert found[128, first - 1, 0] > 0.1 > -0.1 > found[128, last + 1, 0]  # the side to the left looks right
    turned = vectors("tile")[:, 128]
    assert turned[first - 1, 1] < -0.1 < 0.1 < turned[last + 1, 1]  # the side above looks down


def test_what_is_printed_is_flat():
    assert not relief.standing("rug_kilim") and not relief.standing("plaster") and not relief.standing("a/picture.png")
    assert relief.standing("linen") == "weave"


@pytest.mark.parametrize("mirrored", [1.0, -1.0])
def test_tangents_follow_u_and_tell_on_which_side_v_is(mirrored):
    rng = np.random.default_rng(3)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    flat = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]], float)
    uv = flat[:, :2] * [mirrored, 1] / 0.3
    found = tangents(flat @ turn.T, np.tile(turn[:, 2], (4, 1)), uv, np.array([[0, 1, 2], [0, 2, 3]]))
    assert np.allclose(found[:, :3], mirrored * turn[:, 0])
    assert np.allclose(np.cross(turn[:, 2], found[0, :3]) * found[0, 3], turn[:, 1])

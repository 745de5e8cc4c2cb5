"""A fridge is opened from where what is taken out is put down, and opens freely beside a wall."""

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching import stage
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.libraries import open_libraries
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.categories import TABLE

STYLES = furniture.styles("fridge")


def row(flat, *names: str):
    """A kitchen whose units stand at the left wall from one end of it on, their fronts looking along +x."""
    objects, y = [], 0.3
    for name in names:
        d, w, h = TABLE[name].size
        objects.append({"category": name, "center": (d / 2 + 0.01, y + w / 2, h / 2), "size": (d, w, h),
                        "latent": [0.0] * 32})
        y += w
    return flat(*objects, type="kitchen")


def hinges(home) -> set[float]:
    """On which side of its middle the doors of the fridge hang: 1 the left one, -1 the right one."""
    return {float(np.sign(j.origin[1])) for o in home.objects if o.category == "fridge" for j in o.joints}


@pytest.mark.parametrize(("names", "side"), [
    (("fridge", "kitchen_base", "kitchen_sink"), -1.0),
    (("kitchen_sink", "kitchen_base", "fridge"), 1.0),
    (("fridge", "oven", "kitchen_base", "kitchen_sink"), -1.0),
    (("kitchen_base", "fridge", "kitchen_sink"), -1.0),
    (("kitchen_sink", "fridge", "kitchen_base"), 1.0),
])  # fmt: skip
def test_the_hinge_is_on_the_side_away_from_the_worktop(flat, names, side):
    home = stage.run(row(flat, *names), RetrieveConfig(), np.random.default_rng(0))
    assert hinges(home) == {side}


def test_one_that_gives_way_to_a_smaller_one_is_opened_from_the_same_side():
    library = open_libraries()
    right = furniture.build("fridge", STYLES[0], (0.66, 0.6, 1.85), 0, True)
    some = [library.nearest("fridge", (0.6, 0.55, 1.8), np.zeros(32), (0.6, 0.55, 1.8), right.id),
            *library.alternatives("fridge", (0.6, 0.55, 1.8), np.zeros(32), right.id)]
    assert len(some) > 2 and all(j.origin[1] < 0 for asset in some for j in asset.joints)
    left = library.nearest("fridge", (0.6, 0.55, 1.8), np.zeros(32), None, furniture.build("fridge", STYLES[0],
                                                                                       (0.66, 0.6, 1.85)).id)
    assert all(j.origin[1] > 0 for j in left.joints)


def pieces(asset: Asset, flip: float) -> list[list[tuple[float, ...]]]:
    """The boxes that each link is made of, as seen in a mirror where `flip` is -1."""
    return [sorted((*np.round(c.center * [1, flip, 1], 5).tolist(), *np.round(c.size, 5).tolist())
                   for c in link.colliders) for link in asset.links]


@pytest.mark.parametrize("style", STYLES)
def test_hung_on_the_right_it_is_the_mirror_image(style):
    left, right = (furniture.build("fridge", style, (0.66, 0.6, 1.85), 1, side) for side in (False, True))
    assert furniture.load_asset(right.id) is right and right.id != left.id
    for one, other in zip(pieces(left, 1.0), pieces(right, -1.0), strict=True):
        assert np.allclose(one, other, atol=2e-5)
    for a, b in zip(left.links, right.links, strict=True):
        assert a.mass == b.mass
        if a.joint is not None:
            assert np.allclose(np.array(a.joint.origin) * [1, -1, 1], b.joint.origin)
            assert np.allclose(np.array(a.joint.axis) * [-1, 1, -1], b.joint.axis) and a.joint.range == b.joint.range
            assert np.allclose(a.handle * [1, -1, 1], b.handle)


@pytest.mark.parametrize("id", ["sofa/modern/900x2000x850/0/right", "fridge/white/660x600x1850/0/up",
                                "fridge/white/660x600x1850/0/right/right"])  # fmt: skip
def test_what_is_not_handed_has_no_such_piece(id):
    with pytest.raises(BadInput):
        furniture.load_asset(id)

"""The artifact is the truth: its joint ranges are in every format, and what it says of another asset is an error."""

import pytest
from export import readers, sample

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import placed

FORMATS = ("mjcf", "usd", "urdf", "sdf", "glb", "habitat")


def _home(change, *ids):
    """The sample flat with some of its objects changed."""
    home = sample.home()
    for o in home.objects:
        if o.id in ids:
            change(o)
    return home


def _ajar(o):
    o.joints = [o.joints[0].model_copy(update={"range": (0.0, 0.5)})]


@pytest.fixture(scope="module")
def ajar(tmp_path_factory):
    """A display cabinet that opens half as far, and beside it another of the same asset that does not."""
    home = _home(_ajar, "display_cabinet_11")
    twin = next(o for o in sample.home().objects if o.id == "display_cabinet_11")
    home.objects.append(twin.model_copy(update={"id": "twin", "center": (5.51, 2.9, twin.center[2])}))
    out = tmp_path_factory.mktemp("ajar") / "scene"
    export.run(home, list(FORMATS), out, sample.load)
    return out


@pytest.mark.parametrize("name", FORMATS)
def test_a_range_is_the_artifacts(ajar, name):
    joints = getattr(readers, name)(ajar).joints
    assert joints["display_cabinet_11__door"][3] == pytest.approx((0.0, 0.5), abs=1e-6)
    assert joints["twin__door"][3] == pytest.approx((0.0, 1.570796), abs=1e-6)


def test_things_of_one_asset_that_open_differently_have_files_of_their_own(ajar):
    files = sorted((ajar / "urdf" / "objects").glob("*display_cabinet*.urdf"))
    assert ['upper="0.5"' in file.read_text() for file in files] == [True, False]


def test_rounded_numbers_are_the_assets_own():
    """Files hold six digits; what is built is as without them."""
    o = next(o for o in sample.home().objects if o.id == "display_cabinet_11")
    asset = sample.load("plain", "display_cabinet")
    o.joints = [o.joints[0].model_copy(update={"range": (0.0, 1.570796)})]
    o.size = (round(o.size[0], 6), o.size[1] + 1e-6, o.size[2])
    assert placed.links(o, asset) is asset.links


def _larger(o):
    o.size = (o.size[0], o.size[1], o.size[2] + 0.4)


def _joint(**fields):
    def change(o):
        o.joints = [o.joints[0].model_copy(update=fields)]

    return change


@pytest.mark.parametrize("field, change", {
    "size": _larger,
    "joints": lambda o: setattr(o, "joints", []),
    r"joints\[0\].name": _joint(name="gate"),
    r"joints\[0\].type": _joint(type="slide"),
    r"joints\[0\].axis": _joint(axis=(0.0, 0.0, -1.0)),
    r"joints\[0\].origin": _joint(origin=(0.0, 0.0, 0.0)),
    r"joints\[0\].range": _joint(range=(0.5, 0.5)),
}.items())
def test_what_the_asset_is_not_is_an_error_that_names_object_and_field(field, change):
    home = _home(change, "display_cabinet_11")
    with pytest.raises(BadInput, match=f"display_cabinet_11: its {field} "):
        _ = Scene(home, sample.load).bodies


def test_where_along_its_axis_a_hinge_is_told_makes_no_difference():
    o = next(o for o in sample.home().objects if o.id == "display_cabinet_11")
    x, y, z = o.joints[0].origin
    _joint(origin=(x, y, z + 0.3))(o)
    asset = sample.load("plain", "display_cabinet")
    assert placed.links(o, asset) is asset.links

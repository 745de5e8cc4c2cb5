"""`apartgen walkable`: where assets come from, and what the result says of it."""

import json

import commandline
import handmade as h
import pytest

from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen.stages import retrieve


@pytest.fixture
def walked(capsys, monkeypatch, tmp_path):
    def walk(home, *args):
        (tmp_path / "home.json").write_text(artifact.finish(home, Made(by="test", seed=5))[0])
        return commandline.run(capsys, monkeypatch, "walkable", tmp_path / "home.json", *args)

    return walk


def stool(**asset):
    return h.thing("stool", 2, 2).model_copy(update={"asset": h.AssetKey(**asset)})


def test_a_library_that_is_not_open_is_named(walked):
    done = walked(h.home(stool(library="mylib", id="stool")))
    assert done.code == 2 and done.out == ""
    assert "'mylib' is not open" in done.err and "--library" in done.err


def test_an_asset_that_its_library_lacks_is_named(walked):
    done = walked(h.home(stool(library="parametric", id="nothing")))
    assert done.code == 2 and "nothing" in done.err and done.out == ""


def test_the_result_names_the_libraries_that_it_hangs_on(walked):
    asset = retrieve.open_libraries().nearest("stool", (0.4, 0.4, 0.45), ())
    made = json.loads(walked(h.home(stool(library=asset.library, id=asset.id))).out)["made"]
    assert list(made["inputs"]) == ["retrieve", "parametric"]

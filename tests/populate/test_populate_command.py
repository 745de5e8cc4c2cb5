"""`apartgen populate`: what it takes, what it writes, and what the commands before it make of that."""

import json

import commandline
import handmade as h
import pytest
from inhabited import HOME

from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen_cli import main


@pytest.fixture
def ran(capsys, monkeypatch):
    def run(*args, **more):
        return commandline.run(capsys, monkeypatch, *args, **more)

    return run


@pytest.fixture(scope="module")
def filled(tmp_path_factory):
    """A populated home's file."""
    file = tmp_path_factory.mktemp("filled") / "populate.json"
    assert main.status(["populate", str(HOME), "-o", str(file)]) == 0
    return file


def body(file):
    return json.loads(file.read_text())["body"]


def things(file):
    return [o for o in body(file)["objects"] if o.get("stage") == "populate"]


def test_the_file_is_that_of_its_input_and_seed(filled, ran, tmp_path):
    raw = json.loads(filled.read_text())
    before = json.loads(HOME.read_text())
    assert raw["apartgen"] == "populate" and raw["made"]["seed"] == before["made"]["seed"]
    assert raw["made"]["inputs"] == {"walkable": artifact.read(HOME, artifact.Record, whole=True).digest}
    assert raw["body"]["walkable"] == before["body"]["walkable"]
    assert ran("populate", HOME, "--seed", 99, "-o", tmp_path / "other.json").code == 0
    assert things(tmp_path / "other.json") != things(filled)


def test_what_is_not_wanted_is_left_out(ran, tmp_path):
    out = tmp_path / "bare.json"
    assert ran("populate", HOME, "--no-walls", "--no-grasps", "--density", 0.5, "-o", out).code == 0
    assert things(out) and not any(o["on"] == "wall" or "grasps" in o for o in things(out))
    done = ran("populate", HOME, "--density", -1)
    assert done.code == 2 and "--density" in done.err


def test_walkable_refuses_a_populated_file_and_says_what_to_do(filled, ran, tmp_path):
    done = ran("walkable", filled, "-o", tmp_path / "walked.json")
    assert done.code == 2 and "apartgen populate" in done.err and not (tmp_path / "walked.json").exists()


def test_populating_again_begins_anew(filled, ran, tmp_path):
    assert ran("populate", filled, "-o", tmp_path / "again.json").code == 0
    assert body(tmp_path / "again.json") == body(filled)


def test_metrics_and_judge_look_at_furniture(filled, ran):
    figures = [json.loads(ran("metrics", file, "--metric", "counts", "--metric", "collision").out)["body"]
               for file in (filled, HOME)]
    assert figures[0] == figures[1]
    assert ran("check", filled).code == ran("check", HOME).code


def test_a_library_that_is_not_open_is_named(ran, tmp_path):
    shelf = h.thing("bookshelf", 2, 2).model_copy(update={"asset": h.AssetKey(library="mylib", id="shelf")})
    (tmp_path / "home.json").write_text(artifact.finish(h.home(shelf), Made(by="test", seed=5))[0])
    done = ran("populate", tmp_path / "home.json")
    assert done.code == 2 and "'mylib' is not open" in done.err and "--library" in done.err


def test_drawings_leave_small_things_out_and_models_carry_them(filled, ran, tmp_path):
    for name, file in (("one", filled), ("other", HOME)):
        assert ran("export", file, "--format", "svg", "-o", tmp_path / name).code == 0
    assert (tmp_path / "one/plan.svg").read_bytes() == (tmp_path / "other/plan.svg").read_bytes()
    assert ran("export", filled, "--format", "glb", "-o", tmp_path / "model").code == 0
    model = (tmp_path / "model/apartment.glb").read_bytes()
    assert all(f'"name":"{o["id"]}"'.encode() in model for o in things(filled))

"""The apartments of a run: artifacts that can be exported, and that a replay takes or refuses."""

from pathlib import Path

import commandline
import pytest

from apartgen.schemas import artifact
from apartgen.schemas.retrieve import Retrieve
from apartgen.schemas.walkable import Walkable
from apartgen_cli.bench import embodied

EXAMPLE = Path(__file__).parents[2] / "examples" / "two-bedroom-flat" / "walkable.json"
FIRST = "guided-7"


@pytest.fixture(params=[Walkable, Retrieve])
def kept(request, tmp_path, monkeypatch):
    """An apartment, and the file in which a run keeps it; no episode is run."""
    home = artifact.read(EXAMPLE, request.param).body
    first, *others = home.objects
    x, y, z = first.center
    moved = first.model_copy(update={"center": (x + 1e-9, y, z), "latent": [0.5]})
    home = home.model_copy(update={"objects": [moved, *others]})
    monkeypatch.setattr(embodied, "_apartments", lambda *_: iter([home]))
    monkeypatch.setattr(embodied, "_episodes", lambda home, name: [{"name": name}])
    (tmp_path / embodied.HOMES).mkdir()
    assert embodied.trial("guided", 7, 1, tmp_path) == [{"name": FIRST}]
    return home, tmp_path / embodied.HOMES / f"{FIRST}.json"


def test_apartments_are_kept_as_artifacts_with_their_numbers_in_full(kept):
    home, file = kept
    read = artifact.read(file, Retrieve, whole=True)
    assert type(read.body) is type(home) and read.made.seed == 7 and read.made.config["setting"] == "guided"
    objects = [o.model_copy(update={"latent": []}) for o in home.objects]
    assert read.body == home.model_copy(update={"objects": objects})
    assert embodied._read(file).objects == objects


def test_apartments_are_exported_by_the_program(kept, tmp_path, capsys, monkeypatch):
    done = commandline.run(capsys, monkeypatch, "export", kept[1], "--format", "nav2", "-o", tmp_path / "scene")
    assert done.code == 0 and (tmp_path / "scene" / "nav2" / "map.yaml").exists(), done.err


def test_apartments_of_older_runs_are_bodies_alone(kept):
    home, file = kept
    file.write_text(home.model_dump_json(by_alias=True))
    assert embodied._read(file).objects == home.objects


def _replayed(folder, id, capsys, monkeypatch):
    return commandline.run(capsys, monkeypatch, "bench", "embodied", "-o", folder, "--replay", id)


@pytest.mark.parametrize("text, said", [
    ('{"apartgen": "walkable", "version": 1, "ma', "cut off"), ('{"rooms": []}', "field required"),
    ("[1]", "not an apartgen artifact"), ('{"apartgen": "plan"}', "is needed"),
])
def test_broken_apartments_are_refused(text, said, tmp_path, capsys, monkeypatch):
    file = tmp_path / embodied.HOMES / f"{FIRST}.json"
    file.parent.mkdir()
    file.write_text(text)
    done = _replayed(tmp_path, f"{FIRST}:navigation:bed", capsys, monkeypatch)
    assert done.code == 2 and said in done.err and str(file) in done.err and len(done.err.splitlines()) == 1


@pytest.mark.parametrize("id", [
    "home:navigation:bed", "guided-8:navigation:bed", "guided-7:swimming:bed", "guided-7:navigation", "guided-7",
])
def test_episodes_that_are_none_are_refused(id, tmp_path, capsys, monkeypatch):
    for name in (FIRST, "home"):
        file = tmp_path / embodied.HOMES / f"{name}.json"
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(EXAMPLE.read_bytes())
    done = _replayed(tmp_path, id, capsys, monkeypatch)
    assert done.code == 2 and id in done.err and "trials.jsonl" in done.err


@pytest.mark.parametrize("way", ["none-such", "disable"])
def test_without_a_way_to_draw_one_is_named(way, tmp_path):
    (tmp_path / embodied.HOMES).mkdir()
    (tmp_path / embodied.HOMES / f"{FIRST}.json").write_bytes(EXAMPLE.read_bytes())
    asked = ("bench", "embodied", "-o", tmp_path, "--replay", f"{FIRST}:navigation:bed")
    done = commandline.program(*asked, MUJOCO_GL=way)
    assert done.code == 2 and len(done.err.splitlines()) == 1
    assert f"MUJOCO_GL={way}" in done.err and "set MUJOCO_GL=egl" in done.err

"""`apartgen plan --from` with files of other programs: what it writes, says and ends with."""

import json
from pathlib import Path

import pytest
from commandline import run
from plan.imports import homes, writers

from apartgen.schemas import artifact
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args, **given: run(capsys, monkeypatch, *args, **given)


def test_a_home_with_furniture_is_a_layout_artifact(cli, tmp_path: Path) -> None:
    home, file = homes.furnished("one_bedroom", 0), tmp_path / "home.sh3d"
    file.write_bytes(writers.sh3d(home))
    done = cli("plan", "--from", file, "-o", tmp_path / "mine.json")
    assert done.code == 0 and done.out == ""
    read = artifact.read(tmp_path / "mine.json", Plan, whole=True)
    assert read.kind == "layout" and isinstance(read.body, Layout) and len(read.body.objects) == len(home.objects)
    again = cli("plan", "--from", "-", stdin=file.read_bytes())
    assert again.code == 0 and json.loads(again.out)["body"] == json.loads((tmp_path / "mine.json").read_text())["body"]


def test_what_is_completed_is_said_on_standard_error(cli, tmp_path: Path) -> None:
    home, file = homes.furnished("studio", 0), tmp_path / "scan.json"
    raw = json.loads(writers.roomplan(home))
    raw |= {"doors": [], "objects": []}
    file.write_text(json.dumps(raw))
    done = cli("plan", "--from", file)
    assert done.code == 0 and json.loads(done.out)["apartgen"] == "plan"
    assert f"warning: {file}: no entrance: one put into" in done.err and "no door leads to" in done.err


@pytest.mark.filterwarnings("error")
def test_a_door_in_a_wall_without_length_is_told(cli, tmp_path: Path) -> None:
    file = tmp_path / "house.json"
    house = json.loads(writers.procthor(homes.furnished("studio", 0)))
    wall = next(wall for wall in house["walls"] if wall["id"] == house["doors"][0]["wall0"])
    wall["polygon"] = [wall["polygon"][0]] * len(wall["polygon"])
    file.write_text(json.dumps(house))
    done = cli("plan", "--from", file, "-o", tmp_path / "plan.json")
    assert done.code == 2 and "is in a wall of 0 m" in done.err and len(done.err.splitlines()) <= 2


def test_errors_are_one_line_with_the_file_and_the_place(cli, tmp_path: Path) -> None:
    file = tmp_path / "house.json"
    house = json.loads(writers.procthor(homes.furnished("studio", 0)))
    del house["doors"][0]["holePolygon"]
    file.write_text(json.dumps(house))
    done = cli("plan", "--from", file, "-o", tmp_path / "plan.json")
    assert done.code == 2 and f"{file}: doors and windows" in done.err and len(done.err.splitlines()) <= 2
    assert not (tmp_path / "plan.json").exists()
    apart = json.loads(writers.roomplan(homes.furnished("studio", 0)))
    apart |= {
        "walls": apart["walls"][:0],
        "doors": [],
        "openings": [],
        "floors": [
            {**apart["floors"][0], "polygonCorners": [[a, b, 0] for a, b in ring]}
            for ring in ([(0, 0), (4, 0), (4, 4), (0, 4)], [(4, 4), (8, 4), (8, 8), (4, 8)])
        ],
    }
    file.write_text(json.dumps(apart))
    done = cli("plan", "--from", file)
    assert done.code == 1 and "no door leads to" in done.err

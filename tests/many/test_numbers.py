"""Numbers that no home has are refused at once, wherever they stand."""

import json
from pathlib import Path

import commandline
import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "two-bedroom-flat" / "walkable.json"


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args, stdin=b"": commandline.run(capsys, monkeypatch, *args, stdin=stdin)


def square(side: float) -> list[list[float]]:
    return [[0, 0], [side, 0], [side, side], [0, side]]


def programme(**first) -> dict:
    return {"rooms": [{"id": "living_room_1", "type": "living_room"} | first,
                      {"id": "bathroom_1", "type": "bathroom"}], "links": [["living_room_1", "bathroom_1"]]}


def drawn(side: float) -> dict:
    return {"rooms": [{"id": "living_room_1", "type": "living_room", "polygon": square(side)}]}


WANTED = {
    "an area of 1e300": programme(area=1e300), "an area of 1e-7": programme(area=1e-7),
    "a total of 1e300": programme() | {"total_area": 1e300}, "a total of 1e-7": programme() | {"total_area": 1e-7},
    "a room of 5 cm": drawn(0.05), "a room of 1e300 m": drawn(1e300), "a room of 100 km": drawn(1e5),
    "an outline of 900 m": programme() | {"envelope": {"outline": square(900)}},
    "an outline of 200 m": programme() | {"envelope": {"outline": square(200)}},
}


@pytest.mark.parametrize("name", WANTED)
def test_programmes_and_drawings(cli, tmp_path, name):
    file = tmp_path / "wanted.json"
    file.write_text(json.dumps(WANTED[name]))
    done = cli("plan", "--from", file)
    assert done.code in (1, 2) and done.out == "" and 1 <= done.err.count("\n") <= 2, done


@pytest.mark.parametrize("options", [["--height", "1e6"], ["--height", "1e300"], ["--outline", "OUTLINE"],
                                     ["--seed", "9" * 5000], ["--seed", "9" * 29]])
def test_options(cli, tmp_path, options):
    (tmp_path / "outline.json").write_text(json.dumps(square(1e6)))
    given = [str(tmp_path / "outline.json") if one == "OUTLINE" else one for one in options]
    done = cli("plan", "studio", *given)
    assert done.code == 2 and done.out == "" and 1 <= done.err.count("\n") <= 2, done


@pytest.mark.parametrize("change", [
    lambda body: body.update(height=1e6), lambda body: body["rooms"][0].update(polygon=square(900)),
    lambda body: body["rooms"][0].update(polygon=square(1e300)),
    lambda body: body["objects"][0].update(size=[1e12, 1, 1])])
def test_artifacts(cli, tmp_path, change):
    home = json.loads(EXAMPLE.read_text())
    change(home["body"])
    file = tmp_path / "home.json"
    file.write_text(json.dumps(home))
    for command in (["walkable", "--trust"], ["metrics"], ["layout", "--trust"]):
        done = cli(*command, file)
        assert done.code == 2 and done.out == "" and "home.json: body." in done.err, done

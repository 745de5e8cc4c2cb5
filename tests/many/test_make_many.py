"""`make` over a list of prompts: a folder each, the homes that the stages give, what failed in a list."""

import json
import os

import commandline
import pytest

CHEAP = "[layout]\ncandidates = 1\n[plan]\nenough = 1\ncandidates = 1\n"


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args, stdin=b"": commandline.run(capsys, monkeypatch, *args, stdin=stdin)


def test_a_list_fills_a_folder_of_homes(cli, tmp_path):
    (tmp_path / "cheap.toml").write_text(CHEAP)
    rows = [{"id": "a", "prompt": "studio", "settings": {"plan": {"height": 3}}}, {"id": "none"},
            {"id": "b", "prompt": "a 20 m² flat with four bedrooms of 15 m² each"}]
    (tmp_path / "list").write_text("\n".join(map(json.dumps, rows)))
    args = ["make", "--prompts", tmp_path / "list", "-o", tmp_path / "homes", "--config", tmp_path / "cheap.toml",
            "--format", "svg", "--failures", tmp_path / "left", "--no-populate"]
    done = cli(*args)
    assert done.code == 2 and "b: " in done.err and "list:2: " in done.err and "2 of 3" in done.err
    assert os.listdir(tmp_path / "homes") == ["a"]
    assert sorted(os.listdir(tmp_path / "homes" / "a"))[-2:] == ["scene", "walkable.json"]
    made = json.loads((tmp_path / "homes" / "a" / "plan.json").read_text())
    assert made["made"]["id"] == "a" and made["body"]["height"] == 3
    [plan] = cli("plan", "--prompts", tmp_path / "list", "--config", tmp_path / "cheap.toml").out.splitlines()
    assert json.loads(plan)["body"] == made["body"]
    assert [json.loads(line)["id"] for line in (tmp_path / "left").read_text().splitlines()] == ["b"]
    before = (tmp_path / "homes" / "a" / "walkable.json").stat().st_mtime_ns
    cli(*args)
    assert (tmp_path / "homes" / "a" / "walkable.json").stat().st_mtime_ns == before


@pytest.mark.parametrize("args", [[], ["studio", "--prompts", "x"], ["plan.json"], ["--retry", "x", "--prompts", "x"]])
def test_what_to_make_is_said_once(cli, tmp_path, args):
    done = cli("make", *args, "-o", tmp_path / "home")
    assert done.code == 2 and done.out == "" and not (tmp_path / "home").exists()

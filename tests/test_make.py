"""`make` runs every stage, goes on where it was stopped, and gives what the stages give one by one."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import commandline
import pytest
from commandline import timeless

from apartgen.schemas import artifact
from apartgen.schemas.artifact import BODIES

PROMPT = "one-bedroom flat"
FORMATS = ("glb", "mjcf", "svg", "png")
STAGES = ("plan", "layout", "retrieve", "walkable")


def times(folder: Path) -> dict[str, int]:
    return {name: (folder / name).stat().st_mtime_ns for name in timeless(folder)}


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A finished home, made once; tests work on copies."""
    folder = tmp_path_factory.mktemp("made") / "home"
    done = commandline.program("make", PROMPT, "-o", f"{folder}/", "--seed", 3)
    assert done.code == 0, done.err
    return folder, done


@pytest.fixture
def home(made, tmp_path):
    folder = tmp_path / "home"
    shutil.copytree(made[0], folder)
    return folder


@pytest.fixture
def again(capsys, monkeypatch):
    def run(folder, prompt=PROMPT, seed=3, config=None):
        extra = ["--config", config] if config else []
        return commandline.run(capsys, monkeypatch, "make", prompt, "-o", f"{folder}/", "--seed", seed, *extra)

    return run


def test_everything_is_made_and_named_with_a_picture_last(made):
    folder, done = made
    named = [Path(line) for line in done.err.splitlines() if line.startswith(str(folder))]
    assert {path.name for path in named} >= {f"{word}.json" for word in (*STAGES, "metrics")}
    assert {path.suffix for path in named} >= {".glb", ".xml", ".svg", ".png"}
    assert all(path.stat().st_size > 10 for path in named)
    assert named[-1].suffix == ".png" and named[-1].read_bytes().startswith(b"\x89PNG")
    assert done.out == ""


def test_the_apartment_grows_by_one_field_a_stage(made):
    bodies = [artifact.read(made[0] / f"{word}.json", BODIES[word]).body for word in STAGES]
    for before, after in zip(bodies, bodies[1:]):
        for name in type(before).model_fields:
            if name != "objects":
                assert getattr(before, name) == getattr(after, name), name
    assert len(bodies[2].objects) <= len(bodies[1].objects) and bodies[2].objects[0].asset.id


def test_what_is_there_is_kept(home, again):
    before = times(home)
    assert again(home).code == 0
    assert times(home) == before


def test_a_target_missed_on_request_ends_in_1_with_everything_written(again, home):
    config = home.parent / "settings.toml"
    config.write_text("[walkable]\ntarget = 0.99\nwrite_anyway = true\n")
    done = again(home, config=config)
    assert done.code == 1 and "0.99 can't be met" in done.err and "written as asked" in done.err
    assert json.loads((home / "walkable.json").read_text())["body"]["walkable"]["target"] == 0.99
    assert str(home / "scene" / "plan.png") in done.err


@pytest.mark.parametrize("lost", ["plan", "layout", "walkable"])
def test_what_is_missing_is_made_again_and_the_same(made, home, again, lost):
    before = times(home)
    (home / f"{lost}.json").unlink()
    assert again(home).code == 0
    assert timeless(home) == timeless(made[0])
    assert {name for name, when in times(home).items() if when != before.get(name)} == {f"{lost}.json"}


def test_damaged_files_are_made_again(made, home, again):
    text = (home / "layout.json").read_text()
    (home / "layout.json").write_text(text[: len(text) // 2])
    scene = next(file for file in (home / "scene").rglob("*.glb"))
    scene.write_bytes(b"")
    done = again(home)
    assert done.code == 0 and "layout.json" in done.err
    assert timeless(home) == timeless(made[0])


def test_other_weights_make_a_layout_anew(home, again, tmp_path):
    from apartgen import steps
    from apartgen.stages.layout.relations import weights as shipped

    assert steps.weights(steps.LayoutConfig()) == {"weights": shipped.SHIPPED}
    other = tmp_path / "weights.safetensors"
    shutil.copy(shipped.SHIPPED, other)
    with other.open("r+b") as file:
        file.seek(-1, os.SEEK_END)
        last = file.read(1)
        file.seek(-1, os.SEEK_END)
        file.write(bytes([last[0] ^ 1]))
    (tmp_path / "settings.toml").write_text(f'[layout]\nweights = "{other}"\n')
    before = times(home)
    assert again(home, config=tmp_path / "settings.toml").code == 0
    after = times(home)
    assert after["plan.json"] == before["plan.json"] and after["layout.json"] != before["layout.json"]


def test_another_seed_makes_everything_anew(made, home, again):
    assert again(home, seed=4).code == 0
    old, new = timeless(made[0]), timeless(home)
    assert all(old[f"{word}.json"] != new[f"{word}.json"] for word in (*STAGES, "metrics"))


def test_another_prompt_makes_everything_anew(home, again):
    assert again(home, prompt="studio").code == 0
    for word in STAGES:
        assert artifact.read(home / f"{word}.json", BODIES["plan"]).body.prompt == "studio"


def test_a_killed_run_is_finished_by_the_next(made, tmp_path):
    folder = tmp_path / "home"
    command = [sys.executable, "-m", "apartgen_cli", "make", PROMPT, "-o", f"{folder}/", "--seed", "3"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 120
    while not (folder / "plan.json").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    process.send_signal(signal.SIGKILL)
    process.wait()
    left = set(os.listdir(folder)) if folder.exists() else set()
    assert "plan.json" in left and "metrics.json" not in left
    kept = (folder / "plan.json").stat().st_mtime_ns
    assert subprocess.run(command, stderr=subprocess.DEVNULL, timeout=300).returncode == 0
    assert (folder / "plan.json").stat().st_mtime_ns == kept
    mine, others = timeless(folder), timeless(made[0])
    assert {name: data for name, data in mine.items() if name in others} == others


def test_stages_in_a_pipe_give_what_make_gives(made):
    program = f"{sys.executable} -m apartgen_cli"
    pipe = " | ".join([f'{program} plan "{PROMPT}" --seed 3', *(f"{program} {word}" for word in STAGES[1:])])
    done = subprocess.run(pipe, shell=True, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    piped, stored = json.loads(done.stdout), json.loads((made[0] / "walkable.json").read_text())
    for one in (piped, stored):
        one["made"].pop("seconds")
    assert piped == stored


def test_a_batch_gives_what_single_runs_give(made, tmp_path, capsys, monkeypatch):
    shutil.copy(made[0] / "layout.json", tmp_path / "home.json")
    other = json.loads((made[0] / "layout.json").read_text())
    other["body"]["objects"].pop()
    (tmp_path / "other.json").write_text(json.dumps(other))
    for word in ("retrieve", "walkable"):
        inputs = [tmp_path / "home.json", tmp_path / "other.json"]
        done = commandline.run(capsys, monkeypatch, word, *inputs, "-o", f"{tmp_path}/{word}/")
        assert done.code == 0, done.err
        body = json.loads((tmp_path / word / "home.json").read_text())["body"]
        assert body == json.loads((made[0] / f"{word}.json").read_text())["body"]
        for file in inputs:
            shutil.move(tmp_path / word / file.name, file)

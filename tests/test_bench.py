"""Experiments: paired trials, resuming after a kill, and every experiment's contract."""

import json
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import commandline
import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages import registry
from apartgen_cli.bench import (
    _runner,
    ablation,
)

EXPERIMENTS = list(registry.members("apartgen_cli.bench"))


@pytest.mark.parametrize("name", EXPERIMENTS)
def test_every_experiment_keeps_the_contract(name: str) -> None:
    experiment = registry.load("apartgen_cli.bench", name)
    assert experiment.SETTINGS and experiment.SCENES >= experiment.CHUNK >= 1
    assert isinstance(experiment.NOTE, str) and isinstance(experiment.PAPER, list)
    assert callable(experiment.trial) and callable(experiment.rows)


def fake(log: list[Any]) -> Any:
    def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
        log.append((setting, seed))
        return [{"value": float(seed + i)} for i in range(scenes)]

    def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
        return [{"n": len(records), "mean": float(np.mean([r["value"] for r in records]))}]

    return SimpleNamespace(
        SETTINGS=["a", "b"], SCENES=10, CHUNK=4, PAPER=[{"mean": 1}], NOTE="n", trial=trial, rows=rows
    )


def test_settings_share_seeds_and_all_scenes_are_covered() -> None:
    jobs = _runner.jobs(fake([]), 10, 3)
    a, b = ([j[1:] for j in jobs if j[0] == s] for s in "ab")
    assert a == b
    assert sum(scenes for _, scenes in a) == 10


def test_an_interrupted_run_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log: list[Any] = []
    monkeypatch.setattr(registry, "load", lambda package, name: fake(log))
    list(_runner.run(fake(log), "fake", tmp_path, None, 0, 1))
    assert len(log) == 6
    first = json.loads((tmp_path / "results.json").read_text())["rows"]
    lines = (tmp_path / "trials.jsonl").read_text().splitlines()
    (tmp_path / "trials.jsonl").write_text("\n".join(lines[:3]) + "\n" + lines[3][:20])
    log.clear()
    list(_runner.run(fake(log), "fake", tmp_path, None, 0, 1))
    assert len(log) == 3
    assert json.loads((tmp_path / "results.json").read_text())["rows"] == first == [{"n": 20, "mean": 4.5}]
    assert "| n | mean |" in (tmp_path / "table.md").read_text()


def test_other_files_are_other_trials(tmp_path: Path) -> None:
    one, two = tmp_path / "one.bin", tmp_path / "two.bin"
    one.write_bytes(b"1"), two.write_bytes(b"2")
    keys = [tuple(_runner.jobs(fake([]), 10, 0, {"weights": [str(file)]})) for file in (one, one, two)]
    assert keys[0] == keys[1] != keys[2] and _runner.jobs(fake([]), 10, 0)[0] != keys[0][0]
    one.write_bytes(b"3")
    assert tuple(_runner.jobs(fake([]), 10, 0, {"weights": [str(one)]})) != keys[0]
    (tmp_path / "rooms").mkdir()
    real = {"real": f"ssr={tmp_path / 'rooms'}"}
    empty = _runner.jobs(fake([]), 10, 0, real)
    (tmp_path / "rooms" / "a.json").write_text("{}")
    assert _runner.jobs(fake([]), 10, 0, real) != empty


def test_files_reach_the_trials_and_the_record_but_not_their_folders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[Any] = []
    experiment = fake([])
    experiment.trial = lambda *args, **files: seen.append(files) or [{"value": 1.0}]
    monkeypatch.setattr(registry, "load", lambda package, name: experiment)
    files = {"weights": [str(tmp_path / "run_1.safetensors")]}
    (tmp_path / "run_1.safetensors").touch()
    list(_runner.run(experiment, "fake", tmp_path / "out", 4, 0, 1, files))
    assert seen == [files, files]
    record = json.loads((tmp_path / "out" / "results.json").read_text())
    assert record["weights"] == "run_1.safetensors" and str(tmp_path) not in json.dumps(record)
    assert record["commit"] and record["seconds"] >= 0 and record["cpu_seconds"] >= 0 and record["machine"]


@pytest.mark.parametrize("args, said", [
    (["walkable", "--weights", "{file}"], "walkable takes none"),
    (["ablation", "--weights", "none.safetensors"], "no such file"),
    (["ablation", "--weights", "{file}", "--weights", "{twin}"], "rename one"),
    (["ablation", "--weights", "{file}", "--anticipating", "{file}", "--anticipating", "{twin}"], "2 files for 1"),
    (["quantity", "--anticipating", "{file}"], "takes none"),
    (["synthesis", "--real", "{file}"], "SOURCE=PATH"),
    (["synthesi"], "there are"),
])
def test_files_that_make_no_sense_are_refused(args, said, tmp_path, capsys, monkeypatch) -> None:  # type: ignore
    names = {"file": tmp_path / "a" / "run.bin", "twin": tmp_path / "b" / "run.bin"}
    for path in names.values():
        path.parent.mkdir()
        path.touch()
    done = commandline.run(capsys, monkeypatch, "bench", *(arg.format(**names) for arg in args), "-o", tmp_path / "out")
    assert done.code == 2 and said in done.err


def test_new_files_leave_the_trials_of_others_alone(tmp_path: Path) -> None:
    one, two = tmp_path / "one.bin", tmp_path / "two.bin"
    one.write_bytes(b"1"), two.write_bytes(b"2")
    before = _runner.jobs(ablation, 50, 0, {"weights": [str(one)]})
    after = _runner.jobs(ablation, 50, 0, {"weights": [str(one), str(two)]})
    assert set(map(str, before)) < set(map(str, after))


KILLED = """
import os, signal, sys
from pathlib import Path
from types import SimpleNamespace
from apartgen_cli.bench import _runner
from apartgen.schemas.errors import BadInput
from apartgen.stages import registry
left = [int(sys.argv[2])]
def trial(setting, seed, scenes, work):
    left[0] -= 1
    if left[0] < 0:
        os.kill(os.getpid(), signal.SIGKILL)
    return [{"value": seed}]
fake = SimpleNamespace(SETTINGS=["a"], SCENES=5, CHUNK=1, PAPER=[], NOTE="n", trial=trial,
                       rows=lambda records, rng: [{"sum": sum(r["value"] for r in records)}])
registry.load = lambda package, name: fake
list(_runner.run(fake, "fake", Path(sys.argv[1]), None, 0, 1))
"""


def test_a_killed_run_keeps_its_trials_and_goes_on(tmp_path: Path) -> None:
    def run(trials: int) -> int:
        return subprocess.run([sys.executable, "-c", KILLED, tmp_path, str(trials)], check=False).returncode

    assert run(3) == -signal.SIGKILL and not (tmp_path / "results.json").exists()
    assert run(2) == 0
    assert json.loads((tmp_path / "results.json").read_text())["rows"] == [{"sum": 0 + 1 + 2 + 3 + 4}]


def test_wide_tables_are_cut_by_title(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wide = fake([])
    wide.TABLES = {"One": ["setting", "a", "never"], "Two": ["setting", "b"]}
    wide.rows = lambda records, rng: [{"setting": "x", "a": [0.5, 0.25]}, {"setting": "y", "b": [1.0, 0.0, 2.0]}]
    monkeypatch.setattr(registry, "load", lambda package, name: wide)
    list(_runner.run(wide, "fake", tmp_path, 4, 0, 1))
    text = (tmp_path / "table.md").read_text()
    assert "## One\n\n| setting | a |\n| --- | --- |\n| x | 0.5 ± 0.25 |\n\n## Two" in text
    assert "| y | 1 [0, 2] |" in text




@pytest.mark.parametrize("place", ["a-file", "a-file/below", "folder"])
def test_results_that_cannot_be_written_are_refused(place, tmp_path, capsys, monkeypatch) -> None:  # type: ignore
    (tmp_path / "a-file").write_text("mine")
    (tmp_path / "folder" / "trials.jsonl").mkdir(parents=True)
    done = commandline.run(capsys, monkeypatch, "bench", "embodied", "--n", 1, "-o", tmp_path / place)
    assert done.code == 2 and str(tmp_path / place) in done.err and "another folder" in done.err
    assert (tmp_path / "a-file").read_text() == "mine"


def test_trials_that_are_none_of_an_experiment_are_left_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log: list[Any] = []
    monkeypatch.setattr(registry, "load", lambda package, name: fake(log))
    foreign = '{"a": 1}\n[1]\n7\n{"job": 3, "records": [], "seconds": 1, "cpu": 1}\n{"job": ["a", 0, 4]}\n{"job": ["b'
    (tmp_path / "trials.jsonl").write_text(foreign)
    for trials in (6, 0):
        log.clear()
        list(_runner.run(fake(log), "fake", tmp_path, None, 0, 1))
        assert len(log) == trials  # what was run after the line cut short is found again, too
    assert (tmp_path / "trials.jsonl").read_text().startswith(foreign + "\n")


def test_a_file_of_trials_that_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / "trials.jsonl").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(BadInput, match="another folder"):
        list(_runner.run(fake([]), "fake", tmp_path, None, 0, 1))

"""Experiments: paired trials, resuming after a kill, and every experiment's contract."""

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from apartgen_cli.bench import _runner
from stages import registry

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

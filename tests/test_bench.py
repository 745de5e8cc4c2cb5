"""Experiments: paired trials, resuming after a kill, and every experiment's contract."""

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import commandline
import numpy as np
import pytest

from apartgen_cli.bench import _runner, _scenes, ablation, quantity, synthesis, walkable
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
    assert record["commit"] and record["core_seconds"] >= 0 and record["machine"]


@pytest.mark.parametrize("args, said", [
    (["walkable", "--weights", "{file}"], "walkable takes none"),
    (["ablation", "--weights", "none.safetensors"], "no such file"),
    (["ablation", "--weights", "{file}", "--weights", "{twin}"], "rename one"),
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


def test_training_runs_are_pooled_and_shown_apart() -> None:
    names = ablation.settings(["x/one.bin", "y/two.bin"])
    assert names[:2] == ["no guidance · one", "no guidance · two"] and len(names) == 2 * len(ablation.SETTINGS)
    records = [{"setting": name, "R_out/ours": float("two" in name), "of": "bedroom"} for name in names for _ in "ab"]
    rows = {row["setting"]: row for row in ablation.rows(records, np.random.default_rng(0))}
    assert rows["no guidance"]["R_out/ours"][0] == 0.5 and rows["no guidance"]["scenes"] == 4
    assert rows["no guidance · two"]["R_out/ours"] == [1, 1, 1]
    assert list(rows)[:3] == ["no guidance", "no guidance · one", "no guidance · two"]


def seen(setting: str, n: int, shift: float, category: str) -> list[dict[str, Any]]:
    features = np.random.default_rng(len(setting)).normal(shift, 1, (n, 5)).astype(np.float32)
    return [{"setting": setting, "network": "test", "suffix": "_t", "categories": [category],
             "features": synthesis._packed(row)} for row in features]


def test_synthesis_compares_with_the_reference_of_its_place() -> None:
    records = [*seen("single room, reference", 40, 0, "sofa"), *seen("single room, real against real", 40, 0, "sofa"),
               *seen("single room, no guidance", 30, 3, "tv"), *seen("apartment, reference", 40, 3, "tv"),
               *seen("apartment, no guidance", 40, 3, "tv")]
    real, far, near = synthesis.rows(records, np.random.default_rng(0))
    assert [real["setting"], far["setting"], near["setting"]] == [
        "single room, real against real", "single room, no guidance", "apartment, no guidance"]
    assert far["scenes"] == 30 and far["FID_t"][0] > 5 * real["FID_t"][0] and far["SCA_t"][0] > 90
    assert real["CKL"][0] == near["CKL"][0] == pytest.approx(0) and far["CKL"][0] > 5
    assert 30 < near["SCA_t"][0] < 70 and "FID" not in near


def test_real_rooms_are_split_into_reference_and_others(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(synthesis, "_read", lambda name, folder: list(range(21)))
    first = synthesis._given("ssr=x", 0, 5, other=False) + synthesis._given("ssr=x", 5, 50, other=False)
    other = synthesis._given("ssr=x", 0, 50, other=True)
    assert sorted(first + other) == list(range(21)) and len(first) == 11


def test_success_rates_are_counted_at_every_threshold() -> None:
    def some(setting: str, ratios: list[float], connected: float) -> list[dict[str, Any]]:
        fixed = {"connected": connected, "left out": 2, "shrunk": 1, "seconds": 0.1}
        return [{"setting": setting, "ratio": ratio, **fixed} for ratio in ratios]

    records = [*some("unguided", [0.5, 0.9], 0.0), *some("guided", [0.72, 0.7], 1.0)]
    for t in walkable.THRESHOLDS:
        records += some(f"walkable {t:.2f}", [t, t - 0.01], 1.0)
    rows = {row["threshold"]: row for row in walkable.rows(records, np.random.default_rng(0))}
    assert list(rows) == walkable.THRESHOLDS
    assert [rows[0.7][f"SR, {name}"][0] for name in ("unguided", "guided", "walkable")] == [0.5, 1, 0.5]
    assert rows[0.9]["SR, unguided"][0] == 0.5 and rows[0.75]["SR, guided"][0] == 0
    assert rows[0.7]["connected, unguided"] == [0, 0, 0] and rows[0.7]["connected, walkable"] == [1, 1, 1]
    assert rows[0.7]["left out"] == 2


def test_placed_apartments_are_made_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import handmade as h

    made: list[int] = []
    monkeypatch.setattr(_scenes, "plans", lambda seed, n, work: [h.plan()] * n)
    monkeypatch.setattr(_scenes, "furnished", lambda plans, config, seed: plans)
    monkeypatch.setattr(_scenes, "retrieved", lambda home, seed: made.append(seed) or h.home(h.chest(2, 2)))
    first = _scenes.placed("no guidance", 3, 2, tmp_path)
    assert _scenes.placed("no guidance", 3, 2, tmp_path) == first and made == [3, 3]
    _scenes.placed("no guidance", 4, 1, tmp_path), _scenes.placed("all guidance", 3, 2, tmp_path)
    assert made == [3, 3, 4, 3, 3]


def test_quantity_rows_have_intervals_and_a_figure() -> None:
    from matplotlib.figure import Figure

    records = [{"N": n, "count": count, "hit": float(i < 3)} for n in quantity.TARGETS for count in ("exact", "free")
               for i in range(4)]
    rows = quantity.rows(records, np.random.default_rng(0))
    assert [row["N"] for row in rows] == list(quantity.TARGETS) and rows[0]["scenes"] == 4
    value, low, high = rows[0]["Q_ratio, exact"]
    assert value == 0.75 and low < 0.75 < high and "Q_ratio, guided" not in rows[0]
    quantity.draw(rows, Figure().subplots())

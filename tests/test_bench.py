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

from apartgen_cli.bench import (
    _compared,
    _rooms,
    _runner,
    _scenes,
    ablation,
    articulation,
    quantity,
    synthesis,
    walkable,
)
from schemas.errors import BadInput
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


def test_training_runs_are_pooled_and_shown_apart() -> None:
    names = ablation.settings(["x/one.bin", "y/two.bin"])
    assert names[2:4] == ["no guidance · one", "no guidance · two"] and "anticipating · one" not in names
    records = [{"setting": name, "R_out/ours": [float("two" in name), 3], "R_reach/ours": 0.5, "categories": ["sofa"]}
               for name in names for _ in "ab"]
    rows = ablation.rows(records, np.random.default_rng(0))
    pooled, one, two = [row for row in rows if row["setting"] == "no guidance"]
    assert [row["run"] for row in (pooled, one, two)] == ["mean of 2", "one", "two"]
    assert pooled["R_out/ours"] == [0.5, pytest.approx(2**-0.5, abs=1e-5)] and pooled["scenes"] == 2
    assert two["R_out/ours"] == [1, 1, 1] and pooled["R_reach/ours"] == [0.5, 0]


def test_anticipating_weights_serve_the_settings_that_anticipate() -> None:
    files = {"weights": ["x/one.bin", "y/two.bin"], "anticipating": ["x/one-100.bin", "y/two-100.bin"]}
    assert {"anticipating · one", "anticipating · two"} < set(ablation.settings(**files))
    assert ablation.used("no guidance · two", **files) == {"weights": ["y/two.bin"]}
    assert ablation.used("all · two", **files) == {"weights": ["y/two-100.bin"]}
    assert ablation.used("all · two", weights=files["weights"]) == {"weights": ["y/two.bin"]}
    assert ablation.used("reference", **files) == {}
    with pytest.raises(BadInput, match="1 files for 2"):
        ablation.settings(files["weights"], ["x/one-100.bin"])


def test_new_files_leave_the_trials_of_others_alone(tmp_path: Path) -> None:
    one, two = tmp_path / "one.bin", tmp_path / "two.bin"
    one.write_bytes(b"1"), two.write_bytes(b"2")
    before = _runner.jobs(ablation, 50, 0, {"weights": [str(one)]})
    after = _runner.jobs(ablation, 50, 0, {"weights": [str(one), str(two)]})
    assert set(map(str, before)) < set(map(str, after))


def test_every_room_is_asked_for_as_many_objects_as_its_reference_holds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import handmade as h

    pytest.importorskip("efficientnet_lite_pytorch")
    home = h.home(h.thing("sofa", 1, 1), h.thing("armchair", 1, 1), h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM))
    monkeypatch.setattr(_scenes, "of_rooms", lambda seed, rooms, work: [h.plan()])
    monkeypatch.setattr(_compared, "furnished", lambda plans, seed, lane: [home])
    (plan,) = _rooms.plans(0, 2, tmp_path)
    assert plan.program.counts == {h.LIVING: 2, h.BEDROOM: 1}
    made = h.home(h.thing("sofa", 1, 1), h.thing("sofa", 1, 1.2), h.thing("plant", 3, 2)).model_copy(
        update={"program": plan.program})
    living, bedroom = _rooms.records([made], 0.25)
    assert (living["Q_ratio"], bedroom["Q_ratio"]) == (0, 0) and living["seconds"] == 0.25
    assert living["Col_obj/ours"] == [pytest.approx(2 / 3), 3] and "Col_obj/ours" not in bedroom
    assert living["objects_a_room"] == [3, 1] and bedroom["categories"] == []
    row = _rooms.row("x", "", [{**r, "setting": "x"} for r in (living, bedroom)], [], np.random.default_rng(0))
    assert row["Col_obj/ours"][0] == pytest.approx(2 / 3, abs=1e-5) and row["scenes"] == 2


def test_shares_of_objects_are_over_objects() -> None:
    value, low, high = _scenes.mean([[1.0, 1], [0.0, 3]], np.random.default_rng(0))
    assert value == 0.25 and (low, high) == (0, 1) and _scenes.mean([1.0, 0.0], np.random.default_rng(0))[0] == 0.5


KILLED = """
import os, signal, sys
from pathlib import Path
from types import SimpleNamespace
from apartgen_cli.bench import _runner
from stages import registry
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


def seen(setting: str, n: int, shift: float, category: str) -> list[dict[str, Any]]:
    features = np.random.default_rng(len(setting)).normal(shift, 1, (n, 5)).astype(np.float32)
    return [{"setting": setting, "network": "test", "suffix": "_t", "categories": [category],
             "features": _compared._packed(row)} for row in features]


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
    monkeypatch.setattr(_compared, "_read", lambda name, folder: list(range(21)))
    first = _compared.real_rooms("ssr=x", 0, 5) + _compared.real_rooms("ssr=x", 5, 50)
    other = _compared.real_rooms("ssr=x", 0, 50, other=True)
    assert sorted(first + other) == list(range(21)) and len(first) == 11


def test_things_that_real_rooms_never_have_are_left_out_beside_them(monkeypatch: pytest.MonkeyPatch) -> None:
    import handmade as h

    real = h.home(h.thing("sofa", 1, 1))
    monkeypatch.setattr(_compared, "_read", lambda name, folder: [real] * 4)
    monkeypatch.setattr(_compared, "seen", lambda rooms, _: [[o.category for o in things] for _, things in rooms])
    made = h.home(h.thing("sofa", 1, 1), h.thing("plant", 3, 2))
    monkeypatch.setattr(synthesis, "_made", lambda plans, who, seed, weights: [made])
    _compared.kinds.cache_clear()
    assert synthesis.trial("3D-FRONT, no guidance", 0, 2, Path(), real="ssr=x") == [["sofa"]]
    _compared.kinds.cache_clear()
    assert synthesis.used("3D-FRONT, reference", ["w"], None, "ssr=x") == {"real": "ssr=x"}
    assert synthesis.used("apartment, no guidance", ["w"], None, "ssr=x") == {"weights": ["w"]}


def test_the_papers_figures_stand_at_the_settings_they_are_of() -> None:
    from matplotlib.figure import Figure

    assert {row["setting"] for row in articulation.PAPER} <= set(articulation.SETTINGS)
    axes = Figure().subplots()
    rows = [{"setting": name, "R_acoll/ours": [0.5, 0.4, 0.6], "Col_obj/ours": [0.5, 0.4, 0.6],
             "R_reach/standing": [0.5, 0.4, 0.6]} for name in articulation.SETTINGS]
    articulation.draw(rows, axes)
    marks = [(round(float(x), 2), y) for line in axes.lines for x, y in zip(line.get_xdata(), line.get_ydata())]
    # The first setting's first bar is a third of the group's width left of its middle.
    assert (-0.27, 0.191) in marks and len(marks) == sum(len(row) - 2 for row in articulation.PAPER)


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

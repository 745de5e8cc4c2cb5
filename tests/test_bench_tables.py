"""What experiments make of their records: rows, figures, and which files and rooms they use."""


from pathlib import Path
from typing import Any

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen_cli.bench import (
    _compared,
    _rooms,
    _runner,
    _scenes,
    ablation,
    articulation,
    embodied,
    quantity,
    synthesis,
    walkable,
)


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


def opened(setting: str, category: str, failures: list[str | None]) -> list[dict[str, Any]]:
    return [{"setting": setting, "apartment": f"{setting}-{k % 2}", "episode": "interaction", "category": category,
             "success": failure is None, "failure": failure, "cpu_seconds": 1.0, "numbers": {}}
            for k, failure in enumerate(failures)]


def test_interaction_is_shown_by_category_beside_the_settings() -> None:
    from matplotlib.figure import Figure

    drive = {"episode": "navigation", "category": "sofa", "success": True, "failure": None, "cpu_seconds": 1.0}
    records = [{"setting": setting, "apartment": setting, **drive, "numbers": {"spl": 1.0}}
               for setting in embodied.SETTINGS]
    records += opened("no guidance", "oven", ["planner", "blocked part", "planner", None])
    records += opened("guided", "oven", [None, None]) + opened("no guidance", "bin", ["controller", "planner"])
    plain, guided, *kinds = rows = embodied.rows(records, np.random.default_rng(0))
    assert plain["SR_interact"][0] == pytest.approx(1 / 6, abs=1e-5) and guided["SR_interact"] == [1, 1, 1]
    assert [row["category"] for row in kinds] == ["bin", "oven"] and rows == embodied.rows(
        records, np.random.default_rng(0))
    bins, ovens = kinds
    assert ovens["no guidance, episodes"] == 4 and ovens["no guidance, SR_interact"] == [0.25, 0, 0.5]
    assert ovens["no guidance, most failures"] == "planner (2)" and "guided, most failures" not in ovens
    assert bins["no guidance, most failures"] == "planner (1)" and "guided, episodes" not in bins
    text = _runner._markdown(embodied, {"experiment": "embodied"}, rows)  # type: ignore[arg-type]
    totals, by_kind = (text.partition(f"## {title}\n\n")[2].partition("\n\n")[0] for title in embodied.TABLES)
    assert len(totals.splitlines()) == len(by_kind.splitlines()) == 4 and "oven" not in totals
    assert "| bin | 2 | 0 [0, 0] | planner (1) |  |  |" in by_kind
    axes = Figure().subplots()
    embodied.draw(rows, axes)
    assert len(axes.patches) == 4

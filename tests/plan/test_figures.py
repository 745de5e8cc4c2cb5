"""Figures over many plans, reckoned by hand."""

import numpy as np
import pytest

from apartgen.stages.plan.study import archetypes
from apartgen_cli.bench import plan, regularity

GOOD = {"faults": 0.0, "relaxed": 0.0, "S_edge": 1.0, "S_constraint": 0.98, "corridor": 0.1, "aspect": 1.5}


def test_every_archetype_is_measured() -> None:
    assert plan.SETTINGS == list(archetypes())
    assert set(regularity.FLATS) <= set(plan.SETTINGS)


def test_a_row_tells_shares_percentiles_and_signatures_of_the_first_forty() -> None:
    records = [
        {**GOOD, "setting": "studio", "seed": i, "seconds": i / 100, "signature": str(i % 60)} for i in range(100)
    ]
    records[7] = {**records[7], "faults": 2.0, "aspect": 9.0}
    records[8] = {**records[8], "relaxed": 1.0}
    (row,) = plan.rows(records[::-1], np.random.default_rng(0))
    assert row["flat"] == "studio" and row["plans"] == 100
    assert row["valid"] == row["nothing given up"] == pytest.approx(0.99)
    assert row["signatures"] == 40 and row["aspect p95"] == pytest.approx(1.5)
    assert row["CPU median"] == pytest.approx(0.495) and row["CPU p95"] == pytest.approx(0.9405)


def test_the_knob_is_set_and_seeds_are_shared(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[float, int, int]] = []
    monkeypatch.setattr(regularity, "record", lambda program, seed: asked.append(
        (program.regularity, len(program.rooms), seed)) or {})  # fmt: skip
    for setting in regularity.SETTINGS:
        regularity.trial(setting, 20, 4, None)  # type: ignore[arg-type]
    assert [knob for knob, _, _ in asked[::4]] == pytest.approx([0, 0.2, 0.4, 0.6, 0.8, 1.0])
    assert len({(rooms, seed) for _, rooms, seed in asked}) == 4

"""Floor plans from correct programmes: validity, fidelity, form and time over many seeds of eight common flats."""

from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

PAPER: list[dict[str, Any]] = []
NOTE = (
    "Each flat is a complete programme of studio to four bedrooms, 40 to 180 m², solved once a seed. `valid`: a judge "
    "of the finished geometry that shares nothing with the solver finds no fault. `aspect p95`: 95th percentile over "
    "plans of the longest living room, kitchen, dining room, bedroom or study, side over side. `corridor`: hallways' "
    "share of floor area. `signatures`: plans that differ in which rooms touch, of the first 40. CPU seconds are of "
    "the process, after start-up."
)
SETTINGS = [
    "studio", "one_bedroom", "one_bedroom_open", "two_bedroom", "two_bedroom_ensuite", "three_bedroom",
    "three_bedroom_study", "four_bedroom",
]  # fmt: skip
SCENES, CHUNK = 1000, 25
MEANS = ("S_edge", "S_constraint", "corridor")


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` plans of one flat, seeds in a row."""
    from apartgen.stages.plan import warm
    from apartgen.stages.plan.study import archetypes

    warm()
    program = archetypes()[setting]
    return [record(program, seed + i) for i in range(scenes)]


def record(program: Any, seed: int) -> dict[str, Any]:
    """Figures of the plan of one seed, with its CPU seconds and which rooms touch."""
    from apartgen.stages import plan
    from apartgen.stages.plan.study import measured
    from apartgen.stages.plan.variants import touching

    began = process_time()
    made = plan.build(program, plan.PlanConfig(processes=1), np.random.default_rng(seed))
    seconds = process_time() - began
    signature = " ".join(f"{a}+{b}" for a, b in sorted(touching(made)))
    return {"seed": seed, **measured(made), "seconds": seconds, "signature": signature}


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for each flat."""
    by_flat = {flat: [r for r in records if r["setting"] == flat] for flat in SETTINGS}
    return [{"flat": flat, "plans": len(mine), **summary(mine)} for flat, mine in by_flat.items() if mine]


def summary(records: list[dict[str, Any]]) -> dict[str, float]:
    """Shares, means and percentiles over plans."""
    first = [r["signature"] for r in sorted(records, key=lambda r: r["seed"])[:40]]
    seconds = [r["seconds"] for r in records]
    return {
        "valid": float(np.mean([r["faults"] == 0 for r in records])),
        "nothing given up": float(np.mean([r["relaxed"] == 0 for r in records])),
        **{name: float(np.mean([r[name] for r in records])) for name in MEANS},
        "aspect p95": float(np.quantile([r["aspect"] for r in records], 0.95)),
        "signatures": len(set(first)),
        "CPU median": float(np.median(seconds)),
        "CPU p95": float(np.quantile(seconds, 0.95)),
    }

"""The regularity knob of the plan solver: rectangularity of rooms over its range, at what area fidelity."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen_cli.bench.plan import record

PAPER: list[dict[str, Any]] = []
NOTE = (
    "A two-bedroom and a three-bedroom flat, the same seeds at every setting of the knob. `rectangular`: share of "
    "rooms but hallways that are rectangles; `S_constraint`: area fidelity (Eq. 7). Means with 95 % intervals."
)
SETTINGS = [f"{knob:.1f}" for knob in np.linspace(0, 1, 6)]
SCENES, CHUNK = 80, 20
FLATS = ("two_bedroom", "three_bedroom")


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` plans, of each flat in turn."""
    from apartgen.stages.plan.study import archetypes

    flats = [archetypes()[name].model_copy(update={"regularity": float(setting)}) for name in FLATS]
    return [record(flats[i % len(flats)], seed + i) for i in range(scenes)]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for each setting of the knob."""
    from apartgen_cli.bench import _scenes

    return _scenes.intervals(records, SETTINGS, ["rectangular", "S_constraint", "S_edge"], rng)


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Both over the knob, with their intervals."""
    knob = [float(r["setting"]) for r in rows]
    for name in ("rectangular", "S_constraint"):
        mean, low, high = np.array([r[name] for r in rows]).T
        axes.errorbar(knob, mean, (mean - low, high - mean), marker="o", capsize=3, label=name)
    axes.set(xlabel="regularity", ylim=(0, 1.03))
    axes.legend()

"""Figure 7: share of scenes whose walkable ratio reaches a threshold, with and without Algorithm 2."""

from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen_cli.bench import _scenes

THRESHOLDS = [0.60, 0.65, 0.70, 0.75, 0.80, 0.85, 0.90, 0.95]
PAPER: list[dict[str, Any]] = []
NOTE = (
    "A scene is one apartment; the ratio is of the whole free floor, footprints taken as a union. `unguided`: the "
    "diffusion model alone; `guided`: all guidance and projection; `walkable`: that and the walkable stage, asked for "
    "τ. Connected: a robot of 0.25 m radius gets from the entrance through every door to in front of all that opens, "
    "parts closed and open. Left out: objects an apartment that the stage dropped; shrunk: those it made smaller. "
    "Seconds of the stage alone, one core. The paper shows its curves without numbers; it is above its baseline "
    "at every threshold."
)
BASES = {"unguided": "no guidance", "guided": "all guidance + projection"}
SETTINGS = [*BASES, *(f"walkable {t:.2f}" for t in THRESHOLDS)]
SCENES, CHUNK = 100, 10


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` apartments, furnished alike for every threshold."""
    from apartgen.stages import retrieve, walkable
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.walkable.config import WalkableConfig

    homes = _scenes.placed(BASES.get(setting, BASES["guided"]), seed, scenes, work)
    target = 0.0 if setting in BASES else float(setting.split()[1])
    effort = {"connect": False, "drop": False, "unblock": False, "max_iterations": 0} if setting in BASES else {}
    config = WalkableConfig(target=target, write_anyway=True, **effort)
    library, out = retrieve.open_libraries(RetrieveConfig()), []
    for i, home in enumerate(homes):
        began = process_time()
        body = walkable.run(home, config, np.random.default_rng([seed, i]), library)
        took, report = process_time() - began, body.walkable
        out.append({
            "ratio": report.after,
            "connected": float(not (_unreached(body) if setting in BASES else report.unreached)),
            "left out": len(report.dropped),
            "shrunk": len(report.replaced),
            "objects": len(home.objects),
            "seconds": took,
        })
    return out


def _unreached(home: Layout) -> list[str]:
    from apartgen.stages.robot import reach

    return reach.survey(reach.space(home), home.objects).missed


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """SR(τ) of all, and what the stage did for it."""
    out = []
    for t in THRESHOLDS:
        names = {**{base: base for base in BASES}, "walkable": f"walkable {t:.2f}"}
        groups = {name: [r for r in records if r["setting"] == setting] for name, setting in names.items()}
        row: dict[str, Any] = {"threshold": t}
        row |= {f"SR, {name}": _scenes.mean([r["ratio"] >= t - 1e-6 for r in g], rng) for name, g in groups.items()}
        row |= {f"connected, {name}": _scenes.mean([r["connected"] for r in g], rng) for name, g in groups.items()}
        for name in ("left out", "shrunk", "seconds"):
            row[name] = round(float(np.mean([r[name] for r in groups["walkable"]])), 3)
        out.append({**row, "scenes": len(groups["walkable"])})
    return out


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """All curves over the threshold."""
    for name, color in (("unguided", "#0072B2"), ("guided", "#009E73"), ("walkable", "#E69F00")):
        value, low, high = np.array([row[f"SR, {name}"] for row in rows]).T
        axes.plot([row["threshold"] for row in rows], value, marker="o", color=color, label=name)
        axes.fill_between([row["threshold"] for row in rows], low, high, color=color, alpha=0.2)
    axes.set(xlabel="threshold τ", ylabel="SR(τ)", ylim=(-0.02, 1.04), xticks=THRESHOLDS)
    _scenes.tidy(axes)

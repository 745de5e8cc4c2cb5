"""Figure 7: share of scenes whose walkable ratio reaches a threshold, with and without Algorithm 2."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen_cli.bench import _scenes

THRESHOLDS = [0.60, 0.65, 0.70, 0.75, 0.80, 0.85, 0.90, 0.95]
PAPER: list[dict[str, Any]] = []
NOTE = (
    "A scene is one apartment; the ratio is of the whole free floor, footprints taken as a union. The paper shows its "
    "curves without numbers; it is above its baseline at every threshold."
)
SETTINGS = ["baseline", *(f"walkable {t:.2f}" for t in THRESHOLDS)]
SCENES, CHUNK = 100, 10


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` apartments, furnished alike in every setting."""
    from stages import retrieve, walkable
    from stages.retrieve.matching.config import RetrieveConfig
    from stages.walkable.config import WalkableConfig

    homes = _scenes.plans(seed, scenes, work)
    made = _scenes.furnished(homes, _scenes.config("all guidance + projection"), seed)
    placed = [_scenes.retrieved(home, seed) for home in made]
    target = 0.0 if setting == "baseline" else float(setting.split()[1])
    library, out = retrieve.open_libraries(RetrieveConfig()), []
    for i, home in enumerate(placed):
        settings = WalkableConfig(target=max(target, 0.01), write_anyway=True)
        report = walkable.run(home, settings, np.random.default_rng([seed, i]), library).walkable
        ratio = report.before if setting == "baseline" else report.after
        out.append({"ratio": ratio, "unreached": len(report.unreached)})
    return out


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """SR(τ) of both, and how many apartments keep something out of a robot's reach."""
    base = [r["ratio"] for r in records if r["setting"] == "baseline"]
    out = []
    for t in THRESHOLDS:
        mine = [r for r in records if r["setting"] == f"walkable {t:.2f}"]
        out.append(
            {
                "threshold": t,
                "SR, baseline": float(np.mean([r >= t for r in base])),
                "SR, walkable": float(np.mean([r["ratio"] >= t - 1e-6 for r in mine])),
                "connected": float(np.mean([r["unreached"] == 0 for r in mine])),
                "scenes": len(mine),
            }
        )
    return out


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Both curves over the threshold."""
    for name, color in (("SR, baseline", "tab:blue"), ("SR, walkable", "tab:orange")):
        axes.plot([r["threshold"] for r in rows], [r[name] for r in rows], marker="o", color=color, label=name)
    axes.set(xlabel="threshold τ", ylabel="SR(τ)", ylim=(-0.02, 1.03))
    axes.legend()

"""Layout ablation, with Table 5's figures: what each part of the method buys."""

from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from apartgen_cli.bench import _scenes
from schemas.errors import BadInput

PAPER = [
    {"setting": "neither", "Col_obj": 0.279, "R_reach": 0.742},
    {"setting": "articulation", "Col_obj": 0.267, "R_reach": 0.808},
    {"setting": "walkable", "Col_obj": 0.250, "R_reach": 0.782},
    {"setting": "both", "Col_obj": 0.249, "R_reach": 0.830},
]
NOTE = (
    "A scene is one room of a whole apartment. Boxes of the layout stage; `+ walkable` after retrieval and that "
    "stage. Figures as `ours`: contacts up to 1 cm deep or by design are none; `standing` is of what stands on the "
    "floor. Several training runs (--weights) give a row each below their common one. Seconds are of CPU, a room."
)
TAKES = ("weights",)
RUN = " · "
"""Between a setting and the name of the training run."""
SETTINGS = [*_scenes.METHODS, "all guidance + projection, ddpm 1000", "+ walkable"]
SCENES, CHUNK = 1000, 60
FIGURES = [
    "R_acoll/ours",
    "R_acoll/published",
    "Col_obj/ours",
    "Col_obj/published",
    "Col_scene/ours",
    "R_out/ours",
    "R_reach/ours",
    "R_reach/standing",
    "R_reach/published",
    "R_reach_front/ours",
    "R_blocked/ours",
    "seconds",
]
MEASURES = ["articulation", "collision", "outside", "reachable", "doorways"]


def settings(weights: list[str] | None = None) -> list[str]:
    """Every setting, with every training run that is given; BadInput where two go by the same name."""
    if weights and len({Path(file).stem for file in weights}) < len(weights):
        raise BadInput(f"--weights {' '.join(weights)}: the table tells runs apart by file name; rename one")
    return [f"{name}{RUN}{Path(file).stem}" for name in SETTINGS for file in weights] if weights else SETTINGS


def trial(
    setting: str, seed: int, scenes: int, work: Path, weights: list[str] | None = None
) -> list[dict[str, Any]]:
    """Rooms of `scenes` / 6 apartments."""
    from stages import retrieve, walkable
    from stages.retrieve.matching.config import RetrieveConfig
    from stages.walkable.config import WalkableConfig

    homes = _scenes.plans(seed, -(-scenes // 6), work)
    name, _, run = setting.partition(RUN)
    changes: dict[str, Any] = {"weights": next(f for f in weights if Path(f).stem == run)} if weights else {}
    if name.endswith("ddpm 1000") and name not in _scenes.METHODS:
        changes |= {"sampler": "ddpm", "steps": 1000}
    began = process_time()
    method = name if name in _scenes.METHODS else "all guidance + projection"
    made = _scenes.furnished(homes, _scenes.config(method, **changes), seed)
    if name == "+ walkable":
        library = retrieve.open_libraries(RetrieveConfig())
        rng = np.random.default_rng(seed)
        config = WalkableConfig(write_anyway=True)
        made = [walkable.run(_scenes.retrieved(home, seed), config, rng, library) for home in made]
    took = (process_time() - began) / sum(len(home.rooms) for home in homes)
    found = [{**record, "seconds": took} for home in made for record in _scenes.measured(home, MEASURES)]
    return found[:scenes]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """Means over scenes; over all training runs together, then of each."""
    named = list(dict.fromkeys(r["setting"] for r in records))
    if not any(RUN in name for name in named):
        return _scenes.intervals(records, named, FIGURES, rng)
    pooled = [{**r, "setting": r["setting"].partition(RUN)[0]} for r in records]
    out = []
    for whole in dict.fromkeys(r["setting"] for r in pooled):
        out += _scenes.intervals(pooled, [whole], FIGURES, rng)
        out += _scenes.intervals(records, [name for name in named if name.startswith(whole + RUN)], FIGURES, rng)
    return out


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Collisions and reach of every setting, with their intervals."""
    _scenes.bars(rows, ["Col_obj/ours", "R_acoll/ours", "R_reach/standing"], axes)

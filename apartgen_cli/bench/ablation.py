"""Layout ablation, with Table 5's figures: what each part of the method buys."""

from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from apartgen_cli.bench import _scenes

PAPER = [
    {"setting": "neither", "Col_obj": 0.279, "R_reach": 0.742},
    {"setting": "articulation", "Col_obj": 0.267, "R_reach": 0.808},
    {"setting": "walkable", "Col_obj": 0.250, "R_reach": 0.782},
    {"setting": "both", "Col_obj": 0.249, "R_reach": 0.830},
]
NOTE = (
    "A scene is one room of a whole apartment. Boxes of the layout stage; `+ walkable` after retrieval and that "
    "stage. Figures as `ours`: contacts up to 1 cm deep or by design are none."
)
SETTINGS = [*_scenes.METHODS, "all guidance + projection, ddpm 1000", "+ walkable"]
SCENES, CHUNK = 1000, 60
FIGURES = [
    "R_acoll/ours",
    "R_acoll/published",
    "Col_obj/ours",
    "R_out/ours",
    "R_reach/ours",
    "R_reach_front/ours",
    "R_blocked/ours",
    "seconds",
]
MEASURES = ["articulation", "collision", "outside", "reachable", "doorways"]


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """Rooms of `scenes` / 6 apartments."""
    from stages import retrieve, walkable
    from stages.retrieve.matching.config import RetrieveConfig
    from stages.walkable.config import WalkableConfig

    homes, method = _scenes.plans(seed, -(-scenes // 6), work), setting
    changes: dict[str, Any] = {}
    if setting.endswith("ddpm 1000"):
        method, changes = "all guidance + projection", {"sampler": "ddpm", "steps": 1000}
    began = perf_counter()
    made = _scenes.furnished(
        homes, _scenes.config("all guidance + projection" if setting == "+ walkable" else method, **changes), seed
    )
    if setting == "+ walkable":
        library = retrieve.open_libraries(RetrieveConfig())
        rng = np.random.default_rng(seed)
        settings = WalkableConfig(write_anyway=True)
        made = [walkable.run(_scenes.retrieved(home, seed), settings, rng, library) for home in made]
    took = (perf_counter() - began) / sum(len(home.rooms) for home in homes)
    found = [{**record, "seconds": took} for home in made for record in _scenes.measured(home, MEASURES)]
    return found[:scenes]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """Means over scenes."""
    return _scenes.intervals(records, SETTINGS, FIGURES, rng)

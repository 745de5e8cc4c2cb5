"""Tables 4 and 5: collisions of moving parts and reach, with and without articulated guidance and Algorithm 2."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen_cli.bench import _compared, _scenes
from apartgen_cli.bench._compared import REAL

ASSETS = ", assets"
PAPER = [
    {"setting": "no guidance", "table": 4, "R_acoll": 0.191, "R_reach": 0.742},
    {"setting": "articulation", "table": 4, "R_acoll": 0.109, "R_reach": 0.808},
    {"setting": f"no guidance{ASSETS}", "table": 5, "Col_obj": 0.279, "R_reach": 0.742},
    {"setting": f"articulation{ASSETS}", "table": 5, "Col_obj": 0.267, "R_reach": 0.808},
    {"setting": f"no guidance + walkable{ASSETS}", "table": 5, "Col_obj": 0.250, "R_reach": 0.782},
    {"setting": f"articulation + walkable{ASSETS}", "table": 5, "Col_obj": 0.249, "R_reach": 0.830},
]
NOTE = (
    "A scene is one room. `ours` leaves out contacts that belong to use (a chair at its desk), `published` counts all; "
    "contacts up to 1 cm deep are none. `standing` is of what stands on the floor. The layout stage's boxes, so that "
    "nothing but the sampler differs; with `assets` the objects retrieved, their own joints and sizes. `+ walkable` is "
    "Algorithm 2 alone in every room, τ = .70, but for the row with projection, which is the whole walkable stage. "
    "Guidance as Eq. 2 has it, with Σ over 1000 steps, is in the experiment `samplers`. `real against real` are the "
    "same floors furnished by the furnisher, which made the training data, with seeds that training did not use: what "
    "a figure is where nothing is left to learn."
)
ALGORITHM_2 = {"scope": "rooms", "connect": False, "drop": False, "unblock": False, "gentle": 0.0}
WALKABLE = {
    f"no guidance{ASSETS}": ("no guidance", None),
    f"articulation{ASSETS}": ("articulation", None),
    f"no guidance + walkable{ASSETS}": ("no guidance", ALGORITHM_2),
    f"articulation + walkable{ASSETS}": ("articulation", ALGORITHM_2),
    f"all guidance + projection + walkable{ASSETS}": ("all guidance + projection", {}),
}
"""Settings with assets: how they are furnished, and what the walkable stage is told; None leaves it out."""
SETTINGS = [*_scenes.METHODS, *WALKABLE, REAL, f"{REAL}{ASSETS}"]
SCENES, CHUNK = 100, 20
FIGURES = [
    "R_acoll/ours",
    "R_acoll/published",
    "R_acoll/physcene",
    "R_reach/ours",
    "R_reach/standing",
    "R_reach/published",
    "Col_obj/ours",
    "Col_obj/published",
    "R_out/ours",
]


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """Rooms of as many apartments as hold `scenes`, furnished under the setting and measured."""
    made = _made(setting, seed, _scenes.of_rooms(seed, scenes, work), work)
    measures = ["articulation", "reachable", "collision", "outside"]
    return [record for home in made for record in _scenes.measured(home, measures)][:scenes]


def _made(setting: str, seed: int, homes: list[Plan], work: Path) -> list[Layout]:
    if setting in WALKABLE:
        return _with_assets(setting, seed, len(homes), work)
    if setting in _scenes.METHODS:
        return _scenes.furnished(homes, _scenes.config(setting), seed)
    real = _compared.furnished(homes, seed, REAL)
    return [_scenes.retrieved(home, seed) for home in real] if setting.endswith(ASSETS) else real


def _with_assets(setting: str, seed: int, homes: int, work: Path) -> list[Layout]:
    from apartgen.stages import retrieve, walkable
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.walkable.config import WalkableConfig

    method, changes = WALKABLE[setting]
    placed = _scenes.placed(method, seed, homes, work)
    if changes is None:
        return list(placed)
    config, library = WalkableConfig(write_anyway=True, **changes), retrieve.open_libraries(RetrieveConfig())
    return [walkable.run(home, config, np.random.default_rng([seed, i]), library) for i, home in enumerate(placed)]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """Means over scenes; of shares of all objects, over these."""
    return _scenes.intervals(records, SETTINGS, FIGURES, rng)


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Collisions and reach of every setting, with their intervals and the paper's figures."""
    _scenes.bars(rows, ["R_acoll/ours", "Col_obj/ours", "R_reach/standing"], axes, PAPER)
    axes.set_ylim(0, 1.03)

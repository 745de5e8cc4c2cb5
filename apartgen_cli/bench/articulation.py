"""Table 4: collisions of moving parts and reach, with and without articulated guidance."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen_cli.bench import _scenes

PAPER = [
    {"setting": "baseline", "R_acoll": 0.191, "R_reach": 0.742},
    {"setting": "with guidance", "R_acoll": 0.109, "R_reach": 0.808},
]
NOTE = (
    "A scene is one room. `ours` leaves out contacts that belong to use (a chair at its desk), `published` counts all; "
    "contacts up to 1 cm deep are none. `standing` is of what stands on the floor. Boxes before retrieval, so that "
    "nothing but the sampler differs."
)
SETTINGS = list(_scenes.METHODS)
SCENES, CHUNK = 100, 20
FIGURES = [
    "R_acoll/ours",
    "R_acoll/published",
    "R_acoll/physcene",
    "R_reach/ours",
    "R_reach/standing",
    "R_reach/published",
    "Col_obj/ours",
    "R_out/ours",
]


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """Rooms of `scenes` / 6 apartments, furnished under the setting and measured."""
    homes = _scenes.plans(seed, -(-scenes // 6), work)
    made = _scenes.furnished(homes, _scenes.config(setting), seed)
    found = [
        record
        for home in made
        for record in _scenes.measured(home, ["articulation", "reachable", "collision", "outside"])
    ]
    return found[:scenes]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """Means over scenes."""
    return _scenes.intervals(records, SETTINGS, FIGURES, rng)


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """R_acoll and R_reach of every setting, with their intervals."""
    _scenes.bars(rows, ["R_acoll/ours", "R_reach/standing"], axes)
    for row, style in zip(PAPER, (":", "--"), strict=True):
        for name in ("R_acoll", "R_reach"):
            axes.axhline(row[name], color="k", linestyle=style, linewidth=0.8, label=f"paper, {row['setting']}, {name}")
    axes.legend(fontsize=7)

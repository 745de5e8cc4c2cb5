"""Few steps against a thousand: what faster samplers cost, and Eq. 2 with Σ as the paper writes it."""

from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from apartgen_cli.bench import _rooms, _scenes
from apartgen_cli.bench._compared import REAL, REFERENCE

PAPER: list[dict[str, Any]] = []
NOTE = (
    f"{_rooms.NOTE}. `no guidance`: the number exact by construction, nothing else steers; `articulation`: Eq. 4 alone "
    "acts; `all guidance`: articulation, inside and openings. `with Σ`: Eq. 2 as written, below 1 % of the schedule "
    "as in the paper's figure 4; elsewhere the gradient is PhyScene's, without Σ, below 20 %."
)
TAKES = ("weights",)
TABLES = _rooms.TABLES
SAMPLERS: dict[str, dict[str, Any]] = {
    "dpm++ 20": {"sampler": "dpm++", "steps": 20},
    "ddim 20": {"sampler": "ddim", "steps": 20},
    "ddim 50": {"sampler": "ddim", "steps": 50},
    "ddpm 1000": {"sampler": "ddpm", "steps": 1000},
}
GUIDED: dict[str, dict[str, Any]] = {
    "no guidance": {"guidance": {}},
    "articulation": {"guidance": {"articulation": 1.0}},
    "articulation with Σ": {
        "guidance": {"articulation": 1.0}, "scaling": "sigma", "guide_below": 0.01, "guidance_scale": 2000.0},
    "all guidance": {"guidance": _scenes.SPATIAL},
    "all + projection": {"guidance": _scenes.SPATIAL, "projection": True},
}
METHODS = [
    *(("no guidance", sampler) for sampler in SAMPLERS),
    ("articulation", "dpm++ 20"), ("articulation with Σ", "ddpm 1000"),
    ("all guidance", "dpm++ 20"), ("all guidance", "ddpm 1000"),
    ("all + projection", "dpm++ 20"), ("all + projection", "ddpm 1000"),
]
SETTINGS = [REFERENCE, REAL, *(f"{guidance}, {sampler}" for guidance, sampler in METHODS)]
SCENES, CHUNK = 100, 25


def trial(
    setting: str, seed: int, scenes: int, work: Path, weights: list[str] | None = None
) -> list[dict[str, Any]]:
    """Rooms of as many apartments as hold `scenes`."""
    if setting in (REFERENCE, REAL):
        return _rooms.records((_rooms.reference if setting == REFERENCE else _rooms.other)(seed, scenes, work))[:scenes]
    guidance, _, sampler = setting.partition(", ")
    changes = {"projection": False, "weights": weights[0] if weights else None} | GUIDED[guidance]
    plans = _rooms.plans(seed, scenes, work)
    began = process_time()
    made = _scenes.furnished(plans, _scenes.config_of(SAMPLERS[sampler] | changes), seed)
    took = (process_time() - began) / sum(len(plan.rooms) for plan in plans)
    return _rooms.records(made, took)[:scenes]


def used(setting: str, weights: list[str] | None = None) -> dict[str, Any]:
    """The weights, where anything is sampled."""
    return {"weights": weights} if weights and setting not in (REFERENCE, REAL) else {}


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for each sampler and guidance."""
    by = {name: [r for r in records if r["setting"] == name] for name in SETTINGS}
    return [_rooms.row(name, "", by[name], by[REFERENCE], rng) for name in SETTINGS if name != REFERENCE and by[name]]


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Collisions and reach of every setting, with their intervals."""
    _rooms.draw(rows, ["R_acoll/ours", "Col_obj/ours", "R_out/ours", "R_reach/standing"], axes)

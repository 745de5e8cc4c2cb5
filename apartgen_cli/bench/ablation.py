"""Layout ablation: what each part of the method buys, over training runs."""

from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen_cli.bench import _compared, _rooms, _scenes
from apartgen_cli.bench._compared import REAL, REFERENCE

PAPER = [
    {"setting": "neither", "Col_obj": 0.279, "R_reach": 0.742},
    {"setting": "articulation", "Col_obj": 0.267, "R_reach": 0.808},
    {"setting": "walkable", "Col_obj": 0.250, "R_reach": 0.782},
    {"setting": "both", "Col_obj": 0.249, "R_reach": 0.830},
]
NOTE = (
    f"{_rooms.NOTE}; where several training runs are given (--weights, any number of times), a setting's first row is "
    "their mean ± standard deviation. `anticipating` samples without guidance from weights trained by Eq. 1 "
    "(--anticipating, one for each of --weights: as many further steps with λΣg as those had without); `all` is "
    "articulation, inside and openings guidance with the number exact by construction, on anticipating weights where "
    "given, in eight gradient steps, or four where the projection follows. `3D-FRONT` (--real): real rooms themselves."
)
TAKES = ("weights", "anticipating", "real")
TABLES = _rooms.TABLES
PLAIN = {"projection": False}
METHODS: dict[str, dict[str, Any]] = {
    "no guidance": {"guidance": {}, "count": "free", **PLAIN},
    "quantity, Eq. 3": {"guidance": {}, "count": "guided", **PLAIN},
    "quantity, exact": {"guidance": {}, "count": "exact", **PLAIN},
    "articulation": {"guidance": {"articulation": 1.0}, "count": "free", **PLAIN},
    "anticipating": {"guidance": {}, "count": "free", **PLAIN},
    "all": {"guidance": _scenes.SPATIAL, "count": "exact", **PLAIN},
    "all + projection": {"guidance": _scenes.SPATIAL, "count": "exact"},
}
ANTICIPATING = ("anticipating", "all", "all + projection")
"""Sampled from weights trained by Eq. 1, where there are any."""
GIVEN = "3D-FRONT"
RUN = " · "
"""Between a setting and the name of the training run."""
SETTINGS = [REFERENCE, REAL, *METHODS]
SCENES, CHUNK = 1000, 50


def settings(
    weights: list[str] | None = None, anticipating: list[str] | None = None, real: str | None = None
) -> list[str]:
    """Every setting, with every training run that is given; BadInput where runs can't be told apart or paired."""
    if weights and len({Path(file).stem for file in weights}) < len(weights):
        raise BadInput(f"--weights {' '.join(weights)}: the table tells runs apart by file name; rename one")
    if anticipating and len(anticipating) != len(weights or []):
        raise BadInput(f"--anticipating: {len(anticipating)} files for {len(weights or [])} of --weights; "
                       "give the plain weights of each training run and its anticipating ones in the same order")
    methods = [name for name in METHODS if anticipating or name != "anticipating"]
    runs = [f"{name}{RUN}{Path(file).stem}" for name in methods for file in weights] if weights else methods
    return [REFERENCE, REAL, *([GIVEN] if real else []), *runs]


def used(
    setting: str, weights: list[str] | None = None, anticipating: list[str] | None = None, real: str | None = None
) -> dict[str, Any]:
    """The weights of the setting's run, or the real rooms."""
    name, _, run = setting.partition(RUN)
    if name == GIVEN:
        return {"real": real}
    if not run or not weights:
        return {}
    index = [Path(file).stem for file in weights].index(run)
    return {"weights": [(anticipating if anticipating and name in ANTICIPATING else weights)[index]]}


def trial(
    setting: str, seed: int, scenes: int, work: Path, weights: list[str] | None = None, real: str | None = None
) -> list[dict[str, Any]]:
    """Rooms of as many apartments as hold `scenes`."""
    name = setting.partition(RUN)[0]
    if name in (REFERENCE, REAL, GIVEN):
        homes = (_rooms.reference(seed, scenes, work) if name == REFERENCE
                 else _rooms.other(seed, scenes, work) if name == REAL
                 else _compared.real_rooms(str(real), seed, scenes))
        return _rooms.records(homes)[:scenes]
    plans = _rooms.plans(seed, scenes, work)
    changes: dict[str, Any] = {"weights": weights[0]} if weights else {}
    began = process_time()
    made = _scenes.furnished(plans, _scenes.config_of(METHODS[name] | changes), seed)
    took = (process_time() - began) / sum(len(plan.rooms) for plan in plans)
    return _rooms.records(made, took)[:scenes]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """Real rooms, then every setting: over all training runs together, then of each."""
    by = {name: [r for r in records if r["setting"] == name] for name in dict.fromkeys(r["setting"] for r in records)}
    against = by.pop(REFERENCE, [])
    out = [_rooms.row(name, "", by.pop(name), against if name == REAL else [], rng)
           for name in (GIVEN, REAL) if name in by]
    for row in out:
        row.pop("Q_ratio", None)  # nobody asked them for a number
    for whole in dict.fromkeys(name.partition(RUN)[0] for name in by):
        runs = [_rooms.row(whole, name.partition(RUN)[2] or "shipped", mine, against, rng)
                for name, mine in by.items() if name.partition(RUN)[0] == whole]
        out += [*([_rooms.scattered(runs, whole)] if len(runs) > 1 else []), *runs]
    return out


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Collisions and reach of every setting: a bar for all training runs, a point for each."""
    _rooms.draw(rows, ["R_acoll/ours", "Col_obj/ours", "R_out/ours", "R_reach/standing", "Q_ratio"], axes)

"""Realism: how near furnished rooms come to those of people, from the corpus to the finished home."""

from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from safetensors import safe_open

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen_cli.bench import _compared, _lived_in, _replaced, _scenes
from apartgen_cli.bench._lived_in import AGAIN, CORPUS, ON_REAL, OTHER, REAL, SEEN, Moves, Record
from apartgen_cli.bench._runner import SEEDS

PAPER: list[Record] = []
NOTE = (
    "A scene is an apartment that was never trained on. Columns go from the corpus (`corpus`: the furnisher, with "
    "seeds that training did not use; `corpus again`: the same floors once more; `floors of real rooms`: furnished by "
    "it, too) over samples as they come out of a "
    "model (`raw`; `guided`; `constrained`, where nothing follows) to what later steps make of them; `random places` "
    "are the same things put anywhere and settled by the same steps, which is what these do by themselves. `best of "
    "4`: each room chosen of four by the energy of docs/realism.md; `walkable`: that home after retrieval and the "
    "walkable stage. Relations are of things of kinds that the real rooms (--real) have, which lack doors and windows; "
    "shares, means, or medians where they are lengths. Faults: `use`, furniture of no use where it stands; `bodies`, "
    "what stands in something else or in a doorway; `neighbours`, doors and windows. Lacks: wishes of those who live "
    "there, as numbers and as cost. Moved: things that a step put elsewhere than where they were sampled. SCA, CKL: "
    "against as many rooms of one type of the corpus and of the real ones; 50 is best of SCA, and what it is of the "
    "corpus again or of other real rooms stands in their columns; `bare floors` are the same rooms without a thing in "
    "them, what their shapes alone tell. 95 % intervals by bootstrap over rooms."
)
TAKES = ("weights", "real")
SETTLED: dict[str, Any] = {"model": "diffusion", "projection": False, "guidance_repeats": 4}
"""As the projection gets its rooms."""
DRAWN: dict[str, Any] = {"model": "relations", "candidates": 1}
CANDIDATES = 4
METHODS: dict[str, dict[str, Any]] = {
    "relations, raw": DRAWN | {"constraints": False},
    "relations, constrained": DRAWN,
    "relations, best of 4": DRAWN | {"candidates": CANDIDATES},
    "relations, walkable": DRAWN | {"candidates": CANDIDATES},
    "relations, random places": DRAWN | {"places": "random"},
    "relations, random places, best of 4": DRAWN | {"places": "random", "candidates": CANDIDATES},
    "diffusion, raw": {"model": "diffusion", "projection": False, "guidance": {}},
    "diffusion, guided": SETTLED,
    "diffusion, projected": SETTLED,
    "diffusion, best of 4": SETTLED,
    "diffusion, walkable": SETTLED,
    "diffusion, random places": SETTLED,
    "diffusion, random places, best of 4": SETTLED,
    "diffusion, projected, no guidance": {"model": "diffusion", "projection": False, "guidance": {}},
}
SETTINGS = [CORPUS, AGAIN, *METHODS]
KNOWN = ["room", "figure", REAL, OTHER, CORPUS, AGAIN, ON_REAL]
TABLES = {f"{model.capitalize()} model": [*KNOWN, *(name for name in METHODS if name.startswith(model))]
          for model in ("relations", "diffusion")}
RUN = " · "
"""Between a setting and the name of the training run."""
ROOMS = 3
"""Real rooms for each apartment."""
SCENES, CHUNK = 200, 10


def settings(weights: list[str] | None = None, real: str | None = None) -> list[str]:
    """Every setting, of a model that weights are given of with every training run; real rooms where there are some."""
    runs = {path: (model_of(path), Path(path).stem) for path in weights or []}
    if len({stem for _, stem in runs.values()}) < len(runs):
        raise BadInput(f"--weights {' '.join(runs)}: the table tells runs apart by file name; rename one")
    rows = [row for name in METHODS for row in _with_runs(name, list(runs.values()))]
    return [*([REAL, OTHER, ON_REAL] if real else []), CORPUS, AGAIN, *rows]


def _with_runs(name: str, runs: list[tuple[str, str]]) -> list[str]:
    own = [f"{name}{RUN}{stem}" for model, stem in runs if name.startswith(model)]
    return own or [name]


def model_of(path: str) -> str:
    """Which of the two models a weights file is of."""
    with safe_open(path, "np") as file:
        return "relations" if "rank" in (file.metadata() or {}) else "diffusion"


def used(setting: str, weights: list[str] | None = None, real: str | None = None) -> dict[str, Any]:
    """The weights of the setting's run, and the real rooms, whose vocabulary all relations are of."""
    _, _, run = setting.partition(RUN)
    chosen = {"weights": [path for path in weights or [] if Path(path).stem == run]} if run else {}
    return chosen | ({"real": real} if real else {})


def trial(setting: str, seed: int, scenes: int, work: Path, weights: list[str] | None = None,
          real: str | None = None) -> list[Record]:
    """Rooms of `scenes` apartments."""
    name = setting.partition(RUN)[0]
    if name in (REAL, OTHER, ON_REAL):
        first = seed + (ROOMS - 1) * (seed % SEEDS)
        homes = _compared.real_rooms(str(real), first, ROOMS * scenes, name != REAL)
        if name == ON_REAL:
            homes = _compared.furnished([_compared.bare(home) for home in homes], seed, _compared.FURNISHER)
        return [record for home in homes for record in _lived_in.records(home, real, {}, alone=True)]
    plans = _scenes.plans(seed, scenes, work)
    if name in (CORPUS, AGAIN):
        homes = _compared.furnished(plans, seed, _compared.REFERENCE if name == CORPUS else _compared.REAL)
        return [record for home in homes for record in _lived_in.records(home, real, {})]
    changes = METHODS[name] | ({"weights": weights[0]} if weights else {})
    return [record for i, plan in enumerate(plans) for record in _made(name, plan, changes, seed + i, real)]


def _made(name: str, plan: Plan, changes: dict[str, Any], seed: int, real: str | None) -> list[Record]:
    model, _, row = name.partition(", ")
    began = process_time()
    home, moves = (_diffused if model == "diffusion" else _related)(row, plan, changes, seed)
    if row == "walkable":
        home, moves = _walkable(home, seed)
    took = (process_time() - began) / len(plan.rooms)
    return [record | {"seconds": took} for record in _lived_in.records(home, real, moves)]


def _related(row: str, plan: Plan, changes: dict[str, Any], seed: int) -> tuple[Layout, Moves]:
    """An apartment by the relations model, of which nothing is moved."""
    return _sampled(plan, changes, seed, 0), {}


def _diffused(row: str, plan: Plan, changes: dict[str, Any], seed: int) -> tuple[Layout, Moves]:
    """An apartment as a row of the diffusion model has it, and how far its things were moved, by room."""
    if row in ("raw", "guided"):
        return _sampled(plan, changes, seed, 0), {}
    chosen = "best of 4" in row or row == "walkable"
    made = []
    for k in range(CANDIDATES if chosen else 1):
        place = _replaced.anywhere(np.random.default_rng([seed, 8, k])) if "random" in row else None
        made.append(_replaced.projected(_sampled(plan, changes, seed, k), place))
    return (_replaced.chosen([home for home, _ in made]), {}) if chosen else made[0]


def _sampled(plan: Plan, changes: dict[str, Any], seed: int, candidate: int) -> Layout:
    from apartgen.stages import layout

    return layout.run(plan, _scenes.config_of(changes), np.random.default_rng([seed, 5, candidate]))


def _walkable(home: Layout, seed: int) -> tuple[Layout, Moves]:
    """The home after retrieval and the walkable stage, and how far that moved what stays."""
    from apartgen.stages import retrieve, walkable
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.walkable.config import WalkableConfig

    placed, library = _scenes.retrieved(home, seed), retrieve.open_libraries(RetrieveConfig())
    done = walkable.run(placed, WalkableConfig(write_anyway=True), np.random.default_rng([seed, 9]), library)
    before, moves = {o.id: o for o in placed.objects}, dict[str, list[float]]()
    for o in done.objects:
        if o.id in before:
            far = np.hypot(*np.subtract(o.center, before[o.id].center)[:2])
            moves.setdefault(o.room, []).append(round(float(far), 4))
    return done, moves


def rows(records: list[Record], rng: np.random.Generator) -> list[Record]:
    """A row a figure, a column a setting; over several training runs mean ± standard deviation, beside each run's."""
    return [_over_runs(row) for row in _lived_in.rows(records, rng)]


def _over_runs(row: Record) -> Record:
    runs: dict[str, list[Any]] = {}
    for column, value in row.items():
        runs.setdefault(column.partition(RUN)[0], []).append(value)
    out = {}
    for name, values in runs.items():
        several = [value[0] for value in values if isinstance(value, list)]
        out[name] = values[0] if len(values) == 1 else sum(values) if not several else [
            round(float(np.mean(several)), 5), round(float(np.std(several, ddof=1)), 5)]
    return out | {column: value for column, value in row.items() if RUN in column and len(
        runs[column.partition(RUN)[0]]) > 1}


def draw(rows: list[Record], axes: Any) -> None:
    """Faults of use in living rooms and bedrooms, a group of bars a setting."""
    found = {row["room"]: row for row in rows if row["figure"] == "faults, use" and row["room"] in SEEN}
    columns = dict.fromkeys(name for row in found.values() for name, value in row.items()
                            if isinstance(value, list) and len(value) == 3 and RUN not in name)
    bars = [{"setting": name, **{kind: row[name] for kind, row in found.items() if name in row}} for name in columns]
    if bars:
        _scenes.bars(bars, list(found), axes)
    axes.set(ylabel="faults of use a room")

"""Rooms of whole apartments, furnished under a setting, and all that ablations measure of each."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas import artifact
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan, Room
from apartgen.stages.layout.config import N_MAX
from apartgen.stages.metrics import relations
from apartgen.stages.space import polygons
from apartgen_cli.bench import _compared, _scenes
from apartgen_cli.bench._compared import REAL, REFERENCE

MEASURES = ["articulation", "collision", "outside", "reachable"]
FIGURES = [
    "R_acoll/ours", "R_acoll/published", "Col_obj/ours", "Col_obj/published", "Col_scene/ours", "R_out/ours",
    "R_out/published", "R_reach/ours", "R_reach/standing", "R_reach/published", "R_reach_front/ours", "Q_ratio",
    *relations.RELATIONS, "seconds",
]
LEAST = 20
"""Rooms a side below which a classifier is not asked."""
NAMES = ["setting", "run", "scenes"]
TABLES = {
    "Collisions": [*NAMES, *FIGURES[:7]],
    "Reach and count": [*NAMES, *FIGURES[7:12], "objects_a_room", "seconds"],
    "Realism": [*NAMES, "CKL", "SCA", "SCA_efflite0", *relations.RELATIONS[:-1]],
}
NOTE = (
    "A scene is one room of a whole apartment that was never trained on, asked to hold as many objects as its "
    "reference furnishing: the furnisher's, which made the training data, with seeds that training did not use. "
    "Q_ratio: rooms with exactly that number. Figures are of the layout stage's boxes; `ours` counts no contact up to "
    "1 cm deep or by design, `published` all pairs; R_reach/standing is of what stands on the floor. CKL and SCA "
    "compare with the reference furnishings, as many rooms a side; the row `real against real` is the furnisher "
    "again with other seeds. Seconds are of CPU, a room, sampling and projection alone. 95 % intervals by bootstrap"
)


def plans(seed: int, rooms: int, work: Path) -> list[Plan]:
    """Plans of so many rooms, each asked to hold as many objects as in its reference furnishing."""
    return [_compared.bare(home) for home in reference(seed, rooms, work)]


def reference(seed: int, rooms: int, work: Path) -> list[Layout]:
    """The reference furnishings of a trial's plans, which ask for as much as they hold; kept in `work`."""
    path = work / "reference" / f"{seed}-{rooms}.json"
    if path.exists():
        return [Layout.model_validate(row) for row in json.loads(path.read_text())]
    made = [_asking(home) for home in _compared.furnished(_scenes.of_rooms(seed, rooms, work), seed, REFERENCE)]
    path.parent.mkdir(parents=True, exist_ok=True)
    artifact.write(json.dumps([home.model_dump(mode="json") for home in made]), path)
    return made


def _asking(home: Layout) -> Layout:
    held = {room.id: min(len(objects), N_MAX) for room, objects in _compared.inside([home]) if objects}
    return home.model_copy(update={"program": home.program.model_copy(update={"counts": held})})


def other(seed: int, rooms: int, work: Path) -> list[Layout]:
    """The same floors furnished by the furnisher once more, freely."""
    asked = plans(seed, rooms, work)
    free = [plan.model_copy(update={"program": plan.program.model_copy(update={"counts": {}})}) for plan in asked]
    made = _compared.furnished(free, seed, REAL)
    return [home.model_copy(update={"program": plan.program}) for home, plan in zip(made, asked, strict=True)]


def records(homes: Sequence[Layout], seconds: float | None = None) -> list[dict[str, Any]]:
    """A record for every room that the programme asks for a number of objects in, or for all where it asks for none."""
    timed = {} if seconds is None else {"seconds": seconds}
    found = []
    for home in homes:
        count = home.program.counts
        rooms = [(room, objects) for room, objects in _compared.inside([home]) if not count or room.id in count]
        figures = _scenes.by_room(home, MEASURES)
        for (room, objects), look in zip(rooms, _compared.seen(rooms), strict=True):
            hit = {"Q_ratio": float(len(objects) == count[room.id])} if count else {}
            found.append(look | figures[room.id] | _realism(room, objects) | hit | timed)
    return found


def _realism(room: Room, objects: Sequence[Box]) -> dict[str, list[float]]:
    """How people furnish: (mean, how many) of each relation that the room has any case of."""
    sample = relations.of_room(polygons.floor(room), objects)
    return {name: [float(np.mean(found)), len(found)] for name, found in sample.items() if found}


def row(setting: str, run: str, mine: list[dict[str, Any]], against: list[dict[str, Any]],
        rng: np.random.Generator) -> dict[str, Any]:
    """All figures of a setting in a training run, with their intervals."""
    (found,) = _scenes.intervals(mine, [mine[0]["setting"]], FIGURES, rng)
    n = min(len(mine), len(against))
    apart = _compared.apart(mine[:n], against[:n], rng, ("SCA", "CKL")) if n >= LEAST else {}
    return {**found, "setting": setting, "run": run, **apart}


def scattered(runs: list[dict[str, Any]], setting: str) -> dict[str, Any]:
    """Mean over training runs of every figure, with the standard deviation over them."""
    out: dict[str, Any] = {"setting": setting, "run": f"mean of {len(runs)}", "scenes": runs[0]["scenes"]}
    for name in runs[0]:
        if name not in out and all(name in run for run in runs):
            values = [run[name][0] for run in runs]
            out[name] = [round(float(np.mean(values)), 6), round(float(np.std(values, ddof=1)), 6)]
    return out



def draw(rows: list[dict[str, Any]], names: list[str], axes: Any) -> None:
    """Groups of bars, a group a setting, a bar a figure, each with its interval or a point for each training run."""
    settings = list(dict.fromkeys(row["setting"] for row in rows))
    width = 0.84 / len(names)
    for k, (name, colour) in enumerate(zip(names, _scenes.COLOURS)):
        there = [(i, [row[name] for row in rows if row["setting"] == setting and name in row])
                 for i, setting in enumerate(settings)]
        for i, (first, *runs) in [(i, found) for i, found in there if found]:
            at = i + (k - (len(names) - 1) / 2) * width
            axes.bar(at, first[0], width * 0.92, color=colour)
            axes.plot([at] * len(runs), [run[0] for run in runs], ".", color="0.15", markersize=3)
            if len(first) == 3:
                axes.plot([at, at], first[1:], color="0.15", linewidth=0.8)
        axes.bar(0, 0, color=colour, label=name.partition("/")[0])
    axes.set_xticks(range(len(settings)), _scenes.labels(settings), fontsize=7)
    axes.set_ylim(0, 1.02)
    _scenes.tidy(axes)

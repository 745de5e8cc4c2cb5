"""Scenes that experiments share: plans of the eight archetypes, furnished under a named setting."""

import json
import zlib
from collections.abc import Iterable
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np

from apartgen.schemas import artifact
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen.schemas.retrieve import Retrieve
from apartgen.stages.layout.config import LayoutConfig

SPATIAL = {"articulation": 1.0, "inside": 1.0, "openings": 1.0}
BARE: dict[str, Any] = {"guidance": {}, "projection": False}
METHODS: dict[str, dict[str, Any]] = {
    "no guidance": BARE,
    "articulation": {"guidance": {"articulation": 1.0}, "projection": False},
    "all guidance": {"guidance": SPATIAL, "projection": False},
    "all guidance + projection": {"guidance": SPATIAL},
}
"""Layout settings by the names used in tables."""


def plans(seed: int, n: int, work: Path) -> list[Plan]:
    """`n` plans, archetypes in turn; kept in `work`, so that every setting furnishes the same ones."""
    return [_plan(seed + i, work / "plans") for i in range(n)]


def _plan(seed: int, folder: Path) -> Plan:
    from apartgen.stages import plan
    from apartgen.stages.plan.config import PlanConfig
    from apartgen.stages.plan.study import archetypes

    path = folder / f"{seed}.json"
    if path.exists():
        return Plan.model_validate_json(path.read_text())
    programs = list(archetypes().values())
    made = plan.build(programs[seed % len(programs)], PlanConfig(processes=1), np.random.default_rng([seed, 77]))
    folder.mkdir(parents=True, exist_ok=True)
    artifact.write(made.model_dump_json(), path)
    return made


def of_rooms(seed: int, rooms: int, work: Path) -> list[Plan]:
    """Plans as in `plans`, as many as hold at least so many rooms."""
    made: list[Plan] = []
    while sum(len(plan.rooms) for plan in made) < rooms:
        made.append(_plan(seed + len(made), work / "plans"))
    return made


def area(polygon: list[tuple[float, float]]) -> float:
    """Area of a counter-clockwise polygon, m²."""
    x, y = np.array(polygon).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def config(method: str, **changes: Any) -> LayoutConfig:
    """The layout settings of a method; one core, because trials run side by side."""
    return config_of(METHODS[method] | changes)


def config_of(changes: dict[str, Any]) -> LayoutConfig:
    """Layout settings that differ so from the default."""
    return LayoutConfig(**({"threads": 1, "model": "diffusion"} | changes))


def furnished(homes: list[Plan], settings: LayoutConfig, seed: int) -> list[Layout]:
    """The plans furnished; the same seeds in every setting."""
    from apartgen.stages import layout

    return list(layout.run_many(homes, settings, [np.random.default_rng([seed, i, 5]) for i in range(len(homes))]))


def retrieved(home: Layout, seed: int) -> Retrieve:
    """With assets of the embedded library."""
    from apartgen.stages import retrieve
    from apartgen.stages.retrieve.matching.config import RetrieveConfig

    return retrieve.run(home, RetrieveConfig(), np.random.default_rng([seed, 6]))


def placed(method: str, seed: int, n: int, work: Path) -> list[Retrieve]:
    """`n` apartments furnished by a method and retrieved; kept in `work`, for settings that start from the same."""
    from apartgen.stages import layout

    weights = zlib.crc32(Path(layout.__file__).with_name("weights.safetensors").read_bytes())
    path = work / "placed" / f"{method.replace(' ', '-')}-{weights:08x}-{seed}-{n}.json"
    if path.exists():
        return [Retrieve.model_validate(row) for row in json.loads(path.read_text())]
    made = [retrieved(home, seed) for home in furnished(plans(seed, n, work), config(method), seed)]
    path.parent.mkdir(parents=True, exist_ok=True)
    artifact.write(json.dumps([home.model_dump(mode="json") for home in made]), path)
    return made


def measured(home: Layout, names: list[str]) -> list[dict[str, Any]]:
    """One record a room that has any figure, with `of` the room's type."""
    types = {room.id: room.base for room in home.rooms}
    return [{"of": types[room], **found} for room, found in by_room(home, names).items() if found]


def by_room(home: Layout, names: list[str]) -> dict[str, dict[str, Any]]:
    """Figures as "name/version" by room id.

    Shares of all objects come as (share, objects), so that `mean` is over objects; other figures are of scenes.
    """
    from apartgen.stages import metrics
    from apartgen.stages.metrics._table import POOLED

    rooms: dict[str, dict[str, Any]] = {room.id: {} for room in home.rooms}
    for value in metrics.run(home, names).values:
        if value.of in rooms and value.value is not None:
            pooled = value.name in POOLED and value.n is not None
            rooms[value.of][f"{value.name}/{value.version}"] = [value.value, value.n] if pooled else value.value
    return rooms


def intervals(
    records: Iterable[dict[str, Any]], settings: Iterable[str], names: list[str], rng: np.random.Generator
) -> list[dict[str, Any]]:
    """A row a setting: n, and mean with a 95 % bootstrap interval over scenes of every figure."""
    found, out = list(records), []
    for setting in settings:
        mine = [r for r in found if r["setting"] == setting]
        row: dict[str, Any] = {"setting": setting, "scenes": len(mine)}
        for name in names:
            values = [r[name] for r in mine if name in r]
            if values:
                row[name] = mean(values, rng)
        out.append(row)
    return out


def mean(values: Iterable[float | list[float]], rng: np.random.Generator) -> list[float]:
    """Mean of values, or of [value, weight], with the ends of its 95 % bootstrap interval over them."""
    from apartgen.stages.metrics._table import interval

    pairs = [(float(v[0]), float(v[1])) if isinstance(v, list) else (float(v), 1.0) for v in values]
    return [round(v, 5) for v in interval(np.array(pairs), rng)]


COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
"""Told apart by the colour-blind, too (Okabe and Ito)."""


def labels(settings: list[str]) -> list[str]:
    """Names in lines short enough to stand side by side."""
    return [fill(setting, max(9, 110 // len(settings)), break_long_words=False) for setting in settings]


def tidy(axes: Any) -> None:
    """A light grid behind, no box, the legend above."""
    axes.grid(axis="y", alpha=0.3)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(ncols=6, fontsize=8, frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0))


def bars(
    rows: list[dict[str, Any]], names: list[str], axes: Any, paper: Iterable[dict[str, Any]] = ()
) -> None:
    """Figures of `intervals` as groups of bars, a group a setting; what the paper has of a setting as diamonds."""
    place = {row["setting"]: i for i, row in enumerate(rows)}
    width = 0.8 / len(names)
    for k, name in enumerate(names):
        mine = [(i, row[name]) for i, row in enumerate(rows) if name in row]
        value, low, high = np.array([found for _, found in mine]).T
        at = np.array([i for i, _ in mine]) + (k - (len(names) - 1) / 2) * width
        axes.bar(at, value, width * 0.92, color=COLOURS[k % len(COLOURS)], label=name.partition("/")[0])
        axes.vlines(at, low, high, color="0.15", linewidth=0.8)
        theirs = [(place[row["setting"]] + (k - (len(names) - 1) / 2) * width, row[figure])
                  for row in paper if (figure := name.partition("/")[0]) in row and row["setting"] in place]
        if theirs:
            axes.plot(*zip(*theirs), "D", color="white", markeredgecolor="0.15", markersize=4,
                      label=None if k else "the paper")
    axes.set_xticks(range(len(rows)), labels([row["setting"] for row in rows]), fontsize=7)
    tidy(axes)

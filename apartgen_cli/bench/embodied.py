"""Table 6: a robot in physics drives to an object of every room and opens everything that opens."""

import gc
import json
import os
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import ValidationError

from apartgen import __version__
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen.schemas.errors import BadInput
from apartgen.schemas.migrations import VERSION
from apartgen.schemas.retrieve import Retrieve
from apartgen_cli.bench import _scenes
from apartgen_cli.streams import made_folder

if TYPE_CHECKING:
    from apartgen.stages.embodied.lerobot import Half
    from apartgen.stages.embodied.outcome import Outcome
    from apartgen.stages.embodied.world import World
    from apartgen.stages.retrieve.matching.libraries import LibrarySet
    from apartgen.stages.scene.scene import Scene

PAPER = [
    {"setting": "no guidance", "SR_nav": 0.952, "SR_interact": 0.947},
    {"setting": "guided", "SR_nav": 0.998, "SR_interact": 0.992},
]
NOTE = (
    "Without guidance: furnished by the diffusion model alone, no projection, no walkable stage. Guided: all guidance, "
    "projection and the walkable stage. The exported MJCF is simulated in MuJoCo; the paper uses Isaac Sim. "
    "Navigation: a base of 0.25 m radius drives from the entrance to an object drawn in every room, of those that open "
    "or that it gets to; success is to stop within 0.25 m, in time, with no push above 15 N. Interaction: the base "
    "drives from the entrance to every object and parks; an arm that meets nothing opens every joint to 80 % of its "
    "range, against friction. SPL is 0 where an episode fails. CPU "
    "seconds of navigation include the export."
)
METHOD = {"no guidance": "no guidance", "guided": "all guidance + projection"}
SETTINGS = list(METHOD)
SCENES, CHUNK = 1000, 10
FAILURES = ("blocked part", "no standing room", "planner", "controller")
HOMES = "homes"
BY_CATEGORY = "by category"
TABLES = {
    "Measured": [
        "setting", "apartments", "SR_nav", "SPL", "touches", "nav CPU s an apartment",
        *(f"nav, {kind}" for kind in FAILURES), "nav episodes", "SR_interact", "interact CPU s an apartment",
        *(f"interact, {kind}" for kind in FAILURES), "interact episodes",
    ],
    "Interaction by category": [
        "category",
        *(f"{setting}, {what}" for setting in METHOD for what in ("episodes", "SR_interact", "most failures")),
    ],
}


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """Every episode of `scenes` apartments, which are kept in `work` to be replayed."""
    found = []
    for i, home in enumerate(_apartments(setting, seed, scenes, work)):
        name = f"{setting.replace(' ', '-')}-{seed + i}"
        artifact.write(_kept(home, setting, seed + i), work / HOMES / f"{name}.json")
        found += _episodes(home, name)
    return found


def _kept(home: Retrieve, setting: str, seed: int) -> str:
    """The apartment as an artifact; numbers in full, so that a replay meets the very same apartment."""
    made = Made(by=f"apartgen {__version__}", seed=seed, config={"experiment": "embodied", "setting": setting})
    body = home.model_dump(mode="json", by_alias=True, exclude={"objects": {"__all__": {"latent"}}})
    record = {"apartgen": artifact.kind_of(home), "version": VERSION, "made": made.model_dump(mode="json")}
    return json.dumps(record | {"body": body}) + "\n"


def _read(path: Path) -> Retrieve:
    """An apartment of an earlier run; older runs kept the body alone."""
    raw = artifact.json_value(artifact.contents(path), str(path))
    if isinstance(raw, dict) and "apartgen" not in raw:
        try:
            return Retrieve.model_validate(raw)
        except ValidationError as error:
            raise BadInput(f"{path}: {artifact.first_fault(error)}; run the experiment again") from None
    return artifact.read(path, Retrieve).body


def _apartments(setting: str, seed: int, scenes: int, work: Path) -> Iterator[Retrieve]:
    from apartgen.stages import walkable
    from apartgen.stages.walkable.config import WalkableConfig

    homes = _scenes.plans(seed, scenes, work)
    (work / HOMES).mkdir(parents=True, exist_ok=True)
    gc.freeze()  # what was imported stays; looking through it again costs a tenth of a second an apartment
    for i, home in enumerate(_scenes.furnished(homes, _scenes.config(METHOD[setting]), seed)):
        placed = _scenes.retrieved(home, seed)
        if setting == "guided":
            rng = np.random.default_rng([seed, i])
            placed = walkable.run(placed, WalkableConfig(write_anyway=True), rng, _library())
        yield placed


def _episodes(home: Retrieve, name: str) -> list[dict[str, Any]]:
    """Records of all episodes of an apartment, of both halves; the export counts to navigation."""
    began = process_time()
    with _exported(home, bare=True) as (scene, mjcf):
        found = []
        apartment = simulated(scene, mjcf, name)
        for half in (_navigation, _interaction):
            outcomes = half(apartment, None)
            took = round((process_time() - began) / max(1, len(outcomes)), 3)
            found += [{"id": o.id, **o.model_dump(exclude={"trace", "course"}), "cpu_seconds": took} for o in outcomes]
            began = process_time()
    return found


def simulated(scene: "Scene", mjcf: Path, name: str) -> "World":
    """The apartment with the base in it, nothing else free to move."""
    from apartgen.stages.embodied import base, world

    return world.build(scene, mjcf, base.mjcf(), moving=(), fused=True, name=name)


def _navigation(apartment: "World", only: str | None) -> "list[Outcome]":
    from apartgen.stages.embodied import navigate

    return navigate.run(apartment, lane(apartment.name), only)


def _interaction(apartment: "World", only: str | None) -> "list[Outcome]":
    from apartgen.stages.embodied import interact

    return interact.run(apartment, only)


def lane(name: str) -> np.random.Generator:
    """Chance of what an apartment's robot is sent to: the same in every setting."""
    return np.random.default_rng([int(name.rpartition("-")[2]), 8])


@cache
def _library() -> "LibrarySet":
    """The asset library; what the walkable stage has taken from it is still at hand for the export."""
    from apartgen.stages import retrieve
    from apartgen.stages.retrieve.matching.config import RetrieveConfig

    return retrieve.open_libraries(RetrieveConfig())


@contextmanager
def _exported(home: Retrieve, bare: bool = False) -> "Iterator[tuple[Scene, Path]]":
    """The scene, and its MJCF for as long as it is needed; `bare` leaves out what only shows."""
    from apartgen.stages.export import mjcf as exporter
    from apartgen.stages.scene.scene import Scene

    scene = Scene(home, _library().load_asset, shown=not bare)
    with TemporaryDirectory() as folder:
        exporter.write(scene, Path(folder))
        yield scene, Path(folder) / "mjcf" / "apartment.xml"


def replay(out: Path, id: str) -> list[Path]:
    """Run one episode of an earlier run again and show it as a GIF and its end as a PNG, in `out`/replays.

    BadInput for an episode that is not there, and where MuJoCo can't draw.
    """
    name, kind, thing, *joint = id.split(":") if id.count(":") in (2, 3) else ("", "", "")
    path = out / HOMES / f"{name}.json"
    if kind not in ("navigation", "interaction") or not path.exists() or not name.rpartition("-")[2].isdecimal():
        raise BadInput(f"--replay {id}: no such episode in {out / HOMES}; give an id of {out / 'trials.jsonl'}")
    home, shown = _read(path), _replays()
    target = made_folder(str(out / "replays")) / f"{id.replace(':', '-')}.gif"
    from apartgen.stages.embodied import base, interact

    half, robot = (_navigation, base.mjcf()) if kind == "navigation" else (_interaction, interact.robot.mjcf())
    with _exported(home) as (scene, mjcf):
        apartment = simulated(scene, mjcf, name)
        found = [o for o in half(apartment, thing) if o.id == id]
        if not found:
            raise BadInput(f"--replay {id}: {name} has no such episode; ids are in {out / 'trials.jsonl'}")
        files: list[Path] = shown.save(shown.images(apartment, robot, found[0]), target, found[0])
        return files


def lerobot(out: Path, folder: Path) -> list[Path]:
    """Run all episodes of an earlier run's apartments again and keep those that succeed as data sets to learn from."""
    from apartgen_cli.bench._demonstrations import demonstrated

    files = sorted((out / HOMES).glob("*.json"))
    if not files:
        raise BadInput(f"--lerobot: no apartments in {out / HOMES}; run `apartgen bench embodied -o {out}`")
    return demonstrated((run for file in files for run in _runs(file)), folder)


def _runs(file: Path) -> "Iterator[tuple[World, Half, list[Outcome]]]":
    """The episodes of both halves of a kept apartment."""
    with _exported(_read(file), bare=True) as (scene, mjcf):
        apartment = simulated(scene, mjcf, file.stem)
        yield apartment, "navigation", _navigation(apartment, None)
        yield apartment, "interaction", _interaction(apartment, None)


def _replays() -> ModuleType:
    """The module that draws; BadInput where MuJoCo can't."""
    if sys.platform == "linux":
        # Without a display, MuJoCo must be told before it is imported.
        os.environ.setdefault("MUJOCO_GL", "egl")
    try:
        from apartgen.stages.embodied import replay as shown

        shown.ready()
    except (ImportError, AttributeError, OSError, RuntimeError) as error:  # each in its way
        used = os.environ.get("MUJOCO_GL", "")
        raise BadInput(f"MuJoCo can't draw with MUJOCO_GL={used} ({error}); set MUJOCO_GL=egl, which needs no display "
                       "but a driver with EGL (Debian: libegl1)") from None
    return shown


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row a setting: success and SPL with 95 % intervals over apartments, and why the rest failed.

    Then a row a category that opens, with both settings' share of parts opened.
    """
    found = [_row(setting, [r for r in records if r["setting"] == setting], rng) for setting in SETTINGS]
    opened = [r for r in records if r["episode"] == "interaction"]
    kinds = sorted({r["category"] for r in opened})
    return found + [_kind(kind, [r for r in opened if r["category"] == kind], rng) for kind in kinds]


def _kind(category: str, mine: list[dict[str, Any]], rng: np.random.Generator) -> dict[str, Any]:
    """Success of all episodes with a category, and what they failed by most often, by setting."""
    row: dict[str, Any] = {"setting": BY_CATEGORY, "category": category}
    for setting in SETTINGS:
        those = [r for r in mine if r["setting"] == setting]
        if not those:
            continue
        row[f"{setting}, episodes"] = len(those)
        row[f"{setting}, SR_interact"] = _share(those, lambda r: float(r["success"]), rng)
        if failed := Counter(r["failure"] for r in those if not r["success"]):
            worst = max(FAILURES, key=lambda kind: failed[kind])
            row[f"{setting}, most failures"] = f"{worst} ({failed[worst]})"
    return row


def _row(setting: str, mine: list[dict[str, Any]], rng: np.random.Generator) -> dict[str, Any]:
    row: dict[str, Any] = {"setting": setting, "apartments": len({r["apartment"] for r in mine})}
    for episode, name in (("navigation", "nav"), ("interaction", "interact")):
        those = [r for r in mine if r["episode"] == episode]
        if not those:
            continue
        row[f"SR_{name}"] = _share(those, lambda r: float(r["success"]), rng)
        if episode == "navigation":
            row["SPL"] = _share(those, lambda r: r["numbers"]["spl"], rng)
            row["touches"] = float(np.mean([r["numbers"].get("touches", 0.0) for r in those]))
        row[f"{name} CPU s an apartment"] = sum(r["cpu_seconds"] for r in those) / row["apartments"]
        failed = Counter(r["failure"] for r in those if not r["success"])
        row |= {f"{name}, {kind}": failed[kind] / len(those) for kind in FAILURES if failed[kind]}
        row[f"{name} episodes"] = len(those)
    return row


def _share(records: list[dict[str, Any]], value: Any, rng: np.random.Generator) -> list[float]:
    """Mean over episodes with a 95 % bootstrap interval over apartments."""
    from apartgen.stages.metrics._table import interval

    by: dict[str, list[float]] = {}
    for r in records:
        by.setdefault(r["apartment"], []).append(float(value(r)))
    pairs = np.array([(float(np.mean(v)), float(len(v))) for v in by.values()])
    return [round(v, 5) for v in interval(pairs, rng)]


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Success of both settings beside the paper's."""
    rows = [row for row in rows if row["setting"] in SETTINGS]
    names = [name for name in ("SR_nav", "SR_interact") if any(name in row for row in rows)]
    at = np.arange(len(names))
    for k, (row, paper) in enumerate(zip(rows, PAPER, strict=True)):
        shares = np.array([row.get(name, [np.nan] * 3) for name in names])
        spread = np.abs(shares[:, 1:] - shares[:, :1]).T
        axes.bar(at + 0.3 * (k - 0.5), shares[:, 0], 0.28, yerr=spread, capsize=3, label=row["setting"])
        marks = [paper[name] for name in names]
        axes.plot(at + 0.3 * (k - 0.5), marks, "k_", ms=24, label="paper" if k == 0 else None)
    axes.set(xticks=at, xticklabels=names, ylim=(0, 1.05), ylabel="success rate")
    axes.legend(loc="upper center")

"""A whole apartment from a sentence: every stage in turn, going on where an earlier run was stopped."""

import importlib
import os
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

from apartgen.kept import kept
from apartgen.outputs import ExportSettings, MetricsSettings, finished, intact, measure, principal
from apartgen.planning import PlanSettings
from apartgen.planning import draw as draw_plan
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact, Made
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import without_things
from apartgen.stages.aside import aside
from apartgen.steps import LAYOUT, STEPS, WALKABLE, Step, lane, made

KINDS: dict[str, type[Record]] = {
    "plan": PlanSettings, **{step.word: step.config for step in STEPS},
    "metrics": MetricsSettings, "export": ExportSettings,
}
"""The settings of every stage."""
SCENE = "scene"
"""The folder of exported files."""
DEFAULT_FORMATS = ("glb", "mjcf", "svg", "png")
PICTURES = (".svg", ".png")
Drawn = tuple[Plan, dict[str, Any]]
"""A plan, and what a language model took to read its prompt."""
_FURNISHES = "apartgen.stages.layout.relations.home"


def make(prompt: str, folder: Path, seed: int, settings: dict[str, Record], id: str = "") -> Iterator[Path]:
    """Every stage that there are settings for in turn; yields each file, made now or found as an earlier run left it,
    the pictures last. The plan draws by the id, where there is one, else by the prompt's words.

    Raises Unmet at the end where the walkable target was missed and the home asked for all the same.
    """
    home = _planned(prompt, settings["plan"], seed, folder, id, LAYOUT.word in settings)
    yield folder / "plan.json"
    for stage in (stage for stage in STEPS if stage.word in settings):
        home = _advanced(stage, home, settings[stage.word], seed, folder)
        yield folder / f"{stage.word}.json"
    _measured(home, settings["metrics"], seed, folder)
    yield folder / "metrics.json"
    files = _exported(home, settings["export"], seed, folder / SCENE)
    yield from sorted(files, key=lambda file: file.suffix in PICTURES and 1 + PICTURES.index(file.suffix))
    if short := WALKABLE.missed(without_things(home.body), settings["walkable"]):
        raise short


def _saved(body: Record, wanted: Made, began: float, file: Path) -> Artifact[Any]:
    text, settled = artifact.finish(body, wanted.model_copy(update={"seconds": round(perf_counter() - began, 2)}))
    artifact.write(text, file)
    return settled


def _planned(prompt: str, config: Any, seed: int, folder: Path, id: str, furnished: bool) -> Artifact[Any]:
    wanted, began = made("plan", seed, config).model_copy(update={"id": id}), perf_counter()
    old = kept(folder / "plan.json", "plan", wanted)
    if old is not None and old.body.prompt == prompt:
        return old
    draw = partial(draw_plan, prompt, config, seed, id)
    drawn, used = _drawn_aside(draw) if furnished and _FURNISHES not in sys.modules and os.cpu_count() != 1 else draw()
    return _saved(drawn, wanted.model_copy(update={"model": used}), began, folder / "plan.json")


def _drawn_aside(draw: Callable[[], Drawn]) -> Drawn:
    """What a second process draws, while this one loads what is to furnish it: each takes a second."""
    with aside(draw) as plan:
        importlib.import_module(_FURNISHES)
        return plan()


def _advanced(stage: Step, previous: Artifact[Any], config: Record, seed: int, folder: Path) -> Artifact[Any]:
    file, began = folder / f"{stage.word}.json", perf_counter()
    wanted = made(stage.word, seed, config, previous, data=stage.data(config))
    old = kept(file, stage.word, wanted)
    if old is not None:
        return old
    body = stage.taken(previous).body
    outcome = next(iter(stage.advance([body], config, [lane(seed, stage.word, body)])))
    if isinstance(outcome, ApartgenError):
        raise outcome
    return _saved(outcome, wanted, began, file)


def _exported(home: Artifact[Any], settings: Any, seed: int, scene: Path) -> list[Path]:
    """The main file of every format."""
    files = intact(home, settings, scene, seed) or finished(home, settings, scene, seed)
    return [scene / path for path in principal(files)]


def _measured(home: Artifact[Any], settings: Any, seed: int, folder: Path) -> None:
    wanted, began = made("metrics", seed, settings, home), perf_counter()
    if kept(folder / "metrics.json", "metrics", wanted) is None:
        _saved(measure(home.body, settings), wanted, began, folder / "metrics.json")

"""Run an experiment: the paper's tables and figures, measured anew.

Each public module here is one: `PAPER`, what the paper reports · `NOTE`, how ours differs · `SETTINGS`, names of what
is compared · `SCENES`, scenes a setting by default · `CHUNK`, scenes a trial · `trial(setting, seed, scenes, work)`,
records of one trial · `rows(records, rng)`, the table · optionally `draw(rows, axes)`, the figure · `TABLES`, columns
by title, where one table would be too wide.

An experiment may take files (`TAKES`, of `weights`, `anticipating`, `inception_weights`, `real`), which its trials get
by name when they are given; `settings(**given)` stands in for `SETTINGS` where there is one, and `used(setting,
**given)` says which of the files a setting's trials depend on, where not on all.
"""

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Annotated, Any

import typer

from apartgen.schemas.errors import BadInput
from apartgen.stages import registry
from apartgen_cli.console import say

NAME = Annotated[str, typer.Argument(metavar="EXPERIMENT", help="Which; none given lists them.")]
OUT = Annotated[Path | None, typer.Option("--out", "-o", help="Folder of results; an interrupted run goes on there.")]
SCENES = Annotated[int | None, typer.Option("--n", min=1, help="Scenes a setting; the paper's number by default.")]
SEED = Annotated[int, typer.Option("--seed", min=0, help="Fixes everything drawn.")]
PROCESSES = Annotated[int | None, typer.Option("--processes", min=1, help="Workers; every core by default.")]


WEIGHTS = Annotated[list[Path] | None, typer.Option(
    "--weights", help="Layout weights, any number of times: training runs to compare; the shipped ones by default.")]
ANTICIPATING = Annotated[list[Path] | None, typer.Option(
    "--anticipating", metavar="FILE",
    help="Weights trained as those of --weights, but by Eq. 1: one for each of them, in the same order.")]
INCEPTION = Annotated[Path | None, typer.Option(
    "--inception-weights", metavar="FILE", help="Inception-v3 for FID, KID and SCA; a packaged network by default.")]
REAL = Annotated[str | None, typer.Option(
    "--real", metavar="SOURCE=PATH", help="Real rooms to compare with, in the format of a data source: ssr=rooms/.")]
AS = Annotated[str | None, typer.Option(
    "--as", metavar="SOURCE", help="What --real holds, where it is a path alone: ssr, front3d, procthor, boxes.")]
REPLAY = Annotated[str | None, typer.Option(
    "--replay", metavar="ID", help="Show one episode of an earlier run (embodied) as a GIF; nothing else is run.")]


LEROBOT = Annotated[Path | None, typer.Option(
    "--lerobot", metavar="FOLDER",
    help="Run the episodes of an earlier run (embodied) again and write those that succeed as LeRobotDatasets.")]


def _run(name: NAME = "", out: OUT = None, n: SCENES = None, seed: SEED = 0, processes: PROCESSES = None,
         weights: WEIGHTS = None, anticipating: ANTICIPATING = None, inception_weights: INCEPTION = None,
         real: REAL = None, real_as: AS = None, replay: REPLAY = None,
         lerobot: LEROBOT = None) -> int:
    from apartgen_cli.bench import _runner

    experiments = registry.members(__name__)
    if not name:
        say("\n".join(f"{word:18} {text}" for word, text in experiments.items()))
        return 0
    if name not in experiments:
        raise BadInput(f"no experiment {name!r}; there are: {', '.join(experiments)}")
    experiment = registry.load(__name__, name)
    real = f"{real_as}={real}" if real and real_as else real
    given = {"weights": weights, "anticipating": anticipating, "inception_weights": inception_weights, "real": real}
    files = _taken(name, experiment, {option: value for option, value in given.items() if value})
    if replay is not None:
        if not hasattr(experiment, "replay"):
            raise BadInput(f"--replay: {name} has no episodes to show")
        say("\n".join(f"wrote {path}" for path in experiment.replay(out or Path("bench") / name, replay)))
        return 0
    if lerobot is not None:
        if not hasattr(experiment, "lerobot"):
            raise BadInput(f"--lerobot: {name} has no episodes to learn from")
        say("\n".join(f"wrote {path}" for path in experiment.lerobot(out or Path("bench") / name, lerobot)))
        return 0
    for path in _runner.run(experiment, name, out or Path("bench") / name, n, seed, processes, files):
        say(f"wrote {path}")
    return 0


def _taken(name: str, experiment: ModuleType, given: dict[str, Any]) -> dict[str, Any]:
    """The files given, as plain text; BadInput for what the experiment has no use for, and for what is not there."""
    for option, value in given.items():
        shown = "--" + option.replace("_", "-")
        if option not in getattr(experiment, "TAKES", ()):
            raise BadInput(f"{shown}: {name} takes none")
        for path in value if isinstance(value, list) else [value]:
            place = Path(str(path).partition("=")[2]) if option == "real" else path
            if not place.exists() or place == Path():
                raise BadInput(f"{shown} {path}: no such {'folder; give SOURCE=PATH' if option == 'real' else 'file'}")
    return {option: [str(p) for p in value] if isinstance(value, list) else str(value)
            for option, value in given.items()}


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"bench": _run}

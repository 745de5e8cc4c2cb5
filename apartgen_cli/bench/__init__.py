"""Run an experiment: the paper's tables and figures, measured anew.

Each public module here is one: `PAPER`, what the paper reports · `NOTE`, how ours differs · `SETTINGS`, names of what
is compared · `SCENES`, scenes a setting by default · `CHUNK`, scenes a trial · `trial(setting, seed, scenes, work)`,
records of one trial · `rows(records, rng)`, the table · optionally `draw(rows, axes)`, the figure.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen_cli.console import say
from schemas.errors import BadInput
from stages import registry

NAME = Annotated[str, typer.Argument(metavar="EXPERIMENT", help="Which; none given lists them.")]
OUT = Annotated[Path | None, typer.Option("--out", "-o", help="Folder of results; an interrupted run goes on there.")]
SCENES = Annotated[int | None, typer.Option("--n", min=1, help="Scenes a setting; the paper's number by default.")]
SEED = Annotated[int, typer.Option("--seed", min=0, help="Fixes everything drawn.")]
PROCESSES = Annotated[int | None, typer.Option("--processes", min=1, help="Workers; every core by default.")]


def _run(name: NAME = "", out: OUT = None, n: SCENES = None, seed: SEED = 0, processes: PROCESSES = None) -> int:
    from apartgen_cli.bench import _runner

    experiments = registry.members(__name__)
    if not name:
        say("\n".join(f"{word:18} {text}" for word, text in experiments.items()))
        return 0
    if name not in experiments:
        raise BadInput(f"no experiment {name!r}; there are: {', '.join(experiments)}")
    for path in _runner.run(registry.load(__name__, name), name, out or Path("bench") / name, n, seed, processes):
        say(f"wrote {path}")
    return 0


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"bench": _run}

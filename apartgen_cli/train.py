"""Train the models whose weights are shipped."""

import inspect
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from apartgen_cli.console import say, watched
from apartgen_cli.options import CONFIG, configured, tables, with_options
from schemas.errors import BadInput
from stages.layout.config import TrainConfig
from stages.retrieve.shape.config import ShapeTraining

if TYPE_CHECKING:
    from schemas.layout import Layout

WEIGHTS = Annotated[Path | None, typer.Option("--out", "-o", help="The weights file; the shipped one by default.")]
FRESH = Annotated[bool, typer.Option("--fresh", help="Begin anew instead of going on from a checkpoint.")]
SOURCES = Annotated[list[str], typer.Argument(
    metavar="SOURCE", help="Names of data sources, each with its folder where it has one: furnisher=plans/.")]


def _corpus(
    sources: SOURCES, out: Annotated[Path, typer.Option("--out", "-o", help="The corpus, an .npz file.")],
    seed: Annotated[int, typer.Option("--seed", min=0, help="Fixes everything drawn.")] = 0,
    rooms: Annotated[int | None, typer.Option("--rooms", min=1, help="How many, of a source that never ends.")] = None,
    times: Annotated[int | None, typer.Option("--times", min=1, help="How often each home is furnished anew.")] = None,
) -> None:
    """Collect furnished rooms to train the layout model on."""
    from stages.layout.datasets._arrays import write_corpus

    homes = ((home, i) for i, source in enumerate(sources) for home in _homes(source, seed, rooms, times))
    say(f"wrote {out}: {write_corpus(out, homes, seed)} rooms")


def _homes(source: str, seed: int, rooms: int | None, times: int | None) -> "Iterator[Layout]":
    from stages.layout import datasets

    name, _, folder = source.partition("=")
    homes: Callable[..., Iterator[Layout]] = datasets.source(name).homes
    taken = inspect.signature(homes).parameters
    if "rooms" in taken and rooms is None:
        raise BadInput(f"{name} never ends; say how many with --rooms")
    given = {"seed": seed, "rooms": rooms, "times": times}
    told = {key: value for key, value in given.items() if key in taken and value is not None}
    return homes(Path(folder) if folder else None, **told)


def _layout(out: WEIGHTS = None, fresh: FRESH = False, config: CONFIG = None, *, given: Any) -> None:
    """Train the layout model on a corpus; an interrupted run goes on from its checkpoint."""
    from stages.layout import weights
    from stages.layout.calibration import GAINS
    from stages.layout.train import train

    settings, place = configured(TrainConfig, given, tables(config).get("train-layout")), out or weights.SHIPPED
    with watched("layout", settings.steps + (len(GAINS) if settings.calibrate else 0)) as report:
        train(settings, place, resume=not fresh, report=report)
    say(f"wrote {place}")


def _shape(out: WEIGHTS = None, fresh: FRESH = False, config: CONFIG = None, *, given: Any) -> None:
    """Train the shape model on the embedded library, and index the library by it."""
    from stages.retrieve.shape import encoder
    from stages.retrieve.shape.train import train

    settings, place = configured(ShapeTraining, given, tables(config).get("train-shape")), out or encoder.WEIGHTS
    train(settings, place, resume=not fresh)
    say(f"wrote {place} and the index beside it")


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"corpus": _corpus, "layout": with_options(_layout, TrainConfig),
            "shape": with_options(_shape, ShapeTraining)}

"""Train the models whose weights are shipped."""

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

import typer
from pydantic import create_model

from apartgen.schemas.errors import BadInput, need_torch
from apartgen.stages.layout.config import TrainConfig
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.retrieve.shape.config import ShapeTraining
from apartgen_cli.console import say, watched
from apartgen_cli.options import CONFIG, SPLIT, SPLITS, configured, tables, with_options
from apartgen_cli.streams import is_folder

if TYPE_CHECKING:
    from apartgen.schemas.layout import Layout

Item = TypeVar("Item")
EITHER = create_model("EITHER", **{name: (info.annotation, info) for name, info in (  # type: ignore[call-overload]
    TrainConfig.model_fields | Training.model_fields).items()})
"""The settings of both layout models; which one heeds an option is looked at when it is given."""
MODEL = Annotated[Literal["relations", "diffusion"], typer.Option("--model", help="Which layout model.")]

WEIGHTS = Annotated[Path | None, typer.Option("--out", "-o", help="The weights file; the shipped one by default.")]
FRESH = Annotated[bool, typer.Option("--fresh", help="Begin anew instead of going on from a checkpoint.")]
SOURCES = Annotated[list[str], typer.Argument(
    metavar="SOURCE", help="Names of data sources, each with its folder where it has one: furnisher=plans/.")]


def _corpus(
    sources: SOURCES, out: Annotated[Path, typer.Option("--out", "-o", help="The corpus, an .npz file.")],
    seed: Annotated[int, typer.Option("--seed", min=0, help="Fixes everything drawn.")] = 0,
    rooms: Annotated[int | None, typer.Option("--rooms", min=1, help="How many, of a source that never ends.")] = None,
    times: Annotated[int | None, typer.Option("--times", min=1, help="How often each home is furnished anew.")] = None,
    split: SPLIT = None, splits: SPLITS = None,
) -> None:
    """Collect furnished rooms to train the layout model on."""
    from apartgen.stages.layout import datasets
    from apartgen.stages.layout.datasets._arrays import write_corpus

    place = _place(out, "corpus.npz")
    wanted = {"rooms": rooms, "times": times, "split": split, "splits": splits}
    given = {name: value for name, value in wanted.items() if value is not None}
    found = [_homes(source, given | {"seed": seed}) for source in sources]
    for name in given:
        if not any(name in datasets.options(source.partition("=")[0]) for source in sources):
            raise BadInput(f"--{name} {given[name]}: none of {', '.join(sources)} heeds it; leave it out")
    with watched("homes", None) as report:
        homes = ((home, i) for i, source in enumerate(found) for home in source)
        rows = write_corpus(place, _counted(homes, report), seed)
    say(f"wrote {place}: {rows} rooms")


def _homes(source: str, given: dict[str, Any]) -> "Iterator[Layout]":
    """The homes of NAME=FOLDER, told those of the given options that the source heeds."""
    from apartgen.stages.layout import datasets

    name, _, folder = source.partition("=")
    heeded = datasets.options(name)
    if "rooms" in heeded and "rooms" not in given:
        raise BadInput(f"{name} never ends; say how many with --rooms")
    homes: Iterator[Layout] = datasets.source(name).homes(
        Path(folder) if folder else None, **{key: value for key, value in given.items() if key in heeded})
    return homes


def _counted(homes: Iterable[Item], report: Callable[[int], None]) -> Iterator[Item]:
    for done, home in enumerate(homes, 1):
        yield home
        report(done)


def _place(out: Path, name: str) -> Path:
    """`out`, where it is a file that can be written; BadInput before the work for it begins."""
    if is_folder(str(out)):
        raise BadInput(f"-o {out}: is a folder; name a file, such as -o {out / name}")
    if not os.access(out.parent, os.W_OK):
        raise BadInput(f"-o {out}: cannot be written, there is no folder {out.parent} to write to; give another path")
    return out


def _layout(
    out: WEIGHTS = None, fresh: FRESH = False, config: CONFIG = None, model: MODEL = "relations", *, given: Any,
) -> None:
    """Train a layout model on a corpus; an interrupted run goes on from its checkpoint."""
    need_torch("training")
    from apartgen.stages.layout import curve

    table = tables(config).get("train-layout")
    heeded = (TrainConfig if model == "diffusion" else Training).model_fields
    if unheeded := sorted(name for name in given if name not in heeded):
        raise BadInput(f"--{unheeded[0].replace('_', '-')}: the {model} model has no such setting; leave it out")
    place = _diffusion(out, fresh, given, table) if model == "diffusion" else _relations(out, fresh, given, table)
    say(f"wrote {place} and its curve {curve.place(place)}")


def _relations(out: Path | None, fresh: bool, given: Any, table: Any) -> Path:
    from apartgen.stages.layout.relations import weights
    from apartgen.stages.layout.relations.train import train

    settings = configured(Training, given, table)
    place = _place(out or weights.SHIPPED, "weights.safetensors")
    with watched("layout", settings.steps) as report:
        train(settings, place, resume=not fresh, report=report)
    return place


def _diffusion(out: Path | None, fresh: bool, given: Any, table: Any) -> Path:
    from apartgen.stages.layout import weights
    from apartgen.stages.layout.calibration import GAINS
    from apartgen.stages.layout.train import train

    settings = configured(TrainConfig, given, table)
    place = _place(out or weights.SHIPPED, "weights.safetensors")
    with watched("layout", settings.steps + (len(GAINS) if settings.calibrate else 0)) as report:
        train(settings, place, resume=not fresh, report=report)
    return place


def _shape(out: WEIGHTS = None, fresh: FRESH = False, config: CONFIG = None, *, given: Any) -> None:
    """Train the shape model on the embedded library, and index the library by it."""
    need_torch("training")
    from apartgen.stages.retrieve.shape import encoder
    from apartgen.stages.retrieve.shape.train import train

    settings = configured(ShapeTraining, given, tables(config).get("train-shape"))
    place = _place(out or encoder.WEIGHTS, "shape.safetensors")
    train(settings, place, resume=not fresh)
    say(f"wrote {place} and the index beside it")


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"corpus": _corpus, "layout": with_options(_layout, EITHER),
            "shape": with_options(_shape, ShapeTraining)}

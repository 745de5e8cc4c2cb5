"""Train the models whose weights are shipped."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen_cli.console import say
from apartgen_cli.options import CONFIG, configured, tables, with_options
from stages.layout.config import TrainConfig
from stages.retrieve.shape.config import ShapeTraining

OUT = Annotated[Path, typer.Option("--out", "-o", help="The weights file; its checkpoints lie beside it.")]
FRESH = Annotated[bool, typer.Option("--fresh", help="Begin anew instead of going on from a checkpoint.")]


def _layout(out: OUT, fresh: FRESH = False, config: CONFIG = None, *, given: Any) -> None:
    """Train the layout model from a corpus of furnished rooms."""
    from stages.layout.train import train

    settings = configured(TrainConfig, given, tables(config).get("train-layout"))
    record = train(settings, out, resume=not fresh)
    say(f"wrote {out} after {record['step']} steps")


def _shape(out: OUT, fresh: FRESH = False, config: CONFIG = None, *, given: Any) -> None:
    """Train the shape model on the embedded library, and index the library by it."""
    from stages.retrieve.shape.train import train

    settings = configured(ShapeTraining, given, tables(config).get("train-shape"))
    train(settings, out)
    say(f"wrote {out}")


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"layout": with_options(_layout, TrainConfig), "shape": with_options(_shape, ShapeTraining)}

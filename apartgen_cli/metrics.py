"""Measure apartments."""

from collections.abc import Callable
from time import perf_counter
from typing import Annotated, Any

import typer
from pydantic import Field

from apartgen_cli.options import INPUTS, OUT
from apartgen_cli.stage import made, opened, settled, written
from apartgen_cli.streams import sources, targets
from schemas import artifact
from schemas.artifact import Artifact
from schemas.base import Record
from schemas.errors import ApartgenError
from schemas.metrics import Metrics
from schemas.plan import Plan


class MetricsSettings(Record):
    """What is measured."""

    metric: list[str] = Field(default_factory=list, description="names of metrics; all that apply when empty")


METRIC = Annotated[list[str] | None, typer.Option(
    "--metric", help="A metric by name, any number of times; all by default.")]
AGAINST = Annotated[str | None, typer.Option(
    "--against", help="An artifact whose programme is the reference; the apartment's own by default.")]


def measure(home: Plan, settings: MetricsSettings, against: Plan | None = None) -> Metrics:
    """The figures of one apartment."""
    from stages import metrics

    return metrics.run(home, settings.metric or None, against)


def _run(inputs: INPUTS = None, out: OUT = None, metric: METRIC = None, against: AGAINST = None) -> int:
    names = sources(inputs)
    settings, reference = MetricsSettings(metric=metric or []), _reference(against)
    work, errors = opened(list(zip(names, targets("metrics", names, out))), Plan, whole=True)
    for place, read in work:
        began = perf_counter()
        try:
            values = measure(read.body, settings, reference.body if reference else None)
        except ApartgenError as error:
            errors.append(error)
            continue
        record = made(read.made.seed, settings, read, perf_counter() - began)
        if reference:
            record.inputs["against"] = reference.digest
        written(values, record, place)
    return settled(errors, len(names))


def _reference(source: str | None) -> Artifact[Plan] | None:
    return artifact.read(source, Plan) if source else None


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"metrics": _run}

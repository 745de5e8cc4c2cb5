"""Measure apartments."""

from collections.abc import Callable
from time import perf_counter
from typing import Annotated, Any

import numpy as np
import typer
from pydantic import Field

from apartgen_cli.console import progress
from apartgen_cli.options import INPUTS, OUT
from apartgen_cli.stage import made, opened, settled, written
from apartgen_cli.streams import is_folder, sources, targets, whole_set
from schemas import artifact
from schemas.artifact import STREAM, Artifact
from schemas.base import Record
from schemas.errors import ApartgenError, BadInput
from schemas.layout import Layout
from schemas.metrics import Metrics
from schemas.plan import Plan


class MetricsSettings(Record):
    """What is measured."""

    metric: list[str] = Field(default_factory=list, description="names of metrics; all that apply when empty")


METRIC = Annotated[list[str] | None, typer.Option(
    "--metric", help="A metric by name, any number of times; all by default.")]
AGAINST = Annotated[str | None, typer.Option(
    "--against", help="An artifact whose programme is the reference; the apartment's own by default.")]

TABLE = Annotated[bool, typer.Option(
    "--table", help="Write one Markdown table of all inputs, with 95 % intervals over them, in place of JSON.")]
REAL = Annotated[list[str] | None, typer.Option(
    "--real", help="A real apartment or a folder of them, any number of times; the inputs are compared with all.")]
SEED = 0
"""Of the bootstrap behind a table's intervals."""


def measure(home: Plan, settings: MetricsSettings, against: Plan | None = None) -> Metrics:
    """The figures of one apartment."""
    from stages import metrics

    return metrics.run(home, settings.metric or None, against)


def _run(inputs: INPUTS = None, out: OUT = None, metric: METRIC = None, against: AGAINST = None,
         table: TABLE = False, real: REAL = None) -> int:
    names, settings = sources(inputs), MetricsSettings(metric=metric or [])
    if real:
        if against:
            raise BadInput("--real and --against: sets are compared as wholes; give one of the two")
        return _compared(names, whole_set("--real", real), settings, table, out)
    reference = _reference(against)
    return (_tabled if table else _each)(names, settings, reference, out)


def _each(names: list[str], settings: MetricsSettings, reference: Artifact[Plan] | None, out: str | None) -> int:
    """An artifact for every input."""
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


def _tabled(names: list[str], settings: MetricsSettings, reference: Artifact[Plan] | None, out: str | None) -> int:
    """One table of all inputs that can be read and measured."""
    from stages import metrics

    place = _sheet(out)
    work, errors = opened([(name, place) for name in names], Plan, whole=True)
    measured: list[Metrics] = []
    for _, read in progress(work, "metrics", len(work)):
        try:
            measured.append(measure(read.body, settings, reference.body if reference else None))
        except ApartgenError as error:
            errors.append(error)
    if measured:
        rows = metrics.table(measured, np.random.default_rng(SEED))
        artifact.write(metrics.markdown(rows, SEED), place)
    return settled(errors, len(names))


def _compared(names: list[str], real: list[str], settings: MetricsSettings, table: bool, out: str | None) -> int:
    """One artifact, or table, of all inputs against all real apartments; any that cannot be read ends it."""
    from stages import metrics

    place = _sheet(out) if table else targets("metrics", [STREAM], out)[0]
    began = perf_counter()
    ours, theirs = ([artifact.read(name, Layout) for name in some] for some in (names, real))
    values = metrics.compare([a.body for a in ours], [a.body for a in theirs], settings.metric or None)
    if table:
        artifact.write(metrics.side_by_side(values), place)
        return 0
    record = made(SEED, settings, seconds=perf_counter() - began)
    for word, group in (("generated", ours), ("real", theirs)):
        record.inputs |= {f"{word} {i}": a.digest for i, a in enumerate(group, 1)}
    written(values, record, place)
    return 0


def _sheet(out: str | None) -> str:
    if out is not None and is_folder(out):
        raise BadInput(f"-o {out}: a table is one file; give -o {out.rstrip('/')}/table.md")
    return out or STREAM


def _reference(source: str | None) -> Artifact[Plan] | None:
    return artifact.read(source, Plan) if source else None


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"metrics": _run}

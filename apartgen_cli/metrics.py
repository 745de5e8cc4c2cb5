"""Measure apartments."""

import hashlib
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import Annotated, Any, NamedTuple

import numpy as np
import typer

from apartgen.outputs import MetricsSettings, measure
from apartgen.schemas import artifact, consistency
from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Metrics
from apartgen.schemas.plan import Plan, Program
from apartgen.steps import made
from apartgen_cli.check import read_told
from apartgen_cli.console import progress
from apartgen_cli.drawn import asked
from apartgen_cli.options import INPUTS, OUT, SPLIT, SPLITS
from apartgen_cli.stage import about, opened, settled, written
from apartgen_cli.streams import is_folder, sources, targets, whole_set

METRIC = Annotated[list[str] | None, typer.Option(
    "--metric", help="A metric by name, any number of times; all by default.")]
AGAINST = Annotated[str | None, typer.Option(
    "--against", metavar="FILE",
    help="The reference: a programme, or an artifact for its programme; the apartment's own by default.")]

TABLE = Annotated[bool, typer.Option(
    "--table", help="Write one Markdown table of all inputs, with 95 % intervals over them, in place of JSON.")]
REAL = Annotated[list[str] | None, typer.Option(
    "--real", help="A real apartment or a folder of them, any number of times; the inputs are compared with all.")]
AS = Annotated[str | None, typer.Option(
    "--as", metavar="SOURCE", help="What --real holds: front3d, ssr, procthor, boxes; artifacts by default.")]
INCEPTION = Annotated[str | None, typer.Option(
    "--inception-weights", metavar="FILE", help="Inception-v3 for FID, KID and SCA; a packaged network by default.")]
SEED = 0
"""Of the bootstrap behind a table's intervals."""


class Reference(NamedTuple):
    """What apartments are measured against, and the digest of its file."""

    body: Plan | Program
    digest: str


def _run(inputs: INPUTS = None, out: OUT = None, metric: METRIC = None, against: AGAINST = None,
         table: TABLE = False, real: REAL = None, real_as: AS = None, split: SPLIT = None, splits: SPLITS = None,
         inception_weights: INCEPTION = None) -> int:
    names = sources(inputs)
    settings = MetricsSettings(metric=metric or [], real_as=real_as, split=split, inception_weights=inception_weights)
    if real:
        if against:
            raise BadInput("--real and --against: sets are compared as wholes; give one of the two")
        return _compared(names, real, splits, settings, table, out)
    for option, given in (("--as", real_as), ("--split", split), ("--splits", splits),
                          ("--inception-weights", inception_weights)):
        if given:
            raise BadInput(f"{option} {given}: only with --real, which says what the inputs are compared with")
    reference = _reference(against)
    return (_tabled if table else _each)(names, settings, reference, out)


def _each(names: list[str], settings: MetricsSettings, reference: Reference | None, out: str | None) -> int:
    """An artifact for every input."""
    places = dict(zip(names, targets("metrics", names, out)))
    work, errors = opened([(name, name) for name in names], Plan, True, read_told)
    for name, read in work:
        began = perf_counter()
        try:
            values = measure(read.body, settings, reference.body if reference else None)
        except ApartgenError as error:
            errors.append(about(name, error, len(names)))
            continue
        record = made(read.made.seed, settings, read, perf_counter() - began)
        if reference:
            record.inputs["against"] = reference.digest
        written(values, record, places[name])
    return settled(errors, len(names))


def _tabled(names: list[str], settings: MetricsSettings, reference: Reference | None, out: str | None) -> int:
    """One table of all inputs that can be read and measured."""
    from apartgen.stages import metrics

    place = _sheet(out)
    work, errors = opened([(name, name) for name in names], Plan, True, read_told)
    measured: list[Metrics] = []
    for name, read in progress(work, "metrics", len(work)):
        try:
            measured.append(measure(read.body, settings, reference.body if reference else None))
        except ApartgenError as error:
            errors.append(about(name, error, len(names)))
    if measured:
        rows = metrics.table(measured, np.random.default_rng(SEED))
        artifact.write(metrics.markdown(rows, SEED), place)
    return settled(errors, len(names))


def _compared(
    names: list[str], real: list[str], splits: Path | None, settings: MetricsSettings, table: bool, out: str | None
) -> int:
    """One artifact, or table, of all inputs against all real apartments; any that cannot be read ends it."""
    from apartgen.stages import metrics

    place = _sheet(out) if table else targets("metrics", [STREAM], out)[0]
    began = perf_counter()
    ours = [artifact.read(name, Layout) for name in names]
    theirs, digests, files = _real(real, settings, splits)
    inception = Path(settings.inception_weights) if settings.inception_weights else None
    values = metrics.compare([a.body for a in ours], theirs, settings.metric or None, inception)
    if table:
        artifact.write(metrics.side_by_side(values), place)
        return 0
    record = made(SEED, settings, seconds=perf_counter() - began,
                  data=files | ({"inception": inception} if inception else {}))
    record.inputs |= {f"generated {i}": a.digest for i, a in enumerate(ours, 1)} | digests
    written(values, record, place)
    return 0


def _real(
    paths: list[str], settings: MetricsSettings, splits: Path | None
) -> tuple[list[Layout], dict[str, str], dict[str, Path]]:
    """The real apartments, the digests of those that are artifacts, the files of those that are not."""
    from apartgen.stages.layout import datasets

    source, heeded = settings.real_as, datasets.options(settings.real_as) if settings.real_as else frozenset()
    part = {name: value for name, value in (("split", settings.split), ("splits", splits)) if value is not None}
    if part and "split" not in heeded:
        raise BadInput(f"--{next(iter(part))}: --as {source or 'artifacts'} knows no split; it goes with --as boxes")
    if source is None:
        read = [artifact.read(name, Layout) for name in whole_set("--real", paths)]
        return [a.body for a in read], {f"real {i}": a.digest for i, a in enumerate(read, 1)}, {}
    if "seed" in heeded:
        raise BadInput(f"--as {source}: makes its rooms up; name a source of real ones, or give artifacts")
    homes = datasets.source(source).homes
    found = [home for path in paths for home in homes(Path(path), **part)]
    files = sorted(file for path in paths for file in ([Path(path)] if Path(path).is_file() else Path(path).rglob("*")))
    read_from = {f"real {i}": file for i, file in enumerate(files, 1) if file.is_file()}
    return found, {}, read_from | ({"splits": splits} if splits else {})


def _sheet(out: str | None) -> str:
    if out is not None and is_folder(out):
        raise BadInput(f"-o {out}: a table is one file; give -o {out.rstrip('/')}/table.md")
    return out or STREAM


def _reference(source: str | None) -> Reference | None:
    """The plan of an artifact, or the programme of a file that people write."""
    if source is None:
        return None
    data = artifact.contents(source)
    raw = artifact.json_value(data, source)
    if isinstance(raw, dict) and "apartgen" in raw:
        read = artifact.parse(data, source, Plan)
        return Reference(read.body, read.digest)
    program = asked(data, source).program
    if program is None:
        raise BadInput(f"{source}: rooms drawn by hand; give the plan that `apartgen plan --from` makes of them")
    if fault := next(consistency.faults(program), None):
        raise BadInput(f"{source}: {fault.where.removeprefix('program.')}: {fault.what}")
    return Reference(program, "sha256:" + hashlib.sha256(data).hexdigest())


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"metrics": _run}

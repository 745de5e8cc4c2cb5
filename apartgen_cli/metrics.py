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
from apartgen_cli.check import judge, told
from apartgen_cli.console import progress, say
from apartgen_cli.drawn import asked
from apartgen_cli.inputs import Inputs, Read, artifacts, inputs_of, named
from apartgen_cli.options import FAILURES, INPUTS, OUT, RETRY, SPLIT, SPLITS
from apartgen_cli.results import Results, results
from apartgen_cli.streams import is_folder, targets, whole_set
from apartgen_cli.tally import Tally

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
         inception_weights: INCEPTION = None, failures: FAILURES = None, retry: RETRY = None) -> int:
    given = inputs_of(inputs, retry)
    settings = MetricsSettings(metric=metric or [], real_as=real_as, split=split, inception_weights=inception_weights)
    if real:
        if against:
            raise BadInput("--real and --against: sets are compared as wholes; give one of the two")
        return _compared(given, real, splits, settings, table, out)
    for option, value in (("--as", real_as), ("--split", split), ("--splits", splits),
                          ("--inception-weights", inception_weights)):
        if value:
            raise BadInput(f"{option} {value}: only with --real, which says what the inputs are compared with")
    reference = _reference(against)
    if table:
        return _tabled(given, settings, reference, _sheet(out), failures or retry)
    into = results("metrics", given.files, out, given.many)
    return _each(given, settings, reference, into, failures or retry)


def _each(given: Inputs, settings: MetricsSettings, reference: Reference | None, into: Results,
          listing: Path | None) -> int:
    """An artifact for every input."""
    return _measured(given, listing, lambda read: _one(read, settings, reference, into), into.close)


def _one(read: Read, settings: MetricsSettings, reference: Reference | None, into: Results) -> None:
    record = made("metrics", read.artifact.made.seed, settings, read.artifact)
    if reference:
        record.inputs["against"] = reference.digest
    if into.found(read.name, "metrics", record):
        return
    began = perf_counter()
    values = measure(read.artifact.body, settings, reference.body if reference else None)
    into.put(read.name, values, record.model_copy(update={"seconds": round(perf_counter() - began, 2)}))


def _tabled(given: Inputs, settings: MetricsSettings, reference: Reference | None, place: str,
            listing: Path | None) -> int:
    """One table of all inputs that can be read and measured."""
    from apartgen.stages import metrics

    found: list[Metrics] = []

    def write() -> None:
        if found:
            artifact.write(metrics.markdown(metrics.table(found, np.random.default_rng(SEED)), SEED), place)

    return _measured(given, listing, lambda read: found.append(
        measure(read.artifact.body, settings, reference.body if reference else None)), write)


def _measured(given: Inputs, listing: Path | None, one: Callable[[Read], None], last: Callable[[], None]) -> int:
    """`one` for every input that can be read, then the `last`; the exit status."""
    with Tally(given.many, listing) as tally:
        for read in progress(named(artifacts(given.items, Plan, True, told)), "metrics", given.total):
            try:
                if isinstance(read.outcome, ApartgenError):
                    raise read.outcome
                one(read)
            except ApartgenError as error:
                tally.failed(read, error)
            else:
                tally.done()
        last()
    return tally.status


def _compared(
    given: Inputs, real: list[str], splits: Path | None, settings: MetricsSettings, table: bool, out: str | None
) -> int:
    """One artifact, or table, of all inputs against all real apartments; any that cannot be read ends it."""
    from apartgen.stages import metrics

    place = _sheet(out) if table else targets("metrics", [STREAM], out)[0]
    began = perf_counter()
    ours = [_readable(read) for read in artifacts(given.items, Layout, False, judge(trust=True))]
    theirs, digests, files = _real(real, settings, splits)
    inception = Path(settings.inception_weights) if settings.inception_weights else None
    values = metrics.compare([a.body for a in ours], theirs, settings.metric or None, inception)
    if table:
        artifact.write(metrics.side_by_side(values), place)
        return 0
    record = made("metrics", SEED, settings, seconds=perf_counter() - began,
                  data=files | ({"inception": inception} if inception else {}))
    record.inputs |= {f"generated {i}": a.digest for i, a in enumerate(ours, 1)} | digests
    text, _ = artifact.finish(values, record)
    artifact.write(text, place)
    if str(place) != STREAM:
        say(f"wrote {place}")
    return 0


def _readable(read: Read) -> artifact.Artifact[Layout]:
    if isinstance(read.outcome, ApartgenError):
        raise read.outcome
    return read.outcome


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

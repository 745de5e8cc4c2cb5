"""Write an apartment for simulators, viewers and people."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.outputs import ExportSettings, finished, intact, opened_libraries, principal
from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.export import Export
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen_cli.check import judge
from apartgen_cli.console import progress, say
from apartgen_cli.inputs import LINES, Inputs, Read, artifacts, inputs_of, named
from apartgen_cli.options import FAILURES, INPUTS, RETRY, TRUST
from apartgen_cli.streams import targets
from apartgen_cli.tally import Tally

FORMATS = registry.members("apartgen.stages.export")
FORMAT = Annotated[list[str], typer.Option("--format", help=f"Any number of times; of {', '.join(FORMATS)}.")]
LIBRARY = Annotated[list[str] | None, typer.Option("--library", help="Folder of an indexed asset library in use.")]
FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; it is replaced whole or not at all.")]


def _run(out: FOLDER, format: FORMAT, inputs: INPUTS = None, library: LIBRARY = None, trust: TRUST = False,
         failures: FAILURES = None, retry: RETRY = None) -> int:
    if out == STREAM:
        raise BadInput("-o -: an export is a folder of files; give -o FOLDER/")
    given = inputs_of(inputs, retry)
    settings = ExportSettings(format=format, libraries=library or [])
    if settings.libraries:
        opened_libraries(*settings.libraries)  # one that is none is said, though the formats may need no asset
    reads = named(artifacts(given.items, Plan, True, judge(trust)))
    with unless_empty(Path(out)), Tally(given.many, failures or retry) as tally:
        places = _folders(given, out)
        for read in progress(reads, "export", given.total):
            place = places.get(read.name, Path(out) / read.name) if given.many else Path(out)
            _exported(read, settings, place, tally)
    return tally.status


@contextmanager
def unless_empty(out: Path) -> Iterator[Path]:
    """Takes away the folders that have been made for `out` meanwhile and stayed empty."""
    new = [folder for folder in (out, *out.parents) if not folder.exists()]
    try:
        yield out
    finally:
        for folder in (*sorted(out.rglob("*/"), reverse=True), *new) if new else ():
            with suppress(OSError):
                folder.rmdir()


def _exported(read: Read, settings: ExportSettings, folder: Path, tally: Tally) -> None:
    """One apartment; of many, those that are there already are left."""
    try:
        if isinstance(read.outcome, ApartgenError):
            raise read.outcome
        if tally.many and intact(read.outcome, settings, folder):
            say(f"kept {folder}")
        else:
            _listed(finished(read.outcome, settings, folder), folder)
    except ApartgenError as error:
        tally.failed(read, error)
    else:
        tally.done()


def _listed(files: Export, folder: Path) -> None:
    for path in principal(files):
        say(f"wrote {folder / path}")
    say(f"{len(files.files)} files in all")


def _folders(given: Inputs, out: str) -> dict[str, Path]:
    """A folder below the given one for each of several files."""
    if not given.many:
        return {}
    files = [name for name in given.files if name != STREAM and not name.endswith(LINES)]
    return {name: Path(place).with_suffix("")
            for name, place in zip(files, targets("export", files, out.rstrip("/") + "/"))}


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"export": _run}

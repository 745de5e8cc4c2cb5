"""Write an apartment for simulators, viewers and people."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.outputs import ExportSettings, finished, opened_libraries, principal
from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen_cli.check import reader
from apartgen_cli.console import say
from apartgen_cli.options import INPUTS, TRUST
from apartgen_cli.stage import opened, settled
from apartgen_cli.streams import sources, targets

FORMATS = registry.members("apartgen.stages.export")
FORMAT = Annotated[list[str], typer.Option("--format", help=f"Any number of times; of {', '.join(FORMATS)}.")]
LIBRARY = Annotated[list[str] | None, typer.Option("--library", help="Folder of an indexed asset library in use.")]
FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; it is replaced whole or not at all.")]


def _run(out: FOLDER, format: FORMAT, inputs: INPUTS = None, library: LIBRARY = None, trust: TRUST = False) -> int:
    names = sources(inputs)
    if out == STREAM:
        raise BadInput("-o -: an export is a folder of files; give -o FOLDER/")
    settings = ExportSettings(format=format, libraries=library or [])
    if settings.libraries:
        opened_libraries(*settings.libraries)  # one that is none is said, though the formats may need no asset
    with _unless_empty(Path(out)):
        return _exported(names, settings, _folders(names, out), trust)


@contextmanager
def _unless_empty(out: Path) -> Iterator[None]:
    """Takes away the folders that have been made for `out` meanwhile and stayed empty."""
    new = [folder for folder in (out, *out.parents) if not folder.exists()]
    try:
        yield
    finally:
        for folder in (*sorted(out.rglob("*/"), reverse=True), *new) if new else ():
            with suppress(OSError):
                folder.rmdir()


def _exported(names: list[str], settings: ExportSettings, folders: list[Path], trust: bool) -> int:
    work, errors = opened(list(zip(names, folders)), Plan, True, reader(trust))
    for folder, read in work:
        try:
            files = finished(read, settings, Path(folder))
        except ApartgenError as error:
            errors.append(error)
            continue
        for path in principal(files):
            say(f"wrote {Path(folder) / path}")
        say(f"{len(files.files)} files in all")
    return settled(errors, len(names))


def _folders(names: list[str], out: str) -> list[Path]:
    """The folder itself for one apartment, one below it for each of several."""
    if len(names) == 1:
        return [Path(out)]
    return [Path(place).with_suffix("") for place in targets("export", names, out.rstrip("/") + "/")]


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"export": _run}

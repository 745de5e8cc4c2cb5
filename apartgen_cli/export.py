"""Write an apartment for simulators, viewers and people."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Annotated, Any

import typer
from pydantic import Field

from apartgen.schemas import artifact
from apartgen.schemas.artifact import STREAM, Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.export import Export
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen_cli.console import say
from apartgen_cli.options import INPUTS
from apartgen_cli.stage import made, opened, settled
from apartgen_cli.streams import sources, targets

if TYPE_CHECKING:
    from apartgen.stages.retrieve import LibrarySet
    from apartgen.stages.things.asset import Asset

FORMATS = registry.members("apartgen.stages.export")
FORMAT = Annotated[list[str], typer.Option("--format", help=f"Any number of times; of {', '.join(FORMATS)}.")]
LIBRARY = Annotated[list[str] | None, typer.Option("--library", help="Folder of an indexed asset library in use.")]
FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; it is replaced whole or not at all.")]


class ExportSettings(Record):
    """What is written, and where assets are found."""

    format: list[str] = Field(min_length=1)
    libraries: list[str] = Field(default_factory=list)


def export(home: Plan, settings: ExportSettings, folder: Path) -> Export:
    """Write one apartment."""
    from apartgen.stages import export

    def load(library: str, id: str) -> "Asset":
        return _libraries(*settings.libraries).load(library, id)

    return export.run(home, settings.format, folder, load)


@cache
def _libraries(*folders: str) -> "LibrarySet":
    """Opened when the first asset is needed; a picture of a bare plan needs none."""
    from apartgen.stages import retrieve

    return retrieve.open_libraries(RetrieveConfig(libraries=list(folders)))


def finished(read: Artifact[Plan], settings: ExportSettings, folder: Path) -> Export:
    """Write one apartment and the list of its files beside them."""
    began = perf_counter()
    files = export(read.body, settings, folder)
    text, _ = artifact.finish(files, made(read.made.seed, settings, read, perf_counter() - began))
    artifact.write(text, folder / "export.json")
    return files


def principal(files: Export) -> list[str]:
    """The main file of every format, which each format names first."""
    main = {file.format: file.path for file in reversed(files.files)}
    return list(reversed(main.values()))


def _run(out: FOLDER, format: FORMAT, inputs: INPUTS = None, library: LIBRARY = None) -> int:
    names = sources(inputs)
    if out == STREAM:
        raise BadInput("-o -: an export is a folder of files; give -o FOLDER/")
    settings = ExportSettings(format=format, libraries=library or [])
    if settings.libraries:
        _libraries(*settings.libraries)  # one that is none is said, though the formats may need no asset
    with _unless_empty(Path(out)):
        return _exported(names, settings, _folders(names, out))


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


def _exported(names: list[str], settings: ExportSettings, folders: list[Path]) -> int:
    work, errors = opened(list(zip(names, folders)), Plan, whole=True)
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

"""Write an apartment for simulators, viewers and people."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from apartgen.outputs import ExportSettings, finished, intact, opened_libraries, principal
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.export import Export
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen_cli.console import say
from apartgen_cli.folders import into_folders
from apartgen_cli.inputs import inputs_of
from apartgen_cli.options import FAILURES, INPUTS, RETRY, SEED, TRUST

FORMATS = registry.members("apartgen.stages.export")
FORMAT = Annotated[list[str], typer.Option("--format", help=f"Any number of times; of {', '.join(FORMATS)}.")]
LIBRARY = Annotated[list[str] | None, typer.Option("--library", help="Folder of an indexed asset library in use.")]
RANDOMIZE = Annotated[bool, typer.Option(
    "--randomize", help="Draw masses, friction and damping within the ranges of their kinds.")]
COLLIDERS = Annotated[Literal["exact", "primitive"], typer.Option(
    "--colliders", help="Convex hulls as they are, or boxes in their place, which some engines are quicker with.")]
FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; it is replaced whole or not at all.")]


def _run(out: FOLDER, format: FORMAT, inputs: INPUTS = None, library: LIBRARY = None, trust: TRUST = False,
         colliders: COLLIDERS = "exact", randomize: RANDOMIZE = False, seed: SEED = None,
         failures: FAILURES = None, retry: RETRY = None) -> int:
    given = inputs_of(inputs, retry)
    settings = ExportSettings(format=format, libraries=library or [], randomize=randomize, colliders=colliders)
    if settings.libraries:
        opened_libraries(*settings.libraries)  # one that is none is said, though the formats may need no asset

    def write(read: Artifact[Any], folder: Path) -> None:
        if given.many and intact(read, settings, folder, seed):
            say(f"kept {folder}")
        else:
            _listed(finished(read, settings, folder, seed), folder)

    with unless_empty(Path(out)):
        return into_folders("export", Plan, given, out, write, trust=trust, failures=failures or retry)


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


def _listed(files: Export, folder: Path) -> None:
    for path in principal(files):
        say(f"wrote {folder / path}")
    say(f"{len(files.files)} files in all")


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"export": _run}

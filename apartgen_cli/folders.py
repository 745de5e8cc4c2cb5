"""Commands that make a folder of files of every apartment: what is read as one, and where its files go."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

from apartgen.schemas.artifact import STREAM, Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen_cli.check import judge
from apartgen_cli.console import progress
from apartgen_cli.inputs import LINES, Inputs, artifacts, named
from apartgen_cli.streams import targets
from apartgen_cli.tally import Tally

Write = Callable[[Artifact[Any], Path], None]


def into_folders(word: str, takes: type[Record], given: Inputs, out: str, write: Write, *, trust: bool = False,
                 failures: Path | None = None, below: bool = False) -> int:
    """Have `write(artifact, folder)` make the folder of every input: `out` itself for a single one that is not asked
    for `below` it, else one of the input's name in it. Returns the exit status.
    """
    if out == STREAM:
        raise BadInput(f"-o -: {word} writes a folder of files; give -o FOLDER/")
    reads = named(artifacts(given.items, takes, True, judge(trust)))
    with Tally(given.many, failures) as tally:
        places = _places(word, given, out) if given.many or below else {}
        for read in progress(reads, word, given.total):
            place = places.get(read.name, Path(out) / read.name) if given.many or below else Path(out)
            try:
                if isinstance(read.outcome, ApartgenError):
                    raise read.outcome
                write(read.outcome, place)
            except ApartgenError as error:
                tally.failed(read, error)
            else:
                tally.done()
    return tally.status


def _places(word: str, given: Inputs, out: str) -> dict[str, Path]:
    """A folder below the given one for each of several files."""
    files = [name for name in given.files if name != STREAM and not name.endswith(LINES)]
    return {name: Path(place).with_suffix("")
            for name, place in zip(files, targets(word, files, out.rstrip("/") + "/"))}

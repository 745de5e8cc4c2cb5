"""Where results go: a file, a folder of files, lines of a file or of standard output; what is there already is kept."""

import hashlib
import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from apartgen.kept import kept
from apartgen.schemas import artifact
from apartgen.schemas.artifact import BODIES, STREAM, Artifact, Made
from apartgen.schemas.base import Record
from apartgen.schemas.errors import BadInput
from apartgen.schemas.files import part_of
from apartgen_cli.console import log, say
from apartgen_cli.inputs import LINES
from apartgen_cli.streams import is_folder, made_folder, not_to_terminal, targets


class Results:
    """Results by name: one text each on standard output, as it is."""

    def found(self, name: str, kind: str, wanted: Made, prompt: str = "") -> Artifact[Any] | None:
        """The result, where it is there already, of this prompt and made just as it would be now; it counts as put."""
        return None

    def put(self, name: str, body: Record, made: Made) -> None:
        """Write one result."""
        self.write(name, artifact.finish(body, made)[0])

    def write(self, name: str, text: str) -> None:
        """Write one result's text."""
        artifact.write(text, STREAM)

    def close(self) -> None:
        """All is there that will be."""


class Lines(Results):
    """Lines of standard output."""

    def write(self, name: str, text: str) -> None:
        """A line."""
        artifact.write(artifact.as_line(text), STREAM)


class OneFile(Results):
    """The file of the only result."""

    def __init__(self, place: Path) -> None:
        self._place = place

    def write(self, name: str, text: str) -> None:
        """The file."""
        artifact.write(text, self._place)
        say(f"wrote {self._place}")


class Folder(Results):
    """A file for each result; `places` of those whose inputs are files, the others are called by their names."""

    def __init__(self, folder: Path, places: dict[str, Path]) -> None:
        self._folder, self._places = folder, places
        self._taken = set(places.values())

    def found(self, name: str, kind: str, wanted: Made, prompt: str = "") -> Artifact[Any] | None:
        """What the file holds."""
        old = kept(self._place(name), kind, wanted)
        if old is None or (prompt and old.body.prompt != prompt):
            return None
        say(f"kept {self._place(name)}")
        return old

    def write(self, name: str, text: str) -> None:
        """A file."""
        artifact.write(text, self._place(name))
        say(f"wrote {self._place(name)}")

    def _place(self, name: str) -> Path:
        return self._places.get(name) or self._folder / f"{name}.json"


class LinesFile(Results):
    """Lines of one file, in the order of the inputs, all at once.

    What an interrupted run had done is in a file beside it, which the next goes on with.
    """

    def __init__(self, place: Path) -> None:
        self._place, self._part = place, part_of(place)
        _cut_torn(self._part)
        self._old = dict(_lines(place)) | dict(_lines(self._part))
        self._rows: list[_Row] = []
        self._file = open(self._part, "ab")

    def found(self, name: str, kind: str, wanted: Made, prompt: str = "") -> Artifact[Any] | None:
        """What the line holds."""
        row = self._old.get(_key(kind, wanted.model_dump(mode="json"), prompt))
        if row is None:
            return None
        self._rows.append(row)
        return artifact.parse(_bytes(row), name, BODIES[kind])

    def write(self, name: str, text: str) -> None:
        """A line."""
        line = artifact.as_line(text).encode()
        self._rows.append(_Row(self._part, self._file.tell(), len(line)))
        self._file.write(line)
        self._file.flush()

    def close(self) -> None:
        """The file."""
        self._file.close()
        with open(fresh := self._part.with_suffix(".new"), "wb") as file:
            for row in self._rows:
                file.write(_bytes(row))
            os.fsync(file.fileno())
        os.replace(fresh, self._place)
        self._part.unlink()
        say(f"wrote {self._place}")


class _Row(NamedTuple):
    """Where a line is."""

    file: Path
    start: int
    length: int


def _bytes(row: _Row) -> bytes:
    with open(row.file, "rb") as file:
        file.seek(row.start)
        return file.read(row.length)


def _lines(file: Path) -> Iterator[tuple[str, _Row]]:
    """Every artifact in a file of lines, by how it came about."""
    if not file.is_file():
        return
    start = 0
    with open(file, "rb") as lines:
        for line in lines:
            try:
                raw = json.loads(line)
                yield _key(raw["apartgen"], raw["made"], raw["body"].get("prompt", "")), _Row(file, start, len(line))
            except (ValueError, LookupError, TypeError, AttributeError):
                log.info("%s: a line that is no artifact; making it again", file)
            start += len(line)


def _cut_torn(file: Path) -> None:
    """Take off the line that was being written when a run was killed."""
    if file.is_file() and (data := file.read_bytes()) and not data.endswith(b"\n"):
        os.truncate(file, data.rfind(b"\n") + 1)


def _key(kind: str, made: dict[str, Any], prompt: str) -> str:
    """What two results have in common that came about alike."""
    told = {"id": ""} | {name: value for name, value in made.items() if name not in ("seconds", "model")}
    return hashlib.sha256(json.dumps([kind, prompt, told], sort_keys=True).encode()).hexdigest()


def results(word: str, names: Sequence[str], out: str | None, many: bool) -> Results:
    """Where the results of inputs of these names go; `many` where there is more than one."""
    if out is None or out == STREAM:
        not_to_terminal(out)
        return Lines() if many else Results()
    if is_folder(out):
        files = [name for name in names if name != STREAM and not name.endswith(LINES)]
        places = dict(zip(files, map(Path, targets(word, files, out))))
        return Folder(made_folder(out), places)
    if out.endswith(".jsonl"):
        return _lines_file(out, names)
    if out.endswith(".gz"):
        raise BadInput(f"-o {out}: results are not compressed; give a name that ends in .jsonl")
    if many:
        raise BadInput(f"-o {out}: several results need a folder, or a file of lines; give -o {out}/ or -o FILE.jsonl")
    return OneFile(Path(targets(word, names, out)[0]))


def _lines_file(out: str, names: Sequence[str]) -> LinesFile:
    place = Path(targets("", names[:1], out)[0])
    if any(name != STREAM and Path(name).resolve() == place.resolve() for name in names):
        raise BadInput(f"-o {out}: is an input and would be lost; give another file")
    try:
        return LinesFile(place)
    except OSError as error:
        raise BadInput(f"-o {out}: cannot be written ({error.strerror}); give another path") from None

"""What a stage is given: artifacts in files, one each or one a line, or on standard input; read as they come."""

import gzip
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from itertools import chain, islice
from pathlib import Path
from typing import IO, Any, NamedTuple

from apartgen.requests import file_name, slug
from apartgen.schemas import artifact
from apartgen.schemas.artifact import LARGEST, STREAM, Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen_cli.streams import sources

LINES = (".jsonl", ".jsonl.gz")
Judge = Callable[[Artifact[Any], str], Artifact[Any]]
"""Gives an artifact of this name on, or says what is wrong with it."""


class Given(NamedTuple):
    """One input: what errors call it, the file that holds it alone, its text or what is wrong with it."""

    label: str
    file: str | None
    data: bytes | ApartgenError


@dataclass(frozen=True)
class Read:
    """An input as an artifact, or what is wrong with it; `name` is what its result is called."""

    given: Given
    outcome: Artifact[Any] | ApartgenError
    name: str = ""

    @property
    def artifact(self) -> Artifact[Any]:
        """What was read."""
        assert isinstance(self.outcome, Artifact)
        return self.outcome

    @property
    def label(self) -> str:
        """What messages call it: its file or line, and its id."""
        id = self.outcome.made.id if isinstance(self.outcome, Artifact) else ""
        return f"{self.given.label} ({id})" if id and not self.given.file else self.given.label

    def row(self) -> dict[str, Any] | None:
        """What a list of failures holds of it: its file's name, or itself where it came in a stream."""
        if self.given.file is not None:
            return {"input": self.given.file}
        if isinstance(self.outcome, ApartgenError) or isinstance(self.given.data, ApartgenError):
            return None  # what can't be read can't be tried again
        return {"id": self.outcome.made.id, "artifact": json.loads(self.given.data)}


class Inputs(NamedTuple):
    """What a command is given: how many where that is known, and the files' names."""

    items: Iterator[Given]
    many: bool
    total: int | None
    files: list[str]


def inputs_of(names: Sequence[str] | None, retry: Path | None = None) -> Inputs:
    """The inputs of a command; `retry` is a list of failures to take in their place."""
    if retry is not None:
        if names:
            raise BadInput("--retry stands instead of inputs; give one of them")
        again = _failed(str(retry))
        return Inputs(iter(again), True, len(again), [given.file for given in again if given.file])
    found = sources(names)
    items = texts(found)
    first = list(islice(items, 2))
    streamed = any(name == STREAM or name.endswith(LINES) for name in found)
    return Inputs(chain(first, items), len(first) > 1, None if streamed and first[1:] else len(found), found)


def texts(names: Iterable[str]) -> Iterator[Given]:
    """Every input of files and streams, in order; lines are read when they are asked for."""
    for name in names:
        if name != STREAM and not name.endswith(LINES):
            yield _whole(name)
            continue
        label = "standard input" if name == STREAM else name
        try:
            yield from _streamed(label, name)
        except (OSError, EOFError) as error:
            told = getattr(error, "strerror", None) or error
            yield Given(label, None, BadInput(f"{label}: cannot be read ({told}); check the path"))


def _whole(name: str) -> Given:
    try:
        return Given(name, name, artifact.contents(name))
    except ApartgenError as error:
        return Given(name, name, error)


def _streamed(label: str, name: str) -> Iterator[Given]:
    with closing(_opened(name)) if name != STREAM else _left_open() as file:
        lines = ((i, line) for i, line in enumerate(iter(lambda: file.readline(LARGEST + 1), b""), 1) if line.strip())
        number, first = next(lines, (1, b""))
        if name == STREAM and not _one_value(first):
            yield Given(label, None, _limited(first + file.read(LARGEST + 1), label))
            return
        second = next(lines, None)
        if second is None:
            yield Given(label, None, _limited(first, label))
            return
        for i, line in ((number, first), second):
            yield Given(f"{label}:{i}", None, _limited(line, label))
        for i, line in lines:
            yield Given(f"{label}:{i}", None, _limited(line, label))


def _limited(data: bytes, label: str) -> bytes | ApartgenError:
    return data if len(data) <= LARGEST else BadInput(
        f"{label}: larger than {LARGEST // 2**20} MB; not an apartgen artifact")


def _one_value(line: bytes) -> bool:
    return line.strip().startswith(b"{") and line.strip().endswith(b"}")


class _left_open:
    """Standard input, which is not closed."""

    def __enter__(self) -> IO[bytes]:
        return sys.stdin.buffer

    def __exit__(self, *_: object) -> None:
        """Nothing."""


def _opened(name: str) -> Any:
    return gzip.open(name, "rb") if name.endswith(".gz") else open(name, "rb")


def artifacts(inputs: Iterable[Given], model: type[Record], whole: bool, judge: Judge) -> Iterator[Read]:
    """The inputs as artifacts."""
    for given in inputs:
        if isinstance(given.data, ApartgenError):
            yield Read(given, given.data)
            continue
        try:
            yield Read(given, judge(artifact.parse(given.data, given.label, model, whole), given.label))
        except ApartgenError as error:
            yield Read(given, error)


def named(reads: Iterable[Read]) -> Iterator[Read]:
    """The inputs with names: a file's own; in a stream the id's, else the prompt's words, told apart by digests."""
    taken: set[str] = set()
    for read in reads:
        if isinstance(read.outcome, ApartgenError):
            yield read
            continue
        name = read.given.file or _words(read.outcome)
        name = f"{name}-{read.outcome.digest[7:15]}" if name in taken else name
        taken.add(name)
        yield replace(read, name=name)


def _words(read: Artifact[Any]) -> str:
    return file_name(read.made.id) if read.made.id else slug(str(getattr(read.body, "prompt", "")))


def _failed(file: str) -> list[Given]:
    """The inputs of a list of failures."""
    found: list[Given] = []
    for i, line in enumerate(artifact.contents(file).splitlines(), 1):
        if not line.strip():
            continue
        row = artifact.json_value(line, f"{file}:{i}")
        if isinstance(row, dict) and isinstance(row.get("input"), str):
            found.append(_whole(row["input"]))
        elif isinstance(row, dict) and isinstance(row.get("artifact"), dict):
            found.append(Given(f"{file}:{i}", None, json.dumps(row["artifact"], ensure_ascii=False).encode()))
        else:
            raise BadInput(f"{file}:{i}: no input of a stage in it; give a list that --failures wrote")
    return found

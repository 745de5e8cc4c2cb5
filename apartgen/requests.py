"""What homes are asked for: prompts, one a line or as JSON, each with the id that it draws by and a name of its own."""

import hashlib
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from pydantic import ConfigDict, Field, ValidationError

from apartgen import planning
from apartgen.schemas import artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput

LARGEST_SEED = 2**63 - 1
"""What every reader of JSON and of tables takes for a whole number."""
_SLUG, _LONGEST_ID = 48, 1000
_SAFE, _LONGEST_NAME = re.compile(r"\w[\w.+-]*"), 100
_FILES = (".json", ".jsonl", ".txt", ".toml", ".csv", ".gz", ".yaml", ".yml", ".ifc", ".dxf", ".sh3d")


@dataclass(frozen=True)
class Request:
    """A home that is asked for.

    `id` tells it from others of the same words: where there is one, the plan draws from the seed and the id, else from
    the seed and the words. `settings` are by stage. `name` is what its files are called.
    """

    prompt: str
    id: str = ""
    seed: int | None = None
    settings: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    name: str = ""

    def row(self) -> dict[str, Any]:
        """The request as a line of a list."""
        values = {"id": self.id, "prompt": self.prompt, "seed": self.seed, "settings": dict(self.settings)}
        return {name: value for name, value in values.items() if value not in (None, "", {})}


class _Line(Record):
    """A request in JSON; `error` and `status` are what a list of failures adds."""

    model_config = ConfigDict(extra="forbid")
    prompt: str
    id: str | int = ""
    seed: int | None = Field(None, ge=0, le=LARGEST_SEED)
    settings: dict[str, dict[str, Any]] = Field(default_factory=dict)
    error: str | None = None
    status: int | None = None


def listed(data: bytes, source: str) -> list[Request | ApartgenError]:
    """The requests of a list, a line each: a prompt, or JSON with prompt, id, seed, settings; the error of a bad one.

    Every request has a name that no other of the list has.
    """
    lines = [(i, line.strip()) for i, line in enumerate(decoded(data, source).split("\n"), 1)]
    read = [_read(line, f"{source}:{i}") for i, line in lines if line]
    if not read:
        raise BadInput(f"{source}: no prompt in it; give one a line")
    return list(named(read))


def decoded(data: bytes, source: str) -> str:
    """Text as people give it."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeError:
        raise BadInput(f"{source}: not UTF-8 text; give it in that encoding") from None


def _read(line: str, where: str) -> Request | ApartgenError:
    try:
        return _of_json(line, where) if line.startswith("{") else Request(sentence(line))
    except ApartgenError as error:
        told = str(error)
        return type(error)(told if told.startswith(where) else f"{where}: {told}")


def _of_json(line: str, where: str) -> Request:
    value = artifact.json_value(line.encode(), where)
    if "apartgen" in value:
        raise BadInput(f"{where}: an artifact where a prompt is needed; plans are made from words")
    try:
        row = _Line.model_validate_json(json.dumps(value), strict=True)
    except ValidationError as error:
        raise BadInput(f"{where}: {artifact.first_fault(error)}; a line has prompt, id, seed, settings") from None
    if len(str(row.id)) > _LONGEST_ID:
        raise BadInput(f"{where}: the id has {len(str(row.id))} characters; at most {_LONGEST_ID} are read")
    return Request(planning.checked(row.prompt), str(row.id), row.seed, row.settings)


def named(read: Iterable[Request | ApartgenError]) -> Iterator[Request | ApartgenError]:
    """The requests, each with a name of its own; those of equal words get an id. BadInput for an id given twice."""
    read = list(read)
    taken = {file_name(one.id).lower() for one in read if isinstance(one, Request) and one.id}
    given: set[str] = set()
    for one in read:
        if isinstance(one, ApartgenError):
            yield one
        elif one.id:
            twice = file_name(one.id).lower() in given
            given.add(file_name(one.id).lower())
            yield BadInput(f"id {one.id[:60]!r} is given twice; ids tell homes apart") if twice else replace(
                one, name=file_name(one.id))
        else:
            name = _free(slug(one.prompt), taken)
            taken.add(name)
            yield replace(one, name=name, id="" if name == slug(one.prompt) else name)


def _free(name: str, taken: set[str]) -> str:
    """The name, or with the first number from 2 that makes it new."""
    if name not in taken:
        return name
    return next(f"{name}-{k}" for k in range(2, len(taken) + 3) if f"{name}-{k}" not in taken)


def slug(text: str) -> str:
    """The words of a text as a file's name."""
    return "-".join(re.findall(r"\w+", text.lower()))[:_SLUG].strip("-") or "plan"


def file_name(id: str) -> str:
    """What files of an id are called: the id, where it can be a name, else its words and a digest."""
    if _SAFE.fullmatch(id) and not id.endswith(".") and len(id.encode()) <= _LONGEST_NAME:
        return id
    return f"{slug(id)}-{hashlib.sha256(id.encode('utf-8', 'surrogateescape')).hexdigest()[:8]}"


def sentence(text: str) -> str:
    """A prompt as a person gives it; BadInput for what is a file's name or JSON."""
    text = planning.checked(text)
    if text[0] in "{[":
        raise BadInput("JSON where a sentence is expected; --prompts reads requests, --from a programme or rooms")
    if _named_so(text):
        raise BadInput(f"{text[:80]}: a file's name where a sentence is expected; --prompts reads prompts from a file, "
                       "--from a programme or rooms")
    return text


def _named_so(text: str) -> bool:
    """Whether this is a file's name, or the path of something that there is."""
    if text.lower().endswith(_FILES):
        return " " not in text or os.path.exists(text)
    return "/" in text and " " not in text and os.path.exists(text)

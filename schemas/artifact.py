"""Artifacts as files: the envelope around a stage's result, reading of any version, writing whole or not at all.

    {"apartgen": kind, "version": n, "made": {by, seed, config, inputs, seconds}, "body": {…}}

A later kind can be read wherever an earlier one is asked for, because Plan ⊂ Layout ⊂ Retrieve ⊂ Walkable; of a
populated home that is its furniture. Text is
deterministic: keys in the order of the types, numbers to 1e-6, one newline at the end.
"""

import hashlib
import json
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

from pydantic import Field, ValidationError

from apartgen.schemas import consistency, files, writing
from apartgen.schemas.base import Number, Record
from apartgen.schemas.errors import BadInput
from apartgen.schemas.export import Export
from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Metrics
from apartgen.schemas.migrations import VERSION, migrate
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import KIND as POPULATE
from apartgen.schemas.populate import Populate, furniture_only
from apartgen.schemas.render import Render
from apartgen.schemas.retrieve import Retrieve
from apartgen.schemas.walkable import Walkable

BODIES: dict[str, type[Record]] = {
    "plan": Plan, "layout": Layout, "retrieve": Retrieve, "walkable": Walkable, "populate": Populate,
    "export": Export, "metrics": Metrics, "render": Render,
}
"""The body type of every kind of artifact, in the order of the stages."""
LARGEST = 256 * 2**20
"""Bytes above which a file is refused."""
STREAM = "-"
"""Stands for standard input or output."""

Body = TypeVar("Body", bound=Record)
Other = TypeVar("Other", bound=Record)


class Made(Record):
    """How an artifact came about. `inputs` has the digest of every artifact it was made from, by kind."""

    by: str
    id: str = Field("", description="what its request was told from others by, where its words are not enough")
    seed: int = Field(ge=0)
    config: dict[str, Any] = Field(default_factory=dict)
    inputs: dict[str, str] = Field(default_factory=dict)
    model: dict[str, Any] = Field(default_factory=dict, description="a language model asked, its tokens and cost")
    seconds: Number = 0.0


class Envelope(Record, Generic[Body]):
    """What a file holds."""

    apartgen: str
    version: int
    made: Made
    body: Body


@dataclass(frozen=True)
class Artifact(Generic[Body]):
    """What was read. `digest` covers all of the file but `made.seconds`."""

    kind: str
    made: Made
    body: Body
    digest: str

    def save(self, path: str | Path) -> None:
        """Write the file, whole or not at all."""
        write(finish(self.body, self.made)[0], path)

    def taken_as(self, model: "type[Other]") -> "Artifact[Other]":
        """The same with its body as a `model`, fields of later stages left out; BadInput where it lacks some."""
        needed(self.kind, self.kind, model)
        kept = {name: getattr(self.body, name) for name in model.model_fields}
        return Artifact(self.kind, self.made, model.model_validate(kept, from_attributes=True), self.digest)


def kind_of(body: Record) -> str:
    """The kind whose body this is."""
    return next(kind for kind, type_ in BODIES.items() if type(body) is type_)


def accepted(model: type[Record]) -> list[str]:
    """The kinds that can be read where a `model` is asked for."""
    return [kind for kind, type_ in BODIES.items() if issubclass(type_, model)]


def read(source: str | Path, model: type[Body], whole: bool = False) -> Artifact[Body]:
    """The artifact in a file, or on standard input for "-".

    The body comes as a `model`, fields of later stages left out; with `whole`, as the type of the file's own kind.
    Raises BadInput, naming the file and the place in it.
    """
    return parse(contents(source), _name(source), model, whole)


def parse(data: bytes, name: str, model: type[Body], whole: bool = False) -> Artifact[Body]:
    """An artifact from its bytes; `name` says in errors where they came from."""
    raw = json_value(data, name)
    if not isinstance(raw, dict) or "apartgen" not in raw:
        raise BadInput(f'{name}: not an apartgen artifact (no "apartgen" at its top); make one with `apartgen plan`')
    kind = _kind(raw, name, model)
    digest = _digest(raw)
    raw = migrate(raw, name)
    asked = BODIES[kind] if whole else model
    if kind == POPULATE and not issubclass(asked, Populate):
        raw = raw | {"body": furniture_only(raw.get("body"))}
    return _validated(json.dumps(raw), name, kind, asked, digest)


def _validated(text: str | bytes, name: str, kind: str, asked: type[Record], digest: str) -> Artifact[Any]:
    """An artifact of the newest version from its JSON; BadInput names what in it is wrong."""
    try:
        envelope = Envelope[asked].model_validate_json(text, strict=True)  # type: ignore[valid-type]
    except ValidationError as error:
        raise BadInput(f"{name}: {first_fault(error)}; `apartgen schema {kind}` says what belongs there") from None
    if fault := next(consistency.faults(envelope.body), None):
        raise BadInput(f"{name}: body.{fault.where}: {fault.what}")
    return Artifact(kind, envelope.made, envelope.body, digest)


def finish(body: Body, made: Made) -> tuple[str, Artifact[Body]]:
    """The text to write, and the artifact as a reader of that text gets it (numbers rounded).

    Stages are handed what a file would hold, so that running them apart or together gives the same.
    """
    record = _record(body, made)
    read = _settled(record, type(body))
    return writing.laid_out(record) + "\n", read


def settled(body: Body, made: Made) -> Artifact[Body]:
    """The same artifact without the text, which takes as long as all the rest."""
    return _settled(_record(body, made), type(body))


def line_of(body: Record, made: Made) -> str:
    """The text to write on one line."""
    return writing.compact(_record(body, made)) + "\n"


def _record(body: Record, made: Made) -> dict[str, Any]:
    """What a file holds, numbers rounded."""
    record = {"apartgen": kind_of(body), "version": VERSION,
              "made": made.model_dump(mode="json", by_alias=True, exclude=set() if made.id else {"id"}),
              "body": body.model_dump(mode="json", by_alias=True)}
    return {name: writing.rounded(value) for name, value in record.items()}


def _settled(record: dict[str, Any], of: type[Body]) -> Artifact[Body]:
    kind = record["apartgen"]
    try:
        return _validated(writing.compact(record), kind, kind, of, _digest(record))
    except BadInput as error:
        raise RuntimeError(f"the {kind} stage made an inconsistent artifact: {error}") from error


def write(text: str, target: str | Path) -> None:
    """Put text in a file, whole or not at all, or on standard output for "-"."""
    if str(target) == STREAM:
        sys.stdout.write(text)
        sys.stdout.flush()
        return
    try:
        files.replace(text.encode(), Path(target))
    except OSError as error:
        raise BadInput(f"{target}: cannot be written ({error.strerror or error}); give another path with -o") from None


def as_line(text: str) -> str:
    """An artifact's text on one line."""
    return json.dumps(json.loads(text), ensure_ascii=False, separators=(",", ":")) + "\n"


def json_schema(kind: str) -> dict[str, Any]:
    """JSON Schema of an artifact file; BadInput for an unknown kind."""
    if kind not in BODIES:
        raise BadInput(f"no artifact kind {kind!r}; there are: {', '.join(BODIES)}")
    schema = Envelope[BODIES[kind]].model_json_schema(by_alias=True)  # type: ignore[valid-type]
    schema["properties"]["apartgen"] = {"const": kind, "type": "string"}
    schema["properties"]["version"] = {"const": VERSION, "type": "integer"}
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    return head | schema | {"title": kind, "description": (BODIES[kind].__doc__ or "").partition("\n")[0]}


def contents(source: str | Path) -> bytes:
    """The bytes of a file, or of standard input for "-"; BadInput where they cannot be had or are too many."""
    name = _name(source)
    try:
        if str(source) == STREAM:
            data = sys.stdin.buffer.read(LARGEST + 1)
        else:
            with open(source, "rb") as file:
                data = file.read(LARGEST + 1)
    except (OSError, ValueError) as error:  # no path has a null byte
        reason = getattr(error, "strerror", None) or error
        raise BadInput(f"{name}: cannot be read ({reason}); check the path") from None
    if len(data) > LARGEST:
        raise BadInput(f"{name}: larger than {LARGEST // 2**20} MB; not an apartgen artifact")
    return data


def _name(source: str | Path) -> str:
    return "standard input" if str(source) == STREAM else str(source)


def _constant(word: str) -> None:
    raise ValueError(f"{word} is not a number in JSON")


def json_value(data: bytes, name: str) -> Any:
    """What JSON text holds; BadInput, naming the place, for what is none."""
    if not data.strip():
        raise BadInput(f"{name}: empty; what should have written it failed or was never run")
    try:
        raw = json.loads(data.decode("utf-8-sig"), parse_constant=_constant)
        json.dumps(raw, ensure_ascii=False).encode()  # lone surrogates could be read but never written
    except UnicodeError:
        raise BadInput(f"{name}: not UTF-8 text; give a JSON file that apartgen wrote") from None
    except RecursionError:
        raise BadInput(f"{name}: nested too deeply; give a JSON file that apartgen wrote") from None
    except json.JSONDecodeError as error:
        where = f"line {error.lineno} column {error.colno}"
        ended = error.pos >= len(error.doc.rstrip()) or error.msg.startswith("Unterminated string")
        cut = "; the file may be cut off, make it again" if ended else ""
        raise BadInput(f"{name}: not JSON at {where}: {error.msg}{cut}") from None
    except ValueError as error:
        raise BadInput(f"{name}: not JSON: {error}") from None
    return raw


def _kind(raw: dict[str, Any], name: str, model: type[Record]) -> str:
    kind = raw["apartgen"]
    if not isinstance(kind, str) or kind not in BODIES:
        raise BadInput(f"{name}: apartgen: unknown kind {str(kind)[:40]!r}; there are: {', '.join(BODIES)}")
    needed(kind, name, model)
    return kind


def needed(kind: str, name: str, model: type[Record]) -> None:
    """BadInput where an artifact of this kind, named so, has not all of a `model`."""
    good = accepted(model)
    if kind not in good:
        article = "an" if kind[0] in "aeiou" else "a"
        raise BadInput(f"{name}: {article} {kind} artifact where {' or '.join(good)} is needed; {_remedy(good[0])}")


def _remedy(kind: str) -> str:
    return f"make it with `apartgen {kind}`"


def first_fault(error: ValidationError) -> str:
    """Place and nature of the first of a type's complaints, and how many more there are."""
    problems = error.errors(include_url=False)
    first = problems[0]
    path = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in first["loc"]).lstrip(".")
    message = first["msg"][0].lower() + first["msg"][1:]
    more = f" (and {len(problems) - 1} more)" if len(problems) > 1 else ""
    return f"{path}: {message}{more}"


def _digest(raw: dict[str, Any]) -> str:
    made = raw.get("made")
    kept = {k: v for k, v in made.items() if k != "seconds"} if isinstance(made, dict) else made
    text = json.dumps(raw | {"made": kept}, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return "sha256:" + hashlib.sha256(text.encode()).hexdigest()

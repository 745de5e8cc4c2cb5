"""Apartments as the judge reads them: of any stage or tool, one or many, even those that no stage would take."""

import json
from collections.abc import Iterator
from os import PathLike
from typing import Any, NamedTuple

from pydantic import ValidationError

from apartgen.schemas import artifact
from apartgen.schemas.artifact import BODIES, STREAM, Artifact, Envelope
from apartgen.schemas.errors import BadInput
from apartgen.schemas.migrations import migrate
from apartgen.schemas.plan import Plan
from apartgen.stages import check
from apartgen.stages.check import Fault


class Read(NamedTuple):
    """An apartment, where it comes from and of which kind it is."""

    name: str
    kind: str
    home: Plan


def texts(source: str) -> Iterator[tuple[str, bytes]]:
    """What a file holds, and its name: one JSON value, or several, a line each."""
    data, name = artifact.contents(source), "standard input" if source == STREAM else source
    lines = [(i, line) for i, line in enumerate(data.splitlines(), 1) if line.strip()]
    if len(lines) > 1 and all(_begins_and_ends(line) for _, line in lines):
        yield from ((f"{name}:{i}", line) for i, line in lines)
    else:
        yield name, data


def _begins_and_ends(line: bytes) -> bool:
    return line.strip().startswith(b"{") and line.strip().endswith(b"}")


def parsed(data: bytes, name: str, among: bool = False) -> Read | None:
    """The apartment in JSON text, whatever is wrong with it; BadInput where there is none.

    With `among` others, what is no apartment at all is passed over, as the pictures' and figures' files of a folder.
    """
    raw = artifact.json_value(data, name)
    kind = raw.get("apartgen") if isinstance(raw, dict) else None
    if among and kind not in artifact.accepted(Plan):
        return None
    if not isinstance(kind, str) or kind not in BODIES:
        raise BadInput(f'{name}: not an apartgen artifact ("apartgen" at its top must be one of {", ".join(BODIES)})')
    artifact.needed(kind, name, Plan)
    return Read(name, kind, _body(migrate(raw, name), kind, name))


def _body(raw: dict[str, Any], kind: str, name: str) -> Plan:
    try:
        envelope = Envelope[BODIES[kind]].model_validate_json(json.dumps(raw), strict=True)  # type: ignore[valid-type]
    except ValidationError as error:
        told = artifact.first_fault(error)
        raise BadInput(f"{name}: {told}; `apartgen schema {kind}` says what belongs there") from None
    body: Plan = envelope.body
    return body


def judged(home: Artifact[Any] | str | PathLike[str], strict: bool) -> list[Fault]:
    """What the judge has to say of an artifact, or of the one in a file, be it one that nothing else would read."""
    if isinstance(home, Artifact):
        return check.run(home.body, strict)
    name = str(home)
    read = parsed(artifact.contents(name), name)
    return check.run(read.home, strict) if read else []

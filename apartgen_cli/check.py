"""Certify apartments, or name every fault, by an independent judge."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from apartgen import checking
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen_cli.console import fail, log, progress
from apartgen_cli.inputs import Judge
from apartgen_cli.streams import sources

if TYPE_CHECKING:
    from apartgen.stages.check import Fault

Reader = Callable[..., Artifact[Any]]
REFUSED = 1
HOMES = Annotated[list[str] | None, typer.Argument(
    metavar="FILE", help="Artifacts of any stage, files of one a line, folders; - or a pipe is standard input.")]
JSON = Annotated[bool, typer.Option("--json", help="Write a line of JSON for every apartment.")]
STRICT = Annotated[bool, typer.Option("--strict", help="Refuse for what is else only noted, too.")]
NOTES = Annotated[bool, typer.Option("--notes", help="Show what is noted, too.")]


def _run(inputs: HOMES = None, as_json: JSON = False, strict: STRICT = False, notes: NOTES = False) -> int:
    """Faults go to standard output, one a line: code, ids, place, number. Exit status 0 when all apartments are
    certified, 1 when some are refused, 2 when some cannot be read.
    """
    from apartgen.stages import check

    worst = 0
    for read in _read(sources(inputs)):
        if isinstance(read, ApartgenError):
            fail(str(read))
            worst = max(worst, read.exit_code)
            continue
        found = check.run(read.home, strict)
        worst = max(worst, REFUSED if any(fault.refuses for fault in found) else 0)
        typer.echo(_record(read, found) if as_json else _told(read, found, notes))
    return worst


def _read(names: list[str]) -> Iterator[checking.Read | ApartgenError]:
    """Every apartment of files and folders, and what is wrong with what holds none."""
    files = [(str(file), Path(name).is_dir()) for name in names
             for file in (sorted(Path(name).rglob("*.json")) + sorted(Path(name).rglob("*.jsonl"))
                          if Path(name).is_dir() else [name])]
    count = 0
    for file, among in progress(files, "check", len(files)):
        try:
            for name, data in checking.texts(file):
                if read := checking.parsed(data, name, among):
                    count += 1
                    yield read
        except ApartgenError as error:
            count += 1
            yield error
    if not count:
        yield BadInput(f"{', '.join(names)}: no apartment in it; give artifacts, or a folder of them")


def reader(trust: bool) -> Reader:
    """How a stage reads its inputs."""
    return artifact.read if trust else read_sound


def read_sound(name: str, model: type[Any], whole: bool = False) -> Artifact[Any]:
    """An artifact for a stage; BadInput, naming the first fault, where its plan or its furniture's places have any."""
    return sound(artifact.read(name, model, whole), name)


def judge(trust: bool) -> Judge:
    """What a stage takes of what was read."""
    return (lambda read, name: read) if trust else sound


def sound(read: Artifact[Any], name: str) -> Artifact[Any]:
    """The artifact; BadInput, naming the first fault, where its plan or its furniture's places have any."""
    if fault := _first_fault(read.body):
        raise BadInput(f"{name}: {fault}; --trust takes it as it is")
    return read


def told(read: Artifact[Any], name: str) -> Artifact[Any]:
    """The artifact; its first fault is said."""
    if fault := _first_fault(read.body):
        log.warning("%s: %s", name, fault)
    return read


def _first_fault(home: Plan) -> str:
    from apartgen.stages import check

    found = check.quick(home)
    more = f", and {len(found) - 1} more" if found[1:] else ""
    return f"{found[0]}{more} (`apartgen check` names all faults)" if found else ""


def _told(read: checking.Read, found: "list[Fault]", notes: bool) -> str:
    refused = sum(fault.refuses for fault in found)
    counts = [f"{n} {what}{'s' * (n > 1)}" for n, what in ((refused, "fault"), (len(found) - refused, "note")) if n]
    head = f"{read.name}: {', '.join(['refused' if refused else 'certified', *counts])}"
    rows = [f"  {'' if fault.refuses else 'note: '}{fault}" for fault in found if fault.refuses or notes]
    return "\n".join([head, *rows])


def _record(read: checking.Read, found: "list[Fault]") -> str:
    faults = [{"code": fault.code, "of": fault.of, "at": fault.at, "value": fault.value, "refuses": fault.refuses,
               "text": str(fault)} for fault in found]
    refused = any(fault.refuses for fault in found)
    row = {"file": read.name, "kind": read.kind, "certified": not refused, "faults": faults}
    return json.dumps(row, ensure_ascii=False)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"check": _run}

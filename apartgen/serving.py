"""A warm worker: requests as lines of JSON in, answers as lines of JSON out, with all models loaded.

    {"do": "plan", "prompt": "studio", "seed": 7}       {"ok": true, "home": {…}}
    {"do": "walkable", "home": {…} or "home.json"}      {"ok": true, "home": {…}}
    {"do": "make", "prompt": "studio", "out": "home/"}  {"ok": true, "files": […]}
    {"do": "sing"}                                      {"ok": false, "status": 2, "error": "…"}

Every request may have a `tag`, which its answer then has, too.
"""

import json
import logging
import os
import socket
import stat
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO, Any

from pydantic import ConfigDict, Field, ValidationError

import apartgen
from apartgen.requests import LARGEST_SEED
from apartgen.schemas import artifact
from apartgen.schemas.artifact import LARGEST, Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput

log = logging.getLogger("apartgen")
STAGES = ("layout", "retrieve", "walkable", "populate")
_BACKLOG = 16


class Request(Record):
    """One line of what is asked for."""

    model_config = ConfigDict(extra="forbid")
    do: str
    tag: str | int | None = None
    prompt: str = ""
    home: dict[str, Any] | str | None = None
    out: str = ""
    seed: int | None = Field(None, ge=0, le=LARGEST_SEED)
    formats: list[str] | None = None
    settings: dict[str, Any] = Field(default_factory=dict)


def answers(lines: Iterable[bytes]) -> Iterator[str]:
    """An answer for every line, whatever is in it."""
    for line in lines:
        if line.strip():
            yield json.dumps(answer(line), ensure_ascii=False, separators=(",", ":")) + "\n"


def answer(line: bytes) -> dict[str, Any]:
    """The answer to one line; what goes wrong is told in it, too."""
    tag: dict[str, Any] = {}
    try:
        request = _read(line)
        tag = {} if request.tag is None else {"tag": request.tag}
        return tag | {"ok": True} | _DO[request.do](request)
    except ApartgenError as error:
        return tag | {"ok": False, "status": error.exit_code, "error": str(error)}
    except Exception as error:  # the next request is none the worse for it
        log.exception("a request could not be answered")
        return tag | {"ok": False, "status": 70, "error": f"{type(error).__name__}: {error}; please report it"}


def _read(line: bytes) -> Request:
    value = artifact.json_value(line, "the request")
    try:
        request = Request.model_validate_json(json.dumps(value), strict=True)
    except ValidationError as error:
        raise BadInput(f"the request: {artifact.first_fault(error)}") from None
    if request.do not in _DO:
        raise BadInput(f"the request: do: {request.do[:40]!r} is unknown; there are: {', '.join(_DO)}")
    return request


def _home(request: Request) -> Artifact[Any]:
    if isinstance(request.home, str):
        return apartgen.load(request.home)
    if request.home is None:
        raise BadInput("the request: home: give an artifact, or the path of one")
    return artifact.parse(json.dumps(request.home).encode(), "home", Record, whole=True)


def _told(made: Artifact[Any]) -> dict[str, Any]:
    return {"home": json.loads(artifact.line_of(made.body, made.made))}


def _plan(request: Request) -> dict[str, Any]:
    return _told(apartgen.plan(request.prompt, seed=request.seed or 0, **request.settings))


def _stage(request: Request) -> dict[str, Any]:
    function: Callable[..., Artifact[Any]] = getattr(apartgen, request.do)
    return _told(function(_home(request), seed=request.seed, **request.settings))


def _make(request: Request) -> dict[str, Any]:
    apartgen.make(request.prompt, _out(request), seed=request.seed or 0, formats=request.formats,
                  settings=request.settings)
    return {"files": sorted(str(file) for file in Path(request.out).rglob("*") if file.is_file())}


def _export(request: Request) -> dict[str, Any]:
    files = apartgen.export(_home(request), _out(request), request.formats or [], **request.settings)
    return {"files": [str(Path(request.out) / file.path) for file in files.files]}


def _out(request: Request) -> str:
    if not request.out:
        raise BadInput("the request: out: give the folder to write")
    return request.out


def _metrics(request: Request) -> dict[str, Any]:
    return {"values": apartgen.metrics(_home(request)).model_dump(mode="json")["values"]}


def _check(request: Request) -> dict[str, Any]:
    faults = apartgen.check(_home(request))
    return {"certified": not any(fault.refuses for fault in faults), "faults": [str(fault) for fault in faults]}


_DO: dict[str, Callable[[Request], dict[str, Any]]] = {
    "plan": _plan, **dict.fromkeys(STAGES, _stage), "make": _make, "export": _export, "metrics": _metrics,
    "check": _check}


def warm() -> None:
    """Load models, compiled functions and writers of formats, by making a home that nobody keeps."""
    with TemporaryDirectory() as folder:
        apartgen.make("studio", folder)


def listen(path: Path, told: Callable[[], None] = lambda: None) -> None:
    """Answer whoever connects to a socket that only its owner can open, one after another; `told` when it is there."""
    with _bound(path) as server:
        told()
        while True:
            connection, _ = server.accept()
            try:
                with connection, connection.makefile("rb") as lines:
                    for text in answers(read_lines(lines)):
                        connection.sendall(text.encode())
            except OSError as error:
                log.info("a connection ended: %s", error)


def read_lines(file: IO[bytes]) -> Iterator[bytes]:
    """Lines as they come, none longer than a file may be."""
    return iter(lambda: file.readline(LARGEST), b"")


@contextmanager
def _bound(path: Path) -> Iterator[socket.socket]:
    server = socket.socket(socket.AF_UNIX)
    try:
        if path.exists() and stat.S_ISSOCK(path.stat().st_mode) and not _alive(path):
            path.unlink()  # of a worker that was killed
        before = os.umask(0o177)
        try:
            server.bind(str(path))
        finally:
            os.umask(before)
    except OSError as error:
        server.close()
        raise BadInput(f"--socket {path}: cannot be opened ({error.strerror or error}); give another path") from None
    try:
        server.listen(_BACKLOG)
        yield server
    finally:
        server.close()
        path.unlink(missing_ok=True)


def _alive(path: Path) -> bool:
    with socket.socket(socket.AF_UNIX) as probe:
        try:
            probe.connect(str(path))
        except OSError:
            return False
    return True

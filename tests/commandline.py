"""The program, run in this process or in one of its own."""

import io
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

from apartgen_cli import main


class Done(NamedTuple):
    code: int
    out: str
    err: str


class _Pipe(io.StringIO):
    """Standard input as a pipe."""

    def __init__(self, data: bytes) -> None:
        super().__init__(data.decode("utf-8", "surrogateescape"))
        self.buffer = io.BytesIO(data)


def run(capsys, monkeypatch, *args: object, stdin: bytes | str = b"") -> Done:
    """One command line in this process; its standard output is no terminal."""
    monkeypatch.setattr(sys, "stdin", _Pipe(stdin.encode() if isinstance(stdin, str) else stdin))
    capsys.readouterr()
    code = main.status([str(arg) for arg in args])
    return Done(code, *capsys.readouterr())


def program(*args: object, stdin: str = "", **environment: str) -> Done:
    """One command line in a process of its own."""
    command = [sys.executable, "-m", "apartgen_cli", *map(str, args)]
    done = subprocess.run(command, input=stdin, capture_output=True, text=True, timeout=300,
                          env=os.environ | environment)
    return Done(done.returncode, done.stdout, done.stderr)


def timeless(folder: Path) -> dict[str, bytes]:
    """Every file's bytes by path, made.seconds left out."""
    files = {file.relative_to(folder).as_posix(): file.read_bytes() for file in folder.rglob("*") if file.is_file()}
    return {name: re.sub(rb'"seconds": [0-9.]+', b'"seconds": 0', data) if name.endswith(".json") else data
            for name, data in files.items()}

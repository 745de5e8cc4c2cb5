"""Reading JSON, JSON lines and their gzipped forms, and saying in a line what is wrong with a row."""

import gzip
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from apartgen.schemas.artifact import first_fault
from apartgen.schemas.errors import BadInput


def files(root: Path | None, source: str, what: str) -> list[Path]:
    """`root` itself or every JSON file below it, by name; BadInput when there is none."""
    if root is None or not root.exists():
        raise BadInput(f"{source}: name a file or folder of {what}" + (f"; {root} does not exist" if root else ""))
    found = [root] if root.is_file() else sorted(p for p in root.rglob("*") if ".json" in p.name and p.is_file())
    if not found:
        raise BadInput(f"{root}: holds no .json or .jsonl file; {source} reads {what}")
    return found


def rows(path: Path) -> Iterator[Any]:
    """Every value of a file: one of .json, one a line of .jsonl."""
    try:
        with gzip.open(path, "rt") if path.suffix == ".gz" else path.open() as file:
            if ".jsonl" in path.name:
                yield from (json.loads(line) for line in file if line.strip())
            else:
                yield json.loads(file.read())
    except (OSError, ValueError) as error:
        raise BadInput(f"{path}: cannot be read as JSON ({error})") from error


def fault(error: Exception) -> str:
    """What is wrong with a row, in one line."""
    return first_fault(error) if isinstance(error, ValidationError) else repr(error)

"""Reads the files of the lexicon: TOML whose every value is a line of JSON too, which is read many times faster."""

import itertools
import re
from functools import cache
from json import JSONDecoder
from pathlib import Path
from typing import Any


def tables(text: str) -> dict[str, dict[str, Any]]:
    """What `tomllib` gives of `[table]` lines and `key = "…"` or `key = ["…", "…"]` lines, with comments."""
    out: dict[str, dict[str, Any]] = {}
    rows: dict[str, Any] = {}
    decode = JSONDecoder().raw_decode
    for line in text.splitlines():
        if line.startswith("["):
            rows = out.setdefault(line[1 : line.index("]")], {})
        elif line and line[0] != "#":
            key, _, value = line.partition(" = ")
            rows[key.strip('"')] = decode(value)[0]
    return out


@cache
def languages() -> dict[str, dict[str, dict[str, Any]]]:
    """Every language's file, read once, by the language: its groups of phrases."""
    files = sorted((Path(__file__).parent / "lexicon").glob("*.toml"))
    return {file.stem: tables(file.read_text(encoding="utf-8")) for file in files}


def expand(pattern: str) -> list[str]:
    """`{a,b} c` → `a c`, `b c`."""
    if "{" not in pattern:
        return [pattern]
    parts = re.split(r"(\{[^}]*\})", pattern)
    options = [p[1:-1].split(",") if p.startswith("{") else [p] for p in parts]
    return [" ".join("".join(choice).split()) for choice in itertools.product(*options)]

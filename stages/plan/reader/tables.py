"""Reads the files of the lexicon: TOML whose every value is a line of JSON too, which is read many times faster."""

from json import JSONDecoder
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

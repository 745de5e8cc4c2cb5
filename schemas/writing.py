"""JSON as artifacts have it: numbers rounded, laid out so that people can read it and compare it line by line."""

import json
from typing import Any

DECIMALS = 6
"""Digits kept behind the point, in metres and radians."""
_LINE = 112
_CONTAINERS = {dict, list}
_QUOTED = json.encoder.encode_basestring
"""A string in JSON."""
_LINED = json.JSONEncoder(ensure_ascii=False, allow_nan=False).encode
"""JSON on one line; `json.dumps` would make an encoder anew for each of thousands of values."""
compact = json.JSONEncoder(ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode


def laid_out(value: Any, indent: int = 0) -> str:
    """JSON with short containers, and long rows of numbers, on one line."""
    if isinstance(value, str):
        return _QUOTED(value)
    if isinstance(value, dict):
        return _laid([f"{_QUOTED(key)}: {laid_out(item, indent + 1)}" for key, item in value.items()], "{}", indent)
    if not isinstance(value, list):
        return _LINED(value)
    rows = [repr(item) if type(item) is float else laid_out(item, indent + 1) for item in value]
    flat = _CONTAINERS.isdisjoint(map(type, value))
    return f"[{', '.join(rows)}]" if flat else _laid(rows, "[]", indent)


def _laid(rows: list[str], ends: str, indent: int) -> str:
    """The rows of a container on one line, where they are short and none is laid out itself, else one below another."""
    line = ", ".join(rows)
    if "\n" not in line and len(line) + len(ends) + indent <= _LINE:
        return ends[0] + line + ends[1]
    pad = " " * indent
    return f"{ends[0]}\n {pad}" + f",\n {pad}".join(rows) + f"\n{pad}{ends[1]}"


def rounded(value: Any) -> Any:
    """The same with its numbers to so many digits."""
    if isinstance(value, float):
        return round(value, DECIMALS) + 0.0  # no negative zero
    if isinstance(value, dict):
        return {name: rounded(item) for name, item in value.items()}
    if isinstance(value, list):
        return [round(item, DECIMALS) + 0.0 if type(item) is float else rounded(item) for item in value]
    return value

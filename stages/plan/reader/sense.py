"""Architectural common sense; the data is `sense.toml`."""

import tomllib
from functools import cache
from pathlib import Path
from typing import Any


@cache
def sense() -> dict[str, Any]:
    """The tables of `sense.toml`."""
    return tomllib.loads((Path(__file__).parent / "sense.toml").read_text(encoding="utf-8"))


def opens_onto(kind: str) -> list[str]:
    """Types a room of type `kind` opens onto, the preferred first."""
    return list(sense()["opens_onto"][kind])


def may_cross(kind: str) -> bool:
    """Whether a way to another room may lead through this one."""
    return kind in sense()["transit"]["types"]

"""A fault of use: its name, and the objects and openings that it is about."""

import tomllib
from functools import cache
from pathlib import Path
from typing import NamedTuple


class Fault(NamedTuple):
    """Something that those who live there would mind."""

    name: str
    objects: tuple[str, ...]


@cache
def weights() -> dict[str, float]:
    """How much each fault is minded, by name; 1 is what makes a piece of furniture useless."""
    table: dict[str, dict[str, float]] = tomllib.loads(Path(__file__).with_name("faults.toml").read_text())
    return {name: weight for group in table.values() for name, weight in group.items()}


@cache
def activities() -> dict[str, str]:
    """The group of each fault, by name."""
    table: dict[str, dict[str, float]] = tomllib.loads(Path(__file__).with_name("faults.toml").read_text())
    return {name: group for group, names in table.items() for name in names}

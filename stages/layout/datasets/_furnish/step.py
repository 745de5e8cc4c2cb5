"""The rules as read from `rules/*.toml`: what to put, where, and how much it matters."""

import tomllib
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from apartgen.schemas.base import RoomType

RULES = Path(__file__).parent / "rules"


@dataclass(frozen=True)
class Step:
    """Put `repeat` objects of one of the categories `put` at a place named as in `poses.PLACES`.

    `of`: what it relates to · `near`: what `prefer` looks at · `chance`: of being tried · `repeat`: how many, least
    and most · `gap`: kept from wall or neighbour, m · `distance`: range for `across`, m · `prefer`: weights of
    `prefer.FEATURES` · `use`: floor kept free in front, left, right, behind, m · `turn`: spread of yaw, rad ·
    `loose`: spread of place, m · `size`: share of the way from the usual to the greatest size (−1 … 1) · `weight`:
    among extras · `least`: floor area it takes, m² · `most`: no more than this many in the room · `slots`: not where
    fewer objects than this are still wanted · `need`: undone unless so many of what follows find a place ·
    `then`: what follows, related to what was placed (`anchor`, its index) unless it has its own `of`.
    """

    put: tuple[str, ...]
    at: str
    of: tuple[str, ...] = ()
    near: tuple[str, ...] = ()
    chance: float = 1.0
    repeat: tuple[int, int] = (1, 1)
    gap: tuple[float, float] = (0.01, 0.04)
    distance: tuple[float, float] = (2.0, 3.6)
    prefer: dict[str, float] = field(default_factory=dict)
    use: tuple[float, ...] | None = None
    turn: float = 0.0
    loose: float = 0.0
    size: float | None = None
    weight: float = 1.0
    least: float = 0.0
    most: int = 0
    slots: int = 1
    need: int = 0
    anchor: int = -1
    then: tuple["Step", ...] = ()


@dataclass(frozen=True)
class Setup:
    """One way to furnish a room: `core` in order of importance, then `extra` in random order.

    `count`: least, objects per m² beyond it, most · `must`: of each of these sets of categories at least one.
    """

    weight: float
    least: float
    most: float
    core: tuple[Step, ...]
    extra: tuple[Step, ...]
    count: tuple[float, float, float]
    must: tuple[tuple[str, ...], ...]

    def puts(self, categories: tuple[str, ...]) -> bool:
        """Whether the core has a place for any of the categories."""
        return any(set(step.put) & set(categories) for step in self.core)


def _step(row: dict[str, Any]) -> Step:
    row = {key: tuple(value) if isinstance(value, list) else value for key, value in row.items()}
    for key in ("put", "of", "near"):
        if isinstance(row.get(key), str):
            row[key] = (row[key],)
    for key in ("repeat", "gap"):
        if isinstance(row.get(key), int | float):
            row[key] = (row[key], row[key])
    row["then"] = tuple(_step(after) for after in row.get("then", ()))
    return Step(**row)


@cache
def setups(type: RoomType) -> tuple[Setup, ...]:
    """All ways to furnish a room of this type."""
    table = tomllib.loads((RULES / f"{type}.toml").read_text())
    shared = tuple(_step(row) for row in table.get("extra", []))
    return tuple(
        Setup(
            weight=row.get("weight", 1.0),
            least=row.get("least", 0.0),
            most=row.get("most", 1e9),
            core=tuple(_step(step) for step in row.get("core", [])),
            extra=tuple(_step(step) for step in row.get("extra", [])) + shared,
            count=tuple(row.get("count", table["count"])),
            must=tuple(tuple(names) for names in row.get("must", table.get("must", []))),
        )
        for row in table["setup"]
    )


@cache
def sizes() -> dict[str, dict[str, Any]]:
    """Sizes as sold, and floor needed for use, by category."""
    return tomllib.loads((RULES / "sizes.toml").read_text())


def use_of(step: Step, category: str) -> tuple[float, float, float, float]:
    """Floor kept free in front, left, right and behind the object, m."""
    given = step.use if step.use is not None else sizes().get(category, {}).get("use", ())
    front, left, right, back = (float(v) for v in [*given, 0.0, 0.0, 0.0, 0.0][:4])
    return front, left, right, back


@cache
def friends_of(category: str) -> frozenset[str]:
    """What may stand in the floor kept for the category's use."""
    return frozenset(sizes().get(category, {}).get("friends", ()))


def floor_for(category: str) -> float:
    """Floor area below which a room has none of the category, m²."""
    return float(sizes().get(category, {}).get("room", 0.0))


def most_of(step: Step, category: str, type: RoomType) -> int:
    """How many of the category a room of this type holds at most."""
    if step.most:
        return step.most
    limit: int | dict[str, int] = sizes().get(category, {}).get("most", 99)
    return limit.get(type, limit["other"]) if isinstance(limit, dict) else limit


@cache
def essentials(type: RoomType) -> tuple[frozenset[str], ...]:
    """Sets of categories of each of which a room of this type has at least one."""
    return tuple(frozenset(names) for names in setups(type)[0].must)

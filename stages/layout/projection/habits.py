"""What stands where by habit: a chair at its table, a hood over the hob (`habits.toml`)."""

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal

RULES = Path(__file__).parent / "habits.toml"
How = Literal["seat", "before", "facing", "opposite", "beside", "above", "flanks", "under", "over"]


@dataclass(frozen=True)
class Habit:
    """Objects `of` some categories stand in some way `at` others, `gap` m off; worth a way of `worth` m."""

    of: tuple[str, ...]
    at: tuple[str, ...]
    how: How
    worth: float
    gap: float = 0.0
    fit: bool = False


@cache
def habits() -> dict[str, tuple[Habit, ...]]:
    """The habits of every category that has any."""
    rows = tomllib.loads(RULES.read_text())["habit"]
    every = [Habit(**_frozen(row)) for row in rows]
    return {name: tuple(h for h in every if name in h.of) for name in {name for h in every for name in h.of}}


@cache
def across(end: Literal["of", "at"]) -> frozenset[str]:
    """Who looks at something across the room (`of`), or what they look at (`at`)."""
    found = {habit for some in habits().values() for habit in some if habit.how == "opposite"}
    return frozenset(name for habit in found for name in getattr(habit, end))


def _frozen(row: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(value) if isinstance(value, list) else value for key, value in row.items()}


@cache
def belongs_to(category: str, other: str) -> bool:
    """Whether an object of a category takes its place from one of another."""
    return any(other in habit.at for habit in habits().get(category, ()))

"""What is put where: the table `places.toml`, room by room."""

import tomllib
from functools import cache
from pathlib import Path
from typing import Literal, NamedTuple

from pydantic import ConfigDict, TypeAdapter
from pydantic.dataclasses import dataclass

from apartgen.stages.things import categories, small

How = Literal["each", "row", "stack", "grid", "pair", "one"]
Where = Literal["back", "front", "middle", "any"]


@dataclass(frozen=True, kw_only=True, config=ConfigDict(extra="forbid"))
class Rule:
    """One line of the table. `put` names kinds of which each thing is one; `n` is how many there are, `per` person or
    room; `at` the places, the best first, or with `mixed` in any order; `of` how many a stack or row has at most;
    `dish` a kind that they lie on together.
    """

    put: tuple[str, ...]
    at: tuple[str, ...]
    n: tuple[int, int] = (1, 1)
    per: Literal["room", "person"] = "room"
    how: How = "each"
    of: int = 6
    chance: float = 1.0
    where: Where = "any"
    mixed: bool = False
    lying: bool = False
    turned: float = 0.0
    near: str = ""
    dish: str = ""


class Spot(NamedTuple):
    """Categories of furniture, and the kind of their receptacles."""

    categories: frozenset[str]
    kind: str


@cache
def table() -> dict[str, tuple[Rule, ...]]:
    """The rules of every type of room, in order."""
    rows = _rows()
    return TypeAdapter(dict[str, tuple[Rule, ...]]).validate_python(rows["rooms"])


@cache
def spots(at: str) -> Spot:
    """What "kitchen_base inside" means; a name may be that of a group of the table, and means what is like it, too."""
    name, kind = at.split()
    names = set(_rows()["groups"].get(name, [name]))
    return Spot(frozenset(names | {c for c, row in categories.TABLE.items() if names.intersection(row.lineage)}), kind)


@cache
def bearers() -> frozenset[str]:
    """Categories of furniture that anything is put on or in."""
    found = {name for rules in table().values() for rule in rules for at in rule.at for name in spots(at).categories}
    return frozenset(found & set(categories.TABLE))


@cache
def _rows() -> dict[str, dict[str, list[str]]]:
    return tomllib.loads((Path(__file__).parent / "places.toml").read_text(encoding="utf-8"))


def unknown() -> list[str]:
    """Names in the table that mean nothing."""
    put = {name for rules in table().values() for rule in rules for name in (*rule.put, rule.dish) if name}
    named = {name for rules in table().values() for rule in rules for at in rule.at for name in spots(at).categories}
    return sorted((put - set(small.TABLE)) | (named - set(categories.TABLE) - {"floor"}))

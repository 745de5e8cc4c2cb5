"""How large furniture is at least, by who lives there and how much floor there is (`sizes.toml`)."""

import tomllib
from collections.abc import Mapping
from functools import cache
from math import inf
from pathlib import Path
from typing import Any, NamedTuple

from apartgen.stages.use.household import Duties


class Least(NamedTuple):
    """Least depth and width, m."""

    depth: float = 0.0
    width: float = 0.0


class Most(NamedTuple):
    """Greatest depth and width, m."""

    depth: float = inf
    width: float = inf


Sizes = Mapping[str, tuple[Least, ...]]
"""By category, at one look for a place after another."""
NONE = Least()
WHEN = ("in", "from", "night", "table", "people")


@cache
def _file() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "sizes.toml").read_text(encoding="utf-8"))


@cache
def most(name: str) -> Most:
    """How large a category is made at most."""
    return Most(**_file()["most"].get(name, {}))


@cache
def rows() -> tuple[tuple[dict[str, Any], dict[str, tuple[Least, ...]]], ...]:
    """When a row of the file holds, and sizes by category."""
    some = _file()["least"]
    return tuple(({key: row[key] for key in WHEN if key in row},
                  {name: tuple(Least(**look) for look in looks) for name, looks in row.items() if name not in WHEN})
                 for row in some)


def least(kind: str, area: float, due: Duties, sleepers: int) -> Sizes:
    """Of a room of this type and so much floor, m², in a home where so many sleep."""
    found: dict[str, tuple[Least, ...]] = {}
    for when, sizes in rows():
        low, high = when.get("people", (0, sleepers))
        if (when.get("in", kind) == kind and area >= when.get("from", 0.0) and low <= sleepers <= high
                and when.get("night", due.sleeps > 0) == (due.sleeps > 0)
                and when.get("table", due.eats > 0) == (due.eats > 0)):
            found |= sizes
    return found


def at_look(sizes: Sizes, name: str, look: int) -> Least:
    """What a category is at least at a look for a place, the first being 0."""
    looks = sizes.get(name, ())
    return looks[look] if look < len(looks) else NONE


def narrowest(sizes: Sizes, name: str) -> float:
    """The least of the widths of a category, m; 0 where it may be of any."""
    return min(look.width for look in sizes.get(name, (NONE,)))

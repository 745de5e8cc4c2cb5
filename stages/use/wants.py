"""What a room lacks for those who live there, and what it has too much of (`wants.toml`)."""

import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from apartgen.stages.use.kinds import BEDSIDE, DOUBLE, TABLES
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.rules.eat import diners
from apartgen.stages.use.rules.sleep import within_reach

SCREEN = 0.3
"""What a television stand without its television costs."""
NIGHTSTAND, CHAIR, TABLE = 0.5, 0.4, 0.8
"""What each that is lacking costs: two for a double bed, a chair for everyone who sleeps in the home, and a table."""
GUESTS, MOST_CHAIRS = 4, 8
"""Chairs wanted at a table where it is unknown who lives there, and the most that are wanted."""
LITTLE_TABLE = 1.0
"""At a table no longer than this two sit, m."""


class Lack(NamedTuple):
    """What is wanted or too much, by how many, and what that costs."""

    name: str
    number: float
    cost: float


class _Want(NamedTuple):
    name: str
    of: tuple[str, ...]
    number: int
    least_area: float
    each: int
    weight: float


@cache
def _table() -> dict[str, Any]:
    return tomllib.loads(Path(__file__).with_name("wants.toml").read_text())


@cache
def _wants(group: str, kind: str) -> tuple[_Want, ...]:
    rows = _table()[group].get(kind, {})
    return tuple(_Want(name, tuple(row["of"]), row.get("number", 1), row.get("from", 0.0), row.get("each", 0),
                       row["weight"]) for name, row in rows.items())


def lacks(room: Furnished) -> Iterator[Lack]:
    """Everything a room lacks or has too much of; nothing of a type of room that nothing is known about."""
    kind, area = room.site.kind, room.site.area
    for want in _wants("want", kind):
        number = min(want.each, len(room.site.windows)) if want.each else want.number
        missing = number - room.number(want.of)
        if area >= want.least_area and missing > 0:
            yield Lack(f"no {want.name}" if number == 1 or want.each else f"few {want.name}", missing,
                       missing * want.weight)
    for want in _wants("most", kind):
        if (over := room.number(want.of) - want.number) > 0:
            yield Lack(f"too many {want.name}", over, over * want.weight)
    yield from _of_groups(room)
    yield from _few(room)


def _of_groups(room: Furnished) -> Iterator[Lack]:
    """What belongs to a piece of furniture that is there."""
    for bed in room.which(DOUBLE):
        there = sum(within_reach(room, bed, i) for i in room.which(BEDSIDE))
        if room.site.kind == "bedroom" and there < 2:
            yield Lack("double bed without nightstand" if not there else "double bed with one nightstand", 2 - there,
                       (2 - there) * NIGHTSTAND)
    if room.site.meals and not room.number(TABLES | {"island"}):
        yield Lack("no table to eat at", 1, TABLE + 2 * CHAIR)
    for table in room.which(TABLES):
        missing = seats_wanted(room, table) - len(diners(room, table))
        if missing > 0:
            yield Lack("few chairs at the table", missing, missing * CHAIR)
    bare = room.count["tv_stand"] - room.count["tv"]
    if bare > 0:
        yield Lack("stand without television", bare, bare * SCREEN)


def seats_wanted(room: Furnished, table: int) -> int:
    """Chairs for those who sleep in the home, an even number of them; at a little table beside the one where they eat,
    two."""
    people = GUESTS if room.site.sleepers is None else max(2, min(room.site.sleepers, MOST_CHAIRS))
    longest = max(room.width[table], room.depth[table])
    little = longest <= LITTLE_TABLE and room.names[table] == "dining_table" and not room.site.meals
    return min(people + people % 2, 2 if little else MOST_CHAIRS)


def _few(room: Furnished) -> Iterator[Lack]:
    """How empty it is."""
    fixed, by_area = _table()["few"].get(room.site.kind, (0.0, 0.0))
    missing = fixed + by_area * room.site.area - len(room.upright)
    if missing > 0:
        yield Lack("few things", missing, missing * _table()["few_weight"])

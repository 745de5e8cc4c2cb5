"""What a room lacks for those who live there, and what it has too much of (`wants.toml`)."""

import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from apartgen.stages.use.kinds import (
    BEDS,
    BEDSIDE,
    CHAIRS,
    CLOTHES,
    COATS,
    COUNTERS,
    DESKS,
    DOUBLE,
    MACHINES,
    ON_THE_FLOOR,
    TABLES,
    WARDROBES,
    basic,
)
from apartgen.stages.use.room import Furnished
from apartgen.stages.use.rules.eat import diners
from apartgen.stages.use.rules.sleep import within_reach
from apartgen.stages.use.site import Site

MACHINE = 1.2
"""What it costs that nothing washes clothes where the home has its place for that."""
SCREEN = 0.3
"""What a television stand without its television costs."""
HOOKS = 0.5
"""What it costs that nothing takes coats in the room one enters, where that is no hall."""
NIGHTSTAND, CHAIR, TABLE, CLOSET, BERTH = 0.5, 0.4, 0.8, 1.8, 1.0
"""What each that is lacking costs: two for a double bed, a chair for everyone who sleeps in the home, a table, a place
for clothes where one sleeps in the living room, and a place to sleep for the second in a bedroom of two."""
FOR_TWO, LEAST_FOR_TWO = 10.0, 8.5
"""From so much floor on, m², a bed for one is minded in a bedroom (`household` counts two who sleep there from a little
less on), and the want of a double bed in the largest of a home."""
CUPBOARD, FAMILY, ROOMY = 0.3, 3, 7.0
"""What it costs that so many and more have no closed cupboard for coats in a hall of so much floor, m²."""
SEAT, MOST_SEATS, WIDE = 0.2, 6, 22.0
"""What each soft seat costs that more than four lack in a living room of so much floor, m²; so many are enough."""
SEATS = {"sofa": 3, "corner_sofa": 4, "armchair": 1}
"""How many sit there."""
DESK, SECOND_DESK, STUDY, TWO_DESKS = 0.2, 0.1, 8.0, {"bunk_bed": 10.0, "single_bed": 12.0}
"""What a desk costs that a bedroom lacks where no two share a bed, and the second for two; the floor of one that has
one, and of one where each of two who sleep in such beds has one, m²."""
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
    yield from _by_number(room.site, room.count, len(room.upright))
    yield from _of_groups(room)


def lacks_of(site: Site, names: Sequence[str]) -> Iterator[Lack]:
    """What a room with things of these categories lacks, wherever they are going to stand."""
    count = Counter(map(basic, names))
    yield from _by_number(site, count, sum(count[name] for name in ON_THE_FLOOR))
    beside = _number(count, BEDSIDE)
    if (site.kind == "bedroom" or site.sleeps) and count["double_bed"] and beside < 2:
        yield Lack("few nightstands", 2 - beside, (2 - beside) * NIGHTSTAND)
    yield from _of_home(site, count)
    missing = eat_together(site) - _number(count, CHAIRS)
    if _number(count, TABLES) and site.meals and missing > 0:
        yield Lack("few chairs", missing, missing * CHAIR)


def _by_number(site: Site, count: Counter[str], upright: int) -> Iterator[Lack]:
    """What there is too little or too much of, `upright` things standing on the floor."""
    for want in _wants("want", site.kind):
        number = min(want.each, len(site.windows)) if want.each else want.number
        missing = number - _number(count, want.of)
        if site.area >= want.least_area and missing > 0 and not (site.shared and want.name in _table()["for_parents"]):
            yield Lack(f"no {want.name}" if number == 1 or want.each else f"few {want.name}", missing,
                       missing * want.weight)
    for want in _wants("most", site.kind):
        apart = want.name in _table()["for_children"] and not count["double_bed"] and _sleep(count) > 1
        if (over := _number(count, want.of) - want.number - apart) > 0:
            yield Lack(f"too many {want.name}", over, over * want.weight)
    fixed, by_area = _table()["few"].get(site.kind, (0.0, 0.0))
    missing = fixed + by_area * site.area - upright
    if missing > 0:
        yield Lack("few things", missing, missing * _table()["few_weight"])


def belongings(site: Site) -> list[str]:
    """What a home keeps in this room for want of another: its washing machine, a television where one lives and sleeps
    in one room."""
    home, here = _table()["home"], {"laundry": site.laundry, "evenings": site.sleeps}
    return [category for what in here if here[what] for category in home[what]]


def arrivals(site: Site) -> list[str]:
    """What takes coats in the room that a home is entered by."""
    return list(_table()["home"]["arrivals"]) if any(hole.kind == "entrance" for hole in site.holes) else []


def _number(count: Counter[str], names: Iterable[str]) -> int:
    return sum(count[name] for name in names)


def _of_home(site: Site, count: Counter[str]) -> Iterator[Lack]:
    """What is missed where people eat, wash their clothes, sleep by twos or beside a sofa, and at a television's
    stand."""
    if site.kind == "bedroom" and site.sleepers is not None and site.area >= FOR_TWO and _sleep(count) == 1:
        yield Lack("bed for one where two sleep", 1, BERTH)
    if site.main and site.area >= LEAST_FOR_TWO and not count["double_bed"]:
        yield Lack("no double bed in the largest bedroom", 1, BERTH)
    due, desks = desks_due(count, site.area), _number(count, DESKS)
    if site.kind == "bedroom" and site.sleepers is not None and due > desks:
        yield Lack("few desks", due - desks, DESK * (desks < 1) + SECOND_DESK * (due > 1))
    if site.meals and not _number(count, COUNTERS):
        yield Lack("no table to eat at", 1, TABLE + 2 * CHAIR)
    if site.kind == "living_room" and _number(count, BEDS) and not _number(count, CLOTHES):
        yield Lack("no place for clothes", 1, CLOSET)
    if site.laundry and site.kind != "utility" and not _number(count, MACHINES):
        yield Lack("no machine to wash", 1, MACHINE)
    if site.entered and not _number(count, COATS):
        yield Lack("no place for coats", 1, HOOKS)
    many = site.sleepers or 0
    if site.kind == "hallway" and many >= FAMILY and site.area >= ROOMY and not _number(count, WARDROBES):
        yield Lack("no cupboard for the coats of many", 1, CUPBOARD)
    missing = min(many, MOST_SEATS) - sum(count[name] * n for name, n in SEATS.items())
    if site.kind == "living_room" and site.area >= WIDE and many > GUESTS and missing > 0:
        yield Lack("few seats beside the sofa", missing, missing * SEAT)
    bare = count["tv_stand"] - count["tv"]
    if bare > 0:
        yield Lack("stand without television", bare, bare * SCREEN)


def desks_due(count: Counter[str], area: float) -> int:
    """How many desks a bedroom has: none where two share a bed, one for each of two children if there is floor."""
    if count["double_bed"] or not count["bunk_bed"] + count["single_bed"]:
        return 0
    return int(area >= STUDY) + int(_sleep(count) > 1 and area >= TWO_DESKS[
        "bunk_bed" if count["bunk_bed"] else "single_bed"])


def _sleep(count: Counter[str]) -> int:
    """How many can sleep in such beds."""
    return 2 * (count["double_bed"] + count["bunk_bed"]) + count["single_bed"]


def _of_groups(room: Furnished) -> Iterator[Lack]:
    """What belongs to a piece of furniture that is there."""
    for bed in room.which(DOUBLE):
        there = sum(within_reach(room, bed, i) for i in room.which(BEDSIDE))
        if (room.site.kind == "bedroom" or room.site.sleeps) and there < 2:
            yield Lack("double bed without nightstand" if not there else "double bed with one nightstand", 2 - there,
                       (2 - there) * NIGHTSTAND)
    yield from _of_home(room.site, room.count)
    for table in room.which(TABLES):
        missing = seats_wanted(room, table) - len(diners(room, table))
        if missing > 0:
            yield Lack("few chairs at the table", missing, missing * CHAIR)


def seats_wanted(room: Furnished, table: int) -> int:
    """Chairs for those who sleep in the home, an even number of them; at a little table beside the one where they eat,
    two."""
    longest = max(room.width[table], room.depth[table])
    little = longest <= LITTLE_TABLE and room.names[table] == "dining_table" and not room.site.meals
    return min(eat_together(room.site), 2 if little else MOST_CHAIRS)


def eat_together(site: Site) -> int:
    """An even number of those who eat together."""
    people = GUESTS if site.sleepers is None else max(2, min(site.sleepers, MOST_CHAIRS))
    return people + people % 2

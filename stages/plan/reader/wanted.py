"""Rooms that people want beside those one needs: bedrooms for a household, and more as area allows, drawn by lot."""

import tomllib
from functools import cache
from math import exp
from pathlib import Path
from typing import Any

from numpy.random import Generator

from apartgen.schemas.rooms import kinds
from apartgen.stages.plan.reader.about import People
from apartgen.stages.plan.reader.desks import STUDY
from apartgen.stages.plan.reader.doors import Doors
from apartgen.stages.plan.reader.families import COUNTED
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.tokens import fold
from apartgen.stages.plan.reader.vocabulary import Trait

STUDIO = 38.0
"""Area up to which a home for one has no bedroom, m²."""
GUESTS = 62.0
"""Area from which a couple may have a second bedroom, m²."""


ROOM, ROOM_OUTSIDE = 1.08, 1.2
"""Rooms may want so much more than the area stated when another one is drawn, or the first balcony, which most homes of
any size have."""
UNKNOWN = 8.0
"""Area of a room of a type that not everybody knows, m²."""


@cache
def _data() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "wanted.toml").read_text(encoding="utf-8"))


def add_bedrooms(said: Said, home: Household, rng: Generator | None) -> None:
    """Bedrooms for the people named, where the prompt counts none; a loft has none."""
    known = home.of("bedroom")
    named = [e for e in known if not e.vague]  # "the grandmother's room" is one of theirs
    named = named or (known if {Trait.MASTER, Trait.KIDS} <= {label for e in known for label in e.labels} else [])
    people, counted = said.about.people, any(e.counted for e in known)
    beside = {Trait.STAFF, Trait.GUEST}
    beside |= {Trait.RELATIVE} if people and people.pairs and not people.singles else set()
    apart = bool(known) and all(beside & e.labels for e in known)
    child = bool(known) and all((beside | {Trait.KIDS}) & e.labels for e in known)
    child = child and any(Trait.KIDS in e.labels for e in known)  # "two kids' rooms and a guest room"
    couple, one = people is not None and people.pairs > 0, len(known) == 1 and not counted
    several = any(Trait.KIDS in p.labels and (p.count or 1) > 1 for p in said.rooms)
    ours = several and said.about.lived and not COUNTED.search(fold(said.prompt))  # "we want two kids' rooms"
    child = child and (one or couple or bool(said.dwelling) or ours)  # "a flat with two kids' rooms" has parents
    if (child or (apart and not counted)) and not ("bedroom" in home.totals or said.main_rooms):
        many = bedrooms(people, said.total_area, rng) if apart and people else 1
        home.add("bedroom", max(many, 1))  # of those whose child, guest or maid sleeps there
    unsaid = not (named or home.totals or said.main_rooms or said.dwelling == "studio")
    if not unsaid or any(kind == "bedroom" for kind, _ in home.banned):
        return
    if said.about.loft and not known:
        said.dwelling = "studio"
    elif said.about.people is not None:
        many = bedrooms(said.about.people, beside_study(said), rng)
        many = max(many, min(said.studies_for_work, 1))  # who has a study sleeps elsewhere
        home.add("bedroom", many - len(home.of("bedroom")))
        said.dwelling = said.dwelling if many else "studio"


def beside_study(said: Said) -> float | None:
    """Area of a home beside the studies of those who work there."""
    return None if said.total_area is None else said.total_area - STUDY * said.studies_for_work


def bedrooms(people: People, total: float | None, rng: Generator | None) -> int:
    """A bedroom a couple, a grown-up and a child; by lot, or in little area, pairs of children share one."""
    data, lot = _data()["household"], 1.0 if rng is None else float(rng.random())
    usual = data["area"][min(people.count, len(data["area"])) - 1]
    if people.count == 1:
        alone = total < STUDIO if total is not None else lot < 0.25
        return 0 if alone else 1
    if people.children == 0:
        guests = (total is None or total >= GUESTS) and lot < 0.35
        return people.pairs + people.singles + int(guests and people.pairs == 1 and people.singles == 0)
    tight = total is not None and total < 0.9 * usual
    sharing = people.children // 2 if tight or (total is None and lot < data["child_shares"]) else 0
    return people.pairs + people.singles + people.children - sharing


def add_rooms(said: Said, home: Household, doors: Doors, named: set[str], rng: Generator) -> None:
    """Rooms beyond the least, for a prompt that named rooms of these types only."""
    free = not named or (named <= {"bedroom"} and said.about.people is not None)
    if free:
        if said.total_area is None:
            said.flat_size *= exp(rng.normal(0.0, _data()["household"]["spread"]))
        _draw(said, home, doors, rng)
    if not said.about.loft:
        _fill(said, home, _data()["order"]["ample" if free else "roomy" if named <= {"bedroom"} else "lavish"])
    for room in home.rooms:
        room.factor *= exp(rng.normal(0.0, _data()["spread"].get(room.type, 0.0)))


def _draw(said: Said, home: Household, doors: Doors, rng: Generator) -> None:
    """Each kind of room by its share of homes, as long as it fits into the area."""
    beds = min(len(home.of("bedroom")), 5)
    lots = {name: float(rng.random()) < shares[beds] for name, shares in _data()["share"].items()}
    lots["second_balcony"] &= lots["balcony"]
    lots["study"] &= not said.studies_for_work
    for kitchen in home.of("kitchen"):
        living = home.of("living_room")
        if lots["open_kitchen"] and beds and not home.closed_kitchen:
            kitchen.labels.add(Trait.OPEN)
        elif lots["kitchen_off_living"] and living and beds:
            doors.links.append((kitchen, living[0]))
    for name, wanted in lots.items():
        fitting = "kitchen" not in name and not (said.about.loft and name in ("dining_room", "study"))
        if wanted and fitting and _fits(said, home, name):
            _add(home, name)


def _fits(said: Said, home: Household, name: str) -> bool:
    if (_kind(name), "") in home.banned:
        return False
    if said.total_area is None:
        return True
    more = _typical(_kind(name), {Trait.HALF} if name == "half_bath" else set(), 1)
    return size(home) + more <= (ROOM_OUTSIDE if name == "balcony" else ROOM) * said.total_area


def _fill(said: Said, home: Household, limit: float) -> None:
    """More rooms while the area stated is `limit` times what the rooms want."""
    if said.total_area is None:
        return
    for name in _data()["order"]["more"]:
        if said.total_area < limit * size(home):
            return
        kind = _kind(name)
        counted = any(e.counted for e in home.of(kind)) or kind in home.totals
        if (kind, "") not in home.banned and not counted and _there(home, name) < _most(home, name):
            _add(home, name)


def _there(home: Household, name: str) -> int:
    halves = sum(Trait.HALF in e.labels for e in home.of("bathroom"))
    return {"half_bath": halves, "full_bath": len(home.of("bathroom")) - halves}.get(name, len(home.of(_kind(name))))


def _most(home: Household, name: str) -> int:
    beds = len(home.of("bedroom"))
    return {"full_bath": min(1 + beds // 2, 3), "closet": min(beds, 2), "study": 2, "living_room": 2}.get(name, 1)


def _add(home: Household, name: str) -> None:
    for room in home.add(_kind(name)):
        if name == "half_bath":
            room.labels.add(Trait.HALF)
        if name == "second_balcony" and home.of("bedroom"):
            room.owner = home.of("bedroom")[0]


def _kind(name: str) -> str:
    return {"half_bath": "bathroom", "full_bath": "bathroom", "second_balcony": "balcony"}.get(name, name)


def size(home: Household) -> float:
    """Area that the rooms want by their types, m²."""
    beds = len(home.of("bedroom"))
    return sum(e.area or _typical(kinds()[e.type].base, e.labels, beds) * e.factor for e in home.rooms)


def _typical(kind: str, labels: set[Trait], beds: int) -> float:
    data = sense()
    named = [data["area_of"][key] for label in labels if (key := f"{kind}:{label}") in data["area_of"]]
    by_bedrooms = data["by_bedrooms"].get(kind)
    usual = by_bedrooms[min(beds, len(by_bedrooms) - 1)] if by_bedrooms else data["area"].get(kind, UNKNOWN)
    return float(min(named) if named else usual)

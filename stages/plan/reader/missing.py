"""Rooms a home has even when nobody says so."""

from typing import Any

from apartgen.stages.plan.reader.desks import STUDY
from apartgen.stages.plan.reader.doors import Doors
from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.loose import bathed
from apartgen.stages.plan.reader.mention import OPEN_TYPES
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def full_graph(said: Said, home: Household, doors: Doors) -> bool:
    """Whether the doors said connect all rooms named and make a home of them."""
    if len(home.rooms) < (3 if not said.graph else 2) or not doors.links:
        return _lone(said, home)
    seen, queue = {id(home.rooms[0])}, [home.rooms[0]]
    while queue:
        here = queue.pop()
        for a, b in doors.links:
            there = b if a is here else a if b is here else None
            if there is not None and id(there) not in seen:
                seen.add(id(there))
                queue.append(there)
    kinds = {e.type for e in home.rooms}
    lived_in = {"bathroom", "bedroom"} <= kinds and not said.graph
    home_like = {"living_room", "kitchen", "bathroom"} <= kinds or not (said.dwelling or home.totals or lived_in)
    met = all(len(home.of(kind)) == n for kind, n in home.totals.items())
    entered = said.graph or bool(kinds & {"hallway", *OPEN_TYPES})  # bedrooms and baths alone want a way in
    several = len(home.of("bedroom")) > 1  # "two bedrooms, one off the hall" is no whole plan
    entered = entered and (said.graph or not several or bool(kinds - {"bedroom", "hallway"}))
    return len(seen) == len(home.rooms) and home_like and met and entered


def _lone(said: Said, home: Household) -> bool:
    """One or two rooms and no word of a dwelling: exactly those."""
    homely = (
        not home.rooms
        or said.dwelling
        or home.totals
        or said.main_rooms
        or said.about.people
        or said.about.lived
        or said.total_area
        or home.banned
        or any(phrase.type == "any" and phrase.quantifier in (Det.OTHER, Det.ALL) for phrase in said.rooms)
        or _presumed(said)
        or _counted_off(said)
        or any(asked.to == "entrance" for asked in said.asked)  # what has an entrance is a home
        or any(e.labels & {Trait.KIDS, Trait.RELATIVE} for e in home.of("bedroom"))
        or (home.of("bedroom") and len(said.unread) > 1)  # what is told of people and purposes is told of a home
        or len(home.of("bedroom")) > 1
        or (bathed(said) and not home.of("bathroom"))
        or all(p.type in ("hallway", "any") and p.quantifier in (Det.THE, Det.EACH) for p in said.rooms)  # "every room"
    )
    return len(home.rooms) < 3 and not homely


def beside_usual(said: Said, home: Household) -> bool:
    """`a studio with a balcony, nothing else`: nothing beside the rooms that every home has and that are not named."""
    return bool(said.dwelling) and not said.described and not all(map(home.of, sense()["missing"]["always"]))


def _counted_off(said: Said) -> bool:
    """`1 bedroom, 1 bathroom`, `1 bedroom`: as flats are advertised, by numbers alone."""
    counted = [p.type for p in said.rooms if p.count == 1 and p.quantifier == Det.BARE and not p.negated]
    told = said.loose_objects or said.asked or any(p.objects or p.areas or p.bounds for p in said.rooms)
    alone = counted == ["bedroom"] and not told
    return (alone or sorted(counted) == ["bathroom", "bedroom"]) and len(counted) == len(said.rooms)


def _presumed(said: Said) -> bool:
    """`one bedroom, please, and two armchairs in the living room`: of a home whose other rooms need not be named."""
    told = [p for p in said.rooms if not p.negated and p.type not in ("", "any")]
    new = {p.type for p in told if p.quantifier != Det.THE}
    furnished = bool(said.loose_objects) or any(p.objects for p in told)
    one = any(p.type == "bedroom" and p.count == 1 for p in told)
    limited = any(p.bounds for p in told)
    return (furnished or limited) and one and any(p.type not in new for p in told)


def add_missing_rooms(said: Said, home: Household, doors: Doors) -> None:
    """Rooms a home has even when nobody says so."""
    data = sense()["missing"]
    banned = {kind for kind, label in home.banned if not label}
    if said.dwelling == "studio" and not home.of("bedroom"):
        banned.add("bedroom")
    if said.main_rooms and not home.totals.get("bedroom") and all(_of_many(e) for e in home.of("bedroom")):
        others = len(home.of("dining_room")) + len(home.of("study")) + len(home.of("bedroom"))
        least = int(said.main_rooms > 1 and not home.of("bedroom"))  # "2-Zimmer-Wohnung mit Arbeitszimmer"
        home.add("bedroom", max(said.main_rooms - 1 - others, least))
        if said.main_rooms == 1:
            said.dwelling = "studio"
            banned.add("bedroom")
    if not home.of("bedroom") and "bedroom" not in banned:
        home.add("bedroom", _bedrooms(said, data))
    for kind in data["always"]:
        if kind not in banned and not (home.of(kind) and kind != "bathroom"):
            _add_missing(kind, home, data)
    for room in [*home.of("bedroom"), *home.of("living_room")]:
        room.area = room.area or said.main_area
    if (
        home.of("bedroom")
        and "hallway" not in banned
        and not home.of("hallway")
        and not _around_living(said, home, doors)
    ):
        home.add("hallway")
    if not home.of("bedroom"):
        _studio(said, home)


def _of_many(bedroom: Entity) -> bool:
    """Whether it may be one of several nobody counted: `a three-room flat, the bedroom to the east`."""
    told = bedroom.labels & {Trait.MASTER, Trait.GUEST, Trait.KIDS}
    return not bedroom.counted and (bedroom.vague or bool(told))


def _around_living(said: Said, home: Household, doors: Doors) -> bool:
    """Whether all private rooms have doors to lived-in rooms, so that no hallway is wanted."""
    if said.dwelling == "studio":
        return True
    hubs = [
        e
        for s in said.statements
        for p in (*s.left, *s.right)
        for e in home.refs.get(id(p), [])
        if any(q.type == "any" for q in (*s.left, *s.right))
    ]
    if hubs:
        return True

    def served(e: Entity) -> bool:
        near = [b if a is e else a for a, b in doors.links if e in (a, b)]
        return any(n.type in OPEN_TYPES for n in near) or any(
            n.type == "bedroom" and e.type == "bathroom" for n in near
        )

    return all(served(e) for kind in ("bedroom", "bathroom") for e in home.of(kind))


def _bedrooms(said: Said, data: dict[str, Any]) -> int:
    if said.total_area is None:
        return int(data["bedrooms"])
    area = said.total_area - STUDY * said.studies_for_work
    return int(next(n for most, n in data["bedrooms_from_area"] if area < most))


def _add_missing(kind: str, home: Household, data: dict[str, Any]) -> None:
    if kind != "bathroom":
        home.add(kind)
        return
    beds = len(home.of("bedroom"))
    have = home.of("bathroom")
    full = [e for e in have if Trait.HALF not in e.labels]
    served = max(len({id(e.owner) for e in full}), len([e for e in full if Trait.ENSUITE in e.labels]))
    common = [e for e in full if (e.owner is None or e.owner.type == "hallway") and Trait.ENSUITE not in e.labels]
    if not have:
        home.add("bathroom", data["bathrooms"][min(beds, len(data["bathrooms"]) - 1)])
    elif any(e.exact for e in full) and beds < 2:
        return  # "one bedroom, one bathroom", whatever it is
    elif "bathroom" not in home.totals and not common and (not full or beds > served):
        home.add("bathroom")


def _studio(said: Said, home: Household) -> None:
    """One room to live and sleep in, the kitchen open to it."""
    for living in home.of("living_room")[:1]:
        told = [c for c, _ in [*living.objects, *said.loose_objects]]
        if not {"double_bed", "single_bed", "bunk_bed"} & set(told) and home.of("bathroom"):
            living.objects.append(("double_bed", 1))
        living.labels |= {Trait.LOFT} if said.about.loft else set()
    for kitchen in home.of("kitchen"):
        if Trait.SEPARATE not in kitchen.labels and not home.closed_kitchen:
            kitchen.labels |= {Trait.OPEN} if said.about.loft else {Trait.OPEN, Trait.SMALL}

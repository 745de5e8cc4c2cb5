"""Ways of living: what a room has or has not, whatever else is drawn for it, as people differ.

Of several contents those are furnished that lack least, so that without this nearly all would have what most have.
"""

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from apartgen.schemas.plan import Plan, Room
from apartgen.stages.use import lacks_of, site
from apartgen.stages.use.household import linen_in
from apartgen.stages.use.kinds import BEDS
from apartgen.stages.use.site import Site

BASKET, KEPT = "laundry_basket", 0.25
"""What is in one home of four where linen is kept, and then in no bedroom."""
SCREEN, WATCHED, FLOOR = {"tv_stand": 1, "tv": 1}, 0.55, 11.0
"""What is wanted in so many main bedrooms of so much floor, m²; it does not find a place in all, so that .14 of all
double beds have it (28 of 206), of people's one in five."""
SECOND = "loveseat"


class Way(NamedTuple):
    """In a share of the living rooms of so much floor, m², where so many people live, there are so many of these."""

    share: float
    floor: float
    counts: Mapping[str, int]
    people: int = 0


NO_SCREEN = Way(0.2, 0.0, {"tv_stand": 0, "tv": 0})
"""Where one sleeps in the living room, too."""
WAYS = (
    NO_SCREEN,
    Way(0.3, 20.0, {"corner_sofa": 1, "sofa": 0}),
    Way(0.25, 20.0, {"armchair": 2}),
    Way(0.35, 0.0, {"floor_lamp": 0}),
    Way(0.25, 0.0, {"side_table": 0}),
    Way(0.25, 16.0, {"side_table": 2}),
    Way(0.15, 0.0, {"pouffe": 1}),
    Way(0.4, 0.0, {"plant": 0}),
    Way(0.6, 28.0, {"armchair": 2, "floor_lamp": 1}, people=4),
    Way(0.2, 20.0, {"sofa": 2, "corner_sofa": 0, "armchair": 0}),
)
"""No television in one of five (of people's in one of five and more; few find no place for it), a corner sofa in as
many as people have; two armchairs and no floor lamp in as many as in 46 and 72 rooms of iTHOR,
Robot@VirtualHome and TDW, no side table in as many as of iTHOR's, two in fewer than its 11 of 25, an ottoman in
somewhat more. How many do without a plant they do not tell, nor what fills a wide room in which many people live with
one sofa: two armchairs, and a lamp to read by. The later of two that are at odds holds."""


def draw(plan: Plan, room: Room, chances: Sequence[float]) -> list[Mapping[str, int]]:
    """Those of a room, by a chance from 0 to 1 of each: of a living room, but for its screen only where nobody sleeps
    there, of the room in which linen is kept and bedrooms beside it, of the main bedroom."""
    place, linen = site(plan, room.id), linen_in(plan)
    if room.base != "living_room":
        near = linen and (linen == room.id or room.base == "bedroom")
        kept: list[Mapping[str, int]] = [{BASKET: int(linen == room.id and chances[0] < KEPT)}] if near else []
        children = any(asked.children for asked in plan.program.rooms if asked.id == room.id)
        watched = place.main and not children and place.area >= FLOOR and chances[1] < WATCHED
        return [*kept, SCREEN] if watched else kept
    ways = (NO_SCREEN,) if place.sleeps else WAYS
    return [way.counts for way, chance in zip(ways, chances, strict=False)
            if chance < way.share and place.area >= way.floor and (place.sleepers or 0) >= way.people]


def never(plan: Plan, room: Room) -> frozenset[str]:
    """What is not in a living room whose people sleep in bedrooms, unless it is asked for; the model may draw it on
    floors unlike those that it learned."""
    elsewhere = room.base == "living_room" and any(other.base == "bedroom" for other in plan.rooms)
    return BEDS | {"nightstand"} if elsewhere else frozenset()


def settled(wanted: Mapping[str, int], given: Iterable[str]) -> Counter[str]:
    """Contents of which every sofa beside another is a small one that completes its group, where armchairs would
    stand; there are as many of those as are asked for."""
    many, there = wanted.get("sofa", 0), Counter(given)
    round_ = wanted.get("corner_sofa", 0) + there["corner_sofa"] > 0
    more = many - max(there["sofa"], 0 if round_ else 1)
    if more < 1:
        return Counter(wanted)
    return Counter({"armchair": 0, **wanted, "sofa": many - more, SECOND: wanted.get(SECOND, 0) + more})


def called(asked: Mapping[str, int]) -> dict[str, str]:
    """What people call a sofa beside another who did not ask for it by its name."""
    return {} if asked.get(SECOND) else {SECOND: "sofa"}


def in_words(note: str, called: Mapping[str, str]) -> str:
    """What is said about things, as these are `called`."""
    return re.sub(r"\w+", lambda word: called.get(word[0], word[0]), note)


def forgone(place: Site, ways: Sequence[Mapping[str, int]]) -> float:
    """The energy of what some ways do without."""
    without = [name for counts in ways if not any(counts.values()) for name in counts]
    missed = {lack.name for lack in lacks_of(place, without)}
    return sum(lack.cost for lack in lacks_of(place, []) if lack.name not in missed)


def unless_told(ways: Sequence[Mapping[str, int]], told: set[str]) -> dict[str, int]:
    """Counts of those ways of whose things nothing is asked for or given."""
    return {name: count for counts in ways if told.isdisjoint(counts) for name, count in counts.items()}

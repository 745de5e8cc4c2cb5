"""Furniture of several bedrooms that is said of none: `two bedrooms, one double bed and two single beds`."""

from collections import Counter

from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.mention import Item, RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Trait
from apartgen.stages.things.categories import TABLE

BEDS = ("double_bed", "bunk_bed", "single_bed", "cot")
"""Beds by how many sleep in them: the main bedroom, told first, has the widest."""
ONE_EACH = ("wardrobe", "dresser")
"""What each bedroom has one of where there are as many as bedrooms."""

Furniture = list[tuple[Entity, str, int]]


def shared_out(loose: list[tuple[str, int]], bedrooms: list[Entity]) -> Furniture:
    """Beds by bedrooms, those first that have none yet, and what else each bedroom has one of."""
    if len(bedrooms) < 2:
        return []
    free = [e for e in bedrooms if not any(category in BEDS for category, _ in e.objects)] or bedrooms
    counts = [(category, count) for category, count in loose if category in ONE_EACH and count == len(bedrooms)]
    return _beds(loose, free) + [(e, category, 1) for category, _ in counts for e in bedrooms]


def _beds(loose: list[tuple[str, int]], free: list[Entity]) -> Furniture:
    """A double bed a room, then the others evenly among the children's rooms, else among those that are left."""
    said = sorted((BEDS.index(category), count) for category, count in loose if category in BEDS)
    wide = [BEDS[n] for n, count in said if n == 0 for _ in range(count)]
    narrow = [BEDS[n] for n, count in said if n > 0 for _ in range(count)]
    left = [e for e in free if Trait.KIDS in e.labels] or free[len(wide) :] or free
    step = min(len(left), len(narrow))
    dealt = [(free[k % len(free)], bed) for k, bed in enumerate(wide)]
    dealt += [(left[k * step // len(narrow)], bed) for k, bed in enumerate(narrow)]
    places = {id(room): room for room, _ in dealt}
    return [(places[at], bed, count) for (at, bed), count in Counter((id(room), bed) for room, bed in dealt).items()]


def usual_in(item: Item, room: RoomPhrase | None) -> bool:
    """Whether such a thing stands in such a room: `one-bedroom flat with a fridge, a sofa and a desk in the study`."""
    known = room is not None and item.value in TABLE and item.value != "chair"  # chairs go with their table
    return not known or (room is not None and room.type in TABLE[item.value].rooms)

"""Rooms that belong to others: an ensuite to its bedroom, a walk-in wardrobe to each of two."""

from typing import TYPE_CHECKING

from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.traits import lay
from apartgen.stages.plan.reader.vocabulary import Det, Trait

if TYPE_CHECKING:
    from apartgen.stages.plan.reader.household import Household


def own(home: "Household", owned: RoomPhrase, owners: list[Entity], all_of_them: bool = False) -> None:
    """Rooms that open off their owners."""
    if not owners or owned.negated:
        return
    if owned.type == "bathroom" and owned.quantifier != Det.ANOTHER:  # a suite has its bathroom already
        owners = [o for o in owners if Trait.SUITE not in o.labels or not _has_bath(home, o)]
    every = (
        all_of_them or owned.quantifier in (Det.EACH, Det.BARE, Det.OWN) or owned.plural or Trait.OWN in owned.labels
    )
    made: list[Entity] = []
    if owned.type == "bathroom" and owned.count and len(owners) > 1 and not _one_each(owned, all_of_them):
        owners, owned.count, every = owners[: int(owned.count)], None, True
    for owner in owners if every else owners[:1]:
        count = int(owned.count or (2 if owned.plural and len(owners) == 1 else 1))
        found = _claim(home, owned, count)
        found = [e for e in found if e is not owner]
        for entity in found:
            entity.owner = owner
        made += found
    lay(owned, made)
    home.refs[id(owned)] = made
    for inner in owned.owned:
        own(home, inner, made)


def _one_each(owned: RoomPhrase, all_of_them: bool) -> bool:
    """`each bedroom has one bathroom`, `three bedrooms with one bathroom each`."""
    return owned.count == 1 and (all_of_them or owned.quantifier == Det.EACH)


def _has_bath(home: "Household", owner: Entity) -> bool:
    return any(e.owner is owner for e in home.of("bathroom"))


def _claim(home: "Household", owned: RoomPhrase, count: int) -> list[Entity]:
    free = [
        e
        for e in home.of(owned.type)
        if e.owner is None and Trait.HALF not in e.labels and not e.labels & {Trait.FAMILY, Trait.SHARED_PAIR}
    ]
    within = (
        owned.type in home.totals
        or any(e.counted for e in free)
        or owned.quantifier == Det.THE
        or owned.type in ("kitchen", "dining_room")
    )
    named = [e for e in free if Trait.ENSUITE in e.labels]
    found = (named or (free if within else []))[:count]
    return found + home.add(owned.type, count - len(found))

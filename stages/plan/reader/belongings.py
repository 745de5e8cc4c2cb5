"""What may belong to a room: which of the rooms behind `with` open off it."""

from apartgen.stages.plan.reader.links import ANNEXES
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait
from apartgen.stages.things.categories import TABLE

OWNED_BY = {
    "closet": ("bedroom", "hallway"),
    "bathroom": ("bedroom", "hallway"),
    "balcony": ("living_room", "bedroom", "kitchen", "dining_room", "study"),
    "storage": ("kitchen", "hallway", "bathroom"),
    "utility": ("kitchen", "hallway", "bathroom"),
    "study": ("bedroom", "hallway"),
    "dining_room": ("living_room", "kitchen"),
    "kitchen": ("living_room",),
    "bedroom": ("hallway",),
}
"""What `A with a B` makes B: a room that opens off A."""


def of_the_first(before: list[Item], thing: Item) -> RoomPhrase | None:
    """The bedroom of `a bedroom off the hall with a double bed`: no hall has a bed. So, too, of rooms that are new:
    `a utility room off the kitchen with a washing machine`."""
    head, way, hub = ([Item("")] * 3 + before)[-3:]
    if way.kind != "link" or head.room is None or hub.room is None or thing.kind != "object":
        return None
    fits, first = TABLE[thing.value].rooms, head.room.type or "bedroom"
    new = head.room.quantifier == Det.A and not head.room.plural and (way.value, way.form) == ("door", "")
    one = hub.room.quantifier == Det.THE and not hub.room.plural
    told = first in fits and (hub.room.type not in fits or (new and one))
    return head.room if hub.room.quantifier == Det.THE and told else None


def is_the_suite(owner: RoomPhrase, room: RoomPhrase, bare: str, first: bool) -> bool:
    own = bare == "(" or (first and room.quantifier == Det.A and room.count is None and not room.labels)
    return Trait.SUITE in owner.labels and own and room.type == owner.type


def belongs(owner: RoomPhrase, item: Item, first: bool, after: list[Item], bare: str) -> bool:
    assert (phrase := item.room) is not None
    kind = owner.type or "bedroom"
    if phrase.headline or kind not in OWNED_BY.get(phrase.type, ()):
        return False
    if after and after[0].kind == "link" and after[0].value == "between":
        return False  # "two bedrooms with a bathroom in between"
    told = (after[0].value if after[0].value == "has" else after[0].text) if after and not phrase.count else ""
    if not first and (phrase.quantifier, told) in ((Det.THE, "has"), (Det.BARE, "with")):
        return False  # "the hallway has a coat rack, the bathroom has a mirror"
    if Trait.ADJOINING in phrase.labels and first:
        return True
    if kind == "hallway":
        return not bare and (first or phrase.type in ("bedroom", "bathroom", "study", *ANNEXES))
    if phrase.type == "bathroom":
        own = bool(phrase.labels & {Trait.ENSUITE, Trait.OWN}) or (Trait.SUITE in owner.labels and bare == "(")
        own = own and not phrase.labels & ({Trait.FAMILY} if Trait.OWN in phrase.labels else {Trait.FAMILY, Trait.HALF})
        lone = first and not bare and phrase.count in (None, 1) and not any(is_mark(i, ",") for i in after)
        lone = lone and not phrase.labels & _not_own(owner)
        lone = lone and not (phrase.exact and owner.plural and not _each_follows(after))  # "two bedrooms with one bath"
        theirs = first and (not owner.type or _each_follows(after))
        return own or lone or theirs or (not bare and _dressed(owner))
    if phrase.type in ("kitchen", "dining_room"):
        after_one = first or any(o.type in ("kitchen", "dining_room") for o in owner.owned)
        fits = phrase.type == "dining_room" or bool(phrase.labels & {Trait.OPEN, Trait.SMALL})
        return after_one and fits and not bare and phrase.count is None
    suite = bool(owner.owned) or Trait.SUITE in owner.labels
    listed = bare == "(" and suite and not owner.plural
    if not first and after and after[0].kind in ("link", "front"):
        return False
    alike = not owner.owned or bool(owner.owned[-1].quantifier) >= bool(phrase.quantifier)
    stored = phrase.type == "storage" and kind == "kitchen" and not bare and not owner.owned
    return first or stored or phrase.type in ("closet", "balcony") and (not bare or listed) and alike


def _not_own(owner: RoomPhrase) -> set[Trait]:
    """Traits of bathrooms that are not one room's own; one bedroom may have a half bath."""
    one = owner.type == "bedroom" and not owner.plural and owner.quantifier in (Det.A, Det.THE)
    return {Trait.FAMILY} if one else {Trait.FAMILY, Trait.HALF}


def _dressed(owner: RoomPhrase) -> bool:
    """`each with dressing room and bathroom`, `the main one with dressing room and bathroom`."""
    main = owner.type == "" and Trait.MASTER in owner.labels
    return (owner.quantifier == Det.EACH or main) and [o.type for o in owner.owned] == ["closet"]


def beside_another(owner: RoomPhrase, bath: RoomPhrase, after: list[Item]) -> bool:
    """`a suite with dressing room and bathroom, another bathroom`: the first is that of the suite."""
    suite = Trait.SUITE in owner.labels and not owner.plural and all(o.type == "closet" for o in owner.owned)
    suite = suite and bath.type == "bathroom" and bath.count in (None, 1)
    others = [i.room for i in after if i.room is not None and i.room.type == "bathroom"]
    return suite and not bath.labels and any(Trait.HALF not in other.labels for other in others)


def _each_follows(after: list[Item]) -> bool:
    return bool(after) and after[0].room is not None and after[0].room.quantifier == Det.EACH

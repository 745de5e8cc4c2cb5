"""What lies between rooms: which two these are, and whether it has a door to both or is only beside them."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import OPEN_TYPES, RoomPhrase
from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.vocabulary import Relation


def ends_before(before: list[RoomPhrase]) -> list[RoomPhrase]:
    """What `a bath in between` lies between: `two bedrooms`, or the last two of `a bedroom, a kitchen, and …`."""
    last = [room for room in before if not room.headline][-2:]
    single = len(last) > 1 and all(not r.plural and r.count in (None, 1) for r in last)
    return last if single else last[-1:]


def dines(hubs: list[RoomPhrase], ends: list[RoomPhrase]) -> bool:
    """`a dining room between the kitchen and the living room` is where one always is; no door is told from others."""
    return [h.type for h in hubs[-1:]] == ["dining_room"] and {e.type for e in ends} == {"kitchen", "living_room"}


def only_beside(hub: RoomPhrase, ends: list[RoomPhrase]) -> bool:
    """`the kitchen between the living room and the bedroom`: neighbours, for no way leads through a bedroom."""
    beds = any(e.type == "bedroom" for e in ends)
    if hub.type == "bathroom" and any(e.type in OPEN_TYPES for e in ends):
        return True  # no way leads through a bathroom
    return hub.type == "bedroom" or (beds and hub.type in (*OPEN_TYPES, "study"))


def at_table(statements: list[Statement]) -> list[Statement]:
    """A dining room between kitchen and living room is the way from one to the other where the kitchen has no other."""
    denied = [{r.type for r in (*s.left, *s.right)} for s in statements if s.kind == Relation.NOT]
    kind = Relation.DOOR if {"kitchen", "hallway"} in denied else None
    told = [replace(s, kind=kind) if kind and s.kind == Relation.BETWEEN else s for s in statements]
    return [s for s in told if s.kind != Relation.BETWEEN]

"""What stands among rooms and is none: doors counted, things that are no rooms; and `a bathroom each` of the home's."""

from apartgen.stages.plan.reader.clausal import ahead, last
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det


def doors_counted(out: list[Item], items: list[Item], k: int) -> bool:
    """The `two doors` of `the bathroom has two doors, one to the hall and one to the bedroom` count no rooms."""
    room = items[k].room
    counted = room is not None and not room.type and room.count is not None and last(out).kind == "with"
    if counted and ahead(items, k)[0].kind == "graph" and not is_mark(ahead(items, k)[1], ":"):
        items[k + 1] = Item("stop", "", items[k + 1].text)
        return True
    return False


def bath_each(out: list[Item], items: list[Item], k: int) -> bool:
    """`a two-bedroom flat with a bathroom each`: each of the bedrooms has one."""
    bath, each = items[k].room, ahead(items, k)[0].room
    owned = bath is not None and bath.type in ("bathroom", "balcony", "closet") and bath.quantifier == Det.A
    if not owned or each is None or each.type or each.quantifier != Det.EACH or last(out).kind != "with":
        return False
    beds = [i for i in out if i.room is not None and i.room.type == "bedroom" and (i.room.count or 1) > 1]
    if len(out) < 2 or out[-2].kind != "dwelling" or not beds:
        return False
    its = RoomPhrase("bedroom", quantifier=Det.EACH, text=beds[-1].text)
    out[-1:] = [Item("mark", ".", "."), Item("room", "bedroom", its.text, its), Item("with", "has", "has")]
    return False


def of_no_room(out: list[Item], items: list[Item], k: int) -> bool:
    """`a lounge, garage next to the kitchen`: what the relation is said of is no room; that is told elsewhere."""
    if items[k].kind == "link" and _nowhere(items, k):
        return True
    said_of = items[k - 1] if k else Item("")
    if said_of.kind != "thing" or items[k].kind != "link" or items[k].form in ("s", "p"):
        return False
    lists = len(out) > 1 and out[-1] is said_of and is_mark(out[-2], ",")
    if lists:
        out.pop()
    return lists


def _nowhere(items: list[Item], k: int) -> bool:
    """`far from the street and the lounge in front`: the relation leads to no room, and no other is joined to it."""
    thing, joint, room = ahead(items, k)
    after = items[k + 4] if k + 4 < len(items) else Item("mark", ".")
    joined = joint.kind == "conjunction" and room.room is not None and after.kind == "mark"
    return thing.kind == "thing" and not joined

"""What a text takes back: `four bedrooms. Actually, make it three bedrooms.`"""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det


def corrected(items: list[Item]) -> list[Item]:
    """Counts said anew stand in the place of those before; returns the items without the words that announce them."""
    anew = False
    out: list[Item] = []
    for item in _contrasted(items):
        if item.kind == "anew":
            anew = True
            continue
        room = item.room
        if anew and room is not None and room.count is not None and (before := _counted(out, room)) is not None:
            before.count, room.type = room.count, before.type
            before.plural = before.plural or room.count > 1
            room.quantifier, room.count, room.headline = Det.THE, None, False
            room.plural = room.plural or before.count > 1
        anew = anew and not is_mark(item, ".")
        out.append(item)
    return out


def _contrasted(items: list[Item]) -> list[Item]:
    """`not three bedrooms but two`: two."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        no, room, but, other = (items[k : k + 4] + [Item("")] * 4)[:4]
        a, b = room.room, other.room
        counted = a is not None and b is not None and a.count is not None and b.count is not None
        if no.kind == "negation" and but.text == "but" and counted and a is not None and b is not None:
            b.type, b.plural = b.type or a.type, b.plural or (b.count or 1) > 1
            out.append(Item("room", b.type, other.text, b))
            k += 4
        else:
            out.append(items[k])
            k += 1
    return out


def _counted(items: list[Item], room: RoomPhrase) -> RoomPhrase | None:
    """The last rooms of this type that were counted, or of any for `no, three`."""
    rooms = (i.room for i in reversed(items) if i.room is not None and not i.room.negated)
    return next((r for r in rooms if r.count is not None and room.type in ("", r.type)), None)

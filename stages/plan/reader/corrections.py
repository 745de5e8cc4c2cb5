"""What a text takes back: `four bedrooms. Actually, make it three bedrooms.`"""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det


def corrected(items: list[Item]) -> list[Item]:
    """Counts said anew stand in the place of those before; returns the items without the words that announce them."""
    anew = False
    out: list[Item] = []
    for item in items:
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


def _counted(items: list[Item], room: RoomPhrase) -> RoomPhrase | None:
    """The last rooms of this type that were counted, or of any for `no, three`."""
    rooms = (i.room for i in reversed(items) if i.room is not None and not i.room.negated)
    return next((r for r in rooms if r.count is not None and room.type in ("", r.type)), None)

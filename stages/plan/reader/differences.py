"""Areas said as more or less than another: `the second is 3 m² smaller`, `12 m² larger than the kitchen`."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, rooms_of

LESS, MORE = ("smaller", "less"), ("larger", "bigger", "more", "roomier")


def differs(before: list[Item], items: list[Item], k: int) -> Item | None:
    """What follows the area at `k` where it is a difference: a comparison, or `smaller` behind a verb."""
    more = items[k + 1] if k + 1 < len(items) and items[k].kind == "area" else Item("")
    if more.kind == "compare" and more.number > 0:
        return more
    verb = bool(before) and before[-1].kind == "copula"
    return more if more.kind == "size" and verb and more.text in (*LESS, *MORE) else None


def by_difference(before: list[Item], items: list[Item], k: int, known: list[RoomPhrase]) -> bool:
    """Gives the room spoken of its area; False where that of the other is not known."""
    one = next((i.room for i in reversed(before) if i.room is not None), None)
    others = rooms_of(items[k + 2 : k + 3]) if items[k + 1].kind == "compare" else _told_before(before, one)
    other = next((r for r in others if r.areas), None) or _same(others, [*known, *rooms_of(before)])
    if one is None or other is None or one.areas:
        return False
    sign = -1 if set(items[k + 1].text.split()) & set(LESS) else 1
    area = other.areas[0] + sign * items[k].values[0]
    one.areas = (area,) if area > 0 else ()
    return area > 0


def _told_before(before: list[Item], one: RoomPhrase | None) -> list[RoomPhrase]:
    """The last room that has an area in the sentence."""
    return [i.room for i in reversed(before) if i.room is not None and i.room is not one and i.room.areas][:1]


def _same(others: list[RoomPhrase], known: list[RoomPhrase]) -> RoomPhrase | None:
    """The earlier mention, with an area, of the room compared with."""
    told = [r for r in known for o in others if (r.type, r.ordinals, r.labels) == (o.type, o.ordinals, o.labels)]
    return next((r for r in reversed(told) if len(r.areas) == 1 and (r.count or 1) == 1), None)

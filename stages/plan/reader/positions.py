"""Where rooms are to lie: sides, corners, front and back, and the entrance."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.statements import Asked, Said

FACING = ("facing", "nach", "richtung", "plein", "expose", "hacia", "orientad", "朝", "向")
"""Words by which a side is that of a room's windows rather than its place."""


def role_of(items: list[Item], k: int) -> str:
    """What a side is said of: `entrance on the north side`, `party walls to the east and west`, `north entrance`."""
    start = k
    while start > 0 and (items[start - 1].kind in ("side", "conjunction") or is_mark(items[start - 1], ",")):
        start -= 1  # "party walls to the north, east and west"
    recent = items[max(0, start - 4) : k]
    room = max((j for j, i in enumerate(recent) if i.room is not None), default=-1)
    recent = recent[room + 1 :]  # "party walls to the east, balcony to the west"
    before = [i.value for i in recent if i.kind == "side_role"]
    ahead = items[k + 1 : k + 4]
    stop = next((j for j, i in enumerate(ahead) if i.room is not None or i.kind == "mark"), len(ahead))
    after = [i.value for i in ahead[:stop] if i.kind == "side_role"]
    return next(iter([*before[-1:], *after]), "")


def positions(items: list[Item], said: Said) -> list[Item]:
    """Adds what is asked of places to `said`; returns the items without the words that say only that."""
    out: list[Item] = []
    for k, item in enumerate(items):
        room = _known(_room(items, k), items)
        text = item.text.replace(" - ", "-")
        if item.kind == "place" or (item.kind == "side" and not role_of(items, k)):
            if room is None:
                said.unread.append(text)
            else:
                said.asked.append(_placed(item, room, text))
        elif _at_entrance(items, k) and room is not None:
            link = out.pop()
            if k + 1 < len(items) and items[k + 1].kind == "conjunction":
                out.append(Item("mark", ",", ","))  # "bedrooms far from the entrance and a kitchen next to …"
            kind = "apart" if link.value == "apart" else "near"
            said.asked.append(Asked(kind, [room], "entrance", "", f"{room.text} {link.text} {text}"))
        if item.kind != "place":
            out.append(item)
    return out


def _known(room: RoomPhrase | None, items: list[Item]) -> RoomPhrase | None:
    """`kitchen near the entrance` speaks of the kitchen named before."""
    if room is not None and room.quantifier == "" and room.count is None and not room.labels and not room.plural:
        earlier = next(i.room for i in items if i.room is not None and i.room.type == room.type)
        room.quantifier = "the" if earlier is not room else ""
    return room


def _placed(item: Item, room: RoomPhrase, text: str) -> Asked:
    kind = "orientation" if item.kind == "side" and any(word in item.text for word in FACING) else "position"
    return Asked(kind, [room], "", item.value, f"{room.text} {text}")


def _at_entrance(items: list[Item], k: int) -> bool:
    """`near the front door`, not of an entrance whose own side is said."""
    near = k > 0 and items[k - 1].kind == "link" and items[k - 1].value in ("near", "apart")
    return near and items[k].kind == "side_role" and items[k].value == "entrance"


def _room(items: list[Item], k: int) -> RoomPhrase | None:
    """The room whose place `items[k]` is: `south-facing lounge`, `on the left the bath`, `the kitchen at the back`."""
    if items[k].kind not in ("place", "side", "side_role"):
        return None
    opens = k == 0 or items[k - 1].kind in ("mark", "conjunction", "boundary")
    after = k + 1
    while opens and after < len(items) and items[after].kind in ("reach", "copula"):
        after += 1
    following = items[after].room if after < len(items) else None
    if following is not None and (opens or items[k].kind == "side"):
        return following
    for j in range(k - 1, -1, -1):
        if is_mark(items[j], ".") or items[j].room is not None:
            return items[j].room
    return following

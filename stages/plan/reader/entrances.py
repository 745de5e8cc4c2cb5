"""Rooms near the way into a home or far from it: what is said of an entrance."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.vocabulary import OPPOSITE, Det

WAYS_IN = ("entry", "entrada", "entree", "l'entree")
"""Halls, and also where one comes in."""


def at_entrance(items: list[Item], k: int, said: Said) -> bool:
    """`near the front door`, not of an entrance whose own side is said; `close to it` where that is the entrance."""
    near = k > 0 and items[k - 1].kind == "link" and items[k - 1].value in ("near", "apart")
    told = bool(said.asked) and said.asked[-1].to == "entrance"
    it = items[k].value == "it" and (told or _of_entrance(items[:k]))
    room = items[k].room
    article = room is not None and (room.quantifier == Det.THE or room.text.startswith("l'"))
    the = article or items[k - 1].text.endswith((" la", " der", " zum"))
    way_in = room is not None and room.text in WAYS_IN and the
    return near and (it or way_in or (items[k].kind == "side_role" and items[k].value == "entrance"))


def and_entrance(items: list[Item], k: int) -> bool:
    """`away from the kitchen and the entrance`."""
    way_in = items[k].kind == "side_role" and items[k].value == "entrance"
    joined = k > 2 and items[k - 1].kind == "conjunction" and items[k - 2].room is not None
    return way_in and joined and link_before(items, k) < k


def and_room(items: list[Item], k: int) -> int:
    """How many items stand between the entrance at `k` and another room of the relation; 0 where no other follows."""
    joint, to, room, *rest = (items[k + 1 : k + 5] + [Item("mark", ".")] * 4)[:4]
    if joint.kind != "conjunction":
        return 0
    again = to.kind in ("link", "front") and to.value in ("to", "from") and room.room is not None
    if again and not rest[0].kind == "copula":
        return 2
    ends = room.kind == "mark" and room.value in ".;"
    return int(to.room is not None and to.room.quantifier == Det.THE and ends)


def link_before(items: list[Item], k: int) -> int:
    """Where the `near` or `far from` stands whose rooms end before `and` at `k - 1`; `k` where none does."""
    j = k - 2
    while j > 0 and (items[j].room is not None or items[j].kind == "conjunction" or is_mark(items[j], ",")):
        j -= 1
    facing = items[j].text.startswith(OPPOSITE)
    return j if items[j].kind == "link" and items[j].value in ("near", "apart") and not facing else k


def near_behind(items: list[Item], k: int) -> bool:
    """Chinese says `the entrance's nearness`."""
    role = items[k].kind == "side_role" and items[k].value == "entrance" and not items[k].text.isascii()
    return role and k + 1 < len(items) and items[k + 1].kind == "link" and items[k + 1].value == "near"


def there(items: list[Item], k: int) -> list[RoomPhrase]:
    """The room behind `near the entrance is` that begins a clause; Chinese may leave out its verb."""
    opens = k < 3 or items[k - 3].kind in ("mark", "conjunction", "boundary")
    verb = k < len(items) and items[k].kind in ("copula", "reach")
    opens = opens and (verb or not items[k - 1].text.isascii())
    ahead = [i for i in items[k : k + 2] if i.kind not in ("copula", "reach", "with")]
    return [room for i in ahead[:1] if opens and (room := i.room) is not None]


def _of_entrance(before: list[Item]) -> bool:
    """Whether the sentence before speaks of the entrance alone: `The entrance is in the south. …`."""
    stops = [k for k, i in enumerate(before) if is_mark(i, ".")][-2:]
    last = before[stops[0] + 1 if len(stops) > 1 else 0 : stops[-1]] if stops else []
    return any(i.value == "entrance" for i in last) and all(i.room is None for i in last)

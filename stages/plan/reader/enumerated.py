"""Lists of rooms that are the subject of a verb: `the kitchen, the living room and both bedrooms face south`."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det

KNOWN = (Det.THE, Det.BOTH, Det.ALL, Det.EACH, Det.OTHER)
"""Words of rooms that the reader of a text knows."""
PLURAL = ("face", "look", "are", "lie", "have", "overlook", "get", "sit", "need", "朝", "向", "all", "both")
MODAL = ("should", "must", "shall", "may", "can", "will", "would", "ought", "has", "had")
"""First words of a verb that is said of several, and of one that may be."""
SINGULAR = ("faces", "is", "looks", "lies", "has", "overlooks", "gets", "sits", "needs")
VERB = ("copula", "reach", "link", "with")


def subjects_listed(items: list[Item], j: int, k: int) -> list[RoomPhrase]:
    """The rooms of the list that ends at `j` where the verb before `k` is said of all of them, else none."""
    told = [i for i in (*items[j + 1 : k], items[k]) if i.kind in (*VERB, "side", "place") or _all(i)]
    verb = told[0].text.split()[0] if told else ""
    start = _start(items, j)
    first, *others = rooms = [i.room for i in items[start : j + 1] if i.room is not None]
    listed = start > 0 and is_mark(items[start - 1], ",") and all(r.quantifier == Det.THE for r in rooms)
    if not verb and items[k].bounds and listed:
        return rooms  # "…, the kitchen and the study at most 9 m²"
    if not others or not verb or verb in SINGULAR:
        return []
    opens = start == 0 or items[start - 1].kind in ("mark", "boundary", "relative")
    opens = opens and (not is_mark(items[start - 1], ",") or not verb.isascii())
    known, bare = first.quantifier in KNOWN and _alike(others), opens and _plain(first) and _alike(others)
    counted = len(others) == 1 and (first.quantifier == Det.THE or bare or not verb.isascii()) and _some(others[0])
    if verb in PLURAL:
        return rooms if known or bare or counted else []
    with_ = start > 0 and items[start - 1].kind == "with"
    return rooms if known and (verb in MODAL or with_ or opens) else []


def known_list(items: list[Item], j: int) -> list[RoomPhrase]:
    """The rooms of the list that ends at `j`, where all of them are known ones or a sentence begins with them."""
    start = _start(items, j)
    rooms = [i.room for i in items[start : j + 1] if i.room is not None]
    measured = max((n + 1 for n, r in enumerate(rooms[:-1]) if r.areas), default=0)
    rooms = rooms[measured:]  # "each bedroom at least 11 m², the kitchen and the lounge together 30 m²"
    opens = start == 0 or is_mark(items[start - 1], ".;:")
    fits = rooms and (rooms[0].quantifier in KNOWN or (opens and _plain(rooms[0])))
    return rooms if fits and _alike(rooms[1:]) else []


def _alike(others: list[RoomPhrase]) -> bool:
    return all(r.quantifier in KNOWN or _plain(r) for r in others)


def _start(items: list[Item], j: int) -> int:
    """Where the list that ends at `j` begins: after what leads to a room, and after rooms that are new."""
    at, joints = j, 0
    while at > 1 and _joins(items[at - 1]) and _may_be_subject(items[at - 2].room):
        if is_mark(items[at - 1], ",") and not joints:
            break
        joints += 1
        at -= 2
        if is_mark(items[at - 1], ",") and items[at - 2].kind == "conjunction":
            break
    if at > 0 and items[at - 1].kind in ("link", "front", "beside"):
        at += 2  # "next to the kitchen, the lounge and the study face south"
    return min(at, j)


def _joins(item: Item) -> bool:
    return item.kind == "conjunction" and item.value != "or" or is_mark(item, ",")


def _may_be_subject(room: RoomPhrase | None) -> bool:
    return room is not None and bool(room.type) and not room.negated and (room.quantifier in KNOWN or _plain(room))


def _plain(room: RoomPhrase) -> bool:
    """A room without article or number."""
    return room.quantifier == Det.BARE and room.count is None and not room.headline


def _some(room: RoomPhrase) -> bool:
    """`two bedrooms`, `one of the bedrooms`."""
    return room.quantifier == Det.ONE_OF or (room.quantifier == Det.BARE and room.count is not None)


def _all(item: Item) -> bool:
    """The `all` of `should all face south`."""
    return item.room is not None and not item.room.type and item.room.quantifier in (Det.ALL, Det.BOTH)

"""Of which rooms a place is said: `on the left the kitchen and the bath`, `north of A is B`, `it is at the back`."""

from apartgen.stages.plan.reader.enumerated import KNOWN, subjects_listed
from apartgen.stages.plan.reader.faced import subject_of
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det

LEADING = ("on", "at", "in", "to", "along", "im", "an", "auf", "links", "rechts", "hinten", "vorne", "a", "au",
           "en", "al")  # fmt: skip
"""First words of a place that is said of the rooms behind it."""

AGAIN = ("be", "lie", "sit")
"""Verbs behind a modal that was said before: `it should be next to the bath and be at the back`."""
SINGULAR = ("oriente ", "orientee ", "expose ", "exposee ", "orientado ", "orientada ")
"""What a side begins with that is said of one room."""


def side_of(item: Item) -> str:
    """`left` of `to the left of`, which may also begin a sentence of doors: `on the left of the hall are …`."""
    if item.kind == "beside":
        return item.value
    words = item.text.split() if item.kind == "front" else []
    return next((w for w in words if w in ("left", "right")), "")


def rooms_placed(items: list[Item], k: int) -> list[RoomPhrase]:
    """The rooms whose place `items[k]` is: `south-facing lounge`, `on the left the bath`, `the kitchen at the back`."""
    if items[k].kind not in ("place", "side", "side_role", "beside", "front", "pronoun", "room", "link"):
        return []
    if side_of(items[k]):
        return _beside_what(items, k)
    opens = k == 0 or items[k - 1].kind in ("mark", "conjunction", "boundary")
    after = k + 1
    if opens and after < len(items) and is_mark(items[after], ":"):
        return _list(items, after + 1, headed=True)
    while opens and after < len(items) and items[after].kind in ("reach", "copula"):
        after += 1
    following = items[after].room if after < len(items) else None
    if following is not None and following.headline:
        following = None  # "in the corner of a one-bedroom flat"
    if following is not None and opens and items[k].text.split()[0] in LEADING:
        return _list(items, after)
    if following is not None and (opens or items[k].kind == "side"):
        return [following]
    for j in range(k - 1, -1, -1):
        if items[j].room is not None and j and items[j - 1].value == "except":
            continue  # "every room other than the bathroom has a window to the west"
        if is_mark(items[j], ".") and any(i.kind == "pronoun" and i.value == "it" for i in items[j:k]):
            return _spoken_of(items, j)
        j = subject_of(items, _first_of(items, j, k), k)
        if is_mark(items[j], ".") or items[j].room is not None:
            return _pair(items, j - 1 if seen_from(items, k) else j, k)
    return [following] if following else []


def _first_of(items: list[Item], j: int, k: int) -> int:
    """Where the study of `the study is far from the kitchen, near the entrance` stands; `j` where there is no such."""
    apart = [i for i in items[j + 1 : k] if i.kind != "link" and i.text not in AGAIN]
    way = j - 1
    subject = way - 1
    while subject > 0 and items[subject].kind in ("copula", "link", "with"):
        subject -= 1
    if subject < 0:
        return j
    again = any(i.text in AGAIN for i in items[j + 1 : k])
    near = items[way].kind == "link" and (again or items[way].value in ("near", "apart"))
    said = items[j].room is not None and near
    joint = len(apart) == 1 and (is_mark(apart[0], ",") or apart[0].kind == "conjunction")
    fits = said and joint and (k + 1 == len(items) or not items[k + 1].room)
    return subject if fits and items[subject].room is not None else j


def _spoken_of(items: list[Item], end: int) -> list[RoomPhrase]:
    """What `it` is after a sentence: what somebody has or what there is, else what the sentence is about."""
    start = max((j + 1 for j in range(end) if is_mark(items[j], ".")), default=0)
    before = items[start:end]
    rooms = [i.room for i in before if i.room is not None and not i.room.negated]
    lists = len(rooms) > 1 and not any(i.kind in ("copula", "link") for i in before)
    return (rooms[-1:] if lists else rooms[:1]) if all(not r.plural for r in rooms) else rooms[-1:]


def seen_from(items: list[Item], k: int) -> RoomPhrase | None:
    """The other room of Chinese `A at B's north side`, which has no word between the two."""
    near = items[k - 1].room if k > 1 and not items[k].text.isascii() and not items[k].text.startswith("朝") else None
    return near if near is not None and items[k - 2].room is not None else None


def _list(items: list[Item], k: int, headed: bool = False) -> list[RoomPhrase]:
    """The rooms from `k` on that stand behind a place: `on the left the kitchen, the bath and the study`."""
    rooms: list[RoomPhrase] = []
    closed = False
    while k < len(items) and (room := items[k].room) is not None and not room.negated:
        rooms.append(room)
        joint, following = (items[k + 1 : k + 3] + [Item("mark", "."), Item("mark", ".")])[:2]
        k += 1
        if not (joint.kind == "conjunction" or is_mark(joint, ",")) or following.room is None:
            break
        closed = closed or joint.kind == "conjunction"
        k += 1
    after = items[k] if k < len(items) else Item("mark", ".")
    if len(rooms) > 1 and after.kind in ("place", "side", "copula", "link", "beside", "with", "relative"):
        rooms.pop()  # "on the left the kitchen, the bath is on the right"
    again = k + 1 < len(items) and items[k + 1].kind in ("place", "side")
    return rooms if closed or again or headed else rooms[:1]


def _beside_what(items: list[Item], k: int) -> list[RoomPhrase]:
    """The rooms that lie to a side of another: `left of A is B`, `north of A and west of B`, `B, north of A`."""
    if k > 1 and is_mark(items[k - 1], ":") and (headed := items[k - 2].room) is not None:
        return [headed]  # "kitchen: north of the living room"
    if k == 0 or items[k - 1].kind in ("mark", "boundary"):
        after = next((i for i in items[k + 2 :] if i.kind not in ("reach", "copula")), Item(""))
        if after.room is not None or not k or not is_mark(items[k - 1], ","):
            return [after.room] if after.room is not None else []
    for j in range(k - 1, -1, -1):
        if items[j].kind == "thing" or is_mark(items[j], "."):
            return []  # "a mezzanine above the living room"
        if items[j].room is not None and not (j and side_of(items[j - 1])):
            return _pair(items, j, k)
    return []


def one_new(room: RoomPhrase) -> bool:
    return room.quantifier == Det.A or (room.quantifier == Det.BARE and room.count == 1)


def _pair(items: list[Item], j: int, k: int) -> list[RoomPhrase]:
    """The room at `j`, with those before it that a list joins: `bath and bedroom at the back`, `A, B and C face south`.

    Behind a verb of several all of a list count, else just two.
    """
    last = items[j].room
    if last is not None and not last.type and j and items[j - 1].room is not None and last.quantifier == Det.ALL:
        return subjects_listed(items, j - 1, k) or [last]  # "A, B and C should all face south"
    first = items[j - 2].room if j > 1 and items[j - 1].kind == "conjunction" else None
    if items[j].joined and j and items[j - 1].room is not None:
        return [room for i in items[j - 1 : j + 1] if (room := i.room)]  # "living-kitchen"
    if last is None or first is None:
        return [last] if last else []
    if len(whole := subjects_listed(items, j, k)) > 1:
        return whole
    told = j > 2 and items[j - 3].kind in ("link", "front")  # "next to the kitchen and the lounge in the corner"
    listed = told or j > 2 and is_mark(items[j - 3], ",") and j > 3 and items[j - 4].kind in ("room", "object")
    listed = listed and not _led_to(items, j - 5)
    listed = listed or (j > 2 and items[j - 3].value == "plus" and first.quantifier == Det.A)
    single = items[k].text.startswith(("is ", *SINGULAR)) or (j > 2 and bool(side_of(items[j - 3])))
    alone = items[k].text.startswith("facing")
    alone = alone or (items[k].kind in ("link", "side_role") and all(i.kind != "copula" for i in items[j + 1 : k]))
    if alone and one_new(first) and one_new(last):
        return [last]  # "an office and a balcony facing south", "a bathroom and a toilet next to the front door"
    alike = (first.quantifier in KNOWN) == (last.quantifier in KNOWN)
    alike = alike or (first.quantifier == Det.THE and _shares_article(last))  # "the kitchen and bathroom face north"
    alike = alike and not (first.quantifier == Det.BARE and first.count != 1 and one_new(last))
    return [first, last] if alike and not listed and not single else [last]


def _shares_article(last: RoomPhrase) -> bool:
    return last.quantifier == Det.BARE and last.count is None and not last.labels


def _led_to(items: list[Item], k: int) -> bool:
    """Whether the words before the room behind `k` lead to it: `along a long corridor, kitchen and …`."""
    while k > 0 and items[k].kind in ("style", "size", "label"):
        k -= 1
    return k >= 0 and items[k].kind in ("beside", "link", "front")


def nowhere(out: list[Item], items: list[Item], k: int) -> bool:
    """`the bath does not face south`, `no bedroom is in the north`: takes the denial away."""
    at = len(out) - 1
    while at > 0 and out[at].kind == "copula":
        at -= 1
    if at < 0:
        return False
    if out[at].kind == "negation" and out[at].value == "not":
        del out[at]
        return True
    room = out[at].room
    if room is None or not (room.quantifier == Det.NONE or room.negated):
        return False
    if room.negated and at and out[at - 1].kind == "negation":
        room.negated, room.quantifier = False, Det.NONE
        del out[at - 1]
    return room.quantifier == Det.NONE

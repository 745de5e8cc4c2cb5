"""Furniture said once and meant in several rooms: `no rugs: not in the lounge, nor in the hall`, `in A and in B`."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import last
from apartgen.stages.plan.reader.mention import Item, is_mark
from apartgen.stages.plan.reader.vocabulary import Det

SPARED = ("no", "not", "without")
"""What may stand again before each of several rooms that are to be without something."""
NOR = ("ni", "nor", "neither", "non plus", "tampoco")
JOINING = ("conjunction", "negation")
HAVING = ("with", "copula", "link", "object", "objects", "reach", "area", "side", "place")
"""With which begins what is said of a room behind a list."""


def in_several(items: list[Item]) -> list[Item]:
    """Each thing that is said to be, or not to be, in several rooms, once more for each of them."""
    out: list[Item] = []
    k = 0
    items = _neither_has(_none_of_several(items))
    _known_places(items)
    while k < len(items):
        end = _things_end(items, k)
        inside = _first_place(items, end, denied=items[k].number == 0) if end > k else None
        places, after = _places(items, inside, denied=items[k].number == 0) if inside is not None else ([], k)
        if len(places) < 2 and (inside is None or inside == end + 1):
            end = max(end, k + 1)
            out += items[k:end]
            k = end
            continue
        things = [i for i in items[k:end] if i.kind in ("object", "conjunction") or is_mark(i, ",")]
        for at in places:
            there = [replace(i, number=0) if i.kind == "object" and _spared(items, at) else i for i in things]
            out += [*there, Item("with", "in", "in"), items[at], Item("mark", ",", ",")]
        out.pop()
        k = after
    return out


def _known_places(items: list[Item]) -> None:
    """`one bedroom; tv not in bedroom`: in the one that was named, though no article says so."""
    named: set[str] = set()
    for k, item in enumerate(items):
        room = item.room
        if room is None:
            continue
        within = k > 1 and items[k - 1].kind == "with" and items[k - 1].value == "in"
        within = within and items[k - 2].kind in ("object", "negation", "copula")
        plain = room.quantifier == Det.BARE and room.count is None and not (room.labels or room.ordinals or room.plural)
        if within and plain and room.type in named:
            room.quantifier = Det.THE
        named.add(room.type)


def _things_end(items: list[Item], k: int) -> int:
    """Where furniture that begins at `k`, in a list or alone, ends; `k` where none does."""
    if items[k].kind != "object":
        return k
    end = k + 1
    while end + 1 < len(items) and (items[end].kind == "conjunction" or is_mark(items[end], ",")):
        if items[end + 1].kind != "object" or (items[end + 1].number == 0) != (items[k].number == 0):
            break
        end += 2
    return end


def _first_place(items: list[Item], end: int, denied: bool) -> int | None:
    """Where the `in` stands behind furniture that ends at `end`, of what is denied also behind a stop."""
    at = end
    while denied and at < len(items) and (is_mark(items[at], ",:") or _spares(items[at])):
        at += 1
    fits = at + 1 < len(items) and items[at].value == "in" and items[at].kind == "with"
    return at + 1 if fits and items[at + 1].room is not None else None


def _spares(item: Item) -> bool:
    again = item.value != "no" or item.text in NOR  # "kein Fernseher im Wohnzimmer, keine Möbel im Flur"
    return item.kind == "negation" and item.value in SPARED and again


def _places(items: list[Item], first: int, denied: bool) -> tuple[list[int], int]:
    """Where the rooms stand that a list of places names from `first` on, and where it ends."""
    places, end = [first], first + 1
    while True:
        at = end
        while at < len(items) and (items[at].kind == "conjunction" or is_mark(items[at], ",") or _spares(items[at])):
            at += 1
        again = at < len(items) and items[at].kind == "with" and items[at].value == "in"
        room = items[at + again].room if at + again < len(items) else None
        joint = items[end:at]
        if room is None or not joint or not (again or (denied and _listed(items, at, joint))):
            break
        if at + again + 1 < len(items) and items[at + again + 1].kind in HAVING and not again:
            break
        if again and at + 2 < len(items) and items[at + 2].kind == "object":
            break  # "a desk in the study, in the bedroom two beds"
        room.negated = False
        places.append(at + again)
        end = at + again + 1
    return places, end


def _spared(items: list[Item], at: int) -> bool:
    """`a piano in the lounge rather than in the study`: none in the room at `at`."""
    return at > 1 and items[at - 1].value == "in" and _spares(items[at - 2])


def _listed(items: list[Item], at: int, joint: list[Item]) -> bool:
    """Whether the room at `at` goes on a list of places without an `in` of its own."""
    room = items[at].room
    assert room is not None
    one = room.count is None and not room.headline and room.quantifier in (Det.THE, Det.BARE, Det.EACH, Det.BOTH)
    if any(i.kind in JOINING for i in joint):
        return one
    rest = items[at + 1 : at + 6]
    joins = next((i.value for i in rest if i.room is None and not is_mark(i, ",")), "")
    return one and (joins == "or" or (joins == "and" and room.quantifier == Det.THE))


def _none_of_several(items: list[Item]) -> list[Item]:
    """`without a desk or a tv`: neither; what stands behind `and` is denied where `without` is said of both."""
    out: list[Item] = []
    for k, item in enumerate(items):
        joint, before = last(out), last(out[:-1])
        also = item.kind == "object" and joint.kind == "conjunction" and before.kind == "object" and not before.number
        both = joint.value == "or" or (last(out[:-2]).kind, last(out[:-2]).value) == ("negation", "without")
        listed = item.kind == "object" and is_mark(joint, ",") and before.kind == "object" and not before.number
        closes = listed and any(i.value == "or" for i in items[k + 1 : k + 4 : 2])
        out.append(replace(item, number=0) if (also and both) or closes else item)
    return out


def _neither_has(items: list[Item]) -> list[Item]:
    """`neither the lounge nor the bedroom has a tv`, `客厅和走廊都不要地毯`: each of them has none."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        start = k + (items[k].text == "neither")
        end = start
        while end < len(items) and (items[end].room is not None or items[end].kind == "conjunction"):
            end += 1
        rooms = [i for i in items[start:end] if i.room is not None]
        while start > k and end < len(items) and items[end].kind == "copula":
            end += 1
        neither = start > k and end < len(items) and items[end].value == "has"
        none = start == k and end < len(items) and items[end].text == "不 要"
        things_end = _things_end(items, end + 1) if (neither or none) and end + 1 < len(items) else end + 1
        if len(rooms) < 2 - neither or things_end <= end + 1 or items[start].room is None:
            out.append(items[k])
            k += 1
            continue
        things = [replace(i, number=0) if i.kind == "object" else i for i in items[end + 1 : things_end]]
        for item in rooms:
            assert item.room is not None
            item.room.negated = False
            item.room.quantifier = Det.BOTH if len(rooms) == 1 else item.room.quantifier
            out += [*things, Item("with", "in", "in"), item, Item("mark", ",", ",")]
        out.pop()
        k = things_end
    return out

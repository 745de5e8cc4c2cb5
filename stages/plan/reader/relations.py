"""Doors between rooms: finds the subject and the objects of every relation in a sentence."""

from apartgen.stages.plan.reader.anaphora import JOINING
from apartgen.stages.plan.reader.denied import of_all
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.objects import objects
from apartgen.stages.plan.reader.openplan import chain
from apartgen.stages.plan.reader.predicates import Predicate, new_clause, predicates
from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.vocabulary import Det, Relation

OPPOSITE = ("opposite", "across from")
DOORLESS = ("separate from", "separated from", "closed off from", "not connected to", "independent of")
"""Of `apart`, the words that deny a door and not the neighbourhood."""
ANNEXES = ("bathroom", "closet", "balcony", "storage", "utility", "study")
"""Rooms that may open off a bedroom or a bathroom."""


def relations(
    items: list[Item], before: list[RoomPhrase], trail: list[RoomPhrase], graph: bool, told: list[Statement]
) -> list[Statement]:
    """Statements of one sentence; `before` is what "it" at its start refers to, `trail` what "there" does.

    `told` are the statements of the sentences before.
    """
    found = predicates(items, graph)
    floor = 0
    for k, p in enumerate(found):
        _find_subject(items, p, found[k - 1] if k else None, floor)
        floor = p.objects
    out = []
    for k, p in enumerate(found):
        if p.kind == Relation.CHAIN:
            line = _line(items, p)
            out += [Statement(Relation.DOOR, [a], [b]) for a, b in zip(line, line[1:], strict=False)]
            continue
        left = _rooms(items, *p.subject) or (trail if trail and _onward(items[p.at]) else before)
        if p.kind == Relation.BETWEEN and p.subject == (0, 0) and (p.at == 0 or items[p.at - 1].kind != "copula"):
            left = []  # "also a door between the kitchen and the lounge"
        stop = found[k + 1] if k + 1 < len(found) else None
        right = [] if _next_to_it(items, p) else objects(items, p, stop, left)
        left = _annexes(left, right) if p.form == "part" else left
        if p.form == "part" and len(left) > 1 and _closes_list(items, p) and all(r.type != "hallway" for r in right):
            left = left[-1:]  # "a lounge, a bathroom and a terrace off the kitchen"
        barred = [x for x in right if _barred(items, x)]
        right = [x for x in right if x not in barred]
        out += (
            [Statement(Relation.NOT, left, barred, relation=f"not {_worded(p, items[p.at].text)}")]
            if barred and left
            else []
        )
        if not right and p.form in ("s", "p"):
            right = _relative_object(items, p) or (place(out) or trail if _onward(items[p.at]) else [])
        if not right and p.at + 1 < len(items) and items[p.at + 1].kind == "pronoun":
            topic = _rooms(items, 0, p.subject[0])[:1]
            right = [r for r in (trail if trail and _onward(items[p.at]) else topic or before) if r not in left]
        if p.kind == Relation.BETWEEN and not right:
            right = _rooms(items, 0, p.subject[0])[-1:] if left and left[-1].count in (None, 1) else []
            left = left[-1:] if right else []
        if not right and len(left) > 1 and p.kind == Relation.OPEN:
            out += chain(left)  # "kitchen, dining and living areas flow into each other"
            continue
        if not right and len(left) > 1:
            left, right = left[:1], left[1:]  # "the kitchen and the living room are connected"
        if p.kind == Relation.SAME:  # "the bedrooms are off the hall, as is the bathroom"
            alike = out[-1:] or [s for s in told if s.left == told[-1].left]
            out += [Statement(s.kind, right, s.right) for s in alike if right]
            continue
        out += _statement(p, left, right, items[p.at].text)
    return out


def _next_to_it(items: list[Item], p: Predicate) -> bool:
    """`a kitchen, a dining room next to it, three bedrooms`: what follows is listed on."""
    named = p.at > 0 and items[p.at - 1].room is not None
    return named and p.kind == Relation.NEAR and p.form == "part" and [i.value for i in items[p.at + 1 : p.at + 2]] == ["it"]


def _line(items: list[Item], p: Predicate) -> list[RoomPhrase]:
    """The list of rooms that `form a chain`."""
    end = next((j for j in range(p.at - 1, -1, -1) if items[j].room is not None), 0)
    return _rooms(items, _and_group(items, end, 0, whole=True), end + 1)


def _closes_list(items: list[Item], p: Predicate) -> bool:
    """Whether the subject is the end of a longer list of new rooms."""
    start = p.subject[0]
    before = items[start - 2].room if start > 1 and is_mark(items[start - 1], ",") else None
    new = [i.room for i in items[start : p.subject[1]] if i.room is not None]
    return before is not None and p.kind == Relation.DOOR and _alike((before, *new))


def _alike(rooms: tuple[RoomPhrase, ...]) -> bool:
    return all(r.quantifier == Det.A for r in rooms) or all(r.quantifier == Det.BARE and not r.count for r in rooms)


def _onward(item: Item) -> bool:
    """`from there`, `beyond it`: the place one came to last, not what the sentence before was about."""
    words = item.text.split()
    return bool({"there", "beyond", *(["that"] if item.value == "from_which" else [])} & set(words))


def _crossed(phrase: RoomPhrase | None) -> bool:
    return phrase is not None and phrase.type in ("hallway", *OPEN_TYPES)


def place(doors: list[Statement]) -> list[RoomPhrase]:
    """What "there" means after a sentence: the one room it led to, where one may go on from it."""
    last = [s for s in doors if s.kind in (Relation.DOOR, Relation.ONLY, Relation.SERVE, Relation.OPEN)][-1:]
    return last[0].right if last and len(last[0].right) == 1 and _crossed(last[0].right[0]) else []


def _annexes(left: list[RoomPhrase], right: list[RoomPhrase]) -> list[RoomPhrase]:
    """`a kitchen and a balcony off the bedroom`: of a list, only what may belong to a bedroom opens off one."""
    private = bool(right) and all(r.type in ("bedroom", "bathroom") for r in right)
    return [r for r in left if r.type in ANNEXES] or left if private else left


def _barred(items: list[Item], phrase: RoomPhrase) -> bool:
    """`from the hallway and not from the bedroom`."""
    at = next(j for j, i in enumerate(items) if i.room is phrase)
    k = at - 2 if at and items[at - 1].kind in ("front", "link") else at - 1
    return k > 0 and items[k].kind == "negation" and items[k].value == "not"


def _relative_object(items: list[Item], p: Predicate) -> list[RoomPhrase]:
    """`a living room that all other rooms open onto`."""
    j = p.subject[0] - 1
    if j > 0 and items[j].kind == "relative" and items[j - 1].room is not None:
        return _rooms(items, j - 1, j)
    return []


def _rooms(items: list[Item], start: int, end: int) -> list[RoomPhrase]:
    return [i.room for i in items[start:end] if i.room is not None and not i.room.negated]


def _find_subject(items: list[Item], p: Predicate, last: Predicate | None, floor: int) -> None:
    """Set `p.subject` and `p.shared`."""
    p.objects = p.at + 1
    if p.form == "front":
        return
    start = last.at + 1 if last else 0
    rooms = [j for j in range(start, p.at) if items[j].room is not None]
    between = items[rooms[-1] + 1 : p.at] if rooms else items[start : p.at]
    if last is not None and len(rooms) > 1 and rooms[-1] == p.at - 1 and _gapped(items, p, last):
        p.subject = (rooms[-1], rooms[-1] + 1)
        return
    first, *onto = items[p.at].text.split()
    if first in ("one", "another", "a", "the") and onto and items[p.at].kind == "link" and p.kind != Relation.NEAR:
        head = next((j for j, i in enumerate(items[: p.at]) if i.room is not None), None)
        p.subject = last.subject if last else (0, 0) if head is None else (head, head + 1)
        return  # "the kitchen has two doors, one to the hall and one to the lounge"
    if last and _goes_on(items, p, last):
        return
    if last and p.kind == Relation.NEAR and p.form == "part" and is_mark(items[p.at - 1], ",") and _stated(last):
        p.subject = last.subject
        return  # "the kitchen opens off the living room, next to the bathroom"
    if last and _back_to_head(items, p, last, rooms, between):
        p.subject, p.shared = last.subject, True
        return
    if not rooms or (
        last and _verb_coordination(between) and not (_onward(items[p.at]) and _crossed(items[rooms[-1]].room))
    ):
        p.subject = last.subject if last else (0, 0)
        if last and not rooms and p.form not in ("s", "p", ""):
            p.subject = last.subject
        p.shared = True
        return
    again = last and last.form == p.form == "which" and items[p.at - 1].kind == "conjunction"
    if last and again and items[p.at].text.endswith("which"):
        p.subject = last.subject  # "a hall into which … open and from which …"
        return
    relative = any(i.kind == "relative" for i in between) or p.form == "which"
    if relative or p.form == "part":
        near = rooms[-1] == p.at - 1 or relative or is_mark(items[p.at - 1], ",)")
        p.subject = (
            _and_group(items, rooms[-1], start, whole=p.kind == Relation.SHARE and not _plural(items[rooms[-1]])),
            rooms[-1] + 1,
        )
        both = relative and p.form == "p" and not _plural(items[rooms[-1]])
        crowded = (
            last is not None and not both and p.kind != Relation.SHARE and p.subject[0] == rooms[0] and len(rooms) > 1
        )
        if last is not None and is_mark(items[p.subject[0] - 1], ",") and len(rooms) > 1 and not relative:
            return
        if p.kind == Relation.TO or crowded or p.form == "which" or not near or (relative and p.form == "s"):
            p.subject = (rooms[-1], rooms[-1] + 1)
        p.shared = True
        return
    p.subject = (_clause_start(items, rooms, p, last), rooms[-1] + 1)


def _stated(p: Predicate) -> bool:
    """Whether a finite verb says something of the subject."""
    return p.form in ("s", "p") and p.kind != Relation.HAS and p.subject != (0, 0)


def _gapped(items: list[Item], p: Predicate, last: Predicate) -> bool:
    """`the kitchen opens off the hall, the bathroom off the bedroom`: a clause without a verb of its own."""
    again = p.form == "part" and items[p.at].text == items[last.at].text
    return (p.kind in (Relation.TO, Relation.ONLY, Relation.GAP) or again) and new_clause(items, p.at - 2)


def _plural(item: Item) -> bool:
    return item.room is not None and (item.room.plural or (item.room.count or 1) > 1)


def _goes_on(items: list[Item], p: Predicate, last: Predicate) -> bool:
    """Whether the relation continues the one before, whose subject it then takes."""
    if items[p.at].text in ("door to", "doors to") and is_mark(items[p.at - 1], ","):
        p.subject = last.subject  # "hallway: door to the bathroom, door to the bedroom"
        return True
    if p.kind == Relation.TO and items[p.at - 1].text == "but":
        p.subject, p.kind, p.negated = last.subject, Relation.DOOR, False
        return True
    if p.kind == Relation.TO and items[last.at].text.split()[0] in JOINING and last.subject != (0, 0):
        p.subject, p.kind = last.subject, Relation.DOOR  # "a hallway joins the lounge to two bedrooms"
        return True
    if last.kind == Relation.NEAR and last.form == "part" and items[p.at].text.startswith("with "):
        p.subject = last.subject  # "the bathroom next to bedroom 1 with doors to both"
        return True
    return False


def _back_to_head(items: list[Item], p: Predicate, last: Predicate, rooms: list[int], between: list[Item]) -> bool:
    """`a corridor off the hall serves …`, `the kitchen, which opens to the hall, is reached …`."""
    inserted = any(i.kind == "relative" for i in items[max(last.at - 2, 0) : last.at])
    closed = bool(between) and is_mark(between[0], ",") and not any(i.kind in ("relative", "boundary") for i in between)
    modifier = (
        last.form == "part"
        and last.kind in (Relation.DOOR, Relation.ONLY, Relation.NEAR)
        and p.form in ("s", "p")
        and len(rooms) == 1
        and not between[:1]
        and last.subject != (0, 0)
    )
    inserted = inserted or (p.kind == Relation.HAS and last.form == "part")  # "a wing, reached through a hall, has …"
    return (inserted and closed and len(rooms) == 1) or modifier


def _verb_coordination(between: list[Item]) -> bool:
    """`X leads to Y and opens onto Z`: a conjunction, no relative, right before the verb."""
    joins = any(i.kind == "conjunction" or (i.kind == "boundary" and i.text == "but") for i in between)
    return joins and not any(i.kind == "relative" for i in between)


def _and_group(items: list[Item], at: int, floor: int, whole: bool = False) -> int:
    """Start of the rooms joined by `and` that end at `at`."""
    while (
        at - 2 >= floor
        and items[at - 2].room is not None
        and (
            (items[at - 1].kind == "conjunction" and items[at - 1].value != "plus")
            or (whole and is_mark(items[at - 1], ","))
        )
    ):
        at -= 2
    return at


def _clause_start(items: list[Item], rooms: list[int], p: Predicate, last: Predicate | None) -> int:
    """Where the subject of a finite verb begins."""
    one = items[rooms[-1]].room
    if p.form == "s" and one is not None and not one.plural and one.quantifier not in (Det.ALL, Det.BOTH):
        return rooms[-1]
    start = rooms[0]
    for j in range(rooms[-1] - 1, (last.at if last else -1), -1):
        if items[j].kind in ("boundary", "dwelling", "with", "relative") or is_mark(items[j], ":()"):
            start = min(r for r in rooms if r > j)
            break
    if not last:
        return start
    after = [j for j in range(max(start, last.at + 1), rooms[-1]) if is_mark(items[j], ",")]
    if any(r > start and items[j].kind in ("boundary",) for r in rooms for j in range(last.at, start)):
        return start
    if after and all(j < rooms[-1] for j in after):
        return min(r for r in rooms if r > after[0 if _comma_and(items, after[0]) else -1])
    return start if start > rooms[0] else rooms[-1]


def _comma_and(items: list[Item], j: int) -> bool:
    return j + 1 < len(items) and items[j + 1].kind == "conjunction"


def _worded(p: Predicate, words: str) -> str:
    """One wording in all languages for neighbours and for rooms far apart."""
    far = p.kind == Relation.APART and words not in DOORLESS
    return "next to" if p.kind == Relation.NEAR and words not in OPPOSITE else "far from" if far else words


def _dines(hubs: list[RoomPhrase], ends: list[RoomPhrase]) -> bool:
    """`a dining room between the kitchen and the living room` is where one always is; no door is told from others."""
    return [h.type for h in hubs[-1:]] == ["dining_room"] and {e.type for e in ends} == {"kitchen", "living_room"}


def _statement(p: Predicate, left: list[RoomPhrase], right: list[RoomPhrase], words: str) -> list[Statement]:
    if p.kind == Relation.HAS:
        return []
    kind = Relation.NOT if p.negated or p.kind == Relation.APART else p.kind
    if p.kind == Relation.BETWEEN:
        hubs = left if left and left[-1] not in right else []
        if _dines(hubs, right):
            return []
        if hubs:
            return [Statement(Relation.DOOR, hubs[-1:], right)] if right else []
        return [Statement(Relation.DOOR, right[:1], right[1:])] if len(right) > 1 else []
    if kind in (Relation.TO, Relation.IN, Relation.GAP):
        living = {x.type for x in (*left, *right)} <= set(OPEN_TYPES)
        kind = Relation.OPEN if kind == Relation.IN and living else Relation.DOOR
    if kind == Relation.OPEN and p.form == "part" and any(x.type in OPEN_TYPES for x in left):
        left = [x for x in left if x.type not in ANNEXES]  # "a small bathroom and kitchen open to the living room"
    relation = f"not {_worded(p, words)}" if p.negated else _worded(p, words)
    right = of_all(right) if kind == Relation.NOT else right
    return [Statement(kind, left, right, relation=relation)] if left and right else []

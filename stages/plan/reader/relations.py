"""Doors between rooms: finds the subject and the objects of every relation in a sentence."""

from dataclasses import replace

from apartgen.stages.plan.reader.denied import of_all
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.objects import objects
from apartgen.stages.plan.reader.openplan import chain
from apartgen.stages.plan.reader.predicates import Predicate, predicates
from apartgen.stages.plan.reader.scope import INSTEAD
from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.subjects import and_group, crossed, find_subject, has_its_door, onward
from apartgen.stages.plan.reader.vocabulary import OPPOSITE, Det, Relation, Trait

DOORLESS = ("separate from", "separated from", "closed off from", "not connected to", "independent of",
            "separated by", "divided by")  # fmt: skip
"""Of `apart`, the words that deny a door and not the neighbourhood."""
WAYS = (Relation.DOOR, Relation.ONLY, Relation.NEAR)
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
        find_subject(items, p, found[k - 1] if k else None, floor)
        floor = p.objects
    out = []
    for k, p in enumerate(found):
        if p.kind == Relation.CHAIN:
            line = _line(items, p)
            whole = "open" in items[p.at].text.split() and all(r.type in OPEN_TYPES for r in line)
            kind = Relation.OPEN if whole else Relation.DOOR
            out += [Statement(kind, [a], [b]) for a, b in zip(line, line[1:], strict=False)]
            continue
        left = _rooms(items, *p.subject) or (trail if trail and onward(items[p.at]) else before)
        if p.kind == Relation.BETWEEN and p.subject == (0, 0) and (p.at == 0 or items[p.at - 1].kind != "copula"):
            left = []  # "also a door between the kitchen and the lounge"
        stop = found[k + 1] if k + 1 < len(found) else None
        right = [] if _next_to_it(items, p) else objects(items, p, stop, left)
        left = left[-1:] if p.negated and left and left[-1].quantifier == Det.ALL else left
        if len(items) == 2 and p.at == 0 and p.form == "part" and any(r.owned for r in right):
            continue  # "off the bedroom: a closet", once the bedroom has it
        left = _of_a_list(items, p, left, right) if p.form == "part" else left
        barred = [x for x in right if _barred(items, x)]
        right = [x for x in right if x not in barred]
        denied = _denied(items, barred[0], _worded(p, items[p.at].text)) if barred else ""
        out += [Statement(Relation.NOT, left, barred, relation=denied)] if barred and left else []
        if barred and not right and left:
            continue  # all that is said is denied
        if not right and p.form in ("s", "p"):
            right = _relative_object(items, p) or (place(out) or trail if onward(items[p.at]) else [])
        if not right and p.at + 1 < len(items) and items[p.at + 1].kind == "pronoun":
            topic = _topic(items, p, found[:k])
            right = [r for r in (trail if trail and onward(items[p.at]) else topic or before) if r not in left]
            right = _not_alike(right, left, out, p.kind)
        if p.kind == Relation.BETWEEN and not right:
            right = _rooms(items, 0, p.subject[0])[-1:] if left and left[-1].count in (None, 1) else []
            left = left[-1:] if right else []
        left = left if right else _of_one_another(items, p, left)
        if not right and len(left) > 1 and p.kind == Relation.OPEN:
            out += chain(left)  # "kitchen, dining and living areas flow into each other"
            continue
        if not right and len(left) > 1:
            left, right = left[:1], left[1:]  # "the kitchen and the living room are connected"
        if p.kind == Relation.SAME:  # "the bedrooms are off the hall, as is the bathroom"
            alike = out[-1:] or [s for s in told if s.left == told[-1].left]
            out += [Statement(s.kind, right, s.right) for s in alike if right]
            continue
        if p.kind == Relation.USES and has_its_door(items, p):
            continue
        p.kind = Relation.OPEN if _is_to_open(items, p, left, right) else p.kind
        out += _told(items, p, left, right)
    return out


def _told(items: list[Item], p: Predicate, left: list[RoomPhrase], right: list[RoomPhrase]) -> list[Statement]:
    """What a relation says; without its words where it only says what a door is not."""
    found = _statement(p, left, right, items[p.at].text)
    denied = p.negated and p.at > 1 and items[p.at - 1].kind == "negation"
    return [replace(s, relation="") for s in found] if denied and _contrasted(items, p.at - 1) else found


def _of_a_list(items: list[Item], p: Predicate, left: list[RoomPhrase], right: list[RoomPhrase]) -> list[RoomPhrase]:
    """Of a list of rooms, those that a participle or a preposition behind it is said of."""
    left = _annexes(left, right)
    ends = all(r.type != "hallway" for r in right)
    if len(left) == 2 and ends and _last_of_list(items, p):
        left = left[-1:]  # "a toilet, a living room and a laundry room adjacent to the kitchen"
    if len(left) > 1 and ends and _closes_list(items, p):
        left = left[-1:]  # "a lounge, a bathroom and a terrace off the kitchen"
    if left and left[-1].type == "balcony" and all(r.type in OPEN_TYPES for r in right):
        left = [r for r in left if r.type == "balcony"]  # "one bathroom and a balcony off the living room"
    if left and p.kind in WAYS and _other_kind_last(items, p, left):
        left = left[-1:]  # "two bathrooms and a utility room off the kitchen", "storage and a balcony off it"
    return left


def _is_to_open(items: list[Item], p: Predicate, left: list[RoomPhrase], right: list[RoomPhrase]) -> bool:
    """`a living room that opens to the kitchen` says what kind of room it is to be."""
    head, which, verb = ([Item("")] * 3 + items[: p.at + 1])[-3:]
    fits = [head.room] == left and which.kind == "relative" and verb.text in ("opens to", "opens onto", "opens up to")
    pair = {r.type for r in (*left, *right)} if fits and len(right) == 1 and not p.negated else set()
    return len(pair) > 1 and pair <= set(OPEN_TYPES) and not left[0].definite


def _topic(items: list[Item], p: Predicate, before: list[Predicate]) -> list[RoomPhrase]:
    """What `it` is: what the sentence is about, in a bare list the room before."""
    named = [r for r in _rooms(items, 0, p.subject[0]) if not r.headline]
    told = before or any(i.kind == "copula" for i in items[: p.subject[0]])
    single = [r for r in named if not r.plural and (r.count or 1) == 1]
    return named[:1] if told else (single or named)[-1:]


def _not_alike(it: list[RoomPhrase], left: list[RoomPhrase], out: list[Statement], kind: str) -> list[RoomPhrase]:
    """`the kids' bedroom is next to the bathroom, ours is far from it`: from the bathroom, what else."""
    other = out[-1].right if out and len(out[-1].right) == 1 else []
    alike = len(it) == len(left) == 1 and it[0].type == left[0].type and bool(it[0].type)
    alike = alike and bool(other) and other[0].type not in ("", it[0].type)
    lived = kind == Relation.OPEN and bool(other) and other[0].type in OPEN_TYPES  # "… off the lounge, … open to it"
    return other if alike or (lived and not {r.type for r in it} & set(OPEN_TYPES)) else it


def _of_one_another(items: list[Item], p: Predicate, left: list[RoomPhrase]) -> list[RoomPhrase]:
    """`the study and the bath must be next to each other`: both are the subject of what has no object."""
    alone = len(left) == 1 and p.subject[1] > 1 and p.kind in (Relation.NEAR, Relation.OPEN, Relation.APART)
    return _rooms(items, and_group(items, p.subject[1] - 1, 0), p.subject[1]) if alone else left


def _next_to_it(items: list[Item], p: Predicate) -> bool:
    """`a kitchen, a dining room next to it, three bedrooms`: what follows is listed on."""
    named = p.at > 0 and items[p.at - 1].room is not None
    it = [i.value for i in items[p.at + 1 : p.at + 2]] == ["it"]
    return named and it and p.kind == Relation.NEAR and p.form == "part"


def _line(items: list[Item], p: Predicate) -> list[RoomPhrase]:
    """The list of rooms that `form a chain`."""
    end = next((j for j in range(p.at - 1, -1, -1) if items[j].room is not None), 0)
    return _rooms(items, and_group(items, end, 0, whole=True), end + 1)


def _closes_list(items: list[Item], p: Predicate) -> bool:
    """Whether the subject is the end of a longer list of new rooms."""
    start = p.subject[0]
    new = [i.room for i in items[start : p.subject[1]] if i.room is not None]
    if start > 1 and items[start - 1].value == "plus" and is_mark(items[start - 2], ","):
        return p.kind == Relation.DOOR and _alike(tuple(new))  # "…, plus a toilet and two balconies off the lounge"
    before = items[start - 2].room if start > 1 and is_mark(items[start - 1], ",") else None
    known = before is not None and before.quantifier == Det.THE  # "open to the kitchen, a bath and a terrace off it"
    return before is not None and p.kind == Relation.DOOR and _alike(tuple(new) if known else (before, *new))


def _last_of_list(items: list[Item], p: Predicate) -> bool:
    """Whether the subject ends a list of new rooms, and the relation denies other doors or says of neighbours."""
    start = p.subject[0]
    listed = start > 1 and is_mark(items[start - 1], ",") and items[start - 2].kind in ("room", "object", "negation")
    rooms = [i.room for i in items[max(start - 2, 0) : p.subject[1]] if i.room is not None]
    new = listed and (all(r.quantifier in (Det.A, Det.BARE) for r in rooms) or rooms[-1].count == 1)
    return new and p.kind in (Relation.ONLY, Relation.NEAR) and not rooms[-1].plural


def _other_kind_last(items: list[Item], p: Predicate, left: list[RoomPhrase]) -> bool:
    """Several new rooms of a type, or in a list rooms without an article, then one of another type."""
    *rest, last = left
    one = last.quantifier == Det.A or last.count == 1
    listed = p.subject[0] > 0 and is_mark(items[p.subject[0] - 1], ",")
    others = all(r.quantifier == Det.BARE and r.count != 1 and r.type != last.type for r in rest)
    return others and one and bool(rest) and (listed or all((r.count or 1) > 1 for r in rest))


def _alike(rooms: tuple[RoomPhrase, ...]) -> bool:
    """Whether each is new: with an article or counted, the last perhaps several; or none of them with either."""
    several = rooms[-1].quantifier == Det.BARE and (rooms[-1].count or 1) > 1
    counted = all(_single(r) for r in rooms[:-1]) and (several or _single(rooms[-1]))
    return counted or all(r.quantifier == Det.BARE and not r.count for r in rooms)


def _single(room: RoomPhrase) -> bool:
    return room.quantifier == Det.A or (room.quantifier == Det.BARE and room.count == 1)


def place(doors: list[Statement]) -> list[RoomPhrase]:
    """What "there" means after a sentence: the one room it led to, where one may go on from it."""
    last = [s for s in doors if s.kind in (Relation.DOOR, Relation.ONLY, Relation.SERVE, Relation.OPEN)][-1:]
    return last[0].right if last and len(last[0].right) == 1 and crossed(last[0].right[0]) else []


def _annexes(left: list[RoomPhrase], right: list[RoomPhrase]) -> list[RoomPhrase]:
    """`a kitchen and a balcony off the bedroom`: of a list, only what may belong to a bedroom opens off one."""
    private = bool(right) and all(r.type in ("bedroom", "bathroom") for r in right)
    own = [r for r in left if r.type in ANNEXES and r.type not in {x.type for x in right}]
    return own or left if private else left


def _barred(items: list[Item], phrase: RoomPhrase) -> bool:
    """`from the hallway and not from the bedroom`."""
    at = next(j for j, i in enumerate(items) if i.room is phrase)
    k = at - 2 if at and items[at - 1].kind in ("front", "link") else at - 1
    return k > 0 and items[k].kind == "negation" and items[k].value == "not"


def _contrasted(items: list[Item], at: int) -> bool:
    """Whether the negation at `at` says where a door is not, behind where it is: `off the bedroom, not the hall`."""
    links = [i for i in items[:at] if i.kind in ("link", "front")][-1:]
    plain = items[at].text.startswith(INSTEAD) or (is_mark(items[at - 1], ",") and items[at].value == "not")
    return at > 0 and plain and bool(links) and links[0].value in ("door", "from", "only")


def _denied(items: list[Item], barred: RoomPhrase, words: str) -> str:
    """The words of what is denied; none of a contrast, which asks no more than what was said before it."""
    at = next(j for j, i in enumerate(items) if i.room is barred)
    at -= 1 if items[at - 1].kind == "negation" else 2
    return "" if _contrasted(items, at) else f"not {words}"


def _relative_object(items: list[Item], p: Predicate) -> list[RoomPhrase]:
    """`a living room that all other rooms open onto`."""
    j = p.subject[0] - 1
    if j > 0 and items[j].kind == "relative" and items[j - 1].room is not None:
        return _rooms(items, j - 1, j)
    return []


def _rooms(items: list[Item], start: int, end: int) -> list[RoomPhrase]:
    return [i.room for i in items[start:end] if i.room is not None and not i.room.negated]


def _worded(p: Predicate, words: str) -> str:
    """One wording in all languages for neighbours and for rooms far apart."""
    far = p.kind == Relation.APART and not words.startswith(DOORLESS)
    return "next to" if p.kind == Relation.NEAR and not words.startswith(OPPOSITE) else "far from" if far else words


def _dines(hubs: list[RoomPhrase], ends: list[RoomPhrase]) -> bool:
    """`a dining room between the kitchen and the living room` is where one always is; no door is told from others."""
    return [h.type for h in hubs[-1:]] == ["dining_room"] and {e.type for e in ends} == {"kitchen", "living_room"}


def at_table(statements: list[Statement]) -> list[Statement]:
    """A dining room between kitchen and living room is the way from one to the other where the kitchen has no other."""
    denied = [{r.type for r in (*s.left, *s.right)} for s in statements if s.kind == Relation.NOT]
    kind = Relation.DOOR if {"kitchen", "hallway"} in denied else None
    told = [replace(s, kind=kind) if kind and s.kind == Relation.BETWEEN else s for s in statements]
    return [s for s in told if s.kind != Relation.BETWEEN]


def _everybody_uses(p: Predicate, left: list[RoomPhrase], right: list[RoomPhrase]) -> bool:
    """`they all use one bathroom`: it is nobody's own; nothing is said of doors."""
    whole = all(r.type == "" and r.quantifier == Det.ALL for r in left)
    everybody = p.kind == Relation.USES and not p.negated and whole
    for room in right if everybody else []:
        room.labels |= {Trait.SHARED} if room.type == "bathroom" else set()
    return everybody


def _only_beside(hub: RoomPhrase, ends: list[RoomPhrase]) -> bool:
    """`the kitchen between the living room and the bedroom`: neighbours, for no way leads through a bedroom."""
    beds = any(e.type == "bedroom" for e in ends)
    if hub.type == "bathroom" and any(e.type in OPEN_TYPES for e in ends):
        return True  # "the bath between the kitchen and the bedroom": one gets there from the hall
    return hub.type == "bedroom" or (beds and hub.type in (*OPEN_TYPES, "study"))


def _open_ones(right: list[RoomPhrase]) -> list[RoomPhrase]:
    """The dining room of `living room -> dining room (open), kitchen`."""
    return [r for r in right if r.type in OPEN_TYPES and Trait.OPEN in r.labels]


def _statement(p: Predicate, left: list[RoomPhrase], right: list[RoomPhrase], words: str) -> list[Statement]:
    if p.kind == Relation.HAS or _everybody_uses(p, left, right):
        return []
    kind = Relation.NOT if p.negated or p.kind == Relation.APART else p.kind
    if p.kind == Relation.BETWEEN:
        hubs = left if left and left[-1] not in right else []
        if _dines(hubs, right):
            return [Statement(Relation.BETWEEN, hubs, right)]  # until all is read: see `at_table`
        if hubs and _only_beside(hubs[-1], right):
            return [Statement(Relation.NEAR, hubs[-1:], right, relation="next to")]
        if hubs:
            return [Statement(Relation.DOOR, hubs[-1:], right)] if right else []
        return [Statement(Relation.DOOR, right[:1], right[1:])] if len(right) > 1 else []
    if kind in (Relation.TO, Relation.IN, Relation.GAP):
        living = {x.type for x in (*left, *right)} <= set(OPEN_TYPES)
        kind = Relation.OPEN if kind == Relation.IN and living and words != "into" else Relation.DOOR
    if kind == Relation.OPEN and p.form == "part" and any(x.type in OPEN_TYPES for x in left):
        left = [x for x in left if x.type not in (*ANNEXES, "bedroom")]  # "a small bathroom and kitchen open to …"
    if kind == Relation.DOOR and {x.type for x in left} <= set(OPEN_TYPES) and (gaps := _open_ones(right)):
        rest = _statement(p, left, [x for x in right if x not in gaps], words)
        return [Statement(Relation.OPEN, left, gaps, relation=words), *rest]
    relation = f"not {_worded(p, words)}" if p.negated else _worded(p, words)
    right = of_all(right) if kind == Relation.NOT else right
    return [Statement(kind, left, right, relation=relation)] if left and right else []

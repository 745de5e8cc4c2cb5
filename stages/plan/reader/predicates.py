"""Relations between rooms as they stand in a sentence."""

from dataclasses import dataclass

from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Relation


@dataclass
class Predicate:
    """A relation at `at`; its subject lies in items[subject[0]:subject[1]], shared with what came before if `after`."""

    at: int
    kind: Relation
    form: str
    negated: bool
    subject: tuple[int, int] = (0, 0)
    shared: bool = False
    objects: int = 0


def predicates(items: list[Item], graph: bool) -> list[Predicate]:
    out: list[Predicate] = []
    for k, item in enumerate(items):
        negated = any(i.kind == "negation" and i.value == "not" for i in items[max(0, k - 2) : k])
        aux = next((i.value for i in reversed(items[max(0, k - 2) : k]) if i.kind == "copula"), None)
        first = not any(i.room for i in items[:k]) or (
            k > 0 and (items[k - 1].kind == "boundary" or is_mark(items[k - 1], ","))
        )
        first = first or (
            item.kind == "front" and k > 1 and items[k - 1].kind == "conjunction" and is_mark(items[k - 2], ",")
        )
        if first and _headed(items, k):
            out.append(Predicate(k + 2, Relation.DOOR, "front", False, (k + 1, k + 2)))
        elif first and _bare_front(items, k):
            out.append(Predicate(k + 1, Relation.DOOR, "front", False, (k + 1, k + 2)))
        elif _is_front(items, k, first):
            out.append(Predicate(_reach(items, k), Relation.DOOR, "front", False, (k + 1, _reach(items, k))))
        elif item.kind == "front" and _but_to(items, k, out):
            out.append(Predicate(k, Relation.TO, "part", False))  # "not from the hall but from the bedroom"
        elif item.kind == "front" and _way_in(items, k):
            out.append(Predicate(k, Relation.DOOR, "part", negated))
        elif item.kind == "front" and _between_rooms(items, k) and _verb(items, k + 2):
            out.append(Predicate(k, Relation.DOOR, "part", negated))  # "a corridor behind the living room leads to"
        elif item.text == "behind" and _between_rooms(items, k) and _new(items[k - 1], "") and not _new(items[k + 1]):
            out.append(Predicate(k, Relation.DOOR, "part", negated))
        elif item.kind == "front" and out and _between_rooms(items, k) and new_clause(items, k - 2):
            out.append(Predicate(k, Relation.GAP, "part", negated))
        elif item.kind == "with" and item.value == "in" and _between_rooms(items, k):
            out.append(Predicate(k, Relation.IN, "part", negated))
        elif item.kind == "link":
            if out and out[-1].form == "front" and k <= out[-1].at:
                continue
            if item.value == "to" and not (_between_rooms(items, k) or _but_to(items, k, out)):
                continue
            kind, form = _opens_to(items, k) or (Relation(item.value), item.form or aux or "part")
            out.append(Predicate(k, kind, form, negated))
        elif item.kind == "with" and item.value == "has":
            out.append(Predicate(k, Relation.HAS, "s", negated))
        elif item.kind == "relative" and item.value == "from_which":
            out.append(Predicate(k, Relation.DOOR, "which", negated))
        elif (
            item.kind == "boundary"
            and item.value == "then"
            and k + 1 < len(items)
            and items[k + 1].room is not None
            and k
            and _near_room(items, k)
        ):
            out.append(Predicate(k, Relation.DOOR, "which", False))
        elif (
            is_mark(item, "-" if not graph else "-:")
            and 0 < k < len(items) - 1
            and items[k - 1].room is not None
            and items[k + 1].room is not None
        ):
            out.append(Predicate(k, Relation.DOOR, "part" if item.value == "-" else "s", False))
    return out


def _opens_to(items: list[Item], k: int) -> tuple[Relation, str] | None:
    """`a kitchen open to the living room` is no verb: one room, no wall."""
    last = items[k - 1].room if k else None
    alone = k < 2 or not (items[k - 2].kind == "conjunction" and k > 2 and items[k - 3].room is not None)
    alone = alone or (k > 3 and items[k - 4].kind == "link" and _new(items[k - 1]))  # "… off A and a kitchen open to B"
    alone = alone or (_new(items[k - 1]) and items[k - 3].value in ("bedroom", "bathroom"))  # "two beds, a kitchen …"
    alone = alone or k + 1 < len(items) and items[k + 1].value in ("it", items[k - 3].value)  # "A and B open to A"
    single = last is not None and last.type in OPEN_TYPES and not last.plural and not last.definite or _the_one(last)
    if items[k].text not in ("open to", "open onto"):
        return None
    latter = last is not None and not last.type and last.quantifier == Det.THE and bool(last.among)
    if latter and last is not None and all(r.type in OPEN_TYPES for r in last.among):
        return Relation.OPEN, "part"  # "a kitchen and a dining room, the latter open to the living room"
    if single and alone:
        return Relation.OPEN, "part"
    it = k > 0 and items[k - 1].kind == "copula" and (k == 1 or items[k - 2].kind == "pronoun")
    if it or (k > 1 and items[k - 1].kind == "copula" and items[k - 2].value in OPEN_TYPES):
        return Relation.OPEN, items[k - 1].value or "s"  # "the kitchen should be open to it"
    return None


def _the_one(last: RoomPhrase | None) -> bool:
    return last is not None and last.type != "" and last.quantifier == Det.THE and not last.plural


def _near_room(items: list[Item], k: int) -> bool:
    room = items[k - 1].room or (items[k - 2].room if k > 1 and is_mark(items[k - 1], ",") else None)
    ahead = items[k + 1].room
    alike = room is not None and ahead is not None and ahead.type == room.type  # "grandma's bedroom, then ours"
    return room is not None and not (room.plural or alike) and room.quantifier != Det.EACH  # "two beds, then a bath"


def _way_in(items: list[Item], k: int) -> bool:
    """`you enter the kitchen through the living room`."""
    onward = k > 1 and items[k - 2].value == "to" and items[k].text in ("through", "via")
    return _between_rooms(items, k) and (onward or any(i.kind == "reach" for i in items[:k]))


def _but_to(items: list[Item], k: int, before: list[Predicate]) -> bool:
    """`not connected to the hall but to the living room`."""
    contrast = k > 0 and items[k - 1].kind == "boundary" and items[k - 1].text == "but"
    return contrast and bool(before) and (before[-1].negated or before[-1].kind == Relation.APART)


def _between_rooms(items: list[Item], k: int) -> bool:
    before = k - 2 if k > 1 and items[k - 1].text == "should be" else k - 1
    return 0 < k < len(items) - 1 and items[before].room is not None and items[k + 1].room is not None


def _new(item: Item, *also: str) -> bool:
    return item.room is not None and item.room.quantifier in (Det.A, *also)


def new_clause(items: list[Item], k: int) -> bool:
    """Whether a gapped clause may begin after `k`: `…, the dining room from the living room`."""
    return k > 0 and (items[k].kind == "conjunction" or is_mark(items[k], ","))


def _verb(items: list[Item], k: int) -> bool:
    return k < len(items) and items[k].kind == "link" and items[k].form in ("s", "p")


def _is_front(items: list[Item], k: int, first: bool) -> bool:
    """`from the hallway you reach …`, `off the hall are …`."""
    item = items[k]
    starts = item.kind == "front" or (
        item.kind == "link" and item.value == "door" and item.form == "" and item.text in ("off", "off of")
    )
    follows = k + 1 < len(items) and items[k + 1].room is not None
    return starts and first and follows and _reach(items, k) > k


def _headed(items: list[Item], k: int) -> bool:
    """`from the landing: two bedrooms, a bathroom`."""
    if k + 2 >= len(items):
        return False
    lived = (*OPEN_TYPES, "bedroom") if k == 0 or items[k - 1].kind == "mark" else ()
    room = items[k + 1].room
    known = room is not None and room.quantifier == Det.THE
    hall = items[k + 1].value in ("hallway", *(lived if known else ()))
    return hall and items[k].text in ("from", "off") and is_mark(items[k + 2], ":")


def _bare_front(items: list[Item], k: int) -> bool:
    """`off the kitchen a pantry`: no verb, a known room, then a new one."""
    known, new = (items[k + 1].room, items[k + 2].room) if k + 2 < len(items) else (None, None)
    off = items[k].kind in ("front", "link") and items[k].text in ("off", "off of", "from", "beyond", "behind")
    return off and known is not None and known.quantifier == Det.THE and new is not None and new.quantifier == Det.A


def _reach(items: list[Item], k: int) -> int:
    """Where the verb of a fronted clause stands, k when there is none."""
    for j in range(k + 2, len(items)):
        if items[j].kind in ("reach", "copula") or (items[j].kind == "link" and items[j].form in ("s", "p")):
            return j
        if items[j].room is None and items[j].kind != "conjunction":
            return k
    return k

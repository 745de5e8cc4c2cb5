"""What a relation is said of: where its subject stands in the sentence, or that it is the one before."""

from apartgen.stages.plan.reader.anaphora import JOINING
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.predicates import Predicate, new_clause
from apartgen.stages.plan.reader.vocabulary import Det, Relation

ARROWS = ("->", "=>", "→", "⇒")
SINGULAR = ("shares", "touches", "adjoins", "borders")
"""Verbs of neighbours that are said of one room."""


def find_subject(items: list[Item], p: Predicate, last: Predicate | None, floor: int) -> None:
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
        p.subject = _of_doors(items, p, last, rooms)
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
        last and _verb_coordination(between) and not (onward(items[p.at]) and crossed(items[rooms[-1]].room))
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
    if relative and last and p.form == "s" and _plural(items[rooms[-1]]) and last.subject != (0, 0):
        p.subject, p.shared = last.subject, True
        return  # "a bathroom between the two bedrooms which opens to the hall"
    if relative or p.form == "part":
        near = rooms[-1] == p.at - 1 or relative or is_mark(items[p.at - 1], ",)")
        p.subject = (
            and_group(items, rooms[-1], start, whole=p.kind == Relation.SHARE and not _plural(items[rooms[-1]])),
            rooms[-1] + 1,
        )
        both = relative and p.form == "p" and not _plural(items[rooms[-1]])
        crowded = (
            last is not None and not both and p.kind != Relation.SHARE and p.subject[0] == rooms[0] and len(rooms) > 1
        )
        if last is not None and is_mark(items[p.subject[0] - 1], ",") and len(rooms) > 1 and not relative:
            return
        one = p.form == "s" or items[p.at].text.split()[0] in SINGULAR
        crowded = crowded or _bath_of_its_own(items, p)
        if p.kind == Relation.TO or crowded or p.form == "which" or not near or (relative and one):
            p.subject = (rooms[-1], rooms[-1] + 1)
        p.shared = True
        return
    p.subject = (_clause_start(items, rooms, p, last), rooms[-1] + 1)


def _bath_of_its_own(items: list[Item], p: Predicate) -> bool:
    """`a living room and a bathroom with doors to the bedroom and to the hall`: the bathroom has these doors."""
    start, end = p.subject
    led = next((i.value for i in items[p.at + 1 :] if i.room is not None), "")
    kinds = [i.value for i in items[start:end] if i.room is not None]
    return led == "bedroom" and kinds[-1:] == ["bathroom"] and {*kinds[:-1]} <= {*OPEN_TYPES} and len(kinds) > 1


def has_its_door(items: list[Item], p: Predicate) -> bool:
    """`the other bedroom uses the bathroom off the hallway`: there is the bathroom's door."""
    used, way, hall = (items[p.at + 1 : p.at + 4] + [Item("")] * 3)[:3]
    return used.room is not None and way.kind == "link" and hall.value == "hallway"


def _of_doors(items: list[Item], p: Predicate, last: Predicate | None, rooms: list[int]) -> tuple[int, int]:
    """Whose doors `one to the hall and one to the lounge` are: those of the room named last before them."""
    counted_on = last is not None and items[last.at].text.split()[0] in ("one", "another", "a", "the")
    near = not counted_on and bool(rooms) and (last is None or last.kind != Relation.HAS)
    if last and not near:
        return last.subject
    head = rooms[-1] if near else next((j for j, i in enumerate(items[: p.at]) if i.room is not None), None)
    return (0, 0) if head is None else (head, head + 1)


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
    if _of_headed_line(items, p, last):
        p.subject, p.shared = last.subject, True
        return True
    if items[p.at].text in ("door to", "doors to") and is_mark(items[p.at - 1], ","):
        p.subject = last.subject  # "hallway: door to the bathroom, door to the bedroom"
        return True
    if p.negated and p.at > 1 and is_mark(items[p.at - 2], ",") and items[p.at - 1].kind == "negation":
        p.subject = last.subject  # "the bath is next to bedroom 2, not next to bedroom 1"
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


def _of_headed_line(items: list[Item], p: Predicate, last: Predicate) -> bool:
    """`corridor off the living room -> two bedrooms`: the arrow leads from the corridor."""
    modifies = last.form == "part" and items[last.at].text not in ARROWS and last.subject == (0, 1)
    return items[p.at].text in ARROWS and modifies


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


def and_group(items: list[Item], at: int, floor: int, whole: bool = False) -> int:
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
    single = one is not None and (not one.plural or one.type == "any") and one.quantifier not in (Det.ALL, Det.BOTH)
    if p.form == "s" and single:
        return rooms[-1]
    start = rooms[0]
    for j in range(rooms[-1] - 1, (last.at if last else -1), -1):
        if items[j].kind in ("boundary", "dwelling", "with", "relative") or is_mark(items[j], ":()"):
            start = min(r for r in rooms if r > j)
            if is_mark(items[j], ":"):
                return start  # "it has no hallway: the bedrooms, the bath and the kitchen are …"
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


def onward(item: Item) -> bool:
    """`from there`, `beyond it`: the place one came to last, not what the sentence before was about."""
    words = item.text.split()
    return bool({"there", "beyond", *(["that"] if item.value == "from_which" else [])} & set(words))


def crossed(phrase: RoomPhrase | None) -> bool:
    return phrase is not None and phrase.type in ("hallway", *OPEN_TYPES)

"""The rooms a relation leads to, as they stand behind it."""

from apartgen.stages.plan.reader.anaphora import PAIRED
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.predicates import Predicate
from apartgen.stages.plan.reader.vocabulary import Det, Relation


def objects(items: list[Item], p: Predicate, following: Predicate | None, left: list[RoomPhrase]) -> list[RoomPhrase]:
    """Rooms after the relation, up to the next clause."""
    end = len(items)
    if items[p.at].text == "between them":
        return []  # "two bedrooms, a bathroom between them and a kitchen"
    if following is not None:
        goes_on = p.form == "which" or (p.form == "front" and items[p.at].room is not None)
        led = goes_on and following.subject[0] == p.at + 1 and items[p.at + 1].value == "hallway"
        # "from which a passage leads to …"
        end = following.subject[1] if following.shared or led else following.subject[0]
        end = max(end, p.at + 1) if following.subject[1] > p.at else following.at
        if p.kind == Relation.NEAR and following.form == "part" and following.subject[0] > p.at + 1:
            end = following.subject[0]  # "a bath near the hall and a kitchen open to the lounge"
    out: list[RoomPhrase] = []
    it = items[p.at + 1 : p.at + 2] and (items[p.at + 1].kind, items[p.at + 1].value) == ("pronoun", "it")
    if it and not is_mark(items[p.at - 1], ","):  # "and, next to it, a kitchen"
        return out  # "a kitchen open to it, and two bedrooms off …"
    for j in range(p.at + 1, min(end, len(items))):
        item = items[j]
        phrase = item.room
        if phrase is not None:
            if (
                out
                and is_mark(items[j - 2], ",")
                and [i.kind for i in items[j - 1 : j + 2 : 2]] == ["conjunction", "copula"]
            ):
                break  # "not next to the kitchen, and the toilet is separate"
            if out and phrase.quantifier == Det.OTHER and phrase.labels and is_mark(items[j - 1], ","):
                break  # "grandma has the bedroom next to the bathroom, the kids the other one"
            if out and phrase.quantifier == Det.ALL and items[j + 1 : j + 2] and items[j + 1].value == "not":
                break  # "no bathroom next to the kitchen and no bedroom next to the lounge"
            if out and (_heads_next(items, j, following, out[0], left) or not _continues(items, p, j, out, left)):
                break
            if not phrase.negated and phrase not in left:
                out.append(phrase)
        elif out and denied_on(items, j):
            continue
        elif item.kind in ("boundary", "dwelling", "with") or item.value == "except":
            break
        elif item.kind == "relative" and out and _all_of_them(items[j + 1 : j + 2]):
            break  # "separated by a bathroom which both can enter"
        elif item.kind == "front" and out and item.text in ("through", "via") and items[p.at].text.split()[-1] == "to":
            break  # "a door to the corridor and nobody should go through the kitchen"
        elif item.kind == "reach" and out and item.text.startswith("there"):
            break
        elif is_mark(item, ":()") and j > p.at + 1 or is_mark(item, ",") and j == p.at + 1 and p.form != "front":
            break
    return out


def _heads_next(
    items: list[Item], j: int, following: Predicate | None, first: RoomPhrase, left: list[RoomPhrase]
) -> bool:
    """`only from the second bedroom, and a terrace off the kitchen`: a new room of which more is said is listed on."""
    room = items[j].room
    if following is None or room is None or j not in range(*following.subject) or following.form != "part":
        return False
    closes = items[j - 1].kind == "conjunction" and is_mark(items[j - 2], ",")  # "…, and a bathroom off the hall"
    return (first.quantifier == Det.THE or closes) and _new(room) and _no_hallway(left)


def _new(room: RoomPhrase) -> bool:
    return room.quantifier == Det.A or (room.count is not None and not room.definite)


def _both_new(items: list[Item], j: int, first: RoomPhrase) -> bool:
    """Whether two new rooms end a clause, joined by `and`."""
    room, ends = items[j].room, j + 1 == len(items) or is_mark(items[j + 1], ".,")
    return room is not None and items[j - 1].kind == "conjunction" and _new(room) and _new(first) and ends


def denied_on(items: list[Item], j: int) -> bool:
    """`next to the hall but not to the bedroom`: the relation goes on, denied."""
    here = items[j : j + 2]
    return len(here) == 2 and here[0].text == "but" and (here[1].kind, here[1].value) == ("negation", "not")


def _all_of_them(after: list[Item]) -> bool:
    return any(i.room is not None and i.room.type == "" and i.room.quantifier in PAIRED for i in after)


def _continues(items: list[Item], p: Predicate, j: int, out: list[RoomPhrase], left: list[RoomPhrase]) -> bool:
    """Whether the room at `j` is one more object of the relation."""
    phrase, first = items[j].room, out[0]
    assert phrase is not None
    if is_mark(items[j - 1], "/") or any(denied_on(items, i) for i in range(max(j - 3, 0), j)):
        return True
    if items[j - 1].value == "plus" and (p.form == "part" or first.definite > phrase.definite):
        return False  # "the bathroom is off the bedroom, plus a guest toilet"
    if p.form == "which" and items[p.at].text in ("into which", "onto which"):
        return True  # "a hall into which the lounge, the kitchen and the study open"
    counted = is_mark(items[j - 1], ",") and phrase.count and not first.count
    if counted and not phrase.text.isascii() and _no_hallway(left):
        return False  # "餐厅连着客厅,三室两卫"
    if p.kind == Relation.TO and _both_new(items, j, first):
        return True  # "the lounge leads to the kitchen, the kitchen to a pantry and a balcony"
    if p.kind in (Relation.TO, Relation.IN, Relation.GAP) or (
        p.form == "which"
        and p.at
        and is_mark(items[j - 1], ",")
        and not first.quantifier == phrase.quantifier == Det.THE
    ):
        return False
    if is_mark(items[j - 1], ",") and (p.kind == Relation.SHARE or items[p.at].text.endswith(" by")):
        return False  # "separated by a corridor, one bedroom"
    if p.kind == Relation.BETWEEN:
        return len(out) < 2 or (items[j - 1].kind == "conjunction" and not is_mark(items[j - 2], ","))
    if p.kind == Relation.OPEN and phrase.type not in OPEN_TYPES:
        return False
    if p.form != "part":
        listed = is_mark(items[j - 1], ",") and (first.quantifier == Det.THE or first.type == "")
        new = _new(phrase) or (phrase.quantifier == Det.BARE and (first.type == "" or _bare_in_list(items, p)))
        return not (listed and new and _no_hallway(left))  # "a balcony that is off the bedroom, a kitchen, …"
    same = first.definite == phrase.definite
    if left and all(r.type == "hallway" for r in left) and p.kind in (Relation.DOOR, Relation.SERVE):
        return True
    alone = p.subject[0] == 0 and not any(i.room for i in items[p.subject[1] : p.at])  # a sentence of its own
    if is_mark(items[j - 1], ",") and not first.definite and _no_hallway(left) and not alone:
        return False
    if first.definite or first.quantifier == Det.BARE and p.kind in (Relation.NEAR, Relation.OPEN):
        return same and items[j - 1].kind == "conjunction" and phrase.count is None if not first.definite else same
    return same or not phrase.definite


def _bare_in_list(items: list[Item], p: Predicate) -> bool:
    """Whether a clause stands at a room of a list without articles: `hall, lounge that opens to the kitchen, bath`."""
    at = p.subject[0]
    head, relative = items[at].room, any(i.kind == "relative" for i in items[at : p.at])
    return relative and at > 0 and is_mark(items[at - 1], ",") and head is not None and head.quantifier == Det.BARE


def _no_hallway(left: list[RoomPhrase]) -> bool:
    """Only a hallway is expected to lead to a whole list of new rooms."""
    several = (Det.BOTH, Det.EACH, Det.ALL)  # "two bathrooms that both open off the hallway, one kitchen"
    return bool(left) and all(
        r.type not in ("hallway", "any", "") or (r.type == "" and r.quantifier in several) for r in left
    )

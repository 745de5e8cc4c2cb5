"""What stands among rooms and is none: doors counted, things that are no rooms; and `a bathroom each` of the home's."""

from apartgen.stages.plan.reader.clausal import ahead, clause, last
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.placed import side_of
from apartgen.stages.plan.reader.vocabulary import Det


def doors_counted(out: list[Item], items: list[Item], k: int) -> bool:
    """The `two doors` of `the bathroom has two doors, one to the hall and one to the bedroom` count no rooms."""
    room = items[k].room
    counted = room is not None and not room.type and room.count is not None and last(out).kind == "with"
    if counted and ahead(items, k)[0].kind == "graph" and not is_mark(ahead(items, k)[1], ":"):
        items[k + 1] = Item("stop", "", items[k + 1].text)
        return True
    return False


def beside_a_thing(out: list[Item], items: list[Item], k: int) -> bool:
    """`a sofa with a lamp beside it`: beside the sofa, which asks nothing of rooms."""
    beside = (items[k].kind == "link" and items[k].value == "near") or bool(side_of(items[k]))
    fits = beside and ahead(items, k)[0].value == "it"
    if not fits or last(out).kind != "object":
        return False
    items[k + 1] = Item("stop", "", items[k + 1].text)
    return True


def no_such_home(out: list[Item], items: list[Item], k: int) -> bool:
    """`not a studio`: of the home it says what it is not."""
    if items[k].kind != "dwelling" or last(out).kind != "negation" or last(out).value not in ("not", "without"):
        return False
    out.pop()
    return True


def of_which(out: list[Item], items: list[Item], k: int) -> bool:
    """The `of which` of `three bedrooms, two of which have a balcony`, and of `A and B, of which B is small`."""
    counted, which = last(out).room, ahead(items, k)[0].room
    told = counted is not None and not counted.type and counted.count is not None
    return items[k].text == "of which" and (told or (which is not None and bool(which.ordinals)))


def heading(out: list[Item], items: list[Item], k: int) -> bool:
    """The dash of `three bedrooms - one with a balcony`, which begins what is told of them and is no door."""
    counted, one = last(out).room, ahead(items, k)[0].room
    if not is_mark(items[k], "-") or counted is None or one is None or (counted.count or 1) < 2 or not counted.type:
        return False
    if one.type not in ("", counted.type) or not (is_mark(last(out[:-1]), ".:,") or last(out[:-1]).kind == "dwelling"):
        return False
    out.append(Item("mark", ":", ":"))
    return True


def nor_this(out: list[Item], items: list[Item], k: int) -> bool:
    """`not next to the bath or next to the kitchen`, `nor opposite the study`: a relation that is denied as well."""
    link = ahead(items, k)[0]
    denied = [i.kind for i in clause(out) if i.kind in ("negation", "link")][:2] == ["negation", "link"]
    if items[k].kind != "conjunction" or items[k].value != "or" or link.kind != "link" or not denied:
        return False
    if link.form in ("s", "p") or last(out).room is None and not is_mark(last(out), ","):
        return False
    if is_mark(last(out), ","):
        out.pop()
    out += [Item("mark", ",", ","), Item("negation", "not", items[k].text)]
    return True


def bath_each(out: list[Item], items: list[Item], k: int) -> bool:
    """`a two-bedroom flat with a bathroom each`: each of the bedrooms has one."""
    bath, each = items[k].room, ahead(items, k)[0].room
    owned = bath is not None and bath.type in ("bathroom", "balcony", "closet")
    owned = owned and bath is not None and (bath.quantifier == Det.A or bath.count == 1)
    if not owned or each is None or each.type or each.quantifier != Det.EACH or last(out).kind != "with":
        return False
    beds = [i for i in out if i.room is not None and i.room.type == "bedroom" and (i.room.count or 1) > 1]
    if len(out) < 2 or out[-2].kind != "dwelling" or not beds:
        return False
    its = RoomPhrase("bedroom", quantifier=Det.EACH, text=beds[-1].text)
    out[-1:] = [Item("mark", ".", "."), Item("room", "bedroom", its.text, its), Item("with", "has", "has")]
    return False


def has_itself(out: list[Item], items: list[Item], k: int) -> bool:
    """`the bathroom off the corridor has a bathtub`: the bathroom has it."""
    start, head, link, place = ([Item("mark", ".")] * 4 + out)[-4:]
    begins = start.kind in ("mark", "conjunction", "boundary") and items[k].value == "has"
    room = head.room if begins and ahead(items, k)[0].kind == "object" else None
    which = room is not None and room.quantifier == Det.THE and link.kind == "link" and link.form not in ("s", "p")
    if which and place.room is not None:
        out += [Item("mark", ".", "."), head, items[k]]
        return True
    return False


def of_no_room(out: list[Item], items: list[Item], k: int) -> bool:
    """`a lounge, garage next to the kitchen`: what the relation is said of is no room; that is told elsewhere."""
    if items[k].kind == "link" and _nowhere(items, k):
        return True
    said_of = items[k - 1] if k else Item("")
    if said_of.kind != "thing" or items[k].kind != "link" or len(out) < 2 or out[-1] is not said_of:
        return False
    verb = items[k].form in ("s", "p")
    begins = is_mark(out[-2], ",") or (verb and out[-2].kind in ("conjunction", "boundary"))
    if begins:
        out.pop()  # "…, garage next to the kitchen", "… and the children use the other bathroom"
    return begins


def _nowhere(items: list[Item], k: int) -> bool:
    """`far from the street and the lounge in front`: the relation leads to no room, and no other is joined to it."""
    thing, joint, room = ahead(items, k)
    after = items[k + 4] if k + 4 < len(items) else Item("mark", ".")
    joined = joint.kind == "conjunction" and room.room is not None and after.kind == "mark"
    return thing.kind == "thing" and not joined


def none_off(out: list[Item], items: list[Item], k: int) -> bool:
    """`no rooms off the kitchen`, of which `no rooms` is told: no other room is off it."""
    begins = last(out).kind == "negation" and (len(out) == 1 or is_mark(out[-2], "."))
    if not begins or items[k].kind != "link" or items[k].text not in ("off", "off of"):
        return False
    out.pop()
    return True


def denied_beside(out: list[Item], items: list[Item], k: int) -> bool:
    """`kein Schlafzimmer an der Küche`: a room denied, and right behind it another that is known."""
    no, before = ([Item("")] * 2 + out)[-2:]
    room = items[k].room
    fits = no.kind == "negation" and before.room is not None and before.room.negated and room is not None
    if not fits or room is None or room.quantifier != Det.THE or room.text.isascii() and no.text in ("no", "without"):
        return False
    out += [Item("link", "near", "next to"), items[k]]
    return True


def having_something(items: list[Item]) -> list[Item]:
    """Without the verb of `far from the lounge because we have guests`, and of `the bath next to it has`, once its area
    is taken."""
    ends = [k + 1 == len(items) or is_mark(items[k + 1], ".;") for k in range(len(items))]
    return [item for k, item in enumerate(items) if not (k and ends[k] and item.value == "has" and items[k - 1].room)]

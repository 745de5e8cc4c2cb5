"""Rooms told off from others: `another` of two, `a bathroom for each`, `for the other two`, `none is en suite`."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import ahead, clause, last
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

OWNABLE = ("bathroom", "balcony", "closet")
"""Rooms of which each bedroom may have one."""
SERVING = ("for", "serves", "serve", "is used by", "shared by", "belongs to", "is reserved for", "serving", "used by")
"""What stands between a bathroom and those who use it."""
HAVING = ("copula", "with")


def another_of_counted(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bathrooms, one in the main bedroom, another off the hall`: the other of the two, no third."""
    room = items[k].room
    if room is None or room.type or room.quantifier != Det.ANOTHER or room.count:
        return False
    at = next((j for j in range(len(out) - 1, -1, -1) if _several(out[j].room)), None)
    whole = out[at].room if at is not None else None
    if at is None or whole is None:
        return False
    picked = sum(_picked(i.room) for i in out[at + 1 :])
    if not 0 < picked < int(whole.count or 0):
        return False
    room.quantifier, room.count = Det.BARE, 1.0
    out.append(items[k])
    return True


def _several(room: RoomPhrase | None) -> bool:
    """Whether rooms are counted that something may be told of one by one."""
    return room is not None and bool(room.type) and room.quantifier == Det.BARE and (room.count or 1) > 1


def _picked(room: RoomPhrase | None) -> bool:
    """Whether one of several is told off."""
    one = room is not None and (room.count == 1 or bool(room.ordinals)) and not room.type
    return one or (room is not None and room.text.startswith("one") and Trait.OWN in room.labels)


def one_in_bedroom(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bathrooms, one inside the main bedroom`: that bedroom has it."""
    one, (inside, place, _) = items[k].room, ahead(items, k)
    owner = place.room if inside.value == "in" else None
    if one is None or one.type or one.count != 1 or owner is None or owner.type != "bedroom" or owner.plural:
        return False
    counted = [i.room for i in out if _several(i.room)]
    if not counted or counted[-1] is None or counted[-1].type not in OWNABLE or (owner.count or 1) > 1:
        return False
    one.type, one.quantifier, one.count = counted[-1].type, Det.A, None
    one.labels |= {Trait.ENSUITE, Trait.OWN} if one.type == "bathroom" else {Trait.OWN}
    owner.quantifier = Det.THE if owner.quantifier in (Det.A, Det.BARE) else owner.quantifier
    out += [place, Item("with", "has", inside.text), replace(items[k], value=one.type)]
    items[k + 1], items[k + 2] = Item("stop", "", inside.text), Item("stop", "", place.text)
    return True


def is_one(out: list[Item], items: list[Item], k: int) -> bool:
    """`the second bathroom is a half bath`: no further room, but what that one is."""
    room, verb, told = items[k].room, last(out), out[-2].room if len(out) > 1 else None
    if room is not None and (one := _one_of_several(out, room)) is not None:
        one.labels |= room.labels  # "the other one, 15 m², is the parents' bedroom"
        return True
    if room is not None and (one := _also_is(out, room)) is not None:
        one.labels |= room.labels  # "the smallest one is next to the kitchen and is a guest room"
        del out[-2:]
        return True
    if room is None or told is None or verb.kind != "copula" or verb.value == "p" or room.quantifier != Det.A:
        return False
    known = told.quantifier in (Det.THE, Det.OTHER) or bool(told.ordinals) or (told.count == 1 and not told.type)
    if room.type != told.type or not known or room.count or room.ordinals or not (room.labels or room.factor != 1.0):
        return False
    told.labels |= room.labels
    told.factor *= room.factor
    told.owned += room.owned
    return True


def _also_is(out: list[Item], room: RoomPhrase) -> RoomPhrase | None:
    """The one room that a clause is about, of which `and is a guest room` goes on to tell."""
    joint, verb = ([Item("")] * 2 + out)[-2:]
    told = next((i.room for i in clause(out) if i.room is not None), None)
    goes_on = joint.kind == "conjunction" and verb.kind == "copula" and verb.value != "p"
    if told is None or not goes_on or room.quantifier != Det.A or room.count or not room.labels or told.plural:
        return None
    known = told.quantifier in (Det.THE, Det.OTHER) or bool(told.ordinals)
    return told if known and told.type in ("", room.type) else None


def _one_of_several(out: list[Item], room: RoomPhrase) -> RoomPhrase | None:
    """The one of the rooms counted before that `is` ends a clause about, its area perhaps between."""
    if last(out).kind != "copula" or room.quantifier != Det.THE or not room.labels or room.count:
        return None
    said = [i for i in out[:-1] if i.kind != "area" and not is_mark(i, ",(")]
    told = said[-1].room if said else None
    one = told is not None and told.type == "" and told.count in (None, 1) and not told.plural
    counted = [i.room for i in said if i.room is not None and (i.room.count or 1) > 1][-1:]
    return told if one and counted and counted[0].type == room.type else None


def for_each(out: list[Item], items: list[Item], k: int) -> bool:
    """`a bathroom for each of the three bedrooms`, `one balcony per bedroom`: each of them has one."""
    one, near = items[k].room, ahead(items, k)
    at = k + 1 + (near[0].text in ("for", "per"))
    owners = items[at].room if at < len(items) else None
    if one is None or owners is None or one.type not in OWNABLE or not _one(one):
        return False
    told = at + 1 < len(items) and items[at + 1].kind in HAVING
    if owners.quantifier != Det.EACH or not (owners.type == "bedroom" or _beds_last(out, owners)) or told:
        return False
    while last(out).kind in ("conjunction", "boundary", "with") or (out and is_mark(out[-1], ",")):
        out.pop()
    out += [] if is_mark(last(out), ".") else [Item("mark", ".", ".")]
    one.quantifier, one.count = Det.A, None
    out += [items[at], Item("with", "has", "has"), items[k], Item("mark", ".", ".")]
    _skip(items, k + 1, at + 1)
    return True


def _beds_last(out: list[Item], each: RoomPhrase) -> bool:
    """Whether `for each` speaks of bedrooms, counted last."""
    rooms = [i.room for i in out if i.room is not None][-1:]
    return not each.type and not each.labels and bool(rooms) and rooms[0].type == "bedroom" and _several(rooms[0])


def _one(room: RoomPhrase) -> bool:
    return (room.quantifier == Det.A or room.count == 1) and not (room.plural or room.negated or room.areas)


def _skip(items: list[Item], start: int, end: int) -> None:
    """What stands between has been read, and the mark or `and` behind it that goes on with a list."""
    end += end < len(items) and (is_mark(items[end], ",") or items[end].kind == "conjunction")
    for j in range(start, end):
        items[j] = Item("stop", "", items[j].text)


def for_the_others(out: list[Item], items: list[Item], k: int) -> bool:
    """`the second bathroom is for the other two`: for two bedrooms, no bathrooms."""
    room = items[k].room
    if room is None or room.type or room.quantifier != Det.OTHER or not (room.count or "others" in room.text):
        return False
    subject = next((i.room for i in reversed(out) if i.room is not None), None)
    serves = last(out).text in SERVING and (len(out) > 1 and out[-2].kind == "copula" or last(out).text != "for")
    serves = serves or last(out).value == "serve"
    if not serves or subject is None or not (subject.type == "bathroom" or _in_list(out, subject, "bathroom")):
        return False
    if not any(i.room is not None and i.room.type == "bedroom" for i in out):
        return False
    room.type = "bedroom"
    out.append(replace(items[k], value="bedroom"))
    return True


def _in_list(out: list[Item], subject: RoomPhrase, kind: str) -> bool:
    """Whether what has no noun is one of such rooms, counted last."""
    counted = [i.room for i in out if _several(i.room)]
    return not subject.type and bool(counted) and counted[-1] is not None and counted[-1].type == kind


def none_ensuite(out: list[Item], items: list[Item], k: int) -> bool:
    """`none of the three bedrooms is en suite`, `two bedrooms, neither with its own bathroom`."""
    at = k + 1
    while at < len(items) and items[at].kind in HAVING:
        at += 1
    denies = items[k].kind == "negation" and items[k].text.split()[0] in ("neither", "none")
    bath = items[at].room if (denies or k + 1 < at) and at < len(items) else None
    if bath is None or bath.type != "bathroom" or not bath.labels & {Trait.ENSUITE, Trait.OWN} or bath.negated:
        return False
    room = items[k].room
    if room is not None and room.quantifier == Det.NONE and room.type in ("", "bedroom"):
        if room.type and room.count:
            room.quantifier, room.headline = Det.BARE, False
            out.append(items[k])
    elif not denies or not any(i.room is not None and i.room.type == "bedroom" for i in out):
        return False
    bath.negated, bath.quantifier = True, Det.BARE
    bath.labels |= {Trait.ENSUITE}
    out += [Item("mark", ",", ","), Item("negation", "no", "no"), items[at]]
    for j in range(k + 1, at + 1):
        items[j] = Item("stop", "", items[j].text)
    return True

"""Rooms and kinds of rooms denied behind their names: `a lounge is not needed`, `two bathrooms, neither en suite`."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import ahead, clause, last
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

BETWEEN = ("copula", "relative", "pronoun")
"""What may stand between bathrooms and `not en suite`."""


def not_needed(out: list[Item], items: list[Item], k: int) -> bool:
    """`a living room is not needed`, `balcony and terrace not required`: there is none."""
    if items[k].kind != "unneeded":
        return False
    start = len(out)
    while start and (out[start - 1].room is not None or out[start - 1].kind in ("conjunction", "copula")):
        start -= 1
    rooms = [i.room for i in out[start:] if i.room is not None]
    begins = start == 0 or out[start - 1].kind in ("mark", "boundary")
    if not rooms and _thing_denied(out):
        return True
    if not rooms or not begins or not all(_plain(room) for room in rooms):
        out.append(items[k])  # "a door between A and B is not needed" is told
        return True
    for room in rooms:
        room.negated, room.quantifier = True, Det.BARE
    out.insert(start, Item("negation", "no", items[k].text))
    return True


def we_do_not_need(out: list[Item], items: list[Item], k: int) -> bool:
    """`a balcony we don't need`, `living room I do not want`: there is none."""
    room = last(out).room
    ends = k + 1 == len(items) or items[k + 1].kind in ("mark", "boundary", "conjunction")
    denies = items[k].kind == "negation" and items[k].text.split()[-1] in ("need", "want") and ends
    begins = len(out) < 2 or out[-2].kind in ("mark", "boundary", "conjunction")
    if not denies or room is None or not begins or not _plain(room) or (room.count or 1) > 1 or room.plural:
        return False
    room.negated, room.quantifier, room.count = True, Det.BARE, None
    out.insert(len(out) - 1, Item("negation", "no", items[k].text))
    return True


def again_without(out: list[Item], items: list[Item], k: int) -> bool:
    """`bathroom 4.5 m²; bathroom without a bathtub`: the bathroom named before, of which no more was said.

    So is the bedroom of `one bedroom. … Bedroom with a double bed`, which the one told of is.
    """
    room, (no, thing, end) = items[k].room, ahead(items, k)
    denied = no.kind == "negation" and no.value == "without" and thing.kind in ("object", "thing")
    denied = denied and end.kind in ("", "mark", "boundary")
    told_of = no.kind == "area" or (no.kind == "with" and thing.kind == "object")
    if room is None or not (denied or told_of) or not is_mark(last(out), ".," if told_of else "."):
        return False
    named = [j for j, i in enumerate(out) if i.room is not None and i.room.type == room.type]
    told = out[named[0]].room if len(named) == 1 else None
    bare = told is not None and ahead(out, named[0])[0].kind in ("", "area", "mark", "conjunction", "boundary")
    if not denied and named:
        ended = any(is_mark(i, ".") for i in out[named[0] :])
        bare = bare and ended and told is not None and told.count == 1 and ahead(out, named[0])[0].kind != "area"
    if told is not None and bare and _single(told) and _single(room) and room.quantifier == Det.BARE:
        room.quantifier = Det.THE
    return False


def _single(room: RoomPhrase) -> bool:
    plain = room.quantifier in (Det.BARE, Det.A) and not (room.labels or room.owned or room.objects)
    return plain and (room.count or 1) == 1 and not room.plural and _plain(room)


def _thing_denied(out: list[Item]) -> bool:
    """`a bathtub is not needed`; `stairs are not needed`, of which the stairs are told."""
    if last(out).kind == "object":
        out[-1] = replace(out[-1], number=0)
        return True
    return last(out).kind in ("thing", "mark")


def _plain(room: RoomPhrase) -> bool:
    return bool(room.type) and not room.negated and not room.ordinals


def not_ensuite(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bathrooms, neither of which is en suite`, `that are not en suite`: no bathroom is a bedroom's own."""
    room = items[k].room
    if room is None or Trait.ENSUITE not in room.labels or room.quantifier not in (Det.BARE, Det.A) or room.negated:
        return False
    end = len(out)
    while end and out[end - 1].kind in BETWEEN:
        end -= 1
    denied = end > 0 and out[end - 1].kind == "negation" and out[end - 1].value in ("not", "without")
    told = [i for i in clause(out[: end - 1]) if i.room is not None][-1:] if denied else []
    several = [i.room for i in told if i.room is not None and i.room.type == "bathroom" and _several(i.room)]
    if not several or any(i.kind == "link" for i in out[out.index(told[0]) :]):
        return False
    del out[end - 1 :]
    while last(out).kind in BETWEEN or (out and is_mark(out[-1], ",")):
        out.pop()
    room.negated, room.quantifier = True, Det.BARE
    out += [Item("mark", ",", ","), Item("negation", "no", "no"), replace(items[k], room=room)]
    return True


def _several(room: RoomPhrase) -> bool:
    return room.plural or (room.count or 1) > 1

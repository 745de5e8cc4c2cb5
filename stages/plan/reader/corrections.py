"""What a text takes back: counts, areas, neighbours and whole rooms said anew (`actually, make it three bedrooms`)."""

from dataclasses import replace

from apartgen.stages.plan.reader.announced import RELATED, announced
from apartgen.stages.plan.reader.entity import DISTINCT
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.resized import measured_anew, of_another, resized
from apartgen.stages.plan.reader.sufficing import sufficing
from apartgen.stages.plan.reader.vocabulary import Det


def corrected(items: list[Item]) -> list[Item]:
    """What is said anew stands in the place of what was before, without the words that announce it."""
    anew, dropped = False, False
    recounted, start = "", 0
    out: list[Item] = []
    told = sufficing(_contrasted(announced(items)))
    for k, item in enumerate(told):
        if item.value == "instead" and item.kind == "anew":
            out += [] if recounted or _recounted(out) else [Item("instead", "", item.text)]
            continue
        if item.kind == "anew" and item.value == "last":
            out += [] if _last_taken_back(out) else [Item("instead", "", item.text)]
            continue
        if item.kind == "anew":
            anew, dropped = item.value != "drop", item.value == "drop"
            recounted, start = "", len(out)
            continue
        room = item.room
        if room is not None and room.negated and room.quantifier == Det.THE and _commands(out):
            _taken_back(out, room)  # "skip the study"
        if anew and room is not None and room.negated:
            _taken_back(out, room)  # "a study, sorry, no study"
        if room is not None and room.negated and room.quantifier == Det.THE and room.ordinals and _one_fewer(out, room):
            continue  # "an office instead of the second bedroom"
        if room is not None and _renamed(out, room):
            continue
        if anew and room is not None and _ends(told, k) and _meant(out, room, start):
            continue
        if anew and room is not None and _not_this(out, room):
            continue
        if dropped and room is not None:
            dropped = False
            if _taken_back(out, room):
                continue
            _not_wanted(out, room)
        if anew and item.kind == "area" and not of_another(out, start) and measured_anew(out, item, start):
            anew = False
            while [i.value for i in told[k + 1 : k + 2]] == ["with"] and is_mark(out[-1], ","):
                out.pop()  # "a kitchen of 9, sorry, 11 m² with a balcony off it"
            continue
        if anew and room is not None:
            _none_beyond(out, room)
            resized(out, room)
        if anew and item.kind == "object" and _furnished_anew(out, item):
            continue
        if anew and item.kind == "with" and item.value == "in" and _placed_anew(out, start):
            anew = False
        if anew and not recounted and item.kind in RELATED and _related_anew(out, item):
            anew = False
        if anew and room is not None and not (recounted and room.type in ("", recounted)):
            recounted = _counted_anew(out, room) or recounted
        anew = anew and not is_mark(item, ".")
        out.append(item)
    return out


def _counted_anew(out: list[Item], room: RoomPhrase) -> str:
    """The type of the rooms counted before, which are as many as `room` now says; "" where none were."""
    before = _counted(out, room) if room.count is not None else None
    things = [i for i in out if i.kind in ("object", "room")][-1:]
    if before is not None and not room.type and things[0].kind == "object":
        out[out.index(things[0])] = replace(things[0], number=room.count or 1)  # "two bedrooms; four chairs, no, six"
        room.type, room.quantifier, room.count = "any", Det.NONE, None
        return "any"
    if before is None or room.labels & set(DISTINCT) - before.labels:
        return ""
    before.count, room.type = room.count, before.type
    before.quantifier = Det.BARE if before.quantifier == Det.A else before.quantifier
    before.plural = before.plural or (room.count or 1) > 1
    for other in [i.room for i in out if i.room is not None and i.room.type == before.type]:
        other.quantifier = Det.THE if other.quantifier == Det.ANOTHER else other.quantifier
    room.quantifier, room.count, room.headline = Det.THE, None, False
    room.plural = room.plural or (before.count or 1) > 1
    return before.type


def _ends(items: list[Item], k: int) -> bool:
    return k + 1 == len(items) or is_mark(items[k + 1], ".")


def _meant(out: list[Item], room: RoomPhrase, start: int) -> bool:
    """`the bathroom is 6 m², sorry, I meant the kitchen`: what was said of the one room is said of the other."""
    end = start
    while end and out[end - 1].kind in ("mark", "boundary"):
        end -= 1
    begin = max((j + 1 for j in range(end) if is_mark(out[j], ".")), default=0)
    named = [i.room for i in out[begin:end] if i.room is not None]
    told = named[0] if len(named) == 1 and start == len(out) else None
    if told is None or room.quantifier != Det.THE or told.quantifier != Det.THE or room.type in ("", told.type):
        return False
    if out[end - 1].room is told:
        return False
    told.type, told.text, told.labels, told.ordinals = room.type, room.text, room.labels, room.ordinals
    return True


def _not_this(out: list[Item], room: RoomPhrase) -> bool:
    """`with a study. I meant a dining room, not a study`: the study said before is none."""
    if len(out) < 2 or out[-1].kind != "negation" or out[-1].value != "not" or not is_mark(out[-2], ","):
        return False
    if not _taken_back(out, room):
        return False
    del out[-2:]
    return True


def _renamed(out: list[Item], room: RoomPhrase) -> bool:
    """`make the storage room a utility room`: what was said of the one is said of the other."""
    which = out[-1].room if out else None
    begins = len(out) < 2 or out[-2].kind in ("mark", "conjunction", "boundary")
    if which is None or not begins or which.quantifier != Det.THE or room.quantifier != Det.A or not room.type:
        return False
    before = [i for i in out[:-1] if i.room is not None and i.room.type == which.type and not i.room.negated]
    if which.type == room.type or not which.type or not before or before[-1].room is None:
        return False
    if which.ordinals or (before[-1].room.count or 1) > 1:
        return _one_becomes(out, before[-1].room, which)
    others = any(r.type == room.type and not r.negated for i in out if (r := i.room) is not None)
    for item in before:
        told = item.room
        if told is not None:
            if room.ordinals or others:  # "make the study a second bedroom"
                told.ordinals, told.quantifier = room.ordinals, told.quantifier if room.ordinals else Det.ANOTHER
            told.type, told.text, told.labels = room.type, room.text, told.labels | room.labels
    out[:-1] = [replace(i, value=room.type) if i in before else i for i in out[:-1]]
    out.pop()
    return True


def _one_becomes(out: list[Item], counted: RoomPhrase, which: RoomPhrase) -> bool:
    """`make the third bedroom a study`: one fewer, and the other is named behind."""
    if (counted.count or 0) >= max(which.ordinals or (2,)) and counted.quantifier == Det.BARE:
        counted.count = (counted.count or 2) - 1
        out.pop()
    return False


def _recounted(out: list[Item]) -> bool:
    """`two bedrooms, but do three instead`, `no bathtub, a shower instead`; False where nothing was said before."""
    rooms = [i.room for i in out if i.room is not None]
    if not rooms or out[-1].room is not rooms[-1]:
        return any(i.kind == "object" and not i.number for i in out)
    told = rooms[-1]
    before = _counted(out[:-1], told) if told.count is not None else None
    if before is None or told.quantifier != Det.BARE:
        return any(r.negated for r in rooms[:-1])
    before.count, before.plural, told.type = told.count, told.count > 1, before.type  # type: ignore[operator]
    told.quantifier, told.plural = Det.THE, before.plural
    return True


def _taken_back(out: list[Item], room: RoomPhrase) -> bool:
    """`forget the study`: the study said before is none; False where none was."""
    before = [i.room for i in out if i.room is not None and i.room is not room and i.room.type == room.type]
    lone = all(phrase.count in (None, 1) and not phrase.plural for phrase in before)
    lone = lone and (not room.labels or all(phrase.labels == room.labels for phrase in before))
    if room.rank or not room.type or not lone:
        return False  # "two bedrooms, … without the larger bedroom"
    for phrase in before:
        phrase.negated = True
    return bool(before)


def _not_wanted(out: list[Item], room: RoomPhrase) -> None:
    """`the balcony can go` of one that nobody spoke of: there is none."""
    if room.type and room.quantifier == Det.THE and not (room.rank or room.labels or room.plural):
        room.negated, room.quantifier = True, Det.BARE
        out.append(Item("negation", "no", "no"))


def _none_beyond(out: list[Item], room: RoomPhrase) -> None:
    """`the second bathroom - no, just one bathroom`: what was said of the second is said of the last there is."""
    for item in out if room.count else []:
        told = item.room
        if told is not None and told.type == room.type and told.ordinals and max(told.ordinals) > (room.count or 0):
            told.ordinals = (int(room.count or 1),)


def _last_taken_back(out: list[Item]) -> bool:
    """`a dining room - no, skip that`: the room named last is none."""
    room = next((i.room for i in reversed(out) if i.room is not None), None)
    if room is None or room.plural or (room.count or 1) > 1 or room.quantifier not in (Det.A, Det.BARE):
        return False
    room.negated, room.count = True, None
    return True


def _one_fewer(out: list[Item], room: RoomPhrase) -> bool:
    """Takes one from the rooms counted before, and the words that deny it; a room in its place is that said before."""
    counted = [i.room for i in out if i.room is not None and i.room.type == room.type and (i.room.count or 1) > 1]
    if not counted or out[-1].kind != "negation" or (counted[-1].count or 0) < max(room.ordinals):
        return False
    counted[-1].count = (counted[-1].count or 2) - 1
    out.pop()
    rooms = [i.room for i in out if i.room is not None]
    if rooms[-1].count == 1 and any(r.type == rooms[-1].type and r.quantifier == Det.A for r in rooms[:-1]):
        rooms[-1].quantifier, rooms[-1].count = Det.THE, None
    return True


def _commands(out: list[Item]) -> bool:
    """Whether a sentence begins with the negation that ends `out`, which denies a room: `neither` denies a clause."""
    negation = bool(out) and out[-1].kind == "negation" and out[-1].text.split()[0] not in ("neither", "weder", "ni")
    return negation and (len(out) == 1 or is_mark(out[-2], "."))


def _furnished_anew(out: list[Item], thing: Item) -> bool:
    """`a desk in the study, no, two desks`; False where no such thing was named."""
    at = next((k for k in range(len(out) - 1, -1, -1) if out[k].kind == "object" and out[k].value == thing.value), -1)
    if at < 0:
        return False
    out[at] = replace(out[at], number=thing.number, form=thing.form)
    return True


def _placed_anew(out: list[Item], start: int) -> bool:
    """`a piano in the hall, no, in the lounge`: takes the first place away."""
    end = start
    while end and out[end - 1].kind == "mark":
        end -= 1
    said = out[max(end - 3, 0) : end]
    if [i.kind for i in said] != ["object", "with", "room"] or said[1].value != "in":
        return False
    del out[end - 2 :]
    return True


def _related_anew(out: list[Item], item: Item) -> bool:
    """`a balcony off the kitchen, actually off the living room`: takes the first relation away."""
    ends = len(out)
    while ends and out[ends - 1].kind == "mark":
        ends -= 1
    at = next((k for k in range(ends - 1, -1, -1) if out[k].kind in RELATED or is_mark(out[k], ".")), -1)
    if at < 1 or out[at].kind not in RELATED or out[at - 1].room is None:
        return False
    told = [i for i in out[at + 1 :] if i.kind not in ("mark", "boundary", "conjunction")]
    if len(told) > 1 or any(i.room is None and i.value != "entrance" for i in told):
        return False
    del out[at:]
    return True


def _contrasted(items: list[Item]) -> list[Item]:
    """`not three bedrooms but two`: two."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        no, room, but, other = (items[k : k + 4] + [Item("")] * 4)[:4]
        a, b = room.room, other.room
        counted = a is not None and b is not None and a.count is not None and b.count is not None
        if no.kind == "negation" and but.text == "but" and counted and a is not None and b is not None:
            b.type, b.plural = b.type or a.type, b.plural or (b.count or 1) > 1
            out.append(Item("room", b.type, other.text, b))
            k += 4
        else:
            out.append(items[k])
            k += 1
    return out


def _counted(items: list[Item], room: RoomPhrase) -> RoomPhrase | None:
    """The last rooms of this type that were counted, or of any for `no, three`; `a study` where there are now two."""
    rooms = [i.room for i in reversed(items) if i.room is not None and not i.room.negated]
    counted = next((r for r in rooms if r.count is not None and room.type in ("", r.type)), None)
    if counted is not None or not room.type or (room.count or 1) == 1:
        return counted
    return next((r for r in rooms if r.type == room.type and r.quantifier == Det.A), None)

"""What a clause says without its noun: other doors, `but now without`, `ensuite: main bedroom`, things that go in."""

from dataclasses import replace

from apartgen.stages.plan.reader.banned import ALWAYS
from apartgen.stages.plan.reader.belongings import OWNED_BY
from apartgen.stages.plan.reader.clausal import ahead, clause, last
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

GOING = ("go ", "goes ")
BEING = ("is in", "are in", "is inside", "is inside of", "is within")
HOLDING = ("contains", "contain", "includes", "include", "houses", "holds")
DOORS = ("door", "doors")
NAMED = (Det.BARE, Det.A, Det.THE)
TAKING_BACK = ("boundary", "negation", "conjunction")
"""What may stand between a room and the `without` that takes it back."""


def another_door(out: list[Item], items: list[Item], k: int) -> bool:
    """`a door to the hall and another one to the lounge`: another door, no other room."""
    room, link = items[k].room, ahead(items, k)[0]
    if room is None or room.type or room.count or link.kind != "link" or not link.text.startswith("one "):
        return False
    other = room.quantifier in (Det.ANOTHER, Det.OTHER) or bool(room.ordinals) or "second" in room.text
    return other and any(i.kind == "link" and set(DOORS) & set(i.text.split()) for i in clause(out))


def goes_into(out: list[Item], items: list[Item], k: int) -> bool:
    """`a sofa goes into the lounge`, `the piano is in the study`: things lead nowhere."""
    placed = items[k].text.startswith(GOING) or items[k].text in BEING
    if items[k].kind != "link" or not placed or last(out).kind != "object":
        return False
    start = len(out)
    while start and (out[start - 1].kind in ("object", "conjunction") or is_mark(out[start - 1], ",")):
        start -= 1
    if start and out[start - 1].kind == "with" and out[start - 1].value != "in":
        return False  # "a bedroom with a desk goes into the hall"
    out.append(Item("with", "in", items[k].text))
    return True


def one_per(out: list[Item], items: list[Item], k: int) -> bool:
    """`one wardrobe per bedroom`: in each of them."""
    room = items[k].room
    if room is None or room.quantifier != Det.EACH or not room.type or last(out).kind != "object":
        return False
    out += [Item("with", "in", "in"), items[k]]
    return True


def is_not_in(out: list[Item], items: list[Item], k: int) -> bool:
    """`the piano is not in the lounge`: there is none."""
    inside, room = ahead(items, k)[:2]
    end = len(out) - (last(out).kind == "copula")
    thing = out[end - 1] if end > 0 else Item("")
    denies = items[k].kind == "negation" and items[k].value == "not" and thing.kind == "object"
    if not denies or inside.value != "in" or room.room is None or not (end == 1 or is_mark(out[end - 2], ".,")):
        return False
    out[end - 1 :] = [replace(thing, number=0)]
    return True


def holds(out: list[Item], items: list[Item], k: int) -> bool:
    """`the living room also contains the kitchen`: one space, and no room behind a door."""
    other = ahead(items, k)[0].room
    also = last(out).text == "also"
    has = items[k].value == "has" and other is not None and other.quantifier == Det.THE and (also or _within(out))
    if items[k].kind != "with" or not (items[k].text in HOLDING or has) or other is None or other.negated:
        return False
    at = len(out) - 1 - also
    while at >= 0 and (out[at].kind == "relative" or is_mark(out[at], ",")):
        at -= 1
    room = out[at].room if at >= 0 else None
    if room is None or room.type == other.type or not {room.type, other.type} <= set(OPEN_TYPES):
        return False
    if also:
        out.pop()
    out.append(Item("link", "open", items[k].text, form="s"))
    return True


def has_too(out: list[Item], items: list[Item], k: int) -> bool:
    """`the study has a desk; the bedroom a wardrobe but no desk`: it has them."""
    room = last(out).room
    begins = room is not None and room.quantifier == Det.THE and is_mark(last(out[:-1]), ".")
    if items[k].kind != "object" or not begins or not any(i.value == "has" for i in clause(out[:-2])):
        return False
    out += [Item("with", "has", "has"), items[k]]
    return True


def another_alike(out: list[Item], items: list[Item], k: int) -> bool:
    """`bedroom, bedroom, bathroom`: two bedrooms."""
    room, before = items[k].room, last(out[:-1]).room
    joined = is_mark(last(out), ",") or last(out).kind == "conjunction"
    after = ahead(items, k)[0]
    joined = joined and (after.kind in ("", "conjunction", "boundary") or is_mark(after, ",.)"))
    if room is None or before is None or not joined or room.type not in ("bedroom", "bathroom", "balcony"):
        return False
    pair = (room, before)
    plain = all(r.quantifier in (Det.BARE, Det.ANOTHER) and not (r.count or r.plural or r.negated) for r in pair)
    if plain and room.text == before.text and not (room.labels or before.labels or room.ordinals or before.ordinals):
        room.quantifier = Det.ANOTHER
    return False


def _within(out: list[Item]) -> bool:
    """Whether a relative clause begins: `a living room that has the kitchen`."""
    return last(out).kind == "relative"


def no_wall(out: list[Item], items: list[Item], k: int) -> bool:
    """`the kitchen flows into the lounge without a wall between them`, `opens onto it with no door between them`."""
    denies = items[k].kind == "negation" and items[k].value in ("no", "without")
    if not denies or ahead(items, k)[0].text != "between them":
        return False
    said = clause(out)
    if any(i.kind == "open" for i in said):
        return _without_lead(out)
    at = max((j for j, i in enumerate(said) if i.kind == "link"), default=0)
    beside = [i for i in said[at - 1 : at + 2 : 2] if i.room is not None] if at else []
    if len(beside) < 2 or said[at].value not in ("open", "door", "to"):
        return False
    out[len(out) - len(said) + at] = replace(said[at], value="open")
    return _without_lead(out)


def _without_lead(out: list[Item]) -> bool:
    """Takes away what leads to a clause that says nothing more; always true."""
    while out and (out[-1].kind in ("with", "boundary", "conjunction") or is_mark(out[-1], ",")):
        out.pop()
    return True


def whose_value(out: list[Item], items: list[Item], k: int) -> bool:
    """`ensuite: master bedroom`: the bedroom has it, which is one of those that there are."""
    held, owner, end = last(out).room, *ahead(items, k)[:2]
    if not is_mark(items[k], ":") or held is None or owner.room is None or not _lone(held) or not _lone(owner.room):
        return False
    begins = len(out) < 2 or out[-2].kind == "mark"
    fits = owner.room.type != "hallway" and owner.room.type in OWNED_BY.get(held.type, ())
    ends = end.kind == "" or is_mark(end, ".;") or (is_mark(end, ",") and Trait.ENSUITE in held.labels)
    if not begins or not fits or not ends:
        return False
    had = out.pop()
    owner.room.quantifier = Det.THE
    held.quantifier = Det.A
    items[k + 1] = Item("stop", "", owner.text)
    out += [owner, Item("with", "has", items[k].text), had]
    return True


def _lone(room: RoomPhrase) -> bool:
    return room.count is None and room.quantifier in (Det.BARE, Det.THE) and not (room.plural or room.negated)


def taken_back(out: list[Item], items: list[Item], k: int) -> bool:
    """`first with a balcony, but now without`: none of the room named last."""
    if k and items[k].value in ("it", "them") and _bare_without(items, k - 1) and last(out).kind != "negation":
        return True
    if not _bare_without(items, k) or not (last(out).kind == "boundary" or is_mark(last(out), ",")):
        return False
    end = len(out)
    while end and (out[end - 1].kind in TAKING_BACK or is_mark(out[end - 1], ",")):
        end -= 1
    room = out[end - 1].room if end else None
    if room is None or room.negated or room.type in ("", "any", *ALWAYS) or room.quantifier not in NAMED:
        return False
    del out[end:]
    room.negated, room.quantifier, room.count = True, Det.BARE, None
    out.insert(end - 1, Item("negation", "no", items[k].text))
    return True


def _bare_without(items: list[Item], k: int) -> bool:
    """Whether a `without` stands at `k` that nothing follows but `it`."""
    after = [i for i in ahead(items, k)[:2] if i.value not in ("it", "them")]
    return items[k].kind == "negation" and items[k].value == "without" and (
        after[0].kind in ("", "boundary") or is_mark(after[0], ".")
    )


def one_of_counted(out: list[Item], items: list[Item], k: int) -> bool:
    """`four bedrooms, including a master suite`: the suite is one of the four."""
    room = ahead(items, k)[0].room if items[k].value == "including" else None
    whole = [i for i in clause(out) if i.room is not None and room is not None and i.room.type == room.type]
    if room is not None and not room.negated and any(i.room is not None and (i.room.count or 1) > 1 for i in whole):
        room.subset = True
    return False

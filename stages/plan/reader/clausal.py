"""Where a clause ends, and what of the clause before it speaks of again."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det

COMPARED = ("compare", "extreme", "share", "fraction")
DENYING = ("no", "without")
LEADING = ("with", "boundary", "conjunction", "relative", "copula")
"""What may stand between the rooms and `no door between them`."""
FINITE = ("copula", "reach")
"""Verbs that may stand between a room and what is in it."""
SIZING = ("area", "copula", "with", "area_word")
"""What may stand between rooms and their areas."""


def ahead(items: list[Item], k: int) -> list[Item]:
    """The three items behind `k`."""
    return (items[k + 1 : k + 4] + [Item("")] * 3)[:3]


def last(out: list[Item]) -> Item:
    """The item before; a full stop where there is none."""
    return out[-1] if out else Item("mark", ".")


def clause(out: list[Item]) -> list[Item]:
    """What `out` has of the sentence that it ends in."""
    return out[max((j + 1 for j in range(len(out)) if is_mark(out[j], ".")), default=0) :]


def compared(out: list[Item], items: list[Item], k: int) -> bool:
    """`A is smaller than B, and C is next to D`: what is said of C is not said of A and B."""
    room, verb, _ = ahead(items, k)
    joins = items[k].kind == "conjunction" or is_mark(items[k], ",")
    if not joins or room.room is None or verb.kind != "copula" or not any(i.kind in COMPARED for i in clause(out)):
        return False
    out.append(Item("mark", ".", "."))
    return True


def next_one(out: list[Item], items: list[Item], k: int) -> bool:
    """`the first off the hall, the second with a desk`: what is said of the second begins anew."""
    other, verb, _ = ahead(items, k)
    said = clause(out)
    told = _one_of_several(other) and verb.kind in ("with", "link") and any(_one_of_several(i) for i in said)
    if not is_mark(items[k], ",") or not told or not any(i.kind == "link" for i in said):
        return False
    out.append(Item("mark", ".", "."))
    return True


def _one_of_several(item: Item) -> bool:
    """`the first`, `the other`."""
    room = item.room
    return room is not None and not room.type and (bool(room.ordinals) or room.quantifier == Det.OTHER)


def then_listed(out: list[Item], items: list[Item], k: int) -> bool:
    """`a bedroom with a desk and a chair, then a kitchen`, `on the left the kitchen, then the bath`: a list, no way."""
    furnished = len(out) > 1 and is_mark(out[-1], ",") and out[-2].kind == "object"
    told = [i.kind for i in clause(out) if i.kind in ("place", "side", "link", "reach", "front")]
    placed = told[-1:] in (["place"], ["side"])
    return items[k].kind == "boundary" and items[k].value == "then" and (furnished or placed)


def none_between(out: list[Item], items: list[Item], k: int) -> bool:
    """`A is next to B but with no door between them`: between those two, or the several named last."""
    if k and _denies(items, k - 1) and items[k - 1].value in DENYING:
        return True
    pair = _pair(clause(out)) if _denies(items, k) else []
    if not pair:
        return False
    while out[-1].kind in LEADING or is_mark(out[-1], ","):
        out.pop()
    joined = [pair[0], Item("conjunction", "and", "and"), pair[1]] if len(pair) > 1 else pair
    out += [Item("mark", ".", "."), Item("negation", "no", "no"), Item("link", "between", "between"), *joined,
            Item("mark", ".", ".")]  # fmt: skip
    return True


def _denies(items: list[Item], k: int) -> bool:
    return items[k].kind == "negation" and items[k].value in DENYING and ahead(items, k)[0].text == "between them"


def _pair(said: list[Item]) -> list[Item]:
    """The two rooms that a sentence is about, or the phrase for several."""
    named = [i for i in said if i.room is not None and not i.room.negated]
    several = [i for i in named[-1:] if i.room is not None and (i.room.plural or (i.room.count or 1) > 1)]
    return several or (named[-2:] if len(named) > 1 else [])


def beside_it(out: list[Item], items: list[Item], k: int) -> bool:
    """`a bedroom near the entrance, the bathroom beside it`: beside the bedroom; `far from` one, it is the entrance."""
    first, link, place, comma, room, near = ([Item("")] * 6 + out)[-6:]
    fits = items[k].value == "it" and near.kind == "link" and near.value == "near" and room.room is not None
    fits = fits and is_mark(comma, ",") and place.value == "entrance" and link.value == "near"
    if not fits or first.room is None:
        return False
    out.append(again_named(first.room))
    return True


def again_named(room: RoomPhrase) -> Item:
    """A room spoken of once more."""
    said = RoomPhrase(room.type, set(room.labels), quantifier=Det.THE, ordinals=room.ordinals, text=room.text)
    return Item("room", room.type, room.text, said)


def in_every(out: list[Item], items: list[Item], k: int) -> bool:
    """`…, in every bedroom a desk`, `… and in each bedroom one desk`, `…, and in the lounge a sofa`: a new clause."""
    k += items[k].kind == "conjunction" and is_mark(ahead(items, k)[0], ",")  # "… and, in the lounge, a sofa"
    inside, room, _ = ahead(items, k)
    thing = next((i for i in items[k + 3 : k + 6] if i.kind not in FINITE and not is_mark(i, ",")), Item(""))
    joins = items[k].kind == "conjunction" or is_mark(items[k], ",")
    if not joins or inside.value != "in" or room.room is None or thing.kind != "object":
        return False
    new = is_mark(last(out), ",") or (last(out).room is not None and room.room.quantifier == Det.THE)
    each = room.room.quantifier == Det.EACH and last(out).kind != "object"
    if items[k].kind == "conjunction" and not (new or each):
        return False
    out.append(Item("mark", ".", "."))
    return True


def in_each(out: list[Item], items: list[Item], k: int) -> bool:
    """`dans chaque chambre un lit`, where nothing stands for `in`: each has it."""
    room, before = last(out).room, last(out[:-1])
    begins = is_mark(before, ".,:") or before.kind == "conjunction"
    if items[k].kind != "object" or room is None or room.quantifier != Det.EACH or not begins:
        return False
    out += [Item("with", "has", "in"), items[k]]
    return True


def several_areas(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bedrooms of 15 m² and 10 m²`, whose second area is no area of the flat."""
    if items[k].kind == "conjunction" and ahead(items, k)[0].kind == "area" and _owed(out):
        return True
    if k == 0 or items[k].kind != "area" or items[k - 1].kind != "conjunction" or not _owed(out):
        return False
    out[-1] = replace(out[-1], values=(*out[-1].values, *items[k].values))
    return True


def _owed(out: list[Item]) -> bool:
    """Whether `out` ends in fewer areas than there are of the rooms they are said of."""
    said_of = [i for i in out if i.kind not in SIZING and not is_mark(i, ":(,")]
    room = said_of[-1].room if said_of else None
    return last(out).kind == "area" and room is not None and len(out[-1].values) < (room.count or 1)


def is_for(out: list[Item], items: list[Item], k: int) -> bool:
    """`the second bedroom is for a baby`: whom it is for has nothing; what follows belongs to the bedroom."""
    fits = items[k].kind == "with" and items[k].text == "for" and last(out).kind == "copula"
    if not fits or ahead(items, k)[0].kind != "thing" or len(out) < 2 or out[-2].room is None:
        return False
    out.pop()
    return True


def one_of_them(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bedrooms, one bedroom is for us`: of which something is said is one of those counted before."""
    room, verb = items[k].room, ahead(items, k)[0]
    plain = room is not None and room.count == 1 and room.quantifier == Det.BARE and not room.labels
    told = verb.kind in ("copula", "side", "place") or verb.value == "has"
    if room is None or not plain or room.headline or not told:
        return False
    counted = [i.room for i in out if i.room is not None and i.room.type == room.type][-1:]
    if not counted or not room.type or (counted[0].count or 1) < 2 or counted[0].quantifier != Det.BARE:
        return False
    room.type = ""
    out.append(replace(items[k], value=""))
    return True


def several_new(item: Item) -> bool:
    """Whether a phrase counts several rooms that are new."""
    room = item.room
    return room is not None and room.quantifier == Det.BARE and (room.count or 1) > 1

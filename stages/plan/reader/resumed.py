"""Clauses that go on with a room named before: `it has …`, `in the bedroom there is …`, `… inside`, `as is …`."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import again_named, ahead, clause, last
from apartgen.stages.plan.reader.mention import PARTITIVE, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det

FINITE = ("copula", "link", "reach")
INSIDE = ("inside", "within", "inside of")
NEW = (Det.A, Det.BARE)


def it_has(out: list[Item], items: list[Item], k: int) -> bool:
    """`we sleep in the third bedroom, it has a bath`, `the study is large, and has a balcony`: said of that room."""
    it = items[k].kind == "pronoun" and items[k].value == "it" and ahead(items, k)[0].value == "has"
    again = items[k].value == "has" and items[k].kind == "with" and last(out).kind == "conjunction"
    end = len(out) - again
    if not (it or again) or end < 1 or not is_mark(out[end - 1], ",."):
        return False
    said = clause(out[: end - 1])
    room = _spoken_of(said, again)
    if room is None:
        return False
    out[end - 1 :] = [Item("mark", ".", "."), again_named(room)]
    if again:
        out.append(items[k])
    return True


def _spoken_of(said: list[Item], again: bool) -> RoomPhrase | None:
    """The room that a clause is about; None where it lists several, or tells of the home."""
    rooms = [i.room for i in said if i.room is not None]
    if not rooms or any(i.kind in ("dwelling", "negation") or i.value == "has" for i in said):
        return None
    finite = any(i.kind in FINITE for i in said)
    room = rooms[0] if finite else rooms[-1]
    single = not room.plural and (room.count or 1) == 1 and bool(room.type) and room.type != "any"
    known = room.quantifier == Det.THE or bool(room.ordinals) or said[0].kind == "reach"
    lone = len(rooms) == 1 or (finite and len(rooms) == 2)
    return room if single and known and lone and (finite or not again) else None


def there_is_in(out: list[Item], items: list[Item], k: int) -> bool:
    """`in the main bedroom there is a bathroom`: the bedroom has it."""
    if k > 1 and items[k].kind == "reach" and _fronted(items, k - 2):
        out.append(Item("with", "has", items[k].text))
        return True
    return _fronted(items, k) and (not out or out[-1].kind in ("mark", "conjunction", "boundary"))


def _fronted(items: list[Item], k: int) -> bool:
    owner, there, room = ahead(items, k)
    bedroom = owner.room is not None and owner.room.type == "bedroom" and not owner.room.negated
    new = room.room is not None and room.room.quantifier in NEW and room.room.type in ("bathroom", "balcony", "closet")
    begins = k == 0 or items[k - 1].kind in ("mark", "conjunction", "boundary")
    return begins and items[k].value == "in" and bedroom and there.kind == "reach" and new


def has_inside(out: list[Item], items: list[Item], k: int) -> bool:
    """`it has a bathroom inside`: what a room has is in it."""
    it, end = ahead(items, k)[:2]
    end = end if it.value == "it" else it
    ends = end.kind in ("", "conjunction", "boundary", "mark")
    thing = last(out).room is not None or last(out).kind == "object"
    had = thing and [i.value for i in out[-2:-1]] in (["has"], ["with"])
    if not had or not ends or items[k].kind != "with" or items[k].value != "in":
        return False
    if it.value == "it":
        items[k + 1] = Item("stop", "", it.text)
    return True


def off_it(out: list[Item], items: list[Item], k: int) -> bool:
    """`a kitchen with a table, a pantry off it, a bedroom`: off the kitchen."""
    end, room = ahead(items, k)[0], last(out).room
    ends = end.kind in ("", "mark", "conjunction", "boundary") and not is_mark(end, ":")
    if items[k].kind != "relative" or items[k].text != "off it" or room is None or room.quantifier != Det.A or not ends:
        return False
    before = [i.room for i in clause(out[:-1]) if i.room is not None and not i.room.plural and i.room.type != "any"]
    if len(out) < 2 or not is_mark(out[-2], ",") or not before:
        return False
    out += [Item("link", "door", "off"), again_named(before[-1])]
    return True


def which_has(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bedrooms, one with a balcony. The one with the balcony …`: that of which it was said."""
    room, (has, thing, _) = items[k].room, ahead(items, k)
    if room is None or room.quantifier != Det.THE or room.plural or has.kind != "with" or has.value != "with":
        return False
    owned = thing.room is None or thing.room.quantifier == Det.THE
    if not owned or not (thing.kind == "object" or thing.room is not None):
        return False
    told = _who_has(out, room.type, thing)
    if told is None or room.labels - told.labels:
        return False
    room.type, room.count, room.another, room.among = "", 1.0, False, [told]
    items[k + 1 : k + 3] = [Item("stop", "", i.text) for i in (has, thing)]
    out.append(replace(items[k], value=""))
    return True


def _who_has(out: list[Item], kind: str, thing: Item) -> RoomPhrase | None:
    """The one room of a type of which such a thing was said."""
    for j in range(len(out) - 2, -1, -1):
        room, has = out[j].room, out[j + 1]
        if room is None or (kind not in ("", room.type) and room.type):
            continue
        end = next((n for n in range(j + 1, len(out)) if out[n].kind in ("mark", "boundary", "link")), len(out))
        own = out[j + 1 : end] if has.kind in ("with", "object") else []
        same = any(i.kind == thing.kind and i.value == thing.value for i in own)
        if same:
            return room if not room.plural and (room.count or 1) == 1 and room.quantifier not in PARTITIVE[:3] else None
    return None


def set_off(out: list[Item], items: list[Item], k: int) -> bool:
    """`the other one, 6 m², has a bath`: an area between commas."""
    area, comma, verb = ahead(items, k)
    between = is_mark(items[k], ",") and area.kind == "area" and is_mark(comma, ",")
    told = verb.kind == "copula" or verb.value == "has"
    told = told or (verb.value == "with" and [i.kind for i in items[k + 4 : k + 5]] == ["object"])
    if not between or last(out).room is None or not told:
        return False
    items[k + 2] = Item("stop", "", ",")
    return True


def same_area(out: list[Item], items: list[Item], k: int) -> bool:
    """`the living room is 20 m², as is the kitchen`: so large is the kitchen, too."""
    if k and items[k].room is not None and items[k - 1].value == "same" and (area := _measured(out)) is not None:
        out += [items[k], area]
        return True
    same = items[k].kind == "link" and items[k].value == "same" and ahead(items, k)[0].room is not None
    return same and _measured(out) is not None


def _measured(out: list[Item]) -> Item | None:
    """The one area that ends a clause."""
    said = [i for i in out[-3:] if i.kind != "conjunction" and not is_mark(i, ",")][-1:]
    return said[0] if said and said[0].kind == "area" and len(said[0].values) == 1 and not said[0].value else None

"""Doors told beside the point: `whose only door is to the kitchen`, `entered just from it`, `entered from there`."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import again_named, ahead, clause, last
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import EACH_OTHER, Det, Trait

FROM = ("from", "through", "via", "over")
ONLY = ("only", "just", "solely", "exclusively", "merely", "simply")
ENTERED = ("entered", "reached", "accessed", "accessible", "reachable", "entrance", "access")
GOING_IN = ("go in", "enter", "get in", "come in", "walk in", "step in", "go inside", "get there", "reach it")
WAYS_IN = ("door", "doors", "access", "way in")
JOINTS = ("conjunction", "boundary")


def entered_only(out: list[Item], items: list[Item], k: int) -> bool:
    """`that can be reached just from the kitchen`, `whose only entrance is from the kitchen`: from there alone."""
    if items[k].kind != "only" or items[k].text not in ONLY:
        return False
    at = k + 1
    door = at < len(items) and (items[at].value == "entrance" or items[at].text in WAYS_IN)
    at += door
    way, room = (items[at : at + 2] + [Item("")] * 2)[:2]
    leads = way.kind == "front" and way.text in FROM or (door and way.kind == "link" and way.value == "door")
    if not leads or room.room is None or not (door or any(i.room is not None for i in clause(out))):
        return False
    if last(out).kind == "copula" and not door:
        out.pop()
    out.append(Item("link", "only", "reached only from"))
    for j in range(k + 1, at + 1):
        items[j] = Item("stop", "", items[j].text)
    return True


def only_behind(out: list[Item], items: list[Item], k: int) -> bool:
    """`the living room is entered through the kitchen only`."""
    ends = ahead(items, k)[0].kind in ("", "mark", "boundary", "conjunction")
    if items[k].kind != "only" or items[k].text not in ONLY or not ends or len(out) < 2 or last(out).room is None:
        return False
    way = out[-2]
    if way.kind != "link" or way.value != "door" or not set(way.text.split()) & set(ENTERED):
        return False
    out[-2] = Item("link", "only", way.text, form=way.form)
    return True


def from_there(out: list[Item], items: list[Item], k: int) -> bool:
    """`the study is behind the lounge and is entered from there`: from the lounge."""
    words = items[k].text.split()
    if items[k].kind != "link" or words[-1] != "there" or not set(words) & set(ENTERED):
        return False
    named = [i.room for i in clause(out) if i.room is not None]
    if len(named) != 2 or named[0] is named[1] or named[0].type == named[1].type or last(out).kind != "conjunction":
        return False
    out += [Item("link", "door", "is entered from", form="s"), again_named(named[1])]
    return True


def inside(out: list[Item], items: list[Item], k: int) -> bool:
    """`from inside the kitchen`, `with the kitchen inside`: no room is in another behind a door."""
    if items[k].value != "in" or items[k].kind != "with" or items[k].text not in ("inside", "within", "in"):
        return False
    if last(out).kind == "front" and last(out).text == "from" and ahead(items, k)[0].room is not None:
        return True
    whole, with_, part = ([Item("")] * 3 + out)[-3:]
    it, after = ahead(items, k)[:2]
    end = after if it.value == "it" else it
    held = whole.room is not None and with_.value == "with" and part.room is not None and not part.room.negated
    if not held or whole.room is None or part.room is None or end.kind not in ("", "conjunction", "mark"):
        return False
    if whole.room.type == part.room.type or not {whole.room.type, part.room.type} <= set(OPEN_TYPES):
        return False
    out[-2] = Item("link", "open", "with", form="s")
    if it.value == "it":
        items[k + 1] = Item("stop", "", it.text)
    _closed_off(items, k + 1 + (it.value == "it"))
    return True


def _closed_off(items: list[Item], k: int) -> None:
    """What follows in the list is no part of the clause."""
    if k < len(items) and items[k].kind in ("conjunction", "mark"):
        items[k] = Item("mark", ".", ".")


def through_passage(out: list[Item], items: list[Item], k: int) -> bool:
    """`connected to the lounge via an open passage`: an opening, no hall."""
    hall = ahead(items, k)[0].room
    if items[k].kind != "front" or items[k].text not in ("via", "through", "by") or hall is None:
        return False
    if hall.type != "hallway" or Trait.OPEN not in hall.labels or hall.quantifier != Det.A:
        return False
    at = next((j for j in range(len(out) - 1, -1, -1) if out[j].kind == "link" or is_mark(out[j], ".")), -1)
    if at < 0 or out[at].kind != "link" or out[at].value not in ("door", "only", "to", "open"):
        return False
    out[at] = Item("link", "open", out[at].text, form=out[at].form)
    items[k + 1] = Item("stop", "", items[k + 1].text)
    return True


def between_the_two(out: list[Item], items: list[Item], k: int) -> bool:
    """`next to the bedroom comes a store, with a door between the two`: between the two rooms of the sentence."""
    room = items[k].room
    if room is None or room.type or room.quantifier not in (Det.THE, Det.BOTH) or room.count not in (2, None):
        return False
    pair = [i.room for i in clause(out) if i.room is not None]
    if last(out).value != "between" or len(pair) != 2 or pair[0].type == pair[1].type or not all(map(_single, pair)):
        return False
    if out[-2].kind == "negation" or any(i.kind == "negation" for i in items[max(k - 3, 0) : k]):
        return False  # "no wall between the two"
    between = out.pop()
    while last(out).kind in ("with", "boundary", "conjunction") or (out and is_mark(out[-1], ",")):
        out.pop()
    out += [Item("mark", ".", "."), between, again_named(pair[0]), Item("conjunction", "and", "and"),
            again_named(pair[1])]  # fmt: skip
    return True


def _single(room: RoomPhrase) -> bool:
    return bool(room.type) and not room.plural and (room.count or 1) == 1


def you_go_in(out: list[Item], items: list[Item], k: int) -> bool:
    """`the store has no door to the hall, you go in from the kitchen`: into the store."""
    way, room, _ = ahead(items, k)
    if items[k].kind != "reach" or way.kind != "front" or way.text not in FROM or room.room is None:
        return False
    anew = is_mark(last(out), ".") and items[k].text.endswith(("there", " it", " get", " gets"))
    anew = anew and any(i.kind == "negation" for i in clause(out[:-1]))
    goes_on = items[k].text.endswith(GOING_IN) and (is_mark(last(out), ",") or last(out).kind in JOINTS)
    if not (anew or goes_on):
        return False
    subject = next((i.room for i in clause(out[:-1]) if i.room is not None), None)
    if subject is None or not _single(subject) or subject.negated:
        return False
    out.pop()
    out += [Item("mark", ".", "."), again_named(subject), Item("link", "door", "is entered from", form="s")]
    items[k + 1] = Item("stop", "", way.text)
    return True


def to_each_other(out: list[Item], items: list[Item], k: int) -> bool:
    """`the bedrooms are connected to each other`, `two baths with a door to each other`: the first to the second."""
    at = len(out) - 1
    while at >= 0 and (out[at].kind in ("copula", "relative", "with", "pronoun") or out[at].text == "also"):
        at -= 1
    room, they = (out[at].room if at >= 0 else None), any(i.kind == "pronoun" for i in out[at + 1 :])
    they = they or last(out[: at + 1]).kind == "conjunction"
    if items[k].kind != "link" or items[k].value not in ("door", "to") or ahead(items, k)[0].value != "mutual":
        return False
    if they or (room is not None and not _two(room) and any(i.kind == "link" for i in clause(out[: at + 1]))):
        they = True
        room = next((i.room for i in reversed(out) if i.room is not None and _two(i.room)), None)
    if room is None or room.negated or not _two(room) or room.type not in ("bedroom", "bathroom", "study", ""):
        return False
    plain = room.type in ("bedroom", "bathroom") and not room.labels and not they
    if plain or room.type == "study":
        _first_to_second(out, at, room)
    else:
        out[at + 1 :] = [Item("mark", ".", ".")] if they else []
        pair = replace(items[k], value="door", text=EACH_OTHER, form="p")
        these = [Item("room", "", "both", RoomPhrase("", quantifier=Det.BOTH, among=[room], text="both"))
                 for _ in range(2)]  # fmt: skip
        out += [*these[:they], pair, these[1], Item("mark", ".", ".")]
    items[k + 1] = Item("stop", "", items[k + 1].text)
    _closed_off(items, k + 2)
    return True


def _two(room: RoomPhrase) -> bool:
    """Whether a phrase may be of two rooms."""
    several = room.plural or room.count == 2 or (not room.type and room.quantifier in (Det.BOTH, Det.EACH))
    return several and room.count in (2, None)


def _first_to_second(out: list[Item], at: int, room: RoomPhrase) -> None:
    """Puts `room 1 has a door to room 2` behind the rooms at `at`."""
    one, other = (RoomPhrase(room.type, quantifier=Det.THE, ordinals=(n,), text=room.text) for n in (1, 2))
    out[at + 1 :] = []
    if room.quantifier != Det.BARE and room.count is None:
        out.pop()
    end = Item("mark", ".", ".")
    out += [end, Item("room", one.type, one.text, one), Item("link", "door", "has a door to", form="s"),
            Item("room", other.type, other.text, other), end]  # fmt: skip


def which_is_the(out: list[Item], items: list[Item], k: int) -> bool:
    """`it starts in the living room, which should be the largest room`: a sentence of its own."""
    verb, most, _ = ahead(items, k)
    room = out[-2].room if len(out) > 1 and is_mark(last(out), ",") else last(out).room
    if items[k].kind != "relative" or verb.kind != "copula" or most.kind != "extreme" or room is None or not room.type:
        return False
    if is_mark(last(out), ","):
        out.pop()
    out += [Item("mark", ".", "."), again_named(room)]
    _closed_off(items, k + 3)
    return True


def no_door_at_all(out: list[Item], items: list[Item], k: int) -> bool:
    """`there should not be any door between A and B`: no door between them."""
    no, be = ([Item("mark", ".")] * 2 + out)[-2:]
    begins = len(out) < 3 or out[-3].kind in ("mark", "boundary", "conjunction", "reach")
    if items[k].value != "between" or no.kind != "negation" or no.value != "not" or be.kind != "copula" or not begins:
        return False
    out[-2:] = [Item("negation", "no", no.text), items[k]]
    return True

"""Rooms that share a space, said by a noun or by a clause: `through a wide opening`, `open to each other`."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import ahead, clause, last
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

BY = ("front", "with", "negation")
"""Kinds of what leads to an opening: `through an opening`, `with an opening`, `without a door`."""
WAY = ("room", "pronoun", "conjunction", *BY)
"""What may stand between a relation and the opening that it leads through."""
LED = ("link", "with", "conjunction")
"""Kinds of what leads from an opening to a room: `an opening to the kitchen`, `joins the kitchen to the lounge`."""
MUTUAL = ("open", "opens", "opening")


def denied_doors(items: list[Item]) -> list[Item]:
    """`without a door to the hall`, `with no door between them` deny a door, which makes no opening."""
    out: list[Item] = []
    for k, item in enumerate(items):
        denies = k > 0 and items[k - 1].value == "doorless" and item.value == "to"
        none = item.value == "doorless" and ahead(items, k)[0].kind in ("link", "front", "sum", "with")
        item = Item("link", "door", "door to") if denies else item
        out.append(Item("negation", "without", item.text) if none else item)
    return out


def not_open(out: list[Item], items: list[Item], k: int) -> bool:
    """`the kitchen is not open`, `a studio, no open plan`."""
    end = len(out) - (last(out).kind == "copula")
    if items[k].kind != "open" or last(out[:end]).kind != "negation" or ahead(items, k)[0].room is not None:
        return False
    no, said_of = out[end - 1], [i for i in out[: end - 1] if i.kind != "copula"][-1:]
    del out[end - 1 :]
    room = said_of[0].room if said_of else None
    if room is not None and room.type == "kitchen" and not room.negated:
        room.labels.add(Trait.SEPARATE)
    elif room is None or room.type in OPEN_TYPES:
        out += [no, Item("room", "kitchen", "kitchen", RoomPhrase("kitchen", {Trait.OPEN}, negated=True))]
    else:
        out += [no, items[k]]
    return True


def opening(out: list[Item], items: list[Item], k: int) -> bool:
    """The item at `k` where it is an opening or a door that is not there: what it tells becomes a relation."""
    if k and items[k - 1].kind == "opening" and _to_room(items, k) and last(out).kind == "link":
        return True  # the `to` of "an opening to the lounge", which the link stands for
    if items[k].kind != "opening":
        return False
    if last(out).kind == "negation":
        return True  # "no opening between them"
    if _to_room(items, k + 1):
        return _owned(out, items[k])
    return (
        _instead_of_a_door(out) or _joining(out, items, k) or _led_through(out) or _kept(out, items[k])
    )


def _instead_of_a_door(out: list[Item]) -> bool:
    """`no door between the lounge and the dining room, only an opening`."""
    end = len(out)
    while end and (out[end - 1].kind in ("only", "boundary") or is_mark(out[end - 1], ",")):
        end -= 1
    no, link, a, joint, b = ([Item("")] * 5 + out[:end])[-5:]
    between = no.kind == "negation" and link.value == "between" and joint.kind == "conjunction"
    if end == len(out) or not between or a.room is None or b.room is None:
        return False
    out[end - 5 :] = [Item("mark", ".", "."), a, Item("link", "open", "open to", form="s"), b]
    return True


def _to_room(items: list[Item], k: int) -> bool:
    """Whether `to the kitchen` stands at `k`."""
    to, room, _ = (items[k : k + 3] + [Item("")] * 3)[:3]
    return (to.value in ("to", "in") or to.text in ("to", "into", "onto")) and (room.room is not None or
                                                                               room.value == "it")  # fmt: skip


def _owned(out: list[Item], noun: Item) -> bool:
    """`the kitchen has an opening to the lounge`, `a kitchen with an opening to the lounge`."""
    form = "s" if last(out).value == "has" else ""
    if last(out).kind in BY:
        out.pop()
    out.append(Item("link", "open", "open to", form=form))
    return True


def _joining(out: list[Item], items: list[Item], k: int) -> bool:
    """`an opening joins A and B`, `an opening between A and B`: a clause of its own, `A is open to B`."""
    verb, a, joint = ahead(items, k)
    b = items[k + 4] if k + 4 < len(items) else Item("")
    if verb.kind != "link" or a.room is None or joint.kind not in LED or b.room is None:
        return False
    while last(out).kind in (*BY, "reach", "copula"):
        out.pop()
    out += [] if is_mark(last(out), ".") else [Item("mark", ".", ".")]
    if k + 5 < len(items) and is_mark(items[k + 5], ","):
        items[k + 5] = Item("mark", ".", ".")
    items[k + 1], items[k + 3] = Item("stop", "", verb.text), Item("link", "open", "open to", form="s")
    return True


def _led_through(out: list[Item]) -> bool:
    """`connects to the lounge through an opening`, `opens into it without a door`: no door but an opening."""
    said = clause(out)
    at = next((j for j in range(len(said) - 1, -1, -1) if said[j].kind == "link"), None)
    if at is None or said[at].value not in ("door", "to", "open") or any(i.kind not in WAY for i in said[at + 1 :]):
        return False
    if said[at].value == "open":
        return True  # "through an opening without a door"
    where = len(out) - len(said) + at
    out[where] = replace(out[where], value="open")
    if last(out).kind in BY:
        out.pop()
    return True


def _kept(out: list[Item], noun: Item) -> bool:
    """An opening that leads nowhere is told."""
    out.append(noun)
    return True


def open_to_each_other(out: list[Item], items: list[Item], k: int) -> bool:
    """`the kitchen and the dining room open to each other`."""
    item, named = items[k], [i.room for i in clause(out) if i.room is not None]
    pair = [r for r in named if r.type][-2:]
    fits = item.kind == "link" and item.value == "door" and item.text.split()[0] in MUTUAL
    fits = fits and ahead(items, k)[0].value == "mutual" and len(pair) == 2
    if not fits or not all(r.type in OPEN_TYPES for r in pair):
        return False
    out.append(replace(item, value="open"))
    return True


def together_with(out: list[Item], items: list[Item], k: int) -> bool:
    """`one kitchen together with the living room`, `the kitchen together with living room`: no further room."""
    first, other = last(out).room, ahead(items, k)[0].room
    if items[k].text != "together with" or first is None or other is None:
        return False
    if not {first.type, other.type} <= set(OPEN_TYPES) or other.count or other.quantifier not in (Det.THE, Det.BARE):
        return False
    out.append(Item("link", "open", items[k].text))
    return True

"""What a sentence leaves out or says beside the point, written out before relations are looked for."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

ARROWS = ("->", "=>", "→", "⇒")
SAID = ("link", "side", "place", "compare")
"""Kinds with which begins what is said of a room."""
FLOATING = (Det.BOTH, Det.ALL, Det.EACH)


def written_out(items: list[Item]) -> list[Item]:
    """Each short form in the place of which a longer one of the same meaning stands."""
    out: list[Item] = []
    fronted: Item | None = None
    door: Item | None = None
    for k, item in enumerate(items):
        before, ahead = (out[-1] if out else Item("mark", ".")), (items[k + 1 : k + 4] + [Item("")] * 3)[:3]
        room = item.room
        if item.text in ARROWS and ahead[0].kind == "object":
            out.append(Item("with", "has", item.text))  # "bedroom 1 -> double bed"
        elif is_mark(item, ",") and (is_mark(before, ",") or _furnishes(ahead)):
            out += [] if is_mark(before, ",") else [Item("mark", ".", ".")]
        elif item.value == "not" and before.room is not None and _ends(items, k) and (said := _said_before(out)):
            at, verb = said  # "the bathrooms share a wall and the bedrooms do not"
            out[at] = Item("mark", ".", ".")
            out += [item, *verb]
        elif item.text == "also" and before.room is not None and ahead[0].kind in SAID:
            continue  # "a bathroom also accessible from the hall"
        elif item.text == "that" and before.kind == "conjunction" and ahead[0].room is not None:
            out[-1] = Item("boundary", "while", before.text)  # "that A is … and that B is …"
        elif item.text == "together" and ahead[0].kind not in ("area", "share", "with") and _lived(out):
            out.append(Item("open", "", item.text))  # "kitchen and dining area together"
        elif item.text == "between them" and ahead[0].room is not None and ahead[0].room.quantifier == Det.A:
            fronted = Item("link", "between", item.text)  # "and between them a bathroom"
        elif fronted is not None and room is not None:
            out += [item, fronted]
            fronted = None
        elif room is not None and room.text == "own" and ahead[0].text.startswith("door"):
            door = out.pop() if before.value == "has" else item  # "the bedroom has its own door to the bathroom"
        elif door is not None and item.kind == "link":
            out.append(replace(item, form="s"))
            door = None
        elif item.text in ("one from", "one to") and before.value == "plus" and (named := _rooms(out)):
            theirs = named[-1] if item.text == "one from" else named[0]
            out[-1:] = [Item("mark", ".", "."), _again_named(theirs), replace(item, text="reached from", form="")]
        elif room is not None and room.text in ("bed", "beds") and _among_things(items, k):
            out.append(Item("object", "double_bed", item.text, number=2 if room.plural else 1))
        elif item.kind == "only" and before.value == "not":
            continue  # "not just a kitchenette"
        elif item.kind == "front" and before.kind == "conjunction" and _again(out, item):
            continue  # "from the hall and from the lounge"
        elif room is not None and _floats(room) and ahead[0].kind == "front" and ahead[1].room is not None:
            out += [item] if is_mark(before, ",") else []  # "enter the kitchen both from the hall and …"
        elif item.kind == "front" and before.room is not None and _floats(before.room) and ahead[0].room is not None:
            out.append(Item("link", "door", "reached from"))  # "two bathrooms, both from the corridor"
        elif room is not None and room.quantifier == Det.NONE and Trait.ENSUITE in room.labels:
            room.negated, room.quantifier = True, Det.BARE  # "two bathrooms, neither of them en suite"
            out += [Item("negation", "no", item.text), item]
        elif room is not None and before.value == "not" and _contrasted(out, room):
            del out[-2:]  # "a separate kitchen, not a kitchenette"
        elif item.kind == "open" and before.value == "not" and (closed := _closed(out)) is not None:
            closed.labels.add(Trait.SEPARATE)  # "the kitchen is not open"
            out.pop()
        else:
            out.append(item)
    return out


def _furnishes(ahead: list[Item]) -> bool:
    """`…, in every bedroom a desk`: a clause of its own."""
    inside, room, thing = ahead
    return inside.value == "in" and room.room is not None and thing.kind == "object"


def _again(out: list[Item], item: Item) -> bool:
    """Whether the preposition was said of the room before."""
    named = len(out) > 2 and out[-2].room is not None
    return named and (out[-3].text == item.text or (out[-3].text == "reached from" and item.text == "from"))


def _floats(room: RoomPhrase) -> bool:
    return room.type == "" and room.quantifier in FLOATING and room.count is None and not room.labels


def _contrasted(out: list[Item], room: RoomPhrase) -> bool:
    """Whether the room is what another of its type is not, behind a comma."""
    earlier = [i.room for i in out[:-2] if i.room is not None][-1:]
    lone = len(out) > 2 and is_mark(out[-2], ",") and room.quantifier in (Det.A, Det.BARE)
    return lone and bool(earlier) and earlier[0].type == room.type and not earlier[0].negated


def _closed(out: list[Item]) -> RoomPhrase | None:
    """The kitchen that `not open` is said of."""
    said_of = [i for i in out[:-1] if i.kind != "copula"][-1:]
    room = said_of[0].room if said_of else None
    return room if room is not None and room.type == "kitchen" and not room.negated else None


def _ends(items: list[Item], k: int) -> bool:
    return k + 1 >= len(items) or items[k + 1].kind in ("mark", "boundary")


def _said_before(out: list[Item]) -> tuple[int, list[Item]] | None:
    """Where the clause joins that ends `out` with its subject, and what is said of the subject before."""
    at = len(out) - 2
    while at > 0 and not (out[at].kind in ("conjunction", "boundary") or is_mark(out[at], ",.")):
        at -= 1
    start = max((j + 1 for j in range(at) if is_mark(out[j], ".")), default=0)
    verb = next((j for j in range(start, at) if out[j].kind in SAID), at)
    return (at, out[verb:at]) if 0 < verb < at else None


def _lived(out: list[Item]) -> bool:
    """Whether two rooms to live in end `out` that no area was said of."""
    first, joint, second = ([Item("")] * 3 + out)[-3:]
    pair = [i.room for i in (first, second) if i.room is not None and i.value in OPEN_TYPES]
    return len(pair) == 2 and joint.kind == "conjunction" and not any(r.areas or r.plural for r in pair)


def _rooms(out: list[Item]) -> list[RoomPhrase]:
    start = max((j + 1 for j in range(len(out)) if is_mark(out[j], ".")), default=0)
    return [i.room for i in out[start:] if i.room is not None]


def _again_named(room: RoomPhrase) -> Item:
    """A room spoken of once more."""
    return Item("room", room.type, room.text, RoomPhrase(room.type, quantifier=Det.THE, text=room.text))


def _among_things(items: list[Item], k: int) -> bool:
    """The bed of `bed and desk in the main room`."""
    room = items[k].room
    plain = room is not None and room.count is None and room.quantifier == Det.BARE and not room.labels
    j = k + 1
    while j < len(items) and (items[j].kind in ("object", "conjunction") or is_mark(items[j], ",")):
        j += 1
    listed = any(i.kind == "object" for i in items[max(k - 2, 0) : j])
    return plain and listed and j < len(items) and items[j].value == "in"

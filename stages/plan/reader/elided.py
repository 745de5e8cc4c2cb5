"""What a sentence leaves out or says beside the point, written out before relations are looked for."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

ARROWS = ("->", "=>", "→", "⇒")
FLOATING = (Det.BOTH, Det.ALL, Det.EACH)


def written_out(items: list[Item]) -> list[Item]:
    """Each short form in the place of which a longer one of the same meaning stands."""
    out: list[Item] = []
    for k, item in enumerate(items):
        before, ahead = (out[-1] if out else Item("mark", ".")), (items[k + 1 : k + 4] + [Item("")] * 3)[:3]
        room = item.room
        if item.text in ARROWS and ahead[0].kind == "object":
            out.append(Item("with", "has", item.text))  # "bedroom 1 -> double bed"
        elif is_mark(item, ",") and (is_mark(before, ",") or _furnishes(ahead)):
            out += [] if is_mark(before, ",") else [Item("mark", ".", ".")]
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

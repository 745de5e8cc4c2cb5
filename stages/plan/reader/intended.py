"""Whom a room is for, and counts beyond the usual."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def intended(items: list[Item]) -> list[Item]:
    """`a bathroom for the master, one for the other bedrooms`: the first opens off the master bedroom."""
    out: list[Item] = []
    of_baths = False
    k = 0
    while k < len(items):
        phrase = items[k].room
        bath = phrase is not None and phrase.type == "bathroom" and phrase.count in (None, 1)
        one = of_baths and phrase is not None and phrase.type == "" and phrase.count == 1
        user = items[k + 2].room if k + 2 < len(items) and items[k + 1].text == "for" else None
        if _for_guests(phrase, items, k, [i.room for i in out if i.room is not None]):
            phrase.labels.add(Trait.GUEST)  # type: ignore[union-attr]
            out.append(items[k])
            k += 1
            continue
        if phrase is None or not (bath or one) or k + 1 >= len(items) or items[k + 1].text != "for":
            out.append(items[k])
            k += 1
            continue
        lone = user is not None and user.type == "bedroom" and not user.plural and user.count in (None, 1)
        if one or (user is not None and user.type == "bedroom"):
            phrase.type, phrase.text, of_baths = "bathroom", phrase.text or "bathroom", True
            if lone and user is not None:
                phrase.labels |= {Trait.ENSUITE, Trait.OWN}
                user.owned.append(phrase)
            else:
                counted = _counted(phrase, [i.room for i in out if i.room is not None])  # "two baths: one for …"
                phrase.quantifier = (Det.ONE_OF if counted else Det.ANOTHER) if one else phrase.quantifier
                phrase.labels |= {Trait.FAMILY} if user is not None else {Trait.GUEST}
                out.append(items[k])
            k += 2
        else:
            out.append(items[k])
            k += 1
    return out


def _for_guests(one: RoomPhrase | None, items: list[Item], k: int, before: list[RoomPhrase]) -> bool:
    """`two bathrooms (one for guests)`."""
    counted = bool(before) and before[-1].type == "bathroom" and (before[-1].count or 1) > 1
    whom = items[k + 1 : k + 3]
    last = len(whom) == 1 or (len(whom) == 2 and whom[1].kind == "mark")
    return one is not None and one.type == "" and one.count == 1 and counted and last and whom[0].text == "for"


def beyond_usual(items: list[Item], rest: list[RoomPhrase]) -> list[Item]:
    """`one more bathroom than usual`, where the bathrooms are counted: nothing beside those."""
    out: list[Item] = []
    for item in items:
        last = out[-1].room if out else None
        if item.kind != "than":
            out.append(item)
        elif last is not None and last.quantifier == Det.ANOTHER and _counted(last, rest):
            out.pop()
    return out


def _counted(phrase: RoomPhrase, rest: list[RoomPhrase]) -> bool:
    return any(r is not phrase and r.type == phrase.type and (r.count or 0) > 1 for r in rest)

"""How far `no` and `or` reach."""

from apartgen.stages.plan.reader.mention import Item, is_mark, rooms_of
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def negate_links(items: list[Item]) -> list[Item]:
    """`neither the kitchen nor the bathroom opens onto the hall`: of known rooms the link is denied, not the rooms."""
    out = items = _none_does(_instead(_neither_is(_without_contrast(items))))
    for k, item in enumerate(items):
        if item.text != "neither":
            continue
        end = next((j for j in range(k + 1, len(items)) if items[j].kind not in ("room", "conjunction", "negation")), k)
        while end < len(items) and items[end].kind == "copula":
            end += 1
        rooms = [i.room for i in items[k:end] if i.room is not None]
        known = len(rooms) > 1 and all(r.quantifier == Det.THE for r in rooms)
        if known and end < len(items) and items[end].value == "has":
            for room in rooms:
                room.negated = False  # "neither the kitchen nor the bathroom has a window"
            for owned in rooms_of(items[end:])[:1]:
                owned.negated = True
            return [*items[:k], *items[k + 1 :]]
        if len(rooms) == 1 and end < len(items) and items[end].value == "has":
            rooms[0].negated, rooms[0].quantifier = False, Det.BOTH  # "neither bedroom has its own bathroom"
            for owned in rooms_of(items[end:])[:1]:
                owned.negated = True
            return [*items[:k], *items[k + 1 :]]
        if end < len(items) and items[end].kind == "link" and all(r.quantifier == Det.THE for r in rooms):
            for room in rooms:
                room.negated = False
            out = [*items[:k], *items[k + 1 : end], Item("negation", "not", item.text), *items[end:]]
    return out


def _none_does(items: list[Item]) -> list[Item]:
    """`neither of them touches the kitchen`, `none of the bedrooms is next to …`: denied of all of them."""
    out: list[Item] = []
    for k, item in enumerate(items):
        rest = [i for i in items[k + 1 : k + 3] if i.kind != "copula"]
        none = item.room is not None and item.room.quantifier == Det.NONE and item.room.text not in NAMED
        out.append(item)
        if none and item.room is not None and rest and rest[0].kind == "link":
            item.room.quantifier = Det.BOTH if item.text.startswith("neither") else Det.ALL
            out.append(Item("negation", "not", item.text))
    return out


NAMED = ("former", "the former", "latter", "the latter")
INSTEAD = ("instead of", "rather than", "in place of", "statt", "anstatt", "anstelle", "plutot que")
IN_PLACE = ("au lieu", "en lugar", "en vez")


def _instead(items: list[Item]) -> list[Item]:
    """`opens off the bedroom instead of the hall`: that door is denied, not the hall."""
    out: list[Item] = []
    for k, item in enumerate(items):
        again = k + 1 < len(items) and items[k + 1].kind in ("link", "front")  # "off the hall rather than off …"
        room = items[k + 1 + again].room if k + 1 + again < len(items) else None
        told = item.kind == "negation" and item.text.startswith((*INSTEAD, *IN_PLACE))
        linked = any(i.kind in ("link", "front") for i in items[max(k - 3, 0) : k])
        if told and linked and room is not None and out and out[-1].room is not None:
            room.negated = False
            out += [Item("conjunction", "and", "and"), Item("negation", "not", item.text)]
        else:
            out.append(item)
    return out


def _neither_is(items: list[Item]) -> list[Item]:
    """`neither is the study`, behind what another room is not: the same is said of the study."""
    for k, item in enumerate(items[:-2]):
        room, end = items[k + 2].room, items[k + 3] if k + 3 < len(items) else Item("mark", ".")
        copula = items[k + 1].kind == "copula" and item.kind == "negation"
        if item.text in ("neither", "nor") and copula and room is not None and end.kind in ("mark", "conjunction"):
            room.negated = False
            return [*items[:k], Item("link", "same", item.text), *items[k + 2 :]]
    return items


def _without_contrast(items: list[Item]) -> list[Item]:
    """`the lounge, not the hallway, leads to …`: the verb is said of the lounge alone."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        aside = [i.kind for i in items[k : k + 4]] == ["mark", "negation", "room", "mark"]
        verb = items[k + 4].kind if k + 4 < len(items) else ""
        if aside and items[k + 1].value == "not" and verb in ("link", "with", "copula"):
            k += 4
        else:
            out.append(items[k])
            k += 1
    return out


def spread_negation(items: list[Item]) -> None:
    """`no study or balcony`, `without a dining room and balcony`."""
    word, scope, alike = "", False, Det.BARE
    for k, item in enumerate(items):
        if item.kind == "negation":
            word, scope = item.value, item.text == "neither"
        elif item.kind == "object":
            continue
        elif item.room is not None:
            phrase = item.room
            joint = items[k - 1].value if k and items[k - 1].kind == "conjunction" else ""
            plain = (
                phrase.count is None and phrase.quantifier in (Det.BARE, Det.A) and not phrase.labels & {Trait.SEPARATE}
            )
            told = k > 1 and phrase.quantifier == Det.THE and joint in ("and", "or") and phrase.count is None
            other = items[k - 2].room if told else None
            told = other is not None and other.quantifier == Det.THE
            if told and scope and word == "without" and (k + 1 == len(items) or items[k + 1].kind == "mark"):
                phrase.negated = True  # "skip the balcony and the study"
            if scope and plain and not phrase.negated:
                listed = bool(k) and is_mark(items[k - 1], ",") and phrase.quantifier in (Det.BARE, alike)
                denied = word == "without" or phrase.quantifier == Det.BARE
                phrase.negated = joint == "or" or (joint == "and" and denied) or (listed and _closes_with_or(items[k:]))
            if phrase.negated:
                alike = phrase.quantifier
            scope = phrase.negated
            if scope and k + 1 < len(items) and items[k + 1].kind in ("link", "front", "with", "relative"):
                phrase.labels.add(Trait.PLACED)  # "no bathroom off the hallway": not there, but maybe elsewhere
        elif item.kind not in ("conjunction",) and not is_mark(item, ","):
            scope = False


def drop_alternatives(items: list[Item], said: Said) -> list[Item]:
    """`two bedrooms or three bedrooms`: the first is taken, the other reported."""
    out: list[Item] = []
    for item in items:
        phrase, last = item.room, out[-2].room if len(out) > 1 else None
        if phrase and last and phrase.count and last.count and phrase.type == last.type and out[-1].value == "or":
            out.pop()
            said.unread.append(f"or {phrase.count:g} {phrase.text}")
        else:
            out.append(item)
    return out


def _closes_with_or(items: list[Item]) -> bool:
    """Whether this list ends in `or`: `no study, balcony or dining room`."""
    for item in items:
        if item.kind == "conjunction":
            return item.value == "or"
        if item.room is None and not is_mark(item, ","):
            return False
    return False

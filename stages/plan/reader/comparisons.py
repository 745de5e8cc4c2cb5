"""Which rooms are compared: `A is twice as large as B`, `bedrooms of equal size`."""

from apartgen.stages.plan.reader.clausal import again_named
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.vocabulary import Det, Relation

BARE = ("large", "larger", "big", "bigger", "smaller", "the size")
"""How comparisons end that have no object."""


def compared_again(items: list[Item], before: list[RoomPhrase]) -> list[Item]:
    """`The study is next to the kitchen. It should be larger than the bathroom.`: the study of the sentence before."""
    told = [i.kind for i in items if i.kind != "copula"][:2] == ["pronoun", "compare"] and items[0].value == "it"
    one = before[-1] if before else None
    fits = told and one is not None and bool(one.type) and not one.headline and not one.negated
    return [again_named(one), *items[1:]] if fits and one is not None else items


def summed(items: list[Item]) -> None:
    """Marks the rooms of `as large as both bedrooms together`, `larger than the kitchen and the bath together`."""
    for k in (k for k, item in enumerate(items) if item.kind == "sum"):
        at = k - 1
        while at > 0 and (items[at].room is not None or items[at].kind == "conjunction" or is_mark(items[at], ",")):
            at -= 1
        several = rooms_of(items[at + 1 : k])
        if at >= 0 and items[at].kind == "compare" and not any(i.kind == "area" for i in items[k + 1 : k + 2]):
            for room in several:
                room.together = True


def comparisons(items: list[Item]) -> tuple[list[Item], list[Statement]]:
    """`A is twice as large as B`, `bedrooms of equal size`."""
    out: list[Item] = []
    found: list[Statement] = []
    asides: list[Item] = []
    skip = False
    for k, item in enumerate(items):
        if item.kind != "compare":
            if not skip or item.room is None:
                out.append(item)
            skip = skip and item.room is None
            continue
        before = rooms_of(out)
        after = rooms_of(items[k + 1 :])
        if item.text.startswith("each ") and before and (before[-1].count or 1) > 1:
            steps = _steps(before[-1], item.number)
            found += steps
            asides += [Item("room", r.type, r.text, r) for s in steps for r in (*s.left, *s.right)]
        elif item.number == -1 and before:
            clause = _clause(out)
            found.append(Statement(Relation.EQUAL, clause, clause))
        elif before and after and not (_of_the_last(item) and len(before) > 1):
            if after[0].quantifier == Det.A:
                after[0].quantifier = Det.THE  # "three times as large as a bedroom" asks for no further one
            again = found[-1:] and found[-1].right == before[-1:] and found[-1].kind == Relation.COMPARE
            again = again and not any(
                i.kind == "relative" for i in out[-2:]
            )  # "than the kitchen, which is larger than"
            left = found[-1].left if again else before[-1:]  # "smaller than the lounge but larger than the bath"
            all_of_them = [r for r in after if r.together] if after[0].together else after[:1]
            found.append(Statement(Relation.COMPARE, left, all_of_them, item.number, _limit(item)))
            other = Item("room", after[0].type, after[0].text, after[0])
            aside = any(i.kind == "relative" for i in out[-2:])  # "the lounge, which is larger than the bedroom"
            asides += [Item("boundary", "while"), other] if aside else []
            out += [] if aside else [other]
            skip = True
        elif len(before) > 1:  # "a lounge of 20 m² and a bedroom two thirds its size"
            found.append(Statement(Relation.COMPARE, before[-1:], before[-2:-1], item.number, _limit(item)))
    return out + asides, found


def _limit(item: Item) -> str:
    """Which way `at least twice as large as` goes."""
    return item.bounds[0][0] if item.bounds else ""


def _of_the_last(item: Item) -> bool:
    """`the lounge half that size`, `the lounge is twice as large`: as the room named before it."""
    return " that " in f"{item.text} " or item.text.endswith(BARE)


def _steps(rooms: RoomPhrase, number: float) -> list[Statement]:
    """`three bedrooms, each smaller than the one before`: the second than the first, the third than the second."""
    count = range(1, int(rooms.count or 1) + 1)
    line = [RoomPhrase(rooms.type, quantifier=Det.THE, ordinals=(n,), text=rooms.text) for n in count]
    return [Statement(Relation.COMPARE, [b], [a], number) for a, b in zip(line, line[1:], strict=False)]


def _clause(items: list[Item]) -> list[RoomPhrase]:
    """Rooms of the last coordination."""
    out: list[RoomPhrase] = []
    for item in reversed(items):
        if item.room is not None:
            out.append(item.room)
        elif item.kind not in ("conjunction", "copula") and not is_mark(item, ",") and (out or item.value != "has"):
            break
        if (room := item.room) is not None and (room.plural or (room.count or 1) > 1 or room.quantifier == Det.BOTH):
            break  # "three bedrooms, the two children's rooms of the same size"
    return out[::-1]

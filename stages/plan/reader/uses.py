"""One room said twice: what it also serves as, what it is, and people who are no rooms."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.statements import Asked, Said
from apartgen.stages.plan.reader.vocabulary import Det, Trait

WHOSE = {Trait.GUEST, Trait.KIDS, Trait.RELATIVE, Trait.MASTER}
"""Traits of a bedroom that say who sleeps there."""


def uses(items: list[Item], said: Said) -> list[Item]:
    """`a bedroom that serves as study`: one room with two uses; the second becomes a requirement."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        rooms = [i.room for i in out if i.room is not None]
        room = rooms[-1] if rooms else None
        if items[k].kind == "use":
            while out and (out[-1].kind in ("relative", "copula") or out[-1].text == "and"):
                out.pop()  # "which is also used as"
            end = _listed(items, k + 1)
            _used(room, items[k:end], said)
            k = end
        elif _either(items, k):
            _used(items[k + 2].room, [Item("use", "", "/"), items[k]], said)
            k += 2
        elif _is_a(items, k, [r for r in rooms if r.type]) or _is_whose(items, k):
            out = [*out, items[k]]
            _same(items[k].room, items[k + 2].room)
            k += 3
        else:
            out.append(items[k])
            k += 1
    return out


def _listed(items: list[Item], k: int) -> int:
    """End of the rooms without numbers of their own that are joined by `and` from `k` on."""
    end = k
    while k < len(items) and items[k].room is not None and not items[k].room.plural:  # type: ignore[union-attr]
        end = k + 1
        k += 2 if end < len(items) and items[end].kind == "conjunction" else len(items)
    return end


def _used(room: RoomPhrase | None, items: list[Item], said: Said) -> None:
    others = [i.room for i in items if i.room is not None]
    if room is None or not others:
        said.unread.append(items[0].text)
    for other in others if room is not None else []:
        assert room is not None
        room.labels |= other.labels & {Trait.GUEST, Trait.KIDS} if other.type == room.type or not room.type else set()
        said.asked.append(Asked("use", [room], "", other.type, f"{room.text} {items[0].text} {other.text}"))


def _either(items: list[Item], k: int) -> bool:
    """`study/bedroom two` is one room."""
    kinds = [i.room.type if i.room is not None else i.value for i in items[k : k + 3]]
    return kinds == ["study", "/", "bedroom"]


def _is_a(items: list[Item], k: int, before: list[RoomPhrase]) -> bool:
    """`the third is a guest room`, of rooms counted before."""
    if k + 2 >= len(items) or items[k].room is None or items[k + 1].kind != "copula" or not before:
        return False
    one, same = items[k].room, items[k + 2].room
    assert one is not None
    alike = same is not None and same.quantifier == Det.A and same.type == before[-1].type and not same.plural
    named = same is not None and one.type in ("", same.type) and not one.labels  # "one bathroom should be an ensuite"
    told = bool(one.ordinals) or one.count == 1 or one.quantifier in (Det.OTHER, Det.ONE_OF)
    the_one = one.type == "bathroom" and one.quantifier == Det.THE  # "the bathroom is an ensuite"
    return named and (the_one or ((one.type == "" or one.count == 1) and told)) and alike


def _is_whose(items: list[Item], k: int) -> bool:
    """`the other bedroom is the guest room`, `bedroom 2 = kids' room`: told from others twice."""
    one, same = items[k].room, items[k + 2].room if k + 2 < len(items) else None
    if one is None or same is None or not (items[k + 1].kind == "copula" or is_mark(items[k + 1], ":")):
        return False
    told = bool(one.ordinals or one.rank or one.labels) or one.quantifier in (Det.OTHER, Det.ONE_OF)
    whose = bool(same.labels & WHOSE) and same.count is None and not same.ordinals
    alike = one.type == same.type == "bedroom" and one.plural == same.plural
    return told and whose and alike and one.labels <= {Trait.SIZED}


def _same(one: RoomPhrase | None, same: RoomPhrase | None) -> None:
    """What is said of `same` is said of `one`."""
    assert one is not None and same is not None
    one.labels |= same.labels
    one.areas, one.sides = one.areas or same.areas, one.sides or same.sides
    one.owned, one.objects = [*one.owned, *same.owned], [*one.objects, *same.objects]


def sharers(items: list[Item]) -> list[Item]:
    """`our twins share one`: people who are no rooms share; nothing is said of doors."""
    out: list[Item] = []
    rooms: list[RoomPhrase] = []
    for k, item in enumerate(items):
        following = items[k + 1].room if k + 1 < len(items) else None
        one = following is not None and following.type == "" and following.count == 1
        if item.value == "share" and not rooms and one:
            assert following is not None
            following.quantifier = Det.THE
            continue
        rooms += [item.room] if item.room is not None else []
        out.append(item)
    return out


def for_whom(items: list[Item], before: list[Item]) -> None:
    """`two bedrooms for the children, one for us`: a third, for the two have somebody already."""
    whole = [*before, *items]
    for k, item in enumerate(items, len(before)):
        one = item.room
        if one is None or one.type != "" or one.count is None or not _for(whole, k) or one.quantifier:
            continue
        counted = next((j for j in range(k - 1, -1, -1) if (r := whole[j].room) is not None and r.type), None)
        last = whole[counted].room if counted is not None else None
        if counted is not None and last is not None and last.type == "bedroom" and _for(whole, counted):
            one.type, one.quantifier, one.another = last.type, Det.ANOTHER, True


def _for(items: list[Item], k: int) -> bool:
    following = [i for i in items[k + 1 : k + 3] if i.kind != "copula"]
    return bool(following) and following[0].kind == "with" and following[0].text == "for"

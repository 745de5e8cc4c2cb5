"""Which room is the largest or the smallest: `the living room should be the largest room`."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import Item, RoomPhrase
from apartgen.stages.plan.reader.statements import Asked, Said
from apartgen.stages.plan.reader.vocabulary import Det, Trait

LARGEST = ("largest", "biggest", "greatest", "plus grande", "plus grand", "grosste", "grosster", "mas grande", "最大")
SMALLEST = ("smallest", "tiniest", "plus petite", "plus petit", "kleinste", "kleinster", "mas pequena", "最小")
BETWEEN = ("copula", "relative", "area_word", "with")
"""What may stand between `the largest room` and its area."""


def extreme(texts: list[str]) -> str:
    """`largest` or `smallest`, as a noun's modifiers say; else ""."""
    return "largest" if set(texts) & set(LARGEST) else "smallest" if set(texts) & set(SMALLEST) else ""


def orders(items: list[Item], said: Said) -> list[Item]:
    """Adds which room is to be the largest or the smallest; `the largest room: 25 m²` speaks of the living room."""
    out: list[Item] = []
    skip = 0
    for k, item in enumerate(items):
        if skip:
            skip -= 1
        elif _than_all(items, k) and (last := _before(out)) is not None:
            most = "largest" if item.number > 1 else "smallest"
            said.asked.append(Asked("order", [last], "", most, f"{last.text} {item.text} all others"))
            skip = 1
        elif (end := _is_most(items, k)) > k:
            said.asked.append(_most(items[k].room, items[k + 2].room))
            out.append(item)
            skip = end - k - 1
        elif _gapped(items, k):
            # "the lounge is the largest room and the bath the smallest"
            wish = _most(items[k].room, items[k + 1].room)
            of_all = any(i.kind == "extreme" for i in items[max(k - 3, 0) : k])
            value = {"larger": "largest", "smaller": "smallest"}.get(wish.value, wish.value)
            said.asked.append(replace(wish, to="", value=value) if of_all else wish)
            out.append(item)
            skip = 1
        elif item.kind != "extreme":
            out.append(item)
        elif (last := _before(out)) is not None:
            plainly = Asked("order", [last], "", item.value, f"{last.text} {item.text}")
            said.asked.append(_of_counted(last, out, item) or plainly)
        elif (ahead := _after(items, k)) is not None:
            said.asked.append(Asked("order", [ahead], "", item.value, f"{item.text} {ahead.text}"))
            skip = 1  # the copula
        elif item.value == "largest" and _has_area(items, k):
            living = RoomPhrase("living_room", quantifier=Det.THE, text=item.text)
            out.append(Item("room", living.type, living.text, living))
        else:
            said.unread.append(item.text)
    return out


def _gapped(items: list[Item], k: int) -> bool:
    """`all rooms at least 8 m² and the living room the biggest`."""
    room, most = items[k].room, items[k + 1].room if k + 1 < len(items) else None
    ends = k + 2 >= len(items) or items[k + 2].kind in ("mark", "conjunction")
    named = room is not None and room.type not in ("", "any") and room.quantifier == Det.THE and not room.plural
    return named and ends and most is not None and most.type == "" and most.labels == {Trait.SIZED}


def _is_most(items: list[Item], k: int) -> int:
    """Where `the main bedroom is the largest of the bedrooms` ends that begins at `k`; `k` where it does not."""
    room, most = (items[k].room, items[k + 2].room) if k + 2 < len(items) else (None, None)
    if room is None or most is None or not room.type or items[k + 1].kind != "copula":
        return k
    named = most.type == room.type and most.text.split()[:1] and extreme(most.text.split()[:1])
    if not named and (most.type or Trait.SIZED not in most.labels):
        return k
    group = items[k + 3].room if k + 3 < len(items) else None
    return k + 3 + (group is not None and group.plural and group.type in ("", room.type, "any"))


def _most(room: RoomPhrase | None, most: RoomPhrase | None) -> Asked:
    """A room beside all others of its type; a living room beside all rooms."""
    assert room is not None and most is not None
    small = most.factor < 1 or extreme(most.text.split()[:1]) == "smallest"
    text = f"{room.text} is the {'smallest' if small else 'largest'}"
    if room.type not in ("bedroom", "bathroom"):
        return Asked("order", [room], "", "smallest" if small else "largest", text)
    others = RoomPhrase(room.type, quantifier=Det.OTHER, plural=True, text="others")
    return Asked("order", [room], [others], "smaller" if small else "larger", text)


def _of_counted(one: RoomPhrase, out: list[Item], item: Item) -> Asked | None:
    """The first of `three bedrooms: the first is the largest`, beside the others that were counted."""
    counted = [i.room.type for i in out if i.room is not None and i.room.type and (i.room.count or 1) > 1][-1:]
    if one.type or not (one.ordinals or one.count == 1) or counted not in (["bedroom"], ["bathroom"]):
        return None
    others = RoomPhrase(counted[0], quantifier=Det.OTHER, plural=True, text="others")
    value = "larger" if item.value == "largest" else "smaller"
    return Asked("order", [one], [others], value, f"{one.text} {item.text}")


def _than_all(items: list[Item], k: int) -> bool:
    """`larger than all other rooms`."""
    others = items[k + 1].room if k + 1 < len(items) else None
    return items[k].kind == "compare" and others is not None and (others.type, others.quantifier) == ("any", Det.OTHER)


def _before(out: list[Item]) -> RoomPhrase | None:
    """The room of `X is the largest room`; takes the copula away."""
    said = len(out)
    while said and (out[said - 1].kind in ("copula", "relative", "area") or out[said - 1].value == "to"):
        said -= 1  # "is", "to be", "of 30 m², which is"
    last = out[said - 1].room if said else None
    if last is not None:
        out[said:] = [i for i in out[said:] if i.kind == "area"]
    return last


def _after(items: list[Item], k: int) -> RoomPhrase | None:
    copula = k + 2 < len(items) and items[k + 1].kind == "copula"
    return items[k + 2].room if copula else None


def _has_area(items: list[Item], k: int) -> bool:
    rest = [i.kind for i in items[k + 1 : k + 4] if i.kind not in BETWEEN]
    return rest[:1] == ["area"]

"""Whether a text names all rooms that there are to be: `just a kitchen`, `two bedrooms and a bath, nothing else`."""

from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, is_mark, rooms_of
from apartgen.stages.plan.reader.vocabulary import Det


def furnished(before: list[Item]) -> bool:
    """Whether what stands before says what furniture there is: `a bed in the main room, nothing else`."""
    start = max((j + 1 for j, i in enumerate(before) if is_mark(i, ".")), default=0)
    return any(i.kind == "object" for i in before[start:])


def sleeps_only(before: list[Item]) -> bool:
    """Whether `that's all` ends but bedrooms and bathrooms, beside which every home has more: so much is asked for."""
    end = len(before) - (is_mark(before[-1], ".") if before else 0)  # "Two bedrooms, one bathroom. That's all."
    start = max((j + 1 for j in range(end) if is_mark(before[j], ".")), default=0)
    rooms = rooms_of(before[start:end])
    return bool(rooms) and all(r.type in ("bedroom", "bathroom") and r.quantifier == Det.BARE for r in rooms)


def names_all(items: list[Item], k: int) -> bool:
    """Whether no room but those behind the `only` at `k` is named: `just a kitchen`, of no home."""
    rooms = rooms_of(items)
    lone = len(rooms) == 1 and rooms[0].quantifier == Det.A and rooms[0].type in (*OPEN_TYPES, "bathroom")
    return not rooms_of(items[:k]) and (_lists_home(items[k:]) or (lone and all(i.kind != "dwelling" for i in items)))


def _lists_home(after: list[Item]) -> bool:
    """Whether `only`, `just`, `exactly` is said of a whole list of rooms rather than of one."""
    run = 0
    for item in after[1:]:
        listed = item.kind in ("room", "conjunction", "mark", "with", "size", "label", "area")
        if not listed or is_mark(item, ".") or (run and item.value == "has"):
            break
        run += item.room is not None
    return run >= 2

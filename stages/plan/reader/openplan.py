"""Rooms that share one space: `kitchen/living room`, `open-plan kitchen, dining and living`."""

from apartgen.stages.plan.reader.measures import split_area
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.vocabulary import Det, Relation, Trait


def open_groups(items: list[Item]) -> tuple[list[Item], list[Statement]]:
    """Open-plan rooms: `kitchen/living room`, `open-plan kitchen, dining and living`, `lounge-diner`."""
    out: list[Statement] = []
    kept: list[Item] = []
    i = 0
    while i < len(items):
        end = _run(items, i)
        group = rooms_of(items[i:end])
        tight = any(
            x.room and (x.joined or not x.room.quantifier) and items[k].room or is_mark(x, "/")
            for k, x in enumerate(items[i + 1 : end], i)
        )
        within = end < len(items) and (items[end].kind == "copula" or items[end].value == "in" or _all_one(items, end))
        told = len(group) == 1 and _told(items, i, end)
        closing = end + ((within and len(group) > 1) or told)
        after = closing < len(items) and (items[closing].kind == "open" or (closing > end and _in_one(items, closing)))
        _one_space(items, i)
        if len(group) == 1 and after:
            group[0].labels.add(Trait.OPEN)
        if len(group) > 1 and (tight or after or Trait.OPEN in group[0].labels):
            out += chain(group)
            _share_area(group)
            for phrase in group:
                phrase.labels.discard(Trait.OPEN)
        kept += items[i : end + 1] if not after else items[i:end]
        i = (closing if after else end) + 1
        i += told and i < len(items) and is_mark(items[i], ")")
    return kept, out


def _told(items: list[Item], i: int, k: int) -> bool:
    """`kitchen: open plan`, `kitchen (open plan)`, `the kitchen is open plan` of the one room at `i`."""
    verb = k < len(items) and items[k].kind == "copula" and not (i and items[i - 1].kind == "conjunction")
    said = k + 1 < len(items) and (is_mark(items[k], ":(-") or verb)
    return said and items[k + 1].kind == "open"


def _in_one(items: list[Item], k: int) -> bool:
    """`kitchen and living room in one`."""
    one, ends = items[k].room, k + 1 == len(items) or items[k + 1].kind in ("mark", "conjunction", "boundary")
    return one is not None and one.type == "" and one.text == "one" and ends


def _all_one(items: list[Item], k: int) -> bool:
    """`a living room, a dining room and a kitchen, all in one`."""
    comma, one = (items[k : k + 2] + [Item("")] * 2)[:2]
    return is_mark(comma, ",") and one.kind == "open" and one.text.startswith("all ")


def _one_space(items: list[Item], i: int) -> None:
    """`one open space for living, dining and cooking`."""
    ahead = items[i + 2].room if i + 2 < len(items) and items[i + 1].kind == "with" else None
    if items[i].kind == "open" and ahead is not None and ahead.type in OPEN_TYPES:
        ahead.labels.add(Trait.OPEN)


def _share_area(group: list[RoomPhrase]) -> None:
    """`living/kitchen (30 m²)`: an area far above its own room's is that of the whole group."""
    given = [r for r in group if len(r.areas) == 1]
    if len(given) == 1 and given[0].areas[0] > 1.3 * sense()["area"][given[0].type]:
        split_area(group, given[0].areas[0])


def _run(items: list[Item], i: int) -> int:
    """End of the run of open-plan candidates that starts at `i`."""
    if items[i].room is None or items[i].value not in OPEN_TYPES:
        return i + (0 if items[i].room is None else 1)
    first, end, j = items[i], i + 1, i + 1
    assert first.room is not None
    seen = {first.value}
    tight_only = Trait.OPEN not in first.room.labels and not _ends_open(items, i)
    while j < len(items):
        item = items[j]
        separated = _separator(item)
        if (
            item.room is not None
            and item.value in OPEN_TYPES
            and item.value not in seen
            and not item.room.negated
            and Trait.SEPARATE not in item.room.labels
        ):
            linked = item.joined or is_mark(items[j - 1], "/") or (items[j - 1].room is not None and _separates(items))
            listed = (
                not is_mark(items[j - 1], ",")
                or any(x.kind == "conjunction" for x in items[j + 1 : j + 3])
                or len(seen) > 1
                or any(x.value in OPEN_TYPES for x in items[j + 2 : j + 3])
            )
            if (tight_only and not linked and not _open_after(items, j)) or item.room.quantifier == Det.A or not listed:
                break
            seen.add(item.value)
            end = j + 1
            if items[j - 1].kind == "conjunction" and len(seen) > 1:
                break
        elif not separated:
            break
        j += 1
    return end


def _separates(items: list[Item]) -> bool:
    """Whether the writer puts marks between rooms, so that two without one belong together (`salón comedor`)."""
    return (
        any(is_mark(i, ",/") or i.kind == "conjunction" for i in items) or sum(i.room is not None for i in items) == 2
    )


def _ends_open(items: list[Item], i: int) -> bool:
    """`living room, dining room and kitchen are one open space`."""
    j = i
    while j < len(items) and (
        items[j].value in OPEN_TYPES or items[j].kind == "conjunction" or is_mark(items[j], ",/")
    ):
        j += 1
    return j > i + 1 and _open_after(items, j - 1)


def _separator(item: Item) -> bool:
    return item.kind == "conjunction" or is_mark(item, ",/")


def _open_after(items: list[Item], j: int) -> bool:
    kinds = [i.kind for i in items[j + 1 : j + 3]]
    if kinds == ["with", "room"] and items[j + 1].value == "in" and _in_one(items, j + 2):
        return True
    within = kinds == ["with", "open"] and items[j + 1].value == "in"  # "living and kitchen in one open space"
    within = within or _all_one(items, j + 1)
    return kinds[:1] == ["open"] or kinds == ["copula", "open"] or within


def chain(group: list[RoomPhrase]) -> list[Statement]:
    """Open links along kitchen - dining - living, the order in which food travels."""
    order = ["kitchen", "dining_room", "living_room"]
    line = sorted(group, key=lambda r: order.index(r.type) if r.type in order else 3)
    return [Statement(Relation.OPEN, [a], [b]) for a, b in zip(line, line[1:], strict=False)]

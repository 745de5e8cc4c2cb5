"""Rooms that areas are said of behind remarks: in commas, or whose home it is."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.vocabulary import Det

REMARKS = ("relative", "link", "label", "size", "adjective", "side", "place")
"""What a remark in commas begins with."""
VERBS = ("copula", "with", "compare", "only", "reach", "area_word")
"""What stands between such a remark and an area."""


def of_that_home(items: list[Item]) -> list[Item]:
    """The bathroom of `the bathroom of my flat is small, only 4 m²`, of which the rest is said."""
    homes = [k for k, i in enumerate(items) if i.kind == "dwelling" and _in_home(items, k)]
    inside = [k - 1 for k in homes if items[k - 1].value == "in"]
    return [i for k, i in enumerate(items) if k not in homes and k not in inside]


def _in_home(items: list[Item], k: int) -> bool:
    """Whether the home at `k` only says whose the room before it is."""
    before = [i for i in items[max(k - 2, 0) : k] if i.value != "in"]
    room, after = before[-1].room if before else None, items[k + 1 : k + 2]
    alone = room is not None and not room.headline and room.count is None and room.quantifier in (Det.THE, Det.BARE)
    return alone and any(i.kind == "copula" or i.value == "has" for i in after)


def _before_relative(before: list[Item], verb: int) -> RoomPhrase | None:
    """The bathroom of `the bathroom which is next to the kitchen has 6 m²`, with one comma or none."""
    which = next((n for n in range(verb - 1, 0, -1) if before[n].kind == "relative"), 0)
    told = any(i.kind == "copula" or i.value == "has" for i in before[verb:])
    if not which or not told or any(is_mark(i, ".;:") for i in before[which:verb]):
        return None
    room = before[which - 1 - is_mark(before[which - 1], ",")].room
    return room if room is not None and not room.areas and not room.headline else None


def behind_remark(before: list[Item], area: Item) -> RoomPhrase | None:
    """The kitchen of `the kitchen, which is open to the living room, has 12 m²`."""
    verb = next((n + 1 for n in range(len(before) - 1, 1, -1) if before[n].kind not in VERBS), 0)
    if not verb or area.kind != "area" or area.value:
        return None
    if (room := _before_relative(before, verb)) is not None or not is_mark(before[verb - 1], ","):
        return room
    start = max((n + 1 for n in range(verb) if before[n].kind == "boundary" or is_mark(before[n], ".:")), default=0)
    head, comma, *clause = before[start : verb - 1] + [Item("")] * 3
    remark = clause[clause[0].kind == "copula"]  # "la cuisine, qui est ouverte sur le salon, fait 12 m²"
    ends = before[verb - 2].kind in ("copula", "link")  # "die Küche, die zum Wohnzimmer offen ist, hat 12 m²"
    room = head.room if is_mark(comma, ",") and (remark.kind in REMARKS or ends) else None
    if room is None or room.areas or room.headline or any(is_mark(i, ",") for i in before[start + 2 : verb - 1]):
        return None
    told = any(i.kind == "copula" or i.value == "has" for i in before[verb:])
    return room if told or area.values[0] <= 2.2 * sense()["area"].get(room.type, 12.0) else None


def small_home(before: list[Item]) -> bool:
    """Whether a home of at most one bedroom has been told of, and no area: `one-bedroom flat, open kitchen, 40 m²`."""
    told = rooms_of(before)
    beds = [r for r in told if r.type == "bedroom"]
    home = any(i.kind == "dwelling" for i in before) and not any(r.areas or r.factor != 1.0 for r in told)
    return home and len(beds) < 2 and all((r.count or 1) == 1 and not r.plural for r in beds)

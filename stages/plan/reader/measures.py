"""Areas, shares and comparisons, given to the rooms they speak of."""

from apartgen.stages.plan.reader.differences import by_difference, differs
from apartgen.stages.plan.reader.enumerated import known_list, subjects_listed
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.remarks import behind_remark, small_home
from apartgen.stages.plan.reader.resized import SMALLEST
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Asked, Said
from apartgen.stages.plan.reader.vocabulary import Det, Trait

LARGE = 40.0
"""Area, m², that no room has of which several are alike."""
LEAST = 4.0
"""Area, m², that a home has for each kind of room that it has, at the least."""
MOST = 1000.0
"""Greatest area, m², that may be the flat's where it stands with a room."""


def mark_headlines(items: list[Item], said: Said) -> None:
    """`80 m² two-bedroom, two-bath flat`: counts before the dwelling are totals, the area is the flat's."""
    for k, item in enumerate(items):
        phrase = item.room
        if phrase is not None and phrase.count is not None and _totals(items, k):
            phrase.headline = True
        if phrase is not None and _on_top(items, k):
            phrase.quantifier = Det.ANOTHER
        if item.kind != "dwelling" or said.dwelling:
            continue
        j = k - 1
        while j >= 0 and (
            items[j].room is not None or is_mark(items[j], "/,-") or items[j].kind in ("conjunction", "style")
        ):
            phrase = items[j].room
            if phrase is not None:
                if phrase.count is None and not phrase.headline and not item.joined and j != k - 1:
                    break
                phrase.headline = phrase.count is not None
                if phrase.areas:
                    said.total_area, phrase.areas = phrase.areas[0], ()
                if phrase.headline:
                    said.flat_size, phrase.factor = said.flat_size * phrase.factor, 1.0
            j -= 1


def _on_top(items: list[Item], k: int) -> bool:
    """`3BHK + servant room`: a bedroom beside those counted."""
    phrase = items[k].room
    if phrase is None or k == 0 or items[k - 1].text not in ("+", "plus"):
        return False
    counted = any(r.type == "bedroom" and r.count is not None for r in rooms_of(items[:k]))
    return (
        counted
        and phrase.count in (None, 1)
        and phrase.type == "bedroom"
        and Trait.MASTER not in phrase.labels
        and phrase.quantifier in (Det.BARE, Det.A)
    )


def _totals(items: list[Item], k: int) -> bool:
    """`piso de dos dormitorios`, `three bedrooms in total`, `a flat with two bedrooms` and nothing else."""
    before, after = items[max(k - 1, 0)], items[k + 1 : k + 2]
    alone = k > 1 and k + 1 == len(items) and [i.kind for i in items[k - 2 : k]] == ["dwelling", "with"]
    alone = alone and not any(room.areas or room.labels or room.type != "bedroom" for room in rooms_of(items))
    return (
        alone
        or (k > 0 and before.kind == "dwelling")
        or any(i.kind == "area_word" and i.value == "total" for i in after)
    )


def attach_areas(items: list[Item], said: Said) -> list[Item]:
    """Give every area or share to the room it speaks of, else to the flat."""
    out: list[Item] = []
    for k, item in enumerate(items):
        phrase = item.room
        if (
            phrase is not None
            and phrase.areas
            and (phrase.headline or max(5 * sense()["area"].get(phrase.type, 12.0), SMALLEST) < phrase.areas[0] <= MOST)
        ):
            said.total_area, phrase.areas = phrase.areas[0], ()
            said.asked += [Asked(kind, [], "", f"{limit:g}", item.text) for kind, limit in phrase.bounds]
            phrase.bounds = ()
        if item.kind == "fraction":
            item = Item("share", "", item.text, values=item.values)
        if item.kind not in ("area", "share"):
            out.append(item)
            continue
        if (more := differs(out, items, k)) is not None:
            said.unread += [] if by_difference(out, items, k, said.rooms) else [item.text]
            if more.kind == "size":
                items[k + 1] = Item("stop", "", more.text)
            continue
        if item.kind == "area" and k and _of_rooms(items[k - 1], item):
            said.main_area = item.values[0]
            continue
        owners = _corrected(items, k)
        if not owners:
            owners = [] if item.value == "total" or _total_near(items, k) else _owners(out, items, k)
            owners = [] if owners and said.total_area is None and _of_all(out, item) else owners
        if not owners and item.kind == "area":
            _of_home(item, said)
        elif not owners:
            said.unread.append(item.text)
        together = any(i.kind == "sum" for i in items[max(k - 3, 0) : k + 2])
        if together and owners and (len(owners) > 1 or not owners[0].plural or len(_coordinated(out, owners[0])) > 1):
            owners = owners if len(owners) > 1 else _coordinated(out, owners[0])
            split_area(owners, item.values[0]) if item.kind == "area" else _split_share(owners, item.values[0])
            if item.kind == "share":
                continue
        if len(item.values) > 1 and len(owners) == 1 and not owners[0].plural:
            listed = _coordinated(out, owners[0])  # "kitchen and living room 10 and 26 m²"
            if len(listed) == len(item.values) and item.kind == "area":
                for owner, value in zip(listed, item.values, strict=True):
                    owner.areas = owner.areas or (value,)
                continue
        for owner in owners:
            most_of_it = item.kind == "share" and item.values[0] * (owner.count or 1) > 0.9
            owner.together = (together and len(owners) == 1) or most_of_it
            if item.kind == "area":
                owner.sides = owner.sides if owner.areas else item.sides
                owner.bounds = owner.bounds if owner.areas else item.bounds
                owner.areas = owner.areas or item.values
            else:
                owner.share = item.values[0]
    return [i for i in out if i.kind not in ("area_word", "sum")]


def _of_home(item: Item, said: Said) -> None:
    """The first area that no room takes is the flat's, others are not understood, nor sides that no home has."""
    if item.sides and item.values[0] < max(SMALLEST, LEAST * len({room.type for room in said.rooms})):
        said.unread.append(item.text)
        return
    if item.sides:
        said.asked.append(Asked("dimension", [], "", f"{item.sides[0]:g} x {item.sides[1]:g}", item.text))
    said.asked += [Asked(kind, [], "", f"{limit:g}", item.text) for kind, limit in item.bounds]
    said.unread += [f"{more:g} m²" for more in item.values[1:]]
    if said.total_area is None:
        said.total_area = item.values[0]
    elif abs(said.total_area - item.values[0]) > 0.02 * said.total_area:
        said.unread.append(item.text)


def _of_rooms(rooms: Item, area: Item) -> bool:
    """`five rooms of 14 m² each`, which is no area of the flat."""
    return rooms.kind == "main_rooms" and rooms.number > 1 and area.values[0] < LARGE


def _corrected(items: list[Item], k: int) -> list[RoomPhrase]:
    """The room whose area is given anew: `kitchen 12 m², no, 14 m²`."""
    j = k - 1
    while j >= 0 and (items[j].kind in ("negation", "area") or is_mark(items[j], ",")):
        j -= 1
    last = items[j].room if j >= 0 else None
    if last is None or not any(i.text == "no" for i in items[j:k]) or items[k].value == "total":
        return []
    last.areas = ()
    return [last]


def _coordinated(before: list[Item], last: RoomPhrase) -> list[RoomPhrase]:
    """`the kitchen and the living room` that end in `last`."""
    at = next((j for j, i in enumerate(before) if i.room is last), 0)
    out = [last]
    if len(whole := known_list(before, at)) > 1:
        return whole
    while at > 1 and before[at - 1].kind == "conjunction" and (phrase := before[at - 2].room) is not None:
        out.insert(0, phrase)
        at -= 2
    return out


def _total_near(items: list[Item], k: int) -> bool:
    before = [i for i in items[max(0, k - 3) : k] if i.kind not in ("copula",) and not is_mark(i, ":")]
    return any(i.kind == "area_word" and i.value == "total" for i in before[-1:] + items[k + 1 : k + 2])


ENDS = ("haben", "sein", "messen", "werden", "gross")
"""Words that end a German clause: `das Bad soll neben der Küche liegen und mindestens 6 m² haben`."""
SKIPPED = ("copula", "relative", "with", "area_word", "reach", "label", "size", "compare", "sum", "open", "only",
           "style")  # fmt: skip
"""What may stand between a room and its area."""


def _owners(before: list[Item], items: list[Item], k: int) -> list[RoomPhrase]:
    """The rooms the area or share at `items[k]` is said of; none means the flat."""
    if (whole := _has_and(before, items[k]) or behind_remark(before, items[k])) is not None:
        return [whole]
    ahead = rooms_of(items[k + 2 : k + 3])
    if ahead and items[k + 1].value == "with" and (items[k].kind == "share" or items[k + 1].text == "for"):
        return ahead
    is_of = [i for i in items[k + 1 : k + 3] if i.kind != "copula"]
    leading = not before or before[-1].kind in ("conjunction", "with") or is_mark(before[-1], ",:")
    if items[k].kind == "share" and leading and rooms_of(is_of[:1]):
        return rooms_of(is_of[:1])
    j = len(before) - 1
    while j >= 0 and (is_mark(before[j], "():,-") or before[j].kind in SKIPPED or before[j].value in ("it", "them")):
        j -= 1 + (before[j].kind == "size" and before[j - 1].value == "not")  # "not too small, say 22 m²"
    joined = 0 < j and before[j].kind == "conjunction"
    if joined and (j < len(before) - 1 and _verb(before[-1]) or any(i.text in ENDS for i in items[k + 1 : k + 3])):
        j = _subject_at(before, j)  # "the balcony faces south and is 6 m²"
    while j > 0 and is_mark(before[j - 1], ",") is False and before[j].kind in ("side", "place"):
        j -= 1  # "living room on the south side, 27 m²"
    last = before[j].room if j >= 0 else None
    if last is not None:
        each = any(r.quantifier == Det.EACH for r in rooms_of(items[k + 1 : k + 2]))
        return [] if not each and _speaks_of_flat(before, j, items[k]) else _each_of(before, items, j, k)
    if j >= 0 and before[j].kind == "dwelling":
        return []
    follows = k + 1 < len(items) and items[k + 1].kind in ("with", "link", "front")
    homely = any(i.kind in ("dwelling", "main_rooms") for i in items[:k])
    if items[k].kind == "share" or (follows and not homely):
        return rooms_of(items[k + 1 : k + 4])[:1]
    return []


def _verb(item: Item) -> bool:
    """The verb of `… and is 6 m²`, `… and must have at least 12 m²`."""
    return item.kind == "copula" or (item.kind == "with" and item.value == "has")


def _subject_at(before: list[Item], j: int) -> int:
    """Where the room stands that the clause ending before `j` is about."""
    start = max((n + 1 for n in range(j) if before[n].kind == "boundary" or is_mark(before[n], ".:")), default=0)
    return next((n for n in range(start, j) if before[n].room is not None), j)


def _has_and(before: list[Item], area: Item) -> RoomPhrase | None:
    """The bedroom of `a bedroom with a bath and 18 m²`, `the largest has its own bath and measures 18 m²`."""
    owner, having, thing, joint = ([Item("")] * 4 + before)[-4:]
    room = owner.room if having.kind == "with" and joint.kind == "conjunction" else None
    if room is None or room.areas or room.headline or area.kind != "area" or area.value:
        return None
    fits = bool(area.values[0] <= 2.2 * sense()["area"].get(room.type or "bedroom", 12.0))
    return room if fits and (thing.kind == "object" or thing.room is not None) else None


def _each_of(before: list[Item], items: list[Item], j: int, k: int) -> list[RoomPhrase]:
    """The room at `before[j]`, or all of `a bedroom and a study, 12 m² each`."""
    room, earlier = before[j].room, before[j - 1].room if j else None
    assert room is not None
    each = any(r.quantifier in (Det.EACH, Det.BOTH) for r in rooms_of(items[k + 1 : k + 2]))
    if room.type == "" and room.quantifier == Det.EACH and j > 1 and before[j - 1].kind == "copula":
        earlier, before = before[j - 2].room, [*before[: j - 1], *before[j:], before[j - 1]]  # "A and B are each 12 m²"
        j -= 1
    if room.type == "" and room.quantifier in (Det.EACH, Det.BOTH) and earlier is not None:
        each, room, j = True, earlier, j - 1
    if len(whole := subjects_listed([*before, items[k]], j, len(before))) > 1:
        return whole  # "the study and both bedrooms are 12 m²"
    group = [room]
    each = each and room.type != ""
    while each and not room.plural and j > 1 and (before[j - 1].kind == "conjunction" or is_mark(before[j - 1], ",")):
        j -= 2
        phrase = before[j].room
        if phrase is None or phrase.areas:
            break
        group.append(phrase)
    return group


def _speaks_of_flat(before: list[Item], j: int, area: Item) -> bool:
    """`2BHK, 80 m²`, `… and a bathroom, 85 m²`: more than such a room ever has."""
    phrase = before[j].room
    if phrase is None or area.kind == "share":
        return False
    usual = sense()["area"].get(phrase.type, 12.0)
    apart = any(is_mark(i, ",") for i in before[j + 1 :])
    whole = bool(phrase.headline) and area.values[0] > 1.6 * usual  # "1 bath 6 m²" is no flat
    whole = whole or (apart and small_home(before) and area.values[0] > 1.6 * usual)
    return whole or bool(area.values[0] > (2.2 * usual if apart else max(5.0 * usual, SMALLEST)))


def _of_all(before: list[Item], area: Item) -> bool:
    """`bedroom + kitchen + bath + lounge, 40 m²`: behind a list of rooms without areas, more than its last one has."""
    listed = [i.room for i in before if i.room is not None]
    last = listed[-1] if len(listed) > 2 and is_mark(before[-1], ",") and before[-2].room is listed[-1] else None
    if last is None or area.kind != "area" or any(r.areas for r in listed) or any(i.kind == "link" for i in before):
        return False
    return bool(area.values[0] > 1.6 * sense()["area"].get(last.type, 12.0)) and len(area.values) == 1


def _split_share(group: list[RoomPhrase], whole: float) -> None:
    """One share of the floor for several rooms, in the ratio of their usual areas."""
    for room, part in zip(group, _parts(group), strict=True):
        room.share = whole * part


def split_area(group: list[RoomPhrase], whole: float) -> None:
    """One area for several rooms, in the ratio of their usual areas."""
    for room, part in zip(group, _parts(group), strict=True):
        room.areas = (whole * part,)


def _parts(group: list[RoomPhrase]) -> list[float]:
    """What each room of a group has of their area; of a phrase for several, each of these."""
    usual = [sense()["area"].get(r.type, 12.0) for r in group]
    many = [(r.count or 2) if r.plural else 1 for r in group]
    return [part / sum(u * n for u, n in zip(usual, many, strict=True)) for part in usual]

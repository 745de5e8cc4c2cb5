"""Where rooms are to lie: sides, corners, front and back, and the entrance."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import again_named
from apartgen.stages.plan.reader.clauses import clause_of
from apartgen.stages.plan.reader.entrances import and_entrance, and_room, at_entrance, link_before, near_behind, there
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.placed import nowhere, one_new, rooms_placed, seen_from, side_of
from apartgen.stages.plan.reader.statements import Asked, Said
from apartgen.stages.plan.reader.vocabulary import Det

OPPOSED = ("left", "right", "north", "south", "east", "west")
OPPOSITES = [frozenset(pair) for pair in (("left", "right"), ("north", "south"), ("east", "west"))]
NAMED = ("storage", "utility", "study", "closet")
"""Rooms that go by many names, of which each is another one: no pantry is a store."""
FACING = ("facing", "look", "face", "window", "orient", "ausgericht", "nach",
          "richtung", "plein", "expose", "donn", "hacia", "dar al", "da al", "dan al", "朝", "向")  # fmt: skip
"""Words by which a side is that of a room's windows rather than its place."""


def role_of(items: list[Item], k: int) -> str:
    """What a side is said of: `entrance on the north side`, `party walls to the east and west`, `north entrance`."""
    start = k
    while start > 0 and (items[start - 1].kind in ("side", "conjunction") or is_mark(items[start - 1], ",")):
        start -= 1  # "party walls to the north, east and west"
    recent = items[max(0, start - 4) : k]
    room = max((j for j, i in enumerate(recent) if i.room is not None), default=-1)
    recent = recent[room + 1 :]  # "party walls to the east, balcony to the west"
    before = [i.value for i in recent if i.kind == "side_role"]
    ahead = items[k + 1 : k + 4]
    stop = next((j for j, i in enumerate(ahead) if i.room is not None or i.kind == "mark"), len(ahead))
    after = [i.value for i in ahead[:stop] if i.kind == "side_role"]
    return next(iter([*before[-1:], *after]), "")


def positions(items: list[Item], said: Said) -> list[Item]:
    """Adds what is asked of places to `said`; returns the items without the words that say only that."""
    out: list[Item] = []
    seen_from: RoomPhrase | None = None
    k = 0
    while k < len(items):
        item = items[k]
        text = item.text.replace(" - ", "-")
        if _beside(items, k):
            _seen_from(items, k, said)
            items = _it_again(items, k + 1)
            clause_of(out, rooms_placed(items, k), text)
            k += 2
            continue
        placing = item.kind == "place" or (item.kind == "side" and not role_of(items, k))
        if placing and nowhere(out, items, k):
            said.unread.append(f"not {text}")  # no plan is asked for where a room is not
            k += 1
            continue
        if placing:
            rooms = [known(room, items) for room in rooms_placed(items, k)]
            seen_from = seen_from if _its_again(items, k) else _whose(items, k)
            item = _as_before(items, k)
            to = _again_beside(items, k) or seen_from
            said.asked += [_placed(item, room, text, to) for room in rooms if room is not seen_from]
            said.unread += [] if rooms else [text]
            clause_of(out, rooms, text)
            items = _placed_and(items, k)
        elif near_behind(items, k) and (rooms := there(items, k + 2) or rooms_placed(items, k)):
            said.asked += _from_entrance(rooms, items, "near", text)
            clause_of(out, rooms, text)
            k += 2
            continue
        elif at_entrance(items, k, said) and (rooms := there(items, k + 1) or rooms_placed(items, k)):
            link = out.pop()
            more = and_room(items, k)
            if not more and _other_room(items, k + 1):
                out.append(Item("mark", ",", ","))  # "bedrooms far from the entrance and a kitchen next to …"
            clause_of(out, rooms, link.text)
            said.asked += _from_entrance(rooms, items, _unless_denied(out, link.value), f"{link.text} {text}")
            out += [link] if more else []  # "close to the entrance and to the bathroom"
            k += 1 + more
            continue
        elif and_entrance(items, k) and (rooms := rooms_placed(items, link_before(items, k))):
            link = items[link_before(items, k)]
            said.asked += _from_entrance(rooms, items, _as_denied(items, k), f"{link.text} {text}")
            out.pop()
            k += 1
            continue
        if item.kind == "link" and item.form in ("s", "p") and k and items[k - 1].value == "entrance":
            k += 1  # "the entrance leads into the living room" names no door between rooms
            continue
        if item.kind == "beside":
            said.unread.append(text)
        elif item.kind == "thing" and _subject(items, k):
            k += 1  # "a lift opens into the hall" says nothing of rooms
        elif item.kind not in ("place", "thing"):
            out.append(item)
        k += 1
    return out


def _its_again(items: list[Item], k: int) -> bool:
    """`on its left …, on its right …`, of the same room."""
    return " its " in items[k].text and any(" its " in i.text for i in items[:k] if i.kind == "place")


def _placed_and(items: list[Item], k: int) -> list[Item]:
    """`a bedroom facing east and a study next to the lounge`: what is next to it is the study alone."""
    joint, new, link = (items[k + 1 : k + 4] + [Item("")] * 3)[:3]
    first, told = items[k - 1].room if k else None, new.room
    alone = joint.value == "and" and link.kind == "link" and link.value in ("near", "apart")
    if not alone or first is None or told is None or not one_new(told) or first.quantifier == Det.THE:
        return items
    return [*items[: k + 1], Item("mark", ",", ","), *items[k + 2 :]]


def _unless_denied(out: list[Item], value: str) -> str:
    """`not far from the entrance` is near it; takes the `not` away."""
    at = len(out) - 1
    while at > 0 and out[at].kind == "copula":
        at -= 1
    if at < 0 or out[at].kind != "negation" or out[at].value != "not":
        return value
    del out[at]
    return "near" if value == "apart" else "apart"


def _as_denied(items: list[Item], k: int) -> str:
    """`no bedroom may be next to the kitchen or the entrance`: apart from both."""
    at = link_before(items, k)
    value = items[at].value
    denied = any(i.kind == "negation" for i in items[max(at - 3, 0) : at])
    return value if not denied else "near" if value == "apart" else "apart"


def _from_entrance(rooms: list[RoomPhrase], items: list[Item], value: str, text: str) -> list[Asked]:
    """Each of the rooms near the entrance, or apart from it."""
    kind = "apart" if value == "apart" else "near"
    return [Asked(kind, [known(room, items)], "entrance", "", f"{room.text} {text}") for room in rooms]


def _other_room(items: list[Item], k: int) -> bool:
    """Whether a conjunction at `k` joins another room; `… and has a closet` says more of the same."""
    kinds = [i.kind for i in items[k : k + 2]]
    return kinds[:1] == ["conjunction"] and kinds != ["conjunction", "with"]


def _subject(items: list[Item], k: int) -> bool:
    """Whether the thing at `k` begins a sentence and has a verb."""
    begins = k == 0 or is_mark(items[k - 1], ".")
    return begins and k + 1 < len(items) and items[k + 1].kind == "link" and items[k + 1].form == "s"


def _beside(items: list[Item], k: int) -> bool:
    """`the kitchen is to the left of the lounge`."""
    if not side_of(items[k]) or k + 1 >= len(items) or not rooms_placed(items, k):
        return False
    other = items[k + 1].room
    verb = k + 2 < len(items) and items[k + 2].kind in ("reach", "copula", "link")
    doors = items[k].kind == "front" and verb and other is not None and other.type == "hallway"
    return (other is not None and not doors) or items[k + 1].value in ("it", "entrance")


def _seen_from(items: list[Item], k: int, said: Said) -> None:
    """Adds the place of a room as seen from another one, or from the entrance."""
    rooms, other = rooms_placed(items, k), items[k + 1].room
    if other is None and items[k + 1].value == "it" and (again := _it_before(items, k, said)):
        other = again if isinstance(again, RoomPhrase) else None
        items = [*items[: k + 1], Item("entrance", "entrance", again)] if isinstance(again, str) else items
    elif other is None and items[k + 1].value == "it":
        other = next((r for i in reversed(items[:k]) if (r := i.room) is not None and r not in rooms), None)
    to: list[RoomPhrase] | str = "entrance" if items[k + 1].value == "entrance" else [other] if other else ""
    if other is not None and items[k + 1].room is not None:
        said.seen_from.append(known(other, items))
    if not to:
        said.unread.append(items[k].text)
        return
    text = f"{items[k].text} {items[k + 1].text}"
    said.asked += [
        Asked("position", [known(room, items)], to, side_of(items[k]), f"{room.text} {text}") for room in rooms
    ]


def _it_again(items: list[Item], k: int) -> list[Item]:
    """`the kitchen is north of the lounge and connects to it`: to the room at `k`, which the place takes away."""
    end = next((j for j in range(k + 1, len(items)) if items[j].room is not None or is_mark(items[j], ".")), len(items))
    at = next((j for j in range(k + 1, end) if items[j].value == "it" and items[j - 1].kind in ("link", "front")), None)
    room = items[k].room
    if at is None or room is None:
        return items
    return [*items[:at], again_named(room), *items[at + 1 :]]


def _it_before(items: list[Item], k: int, said: Said) -> RoomPhrase | str | None:
    """What `it` stood for just before: `a hall, a lounge to the west of it, a kitchen to the east of it`.

    Or, where the side is the opposite one, what stood there: `the bed left of the entrance, the kitchen right of it`.
    """
    start = max((j + 1 for j in range(k) if is_mark(items[j], ".")), default=0)
    sides = [j for j in range(start, k - 1) if side_of(items[j])]
    told = any(items[j + 1].value == "it" for j in sides)
    other = bool(sides) and frozenset((side_of(items[sides[-1]]), side_of(items[k]))) in OPPOSITES
    to = said.asked[-1].to if (told or other) and said.asked and said.asked[-1].kind == "position" else ""
    return to if isinstance(to, str) else to[0] if to else None


def known(room: RoomPhrase, items: list[Item]) -> RoomPhrase:
    """`kitchen near the entrance` speaks of the kitchen named before."""
    if room.quantifier == Det.BARE and room.count is None and not room.labels and not room.plural:
        named = [i.room for i in items if i.room is not None and i.room.type == room.type]
        if room.type in NAMED:
            named = [r for r in named if r.text == room.text]
        earlier = named[0]
        room.quantifier = Det.THE if earlier is not room else Det.BARE
    return room


def _as_before(items: list[Item], k: int) -> Item:
    """`one faces north, the other south`, `the lounge faces south, the bedrooms east`: the same is said of both."""
    item, gap = items[k], items[k - 1].room if k else None
    if item.kind != "side" or gap is None or any(word in item.text for word in FACING):
        return item
    joined = k > 1 and (items[k - 2].kind in ("conjunction", "boundary") or is_mark(items[k - 2], ","))
    if not (gap.quantifier == Det.OTHER or gap.ordinals) and not (joined and _named(gap) and _bare_side(item)):
        return item
    start = max((j + 1 for j in range(k) if is_mark(items[j], ".")), default=0)
    told = [i for i in items[start:k] if i.kind == "side" and any(word in i.text for word in FACING)]
    return replace(item, text=f"facing {item.text}") if told else item


def _named(room: RoomPhrase) -> bool:
    return room.definite or (room.quantifier == Det.BARE and room.count is None)


def _bare_side(item: Item) -> bool:
    """`east`, `to east`, `towards the east`."""
    *words, side = item.text.split()
    return side == item.value and set(words) <= {"to", "towards", "toward", "the"}


def _whose(items: list[Item], k: int) -> RoomPhrase | None:
    """The room that `on its left side` is said of."""
    if (other := seen_from(items, k)) is not None:
        return other
    rooms = [i.room for i in items[:k] if i.room is not None] if " its " in items[k].text else []
    told = rooms_placed(items, k)
    return next((r for r in reversed(rooms) if r not in told), None)  # "a lounge, a kitchen to its left"


def _again_beside(items: list[Item], k: int) -> RoomPhrase | str | None:
    """The hall of `the bedrooms lie to the east of the hall, the kitchen to the west`; it may be the entrance."""
    if not _plain_direction(items[k]):
        return None
    start = max((j + 1 for j in range(k) if is_mark(items[j], ".")), default=0)
    told = [j for j in range(start, k - 1) if side_of(items[j])]
    if not told or any(items[j].kind in ("side", "place") for j in range(told[-1], k)):
        return None
    other = items[told[-1] + 1]
    return "entrance" if other.value == "entrance" else other.room


def _plain_direction(item: Item) -> bool:
    """Whether a place is but a direction: `to the west`, `on the left`."""
    return item.text.split()[:2] in (["to", "the"], ["on", "the"]) and item.value in OPPOSED


def _placed(item: Item, room: RoomPhrase, text: str, seen_from: RoomPhrase | str | None) -> Asked:
    if seen_from is not None:
        to = seen_from if isinstance(seen_from, str) else [seen_from]
        return Asked("position", [room], to, item.value, f"{room.text} {text}")
    kind = "orientation" if item.kind == "side" and any(word in item.text for word in FACING) else "position"
    return Asked(kind, [room], "", item.value, f"{room.text} {text}")

"""Completes the door graph of a programme: every room is reached, none through a bedroom or a bathroom."""

from apartgen.schemas.plan import AskedRoom, Link
from apartgen.stages.plan.reader.sense import may_cross, opens_onto, sense

OWNED = ("bathroom", "closet", "study", "storage", "utility", "balcony")
"""Types that may be a private annex of a bedroom."""
ANNEXES = ("closet", "storage", "utility")
"""Types that may be one of a bathroom too."""


def edge(a: str, b: str) -> Link:
    """A link in canonical order."""
    return (a, b) if a <= b else (b, a)


def hub(rooms: list[AskedRoom]) -> AskedRoom:
    """Where one comes in: the first hallway, else the living room, else what is most public."""
    order = sense()["order"]["types"]
    return min(rooms, key=lambda r: (order.index(r.type), rooms.index(r)))


def mark_private(rooms: list[AskedRoom], links: list[Link]) -> None:
    """What opens only off a bedroom is that bedroom's own; a pair of bedrooms may share a bathroom."""
    kind = {r.id: r.type for r in rooms}
    for room in rooms:
        near = [n for n in _beside(room.id, links) if not (kind[n] in ANNEXES and _beside(n, links) == [room.id])]
        owners: tuple[str, ...] = ("bedroom", "bathroom") if room.type in ANNEXES else ("bedroom",)
        if room.type == "bathroom" and sum(r.type == "bathroom" for r in rooms) > 1:
            owners += ("closet",)  # entered through the dressing room
        if room.type in OWNED and room.private_to is None and near and all(kind[n] in owners for n in near):
            room.private_to = next((n for n in near if kind[n] == "bedroom"), near[0])


def _beside(room: str, links: list[Link]) -> list[str]:
    return [b if a == room else a for a, b in links if room in (a, b)]


def reached(rooms: list[AskedRoom], links: list[Link], start: str) -> set[str]:
    """Ids reached from `start` without crossing a private room."""
    kind = {r.id: r.type for r in rooms}
    owner = {r.id: r.private_to for r in rooms}
    seen, queue = {start}, [start]
    while queue:
        here = queue.pop()
        for a, b in links:
            if here not in (a, b):
                continue
            there = b if a == here else a
            crossing = here == start or may_cross(kind[here]) or owner[there] == here
            if crossing and there not in seen:
                seen.add(there)
                queue.append(there)
    return seen


def complete_links(
    rooms: list[AskedRoom],
    links: list[Link],
    forbidden: set[Link],
    near: set[Link] = frozenset(),  # type: ignore[assignment]
    only: set[str] = frozenset(),  # type: ignore[assignment]
    passing: set[Link] = frozenset(),  # type: ignore[assignment]
    told: set[str] = frozenset(),  # type: ignore[assignment]
) -> list[Link]:
    """`links` and as many more as needed, by `sense.toml`; those of `near` do not stand for a room's usual doors.

    Rooms of `only` get further doors where nothing else leads to them; a kitchen has its usual door beside those of
    `passing`; rooms of `told` are entered through whatever leads to them.
    """
    out = sorted({edge(a, b) for a, b in links}, key=_natural)
    for room in rooms:
        if room.private_to is not None and not any(room.id in pair for pair in out):
            out.append(edge(room.id, room.private_to))
    mark_private(rooms, out)
    _inner_bedrooms([r for r in rooms if r.id in only], rooms, out)
    start = hub(rooms).id
    order = sense()["order"]["types"]
    inner = {r.id for r in rooms if r.type == "hallway" and r.id != start and _off_living(r, rooms, out)}
    after = order.index("dining_room")  # "a second hallway off the living room": first the way to the living room
    for room in sorted(rooms, key=lambda r: (r.id in only | told, after if r.id in inner else order.index(r.type))):
        ways = out if room.id in only | told else _without_short_cuts(room, rooms, out, start)
        ways = [w for w in ways if w not in passing] if room.type == "kitchen" else ways
        seen = reached(rooms, ways, start)
        if room.id not in seen:
            partner = _partner(room, rooms, out, seen, forbidden)
            if partner is not None:
                out.append(edge(_dining(room, partner, rooms, out, forbidden) or room.id, partner))
    return sorted(set(out) | set(_also(rooms, [p for p in links if p not in near], forbidden)), key=_natural)


def _inner_bedrooms(only: list[AskedRoom], rooms: list[AskedRoom], links: list[Link]) -> None:
    """A bedroom that is to be entered only through another one belongs to that one."""
    beds = {r.id for r in rooms if r.type == "bedroom"}
    for room in only:
        near = _beside(room.id, links)
        if room.id in beds and len(near) == 1 and near[0] in beds:
            room.private_to = near[0]


def _dining(
    room: AskedRoom, partner: str, rooms: list[AskedRoom], links: list[Link], forbidden: set[Link]
) -> str | None:
    """The dining room through which the living room leads to a kitchen that has no other door; None elsewhere."""
    kind = {r.id: r.type for r in rooms}
    near = _beside(room.id, links) if (room.type, kind[partner]) == ("kitchen", "living_room") else []
    lone = len(near) == 1 and kind[near[0]] == "dining_room" and _beside(near[0], links) == [room.id]
    return near[0] if lone and edge(near[0], partner) not in forbidden else None


def _off_living(hallway: AskedRoom, rooms: list[AskedRoom], links: list[Link]) -> bool:
    living = {r.id for r in rooms if r.type in ("living_room", "dining_room")}
    return any(hallway.id in pair and living & set(pair) for pair in links)


def _without_short_cuts(room: AskedRoom, rooms: list[AskedRoom], links: list[Link], start: str) -> list[Link]:
    """A kitchen or a study with doors to both hallway and living room is no way in to the living room.

    Nor is a dining room behind such a kitchen.
    """
    if room.type != "living_room":
        return links
    kitchens = [r.id for r in rooms if r.type in ("kitchen", "study") and edge(r.id, start) in links]
    dining = [r.id for r in rooms if r.type == "dining_room" and set(_beside(r.id, links)) & set(kitchens)]
    kitchens += [r for r in dining if set(_beside(r, links)) <= {*kitchens, room.id}]
    return [pair for pair in links if not (room.id in pair and set(pair) & set(kitchens))]


def _natural(link: Link) -> tuple[str, str]:
    return link


def _partner(
    room: AskedRoom, rooms: list[AskedRoom], links: list[Link], seen: set[str], forbidden: set[Link]
) -> str | None:
    """The best reached room for a new door; a second hallway serves the private rooms."""
    for kind in opens_onto(room.type):
        near = [
            r
            for r in rooms
            if r.type == kind and r.id in seen and r.id != room.id and edge(r.id, room.id) not in forbidden
        ]
        if kind == "hallway" and room.type in ("bedroom", "bathroom", "study"):
            near = near[::-1]
        if near:
            return near[0].id
    rest = [r for r in rooms if r.id in seen and r.id != room.id and edge(r.id, room.id) not in forbidden]
    return min(rest, key=lambda r: not may_cross(r.type)).id if rest else None


def _also(rooms: list[AskedRoom], said: list[Link], forbidden: set[Link]) -> list[Link]:
    """Doors that rooms have beside the one by which they are reached, where none is said but to balconies."""
    out: list[Link] = []
    ends = {r.id for r in rooms if r.type == "balcony"}
    said = [pair for pair in said if not ends & set(pair)]
    for kind, others in sense()["also"].items():
        for room in rooms:
            if room.type != kind or any(room.id in pair for pair in said):
                continue
            for other in others:
                near = [r.id for r in rooms if r.type == other]
                if near and edge(room.id, near[0]) not in forbidden:
                    out.append(edge(room.id, near[0]))
    return out

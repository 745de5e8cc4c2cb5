"""Who lives in a home, as its plan tells: how many sleep there, which room is for what."""

from typing import NamedTuple

from apartgen.schemas.plan import Plan, Program, Room

DOUBLE = 9.6
"""A bedroom of so much floor sleeps two, m²."""
STUDIO = 30.0
"""A home without bedrooms of which the largest room has so much floor sleeps two, m²."""

PLACES = (("dining_room", 0.0), ("kitchen", 10.5), ("living_room", 14.0), ("kitchen", 7.5), ("living_room", 10.0))
"""Where up to two people eat, the likeliest first, with the floor that takes, m²."""
TWO, ONE_MORE = 2, 1.7
"""A kitchen of the least floor has a table for two; each one more who sleeps there takes so much more, m²: a chair from
behind which one cooks."""


def sleepers(plan: Plan) -> int | None:
    """Who sleeps in the home: two in a large bedroom and in that of parents, one in a small one, in children's rooms
    they; None for a room by itself."""
    if len(plan.rooms) == 1 and plan.rooms[0].base != "living_room":
        return None
    beds = [room for room in plan.rooms if room.base == "bedroom"]
    if not beds:
        return None if len(plan.rooms) == 1 else 1 + (_area(_largest(plan)) >= STUDIO)
    known, parents = {room.id: room.children for room in plan.program.rooms}, parents_in(plan.program)
    return sum(known.get(room.id) or 1 + (_area(room) >= DOUBLE or room.id == parents) for room in beds)


def parents_in(program: Program) -> str | None:
    """The one bedroom that is not children's; None where there are several, or nothing is known of children."""
    others = [room.id for room in program.rooms if room.base == "bedroom" and not room.children]
    return others[0] if len(others) == 1 and any(room.children for room in program.rooms) else None


def eats_in(plan: Plan) -> str | None:
    """The room where a home has its meals: a dining room, else a kitchen with floor for a table, else a living room;
    None for a room by itself."""
    return None if len(plan.rooms) == 1 else _first(plan, places(plan))


def places(plan: Plan) -> tuple[tuple[str, float], ...]:
    """Where those who live in a home may eat, the likeliest first, with the floor that takes, m²."""
    more = ONE_MORE * max((sleepers(plan) or 0) - TWO, 0)
    return tuple((kind, least + more if kind == "kitchen" else least) for kind, least in PLACES)


class Duties(NamedTuple):
    """What a room is for beside what its type says, 1, 0, or -1 where that is open: meals are eaten there, somebody
    sleeps there for want of a bedroom, clothes are washed there, it is the largest bedroom."""

    eats: int
    sleeps: int
    washes: int
    main: int


OPEN = Duties(-1, -1, -1, -1)
WASHING = (("utility", 0.0), ("bathroom", 4.6), ("kitchen", 0.0), ("bathroom", 0.0))
"""Where clothes are washed, the likeliest first, with the floor that takes, m²."""
LINEN = (("utility", 0.0), ("bathroom", 4.0))
"""Where what is to be washed is kept, the likeliest first, with the floor that takes, m²."""


def washes_in(plan: Plan) -> str | None:
    """The room with the washing machine, None where there is no place for one."""
    return _first(plan, WASHING)


def linen_in(plan: Plan) -> str | None:
    """The room with the laundry basket, None where there is no place for one, and for a room by itself."""
    return None if len(plan.rooms) == 1 else _first(plan, LINEN)


def duties(plan: Plan, room: Room) -> Duties:
    """What one room of a home is for; all is open of a room by itself."""
    if len(plan.rooms) == 1:
        return OPEN
    beds = [other for other in plan.rooms if other.base == "bedroom"]
    return Duties(int(eats_in(plan) == room.id), int(not beds and room.base == "living_room"),
                  int(washes_in(plan) == room.id), int(bool(beds) and room.id == max(beds, key=_area).id))


def served_by(plan: Plan, room: Room) -> tuple[str, ...]:
    """The openings of a room by which dishes come from the nearest kitchen; none where one cooks in it."""
    doors = [o for o in plan.openings if o.kind in ("door", "opening") and len(o.rooms) == 2]
    reached = [other.id for other in plan.rooms if other.base == "kitchen"]
    far = dict.fromkeys(reached, 0)
    for one in reached:  # grows as it goes
        for other in (id for o in doors if one in o.rooms for id in o.rooms if id not in far):
            far[other] = far[one] + 1
            reached.append(other)
    own = far.get(room.id, 0)
    return tuple(o.id for o in doors if room.id in o.rooms and min(far.get(id, own) for id in o.rooms) < own)


def _first(plan: Plan, places: tuple[tuple[str, float], ...]) -> str | None:
    """The largest room of the first kind of which one has the floor."""
    for kind, least in places:
        fitting = [room for room in plan.rooms if room.base == kind and _area(room) >= least]
        if fitting:
            return max(fitting, key=_area).id
    return None


def _largest(plan: Plan) -> Room:
    return max(plan.rooms, key=_area)


def _area(room: Room) -> float:
    """Of a few corners, without numpy, which would take ten times as long."""
    ends = zip(room.polygon, (*room.polygon[1:], room.polygon[0]), strict=True)
    return abs(sum(x * v - u * y for (x, y), (u, v) in ends)) / 2

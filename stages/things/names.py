"""What things and rooms of a home are called so that only one can be meant."""

from collections import Counter
from collections.abc import Iterable, Mapping

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Room
from apartgen.stages.things.categories import TABLE

SMALL = 0.35
"""Longest side of things that are too small to be told by their names, m."""
LARGE = 0.7
"""Longest side from which a room is known by a thing, m."""
CALLED = {"utility": "utility room", "storage": "storage room"}
"""Types of rooms that are not called as they are written."""
LOOKALIKES = ({"basin", "sink"}, {"worktop", "table"})
"""Symbols of things that look much alike, cabinets with something to wash in, and tables at walls."""
OWNED = ("blanket", "cushion", "throw")
"""What sofas and beds have of their own, too."""
SIMILAR = ({"mirror", "picture"}, {"picture", "picture_frame"}, {"plant", "succulent"}, {"shelving", "wall_shelf"},
           {"shelving", "bookshelf"}, {"bin", "laundry_basket"})
"""Categories of things that look alike: what hangs flat on walls, often in a frame, so that a mirror that shows a plain
wall is taken for a picture, what grows, boards on uprights and on walls, and what things are thrown into."""


def spoken(category: str) -> str:
    """A category's name in sentences."""
    return TABLE[category].called if category in TABLE else category.replace("_", " ")


def one(category: str) -> str:
    """A thing of a category in sentences."""
    name = spoken(category)
    if name.endswith("hooks"):
        return name
    return f"{'an' if name[0].lower() in 'aeiou' else 'a'} {name}"


def alike(one: str, other: str) -> bool:
    """Whether somebody may take a thing of one category for one of another: their names end alike, as those of all
    tables do, or plans have one symbol for both, as for chests and sideboards, or they look alike.
    """
    a, b = spoken(one).lower().split()[-1], spoken(other).lower().split()[-1]
    symbols = {TABLE[name].symbol for name in (one, other) if name in TABLE}
    drawn = one in TABLE and other in TABLE and (len(symbols) == 1 or any(symbols <= some for some in LOOKALIKES))
    return drawn or {one, other} in SIMILAR or a.endswith(b) or b.endswith(a)


def meanings(things: Iterable[Box]) -> dict[str, int]:
    """By category, how many of these things its name could mean."""
    counts = Counter(o.category for o in things)
    return {name: sum(n for other, n in counts.items() if alike(name, other)) for name in counts}


def type_of(room: Room) -> str:
    """A room's type in sentences."""
    return CALLED.get(room.type, room.type.replace("_", " "))


def stands(o: Box) -> bool:
    """Whether it stands on the floor, as far as is told, and does not lie flat on it, as a rug does."""
    return o.on in (None, "floor") and o.category in TABLE and TABLE[o.category].place == "floor"


def hidden(o: Box) -> bool:
    """Whether it is fitted among units that may look like it, as a dishwasher is, or what others have of their own, as
    sofas have cushions and beds throws.
    """
    return o.category in OWNED or o.category in TABLE and TABLE[o.category].run in ("unit", "fitted")


def of_rooms(home: Layout) -> dict[str, str]:
    """Rooms that can be spoken of: the only one of their type, or the only one of it with something."""
    rooms, types = {room.id: room for room in home.rooms}, Counter(room.type for room in home.rooms)
    found = {room.id: f"the {type_of(room)}" for room in home.rooms if types[room.type] == 1}
    held = Counter((rooms[room].type, category) for room, category in
                   {(o.room, o.category) for o in home.objects if o.room in rooms})
    for o in sorted(home.objects, key=lambda o: o.id):
        room = rooms.get(o.room)
        if room and room.id not in found and held[room.type, o.category] == 1 and _tells(o):
            found[room.id] = f"the {type_of(room)} with {one(o.category)}"
    return found


def _tells(o: Box) -> bool:
    """Whether it is something that a room is known by."""
    return o.category in TABLE and TABLE[o.category].place == "floor" and max(o.size) > LARGE


def of_objects(home: Layout, rooms: Mapping[str, str]) -> dict[str, str]:
    """Larger objects that can be spoken of, none that others have of their own: the only one that their name could mean
    in the home, or in a room that has a name in `rooms`.
    """
    whole, found = meanings(home.objects), {}
    inside = {(room, category): n for room in {o.room for o in home.objects} for category, n in
              meanings(o for o in home.objects if o.room == room).items()}
    for o in (o for o in home.objects if max(o.size) > SMALL and o.category not in OWNED):
        if whole[o.category] == 1:
            found[o.id] = f"the {spoken(o.category)}"
        elif inside[o.room, o.category] == 1 and o.room in rooms:
            room = rooms[o.room]
            if f"with {one(o.category)}" not in room:
                found[o.id] = f"the {spoken(o.category)} in {room}"
    return found

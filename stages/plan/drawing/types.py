"""Types and ids of drawn rooms: by their names, else by what stands in them, else by their size and shape."""

from collections import Counter

from shapely.geometry import Point, Polygon

from apartgen.stages.plan.drawing import Thing, names
from apartgen.stages.plan.drawing.floors import Room, at
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.words import category

TELLING = {
    "toilet": "bathroom",
    "bath": "bathroom",
    "shower": "bathroom",
    "hob": "kitchen",
    "kitchen_sink": "kitchen",
    "fridge": "kitchen",
    "oven": "kitchen",
    "dishwasher": "kitchen",
    "double_bed": "bedroom",
    "single_bed": "bedroom",
    "bunk_bed": "bedroom",
    "cot": "bedroom",
    "sofa": "living_room",
    "corner_sofa": "living_room",
    "tv_stand": "living_room",
    "dining_table": "dining_room",
    "round_table": "dining_room",
    "desk": "study",
    "washing_machine": "utility",
}
"""What a piece of furniture says of its room, the most telling first."""
NARROW, SMALL, MIDDLING = 1.9, 4.0, 7.0
"""A corridor's width, m; greatest floors of a storage room and of a bathroom that nothing else tells, m²."""


def told(rooms: list[Room], things: list[Thing], said: list[str]) -> list[tuple[str, str]]:
    """Id and type of each room; what is guessed is `said`."""
    read = [None if names.is_outside(room.name) else names.read(room.name) for room in rooms]
    largest = max((k for k, found in enumerate(read) if found is None), key=lambda k: rooms[k].floor.area, default=-1)
    lived = any(found and found.type == "living_room" for found in read)
    types = [
        found.type if found else _guessed(room, things, k == largest and not lived)
        for k, (room, found) in enumerate(zip(rooms, read))
    ]
    taken = {(type, found.number) for type, found in zip(types, read) if found and found.number}
    seen = Counter((type, found.number) for type, found in zip(types, read) if found and found.number)
    ids = []
    for type, found in zip(types, read):
        own = found.number if found and found.number and seen[type, found.number] == 1 else None
        number = own or next(n for n in range(1, len(rooms) + 2) if (type, n) not in taken)
        taken.add((type, number))
        ids.append(f"{type}_{number}")
    for room, found, id in zip(rooms, read, ids):
        if found is None:
            name = f"{room.name!r} speaks of no type of room" if room.name else "a room has no name"
            said.append(f"{name}, at {at(room.floor)}, {room.floor.area:.1f} m²: taken for {id}")
    return list(zip(ids, types))


def _guessed(room: Room, things: list[Thing], largest: bool) -> str:
    inside = {_kind(thing) for thing in things if room.floor.intersects(Point(thing.middle[:2]))}
    by_things = next((type for kind, type in TELLING.items() if kind in inside), None)
    if by_things is not None:
        return by_things
    if largest:
        return "living_room"
    if _width(room.floor) < NARROW and room.floor.area > 1.6 * NARROW:
        return "hallway"
    if room.floor.area < SMALL:
        return "storage"
    return "bathroom" if room.floor.area < MIDDLING else "bedroom"


def _kind(thing: Thing) -> str:
    return thing.name if thing.name in TABLE else category(thing.name)


def _width(floor: Polygon) -> float:
    """Twice the greatest distance from the walls, to 5 cm."""
    half = 0.0
    while not floor.buffer(-half - 0.025).is_empty:
        half += 0.025
    return 2 * half

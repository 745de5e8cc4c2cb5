"""What a home looks like in few numbers: rooms and doors as a signature, sizes as a vector, furniture as counts."""

import hashlib
from collections import Counter
from typing import Any

from apartgen.schemas.plan import Plan

ROUNDS = 3
"""Steps over doors that a room's colour tells of."""
_THROUGH = ("door", "opening")


def of(home: Plan) -> dict[str, Any]:
    """`signature` of the graph of rooms; `sides`, the box of every room in the signature's order, short side first, m;
    types of rooms and categories of objects by count; floor area, m².
    """
    colours = _colours(home)
    boxes = {room.id: _sides(room.polygon) for room in home.rooms}
    order = sorted(home.rooms, key=lambda room: (colours[room.id], boxes[room.id]))
    return {
        "signature": _digest(*sorted(colours.values())),
        "sides": [side for room in order for side in boxes[room.id]],
        "rooms": dict(sorted(Counter(room.type for room in home.rooms).items())),
        "objects": dict(sorted(Counter(o.category for o in getattr(home, "objects", [])).items())),
        "area": round(sum(_area(room.polygon) for room in home.rooms), 2),
    }


def _colours(home: Plan) -> dict[str, str]:
    """A colour for every room, the same for rooms that no walk of a few doors tells apart."""
    beside: dict[str, list[str]] = {room.id: [] for room in home.rooms}
    for opening in home.openings:
        if opening.kind in _THROUGH and len(opening.rooms) == 2 and set(opening.rooms) <= set(beside):
            one, other = opening.rooms
            beside[one].append(other)
            beside[other].append(one)
    colours = {room.id: room.type for room in home.rooms}
    for _ in range(ROUNDS):
        colours = {id: _digest(colour, *sorted(colours[other] for other in beside[id]))
                   for id, colour in colours.items()}
    return colours


def _digest(*words: str) -> str:
    return hashlib.sha256("\n".join(words).encode()).hexdigest()[:16]


def _sides(polygon: list[Any]) -> tuple[float, float]:
    """The sides of the box around a room, whichever way it is turned by quarters."""
    xs, ys = zip(*polygon)
    short, long = sorted((max(xs) - min(xs), max(ys) - min(ys)))
    return round(short, 2), round(long, 2)


def _area(polygon: list[Any]) -> float:
    turned = [*polygon[1:], polygon[0]]
    return float(abs(sum(x * v - u * y for (x, y), (u, v) in zip(polygon, turned)))) / 2

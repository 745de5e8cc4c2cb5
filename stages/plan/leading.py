"""What doors cost for where they lie: near the entrance, the table, the way; the cheapest are tried first."""

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.base import RoomType
from apartgen.schemas.plan import Program
from apartgen.stages.plan import faces
from apartgen.stages.plan.swings import Choice, Column

NEARER = 1.0
"""Cost of a metre between the entrance and what is to be near it."""
AFAR = 1.0
"""Cost of a metre between the entrance and the place that ways were reckoned from."""
SERVED, CARRIED = 1.5, 3.5
"""Cost of a metre by which a kitchen's door in a hall is farther than that from the door to where one eats, m."""
RETIRED = 2.0
"""Cost of a metre by which a bedroom's door is nearer to the entrance than that of the living room."""
DETOUR = 0.3
"""Cost of a metre that the way from the entrance through a door to a room's middle is longer than the straight one."""
EATEN_IN = ({"living_room", "hallway"}, {"dining_room", "hallway"})
"""What is joined by a door from a hall to where one eats."""


def towards(choice: Choice, near: shapely.Geometry | None) -> Choice:
    """An entrance costs less the nearer it is to what is to be near it, so that nobody walks past the bedrooms."""
    if near is None:
        return choice
    return choice._replace(cost=choice.cost + NEARER * float(shapely.Point(middle(choice)).distance(near)))


def about(entrances: list[Choice]) -> list[Choice]:
    """Entrances cost more the farther they are from the cheapest: from there the ways through the other doors count."""
    away = [float(np.abs(middle(choice) - middle(entrances[0])).sum()) for choice in entrances]
    dearer = [choice._replace(cost=choice.cost + AFAR * d) for choice, d in zip(entrances, away, strict=True)]
    return sorted(dearer, key=lambda c: c.cost)


def nearest(choices: list[Choice], entrance: Choice) -> list[Choice]:
    """Doors to the living room cost less the nearer they are to the entrance."""
    away = [float(np.abs(middle(choice) - middle(entrance)).sum()) for choice in choices]
    dearer = [choice._replace(cost=choice.cost + NEARER * d) for choice, d in zip(choices, away, strict=True)]
    return sorted(dearer, key=lambda c: c.cost)


def served(columns: list[Column], types: dict[str, RoomType], each: float) -> list[Column]:
    """Columns in which doors of kitchens and of rooms where one eats cost more the farther they are apart in a hall, of
    `each` metre."""
    out = list(columns)
    for i, cooked in enumerate(columns):
        for j, eaten in enumerate(columns):
            kinds = {types[room] for room in cooked.rooms}, {types[room] for room in eaten.rooms}
            dishes = kinds[0] == {"kitchen", "hallway"} and kinds[1] in EATEN_IN
            if dishes and set(cooked.rooms) & set(eaten.rooms) and cooked.choices and eaten.choices:
                out[i] = _nearer(out[i], out[j].choices[0], each)
                out[j] = _nearer(out[j], out[i].choices[0], each)
    return out


def retired(
    columns: list[Column], types: dict[str, RoomType], entrance: faces.Array, each: float
) -> list[Column]:
    """Columns in which doors of bedrooms cost more the more of a hall one walks behind them to that of the living room,
    of `each` metre."""
    led = [column.choices[0] for column in columns if column.choices
           and {types[room] for room in column.rooms} == {"living_room", "hallway"}]
    if not led:
        return columns
    lead = min(float(np.abs(middle(choice) - entrance).sum()) for choice in led)
    return [_deeper(column, entrance, lead, each) if {types[room] for room in column.rooms} == {"bedroom", "hallway"}
            else column for column in columns]


def _deeper(column: Column, entrance: faces.Array, lead: float, each: float) -> Column:
    """A column whose doors cost more the nearer than `lead`, m, they are to the entrance, of `each` metre."""
    sooner = [max(0.0, lead - float(np.abs(middle(c) - entrance).sum())) for c in column.choices]
    dearer = [c._replace(cost=c.cost + each * far) for c, far in zip(column.choices, sooner, strict=True)]
    return column._replace(choices=sorted(dearer, key=lambda c: c.cost))


def _nearer(column: Column, other: Choice, each: float) -> Column:
    """A column whose doors cost more the farther they are from another, of `each` metre."""
    away = [max(0.0, float(np.abs(middle(c) - middle(other)).sum()) - CARRIED) for c in column.choices]
    dearer = [c._replace(cost=c.cost + each * far) for c, far in zip(column.choices, away, strict=True)]
    return column._replace(choices=sorted(dearer, key=lambda c: c.cost))


def on_the_way(choices: list[Choice], entrance: faces.Array, room: Polygon, program: Program) -> list[Choice]:
    """Doors cost more the farther they lead about on the way to the room behind."""
    counts = DETOUR * program.weights.get("shortest_path", 1.0)
    end = np.array(room.envelope.centroid.coords[0])
    straight = float(np.abs(end - entrance).sum())
    at = np.array([middle(choice) for choice in choices]).reshape(-1, 2)
    ways = (np.abs(at - entrance).sum(axis=1) + np.abs(at - end).sum(axis=1)).tolist()
    dearer = [c._replace(cost=c.cost + counts * (way - straight)) for c, way in zip(choices, ways, strict=True)]
    return sorted(dearer, key=lambda c: c.cost)


def middle(choice: Choice) -> faces.Array:
    """The middle of a door in the edge of its room, (2,), m."""
    return np.asarray(choice.face.start + 0.5 * (choice.lo + choice.hi) * choice.face.along)

"""Furniture of a drawing as boxes of the layout's categories."""

from collections import Counter
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.polygon import orient

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Room
from apartgen.stages.plan.drawing import Thing
from apartgen.stages.space import polygons
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.words import OTHER, category

Array = NDArray[np.float64]
THIN = 1e-3
"""What is thinner in some way is no body, m."""
LITTLE = 1e-3
"""What reaches less into walls is left where it is, m²."""
IN_WALL = 0.15
"""Furniture drawn so far into a wall is moved out of it, m."""
IN_ROOM = 0.6
"""The same where its size is not known."""
LYING = 0.45
"""A double bed is at least three times as wide, a single one narrower, m."""


def boxes(things: list[Thing], rooms: list[Room], said: list[str]) -> list[Box]:
    """What is furniture here and stands in a room; the rest is left out and `said`."""
    out: list[Box] = []
    strange: Counter[str] = Counter()
    outside: Counter[str] = Counter()
    flat: Counter[str] = Counter()
    for thing in things:
        if not min(thing.size) >= THIN:
            flat[thing.name or "without a name"] += 1
            continue
        name = _category(thing)
        room = _room(thing, rooms)
        if name is None or room is None:
            (strange if name is None else outside)[thing.name or "without a name"] += 1
            continue
        number = sum(box.room == room.id and box.category == name for box in out) + 1
        out.append(_box(f"{room.id}.{name}_{number}", thing, name, room))
    for found, why in ((strange, "no furniture known here"), (outside, "in no room"), (flat, "without a body")):
        if found:
            told = ", ".join(f"{name} ({count})" if count > 1 else name for name, count in sorted(found.items()))
            said.append(f"left out, {why}: {told}")
    return out


def footprint(thing: Thing) -> Polygon:
    """The floor that a thing stands over."""
    d, w, _ = thing.size
    c, s = np.cos(thing.yaw), np.sin(thing.yaw)
    ring = np.array([[-d, -w], [d, -w], [d, w], [-d, w]]) / 2
    return Polygon(ring @ np.array([[c, s], [-s, c]]) + np.array(thing.middle[:2]))


def standing(objects: list[Box]) -> list[Polygon]:
    """Floors under what is in the way of doors."""
    low = [
        o
        for o in objects
        if o.center[2] - o.size[2] / 2 < 2.0 and not (o.category in TABLE and TABLE[o.category].place == "flat")
    ]
    return [footprint(Thing(o.category, o.center, o.size, o.yaw)) for o in low]


def _category(thing: Thing) -> str | None:
    """Our category; beds and tables by their size, which their names seldom tell."""
    name = thing.name if thing.name in TABLE else category(thing.name)
    if name == OTHER or name not in TABLE:
        return None
    if name in ("double_bed", "single_bed") and thing.name not in TABLE:
        return "single_bed" if min(thing.size[:2]) < 3 * LYING else "double_bed"
    return name


def _room(thing: Thing, rooms: list[Room]) -> Room | None:
    """The room that its middle is in, else the one that it reaches furthest into."""
    middle = Point(thing.middle[:2])
    inside = next((room for room in rooms if polygons.floor(room).intersects(middle)), None)
    if inside is not None:
        return inside
    mark = footprint(thing)
    shares = [(polygons.floor(room).intersection(mark).area / mark.area, room) for room in rooms]
    share, room = max(shares, key=lambda pair: pair[0])
    return room if share > 0.3 else None


def _box(id: str, thing: Thing, name: str, room: Room) -> Box:
    (d, w, h), yaw = thing.size, thing.yaw
    if not thing.turned:
        (d, w), yaw = _faced(thing, name, polygons.floor(room))
    shown = replace(thing, size=(d, w, h), yaw=yaw)
    shown = _inside(shown, polygons.floor(room), IN_WALL) if thing.sized else _fitted(shown, name, polygons.floor(room))
    (x, y, z), (d, w, h) = (round(float(v), 4) for v in shown.middle), shown.size
    return Box(
        id=id,
        room=room.id,
        category=name,
        center=(x, y, z),
        size=(round(d, 4), round(w, 4), round(h, 4)),
        yaw=round(float((yaw + np.pi) % (2 * np.pi) - np.pi), 4),
    )


def _fitted(thing: Thing, name: str, floor: Polygon) -> Thing:
    """Of usual size where that fits between the walls, else of the least there is."""
    d, w, _ = TABLE[name].min
    ways = [_inside(one, floor, IN_ROOM) for one in (thing, replace(thing, size=(d, w, thing.size[2])))]
    return min(ways, key=lambda one: round(float(footprint(one).difference(floor).area), 2))


def _inside(thing: Thing, floor: Polygon, most: float) -> Thing:
    """The thing moved by what it reaches into walls, where that is at `most` so much."""
    if footprint(thing).difference(floor).area < LITTLE:
        return thing
    x, y, z = thing.middle
    ring = np.asarray(orient(floor).exterior.coords)
    for a, b in zip(ring, ring[1:]):
        unit = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
        corners = np.asarray(footprint(replace(thing, middle=(x, y, z))).exterior.coords) - a
        beyond, spans = float((corners @ np.array([unit[1], -unit[0]])).max()), corners @ unit
        if 0 < beyond <= most and spans.min() < np.hypot(*(b - a)) and spans.max() > 0:
            x, y = x - beyond * unit[1], y + beyond * unit[0]
    moved = replace(thing, middle=(float(x), float(y), z))
    better = footprint(moved).difference(floor).area < footprint(thing).difference(floor).area - 1e-9
    return moved if better else thing


def _faced(thing: Thing, name: str, floor: Polygon) -> tuple[tuple[float, float], float]:
    """Depth, width and yaw with the back to the nearest wall, of the two sides that are as long as it is wide."""
    d, w, _ = thing.size
    usual = TABLE[name].size
    across = (d < w) != (usual[0] < usual[1]) and abs(d - w) > 0.05
    size, yaw = ((w, d), thing.yaw + np.pi / 2) if across else ((d, w), thing.yaw)
    walls = LineString(floor.exterior.coords)
    ways = [yaw, yaw + np.pi] if abs(d - w) > 0.05 else [yaw + k * np.pi / 2 for k in range(4)]

    def behind(yaw: float) -> float:
        x, y = np.array(thing.middle[:2]) - size[0] / 2 * np.array([np.cos(yaw), np.sin(yaw)])
        return float(walls.distance(Point(x, y)))

    return size, min(ways, key=lambda way: (round(behind(way), 3), way))

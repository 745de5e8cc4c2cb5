"""What each reward term is about, measured on a finished plan: of all but shares and corners held, less is better."""

from collections.abc import Iterable, Mapping
from heapq import heappop, heappush
from itertools import combinations, pairwise

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.base import RoomType
from apartgen.schemas.plan import Plan
from apartgen.stages.plan import faces
from apartgen.stages.plan.blocks import facing
from apartgen.stages.plan.slicing import Floats
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.space import polygons

UNITS = {
    "shortest_path": "detour", "typical_area": "area off", "aspect_ratio": "aspect", "convexity": "hull over area",
    "conciseness": "corners a room", "exterior_length": "façade held, %", "exterior_corner": "corners held, %",
    "collinearity": "wall lines", "functional_room": "lived in, %", "narrow_passage": "m² narrow",
    "near_rooms": "m between wet rooms", "wide_corridor": "m wider than 1.3", "privacy": "m before the living room",
}  # fmt: skip
"""What is measured for each term that a plan on one storey has."""
UP = ("exterior_length", "exterior_corner", "functional_room")
"""Terms whose measure grows with their weight."""
ROOMY, NARROW = 1.5, 1.3
"""Width from which no passage is narrow, where two people pass, and up to which no corridor is wide, m."""
FINE = 1e-3
"""Error of a width, m."""
ALONG = 0.06
"""Wall lines so near one another are one, m."""

Floors = dict[str, Polygon]


def seen(plan: Plan) -> dict[str, float]:
    """The measure of every term that a plan on one storey has, by its name."""
    floors = {r.id: polygons.floor(r) for r in plan.rooms if r.base != "balcony"}
    types = {r.id: r.base for r in plan.rooms}
    rooms = [floor for r, floor in floors.items() if types[r] != "hallway"]
    ways, away = walked(plan)
    return {
        "shortest_path": _detour(ways, away, floors),
        "typical_area": _off(plan, floors),
        "aspect_ratio": float(np.mean([_extents(floor).max() / _extents(floor).min() for floor in rooms])),
        "convexity": float(np.mean([floor.convex_hull.area / floor.area for floor in rooms])),
        "conciseness": float(np.mean([len(floor.simplify(1e-3).exterior.coords) - 1 for floor in floors.values()])),
        "exterior_length": 100 * _rim_held(plan, floors, types),
        "exterior_corner": 100 * _corners_held(floors, types),
        "collinearity": _lines(floors, plan.walls.inner),
        "functional_room": 100 * _area(f for r, f in floors.items() if STANDARDS[types[r]].functional)
        / _area(floors.values()),
        "narrow_passage": sum(floor.area - _opened(floor).area for floor in floors.values()),
        "near_rooms": _between([floors[r] for r in floors if STANDARDS[types[r]].wet]),
        "wide_corridor": sum(max(0.0, _width(f) - NARROW) for r, f in floors.items() if types[r] == "hallway"),
        "privacy": _before_living(ways, types),
    }


def walked(plan: Plan) -> tuple[dict[str, float], dict[str, Floats]]:
    """The way from the entrance to each room's door, Manhattan from door to door, and that door's place, by room."""
    middles = {o.id: np.mean(np.array(o.segment), axis=0) for o in plan.openings}
    entrance = next(o for o in plan.openings if o.kind == "entrance")
    ways: dict[str, float] = {}
    doors: dict[str, Floats] = {}
    queue = [(0.0, 0, entrance.rooms[0], entrance.id)]
    while queue:
        way, _, here, door = heappop(queue)
        if here in ways:
            continue
        ways[here], doors[here] = way, middles[door]
        for o in plan.openings:
            if o.kind in ("door", "opening") and here in o.rooms:
                there = next(room for room in o.rooms if room != here)
                step = float(np.abs(middles[o.id] - middles[door]).sum())
                heappush(queue, (way + step, len(queue), there, o.id))
    return ways, doors


def _detour(ways: Mapping[str, float], doors: Mapping[str, Floats], floors: Floors) -> float:
    """Mean over rooms of the way from the entrance to a room's middle over the same without walls, less one."""
    entrance = next(doors[room] for room, way in ways.items() if way == 0.0)
    middles = {room: np.array([floor.envelope.centroid.x, floor.envelope.centroid.y]) for room, floor in floors.items()}
    far = [(ways[r] + np.abs(at - doors[r]).sum(), np.abs(at - entrance).sum()) for r, at in middles.items()]
    return float(np.mean([max(0.0, way / (straight + 0.5) - 1) for way, straight in far]))


def _off(plan: Plan, floors: Floors) -> float:
    """Mean part by which rooms' shares of the area differ from those asked for."""
    asked = {r.id: r.area for r in plan.program.rooms if r.area and r.id in floors}
    scale = sum(asked.values()) / _area(floors[r] for r in asked) if asked else 1.0
    return float(np.mean([abs(floors[r].area * scale / area - 1) for r, area in asked.items()] or [0.0]))


def _area(floors: Iterable[Polygon]) -> float:
    return float(sum(floor.area for floor in floors))


def _extents(floor: Polygon) -> Floats:
    x0, y0, x1, y1 = floor.bounds
    return np.array([x1 - x0, y1 - y0])


def _opened(floor: Polygon) -> Polygon:
    """The parts of a floor that are `ROOMY` wide."""
    half = ROOMY / 2 - 1e-3
    wide: Polygon = floor.buffer(-half, join_style="mitre").buffer(half, join_style="mitre")
    return wide


def _width(floor: Polygon) -> float:
    """Side of the widest square along the walls that fits, m; a circle would find corridors wider where they turn."""
    low, high = 0.0, float(_extents(floor).min())
    while high - low > FINE:
        side = 0.5 * (low + high)
        fits = not floor.buffer(-side / 2, join_style="mitre").is_empty
        low, high = (side, high) if fits else (low, side)
    return low


def _rim_held(plan: Plan, floors: Floors, types: Mapping[str, RoomType]) -> float:
    """Share of the walls that may have windows which rooms that want them hold."""
    party, held, total = plan.program.envelope.party_walls, 0.0, 0.0
    for room, floor in floors.items():
        found = faces.outside(floor, [other for r, other in floors.items() if r != room])
        length = sum(face.length for face in found if facing(*face.along) not in party)
        held, total = held + length * STANDARDS[types[room]].outer, total + length
    return held / max(total, 1e-9)


def _corners_held(floors: Floors, types: Mapping[str, RoomType]) -> float:
    """Share of the corners of the box about the flat that rooms which want them hold."""
    x0, y0, x1, y1 = shapely.total_bounds(list(floors.values()))
    corners = [shapely.Point(x, y) for x in (x0, x1) for y in (y0, y1)]
    holding = [r for r, floor in floors.items() for corner in corners if floor.distance(corner) < 0.01]
    return float(sum(STANDARDS[types[r]].outer for r in holding) / max(len(holding), 1))


def _lines(floors: Floors, thick: float) -> float:
    """Distinct lines that walls stand on, both ways, by the walls' middles."""
    found = 0
    for axis in (0, 1):
        at = []
        for floor in floors.values():
            ring = shapely.get_coordinates(floor.exterior)
            for a, b in pairwise(ring):
                if abs(a[axis] - b[axis]) < 1e-6:
                    out = np.sign(a[1 - axis] - b[1 - axis]) * (1 if axis else -1)
                    at.append(float(a[axis] + out * thick / 2))
        lines = np.sort(at)
        found += 1 + int((np.diff(lines) > ALONG).sum())
    return float(found)


def _between(wet: list[Polygon]) -> float:
    """Mean distance of two wet rooms, m."""
    return float(np.mean([a.distance(b) for a, b in combinations(wet, 2)] or [0.0]))


def _before_living(ways: Mapping[str, float], types: Mapping[str, RoomType]) -> float:
    """Metres that bedrooms are nearer the entrance than the living room, a bedroom."""
    lived = min((way for room, way in ways.items() if types[room] == "living_room"), default=0.0)
    beds = [max(0.0, lived - way) for room, way in ways.items() if types[room] == "bedroom"]
    return float(np.mean(beds or [0.0]))

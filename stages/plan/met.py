"""Which requirements a finished plan meets, seen from its geometry alone."""

from dataclasses import dataclass
from statistics import median

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon

from apartgen.schemas.plan import Plan, Requirement
from apartgen.stages.plan.slicing import Floats
from apartgen.stages.plan.wishes import DIRECTIONS, lengths
from apartgen.stages.space import polygons

OFF, MIDDLE = 0.1, 0.4
"""Half extents of the home by which a room's middle lies to a side, and at most from the middle in the centre."""
BESIDE, SHARED, NEAR = 0.5, 0.5, 3.0
"""Metres between the middles of rooms beside one another, of wall that neighbours share, and that are near."""
TOLERANCE, AREA, LENGTH = 0.03, 0.05, 0.1
"""Parts by which limits, areas and lengths may differ."""


@dataclass(frozen=True)
class Seen:
    """The plan's clear floors by room, their whole, and the entrance's place and direction inwards."""

    plan: Plan
    floors: dict[str, Polygon]
    whole: Polygon
    door: shapely.Point
    inwards: Floats

    def off(self, room: str) -> Floats:
        """The room's middle from the home's, in half extents of the home (2,)."""
        x0, y0, x1, y1 = self.whole.bounds
        middle, half = np.array([x0 + x1, y0 + y1]) / 2, np.array([x1 - x0, y1 - y0]) / 2
        return (self.middle(room) - middle) / half

    def middle(self, room: str) -> Floats:
        """Centroid (2,)."""
        point = self.floors[room].centroid
        return np.array([point.x, point.y])


def judged(plan: Plan) -> Plan:
    """The plan with `met` of every requirement that can be seen in it."""
    if not plan.program.requirements:
        return plan
    seen = _seen(plan)
    rows = [r.model_copy(update={"met": met(r, seen)}) for r in plan.program.requirements]
    return plan.model_copy(update={"program": plan.program.model_copy(update={"requirements": rows})})


def unmet(plan: Plan) -> int:
    """How many requirements a judged plan does not meet."""
    return sum(r.met is False for r in plan.program.requirements)


def met(asked: Requirement, seen: Seen) -> bool | None:
    """Whether the plan has what is asked; None for what cannot be seen in a plan."""
    if asked.of not in seen.floors:
        return _of_home(asked, seen) if asked.of == "home" else None
    other = asked.to if asked.to in seen.floors else None
    match asked.kind:
        case "position" if asked.to is None:
            return _placed(asked.of, str(asked.value), seen)
        case "position" if other is not None and str(asked.value) in DIRECTIONS:
            away = (seen.middle(asked.of) - seen.middle(other)) * DIRECTIONS[str(asked.value)]
            return bool((away[np.array(DIRECTIONS[str(asked.value)]) != 0] >= BESIDE).all())
        case "position" if asked.to == "entrance":
            return _as_one_comes_in(asked.of, str(asked.value), seen)
        case "orientation":
            return _faces(asked.of, str(asked.value), seen)
        case "near" | "apart" if asked.to == "entrance":
            return _from_door(asked.of, asked.kind == "near", seen)
        case "adjacent" | "apart" if other is not None:
            return (_shared(asked.of, other, seen) >= SHARED) == (asked.kind == "adjacent")
        case "opposite" if other is not None:
            return _across(asked.of, other, seen)
        case "dimension":
            return _sides(seen.floors[asked.of], *lengths(str(asked.value)))
        case "area":
            return bool(abs(seen.floors[asked.of].area / float(asked.value or 0) - 1) <= AREA)
        case "order":
            return _ordered(asked.of, other, str(asked.value), seen)
        case "at_least" | "at_most" if asked.to == "width":
            return _wide(seen.floors[asked.of], asked)
        case "at_least" | "at_most":
            return _bounded(_measured(asked, seen), asked)
        case "no_door" if other is not None:
            return all(set(o.rooms) != {asked.of, other} for o in seen.plan.openings)
        case "use":
            return True
    return None


def _seen(plan: Plan) -> Seen:
    floors = {room.id: polygons.floor(room) for room in plan.rooms}
    indoors = [floors[r.id] for r in plan.rooms if r.base != "balcony"] or list(floors.values())
    whole = shapely.union_all(indoors)
    entrance = next((o for o in plan.openings if o.kind == "entrance"), None)
    if entrance is None:
        return Seen(plan, floors, whole, whole.centroid, np.zeros(2))
    line = LineString(entrance.segment)
    door = line.interpolate(0.5, normalized=True)
    room = floors[entrance.rooms[0]]
    (ax, ay), (bx, by) = entrance.segment
    normal = np.array([ay - by, bx - ax]) / line.length
    ahead = shapely.Point(shapely.get_coordinates(door)[0] + 0.5 * normal)
    return Seen(plan, floors, whole, door, normal if room.distance(ahead) < 0.1 else -normal)


def _placed(room: str, value: str, seen: Seen) -> bool | None:
    off = seen.off(room)
    if value == "centre":
        return bool((np.abs(off) <= MIDDLE).all())
    if value == "corner":
        return bool((_gaps(room, seen).reshape(2, 2).min(axis=0) < 0.5).all())
    if value in ("front", "back"):
        return _from_door(room, value == "front", seen)
    if value not in DIRECTIONS:
        return None
    along = np.array(DIRECTIONS[value])
    return bool((off[along != 0] * along[along != 0] >= OFF).all())


def _gaps(room: str, seen: Seen) -> Floats:
    """Metres from the room to the west, south, east and north of the home."""
    gaps: Floats = np.abs(np.array(seen.floors[room].bounds) - np.array(seen.whole.bounds))
    return gaps


def _from_door(room: str, near: bool, seen: Seen) -> bool:
    """Near: within a few metres, or nearer than most rooms; far: farther than most."""
    away = {r: floor.distance(seen.door) for r, floor in seen.floors.items()}
    usual = median(away.values())
    return bool(away[room] <= NEAR or away[room] < usual if near else away[room] >= usual)


def _as_one_comes_in(room: str, value: str, seen: Seen) -> bool | None:
    if value not in ("left", "right"):
        return None
    x, y = seen.middle(room) - shapely.get_coordinates(seen.door)[0]
    left = seen.inwards[0] * y - seen.inwards[1] * x
    return bool(left > 0 if value == "left" else left < 0)


def _faces(room: str, value: str, seen: Seen) -> bool | None:
    """Whether a window, or the rim of a balcony, looks to a side."""
    if value not in DIRECTIONS:
        return None
    along, mine = np.array(DIRECTIONS[value]), seen.floors[room]
    lines = [LineString(o.segment) for o in seen.plan.openings if o.kind == "window" and room in o.rooms]
    ways = [_outwards(line, mine) for line in lines]
    if not lines:  # a balcony
        ways = [seen.off(room)]
    return any(bool((way[along != 0] * along[along != 0] >= 0.6).all()) for way in ways)


def _outwards(line: LineString, floor: Polygon) -> Floats:
    """Unit normal of a wall, away from the room."""
    (ax, ay), (bx, by) = line.coords
    normal: Floats = np.array([ay - by, bx - ax]) / line.length
    middle = shapely.get_coordinates(line.interpolate(0.5, normalized=True))[0]
    ahead, behind = (floor.distance(shapely.Point(middle + way * normal)) for way in (1, -1))
    return normal if ahead > behind else -normal


def _shared(room: str, other: str, seen: Seen) -> float:
    """Metres of wall between two rooms; a balcony has an outer wall behind it."""
    outside = any(r.id in (room, other) and r.base == "balcony" for r in seen.plan.rooms)
    grow = (seen.plan.walls.outer if outside else seen.plan.walls.inner) / 2 + 0.01
    a, b = (seen.floors[r].buffer(grow, join_style="mitre") for r in (room, other))
    return float(a.intersection(b).length) / 2


def _across(room: str, other: str, seen: Seen) -> bool:
    """Whether two rooms lie face to face with at most a passage between them."""
    a, b = seen.floors[room].bounds, seen.floors[other].bounds
    gap = [max(0.0, max(a[k], b[k]) - min(a[k + 2], b[k + 2])) for k in (0, 1)]
    return min(gap) == 0.0 and max(gap) <= NEAR and _shared(room, other, seen) < SHARED or gap == [0.0, 0.0]


def _sides(floor: Polygon, a: float, b: float) -> bool:
    """Whether a floor is a rectangle of two lengths."""
    x0, y0, x1, y1 = floor.bounds
    ways = [(x1 - x0, y1 - y0), (y1 - y0, x1 - x0)]
    return any(abs(w / a - 1) <= LENGTH and abs(h / b - 1) <= LENGTH for w, h in ways)


def _ordered(room: str, other: str | None, value: str, seen: Seen) -> bool | None:
    area = seen.floors[room].area
    rest = [floor.area for r, floor in seen.floors.items() if r == other or (other is None and r != room)]
    if not rest:
        return None
    return bool(area > max(rest)) if value in ("larger", "largest") else bool(area < min(rest))


def _bounded(area: float, asked: Requirement) -> bool:
    limit = float(asked.value or 0)
    return area >= limit * (1 - TOLERANCE) if asked.kind == "at_least" else area <= limit * (1 + TOLERANCE)


def _measured(asked: Requirement, seen: Seen) -> float:
    """The area of a room; its length, or how many doors it has beside the entrance, where `to` says so."""
    if asked.to == "doors":
        return sum(asked.of in o.rooms for o in seen.plan.openings if o.kind in ("door", "opening"))
    x0, y0, x1, y1 = seen.floors[asked.of].bounds
    return float(max(x1 - x0, y1 - y0)) if asked.to == "length" else float(seen.floors[asked.of].area)


def _wide(floor: Polygon, asked: Requirement) -> bool:
    """Whether a floor is nowhere narrower than a width, or nowhere wider."""
    half = float(asked.value or 0) / 2
    if asked.kind == "at_most":
        return bool(floor.buffer(-half * (1 + TOLERANCE), join_style="mitre").is_empty)
    half *= 1 - TOLERANCE
    return bool(floor.buffer(-half, join_style="mitre").buffer(half, join_style="mitre").area > 0.99 * floor.area)


def _of_home(asked: Requirement, seen: Seen) -> bool | None:
    if asked.kind in ("at_least", "at_most"):
        return _bounded(sum(floor.area for floor in seen.floors.values()), asked)
    return _sides(seen.whole.envelope, *lengths(str(asked.value))) if asked.kind == "dimension" else None

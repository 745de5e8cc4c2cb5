"""The shapes a plan implies: floors, walls, thresholds, and what a door leaf sweeps.

Everything is a shapely geometry in the plan's metres; an empty polygon stands for "nothing".
"""

from functools import lru_cache
from math import hypot
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry
from shapely.geometry import Point, Polygon
from shapely.ops import nearest_points, unary_union

from apartgen.schemas.plan import Opening, Plan, Room, Walls

LEAF = 0.04
"""Thickness of a door leaf, m; it fills the wall's face on the side it opens to."""
OVERLAP = 0.01
"""How far a threshold reaches onto the floors it joins, m, so that unions connect."""
RAIL = 0.05
"""Thickness of a balcony's railing, m."""
PASSAGES = ("door", "opening", "entrance")
"""Kinds of opening that one walks through."""
ARC = 12
"""Segments of a leaf's quarter circle."""

Array = NDArray[np.float64]


class Hinge(NamedTuple):
    """A leaf's pivot on the wall's face, the unit direction it lies in when shut, and the one it opens to."""

    pivot: Array
    shut: Array
    opened: Array
    width: float


def floor(room: Room) -> Polygon:
    """The clear floor of a room."""
    return Polygon(room.polygon)


def floors(plan: Plan) -> dict[str, Polygon]:
    """Every room's clear floor by id."""
    return {room.id: floor(room) for room in plan.rooms}


def width(opening: Opening) -> float:
    """Clear width, m."""
    (ax, ay), (bx, by) = opening.segment
    return hypot(bx - ax, by - ay)


def along(opening: Opening) -> Array:
    """Unit direction from the first end of the segment to the second."""
    a, b = np.asarray(opening.segment, float)
    unit: Array = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    return unit


def face(opening: Opening, plan: Plan, room: str) -> tuple[Array, float]:
    """Unit normal of the cut wall towards `room`, and the distance from its centre line to that room's floor."""
    here = next(r for r in plan.rooms if r.id == room)
    (ax, ay), (bx, by) = opening.segment
    x, y, reach = _face((ax, ay, bx, by), tuple(map(tuple, here.polygon)))
    return np.array([x, y]), reach


@lru_cache(maxsize=4096)
def _face(segment: tuple[float, ...], corners: tuple[tuple[float, float], ...]) -> tuple[float, float, float]:
    """The same by value, because the same openings are asked for again and again."""
    a, b = np.array(segment).reshape(2, 2)
    middle = (a + b) / 2
    near = nearest_points(Polygon(corners), Point(middle))[0]
    ahead = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    normal = np.array([-ahead[1], ahead[0]])
    reach = float(np.dot(np.array([near.x, near.y]) - middle, normal))
    sign = 1.0 if reach >= 0 else -1.0
    return float(sign * normal[0]), float(sign * normal[1]), sign * reach


def _strip(opening: Opening, normal: Array, lo: float, hi: float) -> Polygon:
    a, b = np.asarray(opening.segment, float)
    return Polygon([a + lo * normal, b + lo * normal, b + hi * normal, a + hi * normal]).buffer(0)


def before(opening: Opening, plan: Plan, room: str, depth: float, from_face: bool = False) -> Polygon:
    """What lies before an opening in `room`, as wide as it, from the wall's centre line or its face to `depth` beyond
    the face.
    """
    normal, reach = face(opening, plan, room)
    return _strip(opening, normal, reach if from_face else 0.0, reach + depth)


def ways_in(plan: Plan) -> list[Opening]:
    """The entrances; without one, the first door."""
    return [o for o in plan.openings if o.kind == "entrance"] or [o for o in plan.openings if o.kind == "door"][:1]


def inward(plan: Plan) -> float | None:
    """The yaw of coming in, square to the first way in; None without any."""
    for way in ways_in(plan):
        normal, _ = face(way, plan, way.rooms[0])
        return float(np.arctan2(normal[1], normal[0]))
    return None


def threshold(opening: Opening, plan: Plan) -> Polygon:
    """The rectangle cut through the wall, `OVERLAP` onto the floors on both sides.

    Towards the open air it ends flush with the outer face.
    """
    normal, reach = face(opening, plan, opening.rooms[0])
    if len(opening.rooms) == 1:
        return _strip(opening, normal, -reach, reach + OVERLAP)
    beyond = face(opening, plan, opening.rooms[1])[1]
    return _strip(opening, normal, -beyond - OVERLAP, reach + OVERLAP)


def hinge(opening: Opening, plan: Plan) -> Hinge | None:
    """Where and how the leaf turns; None for what has no leaf."""
    if opening.into is None or opening.kind not in ("door", "entrance"):
        return None
    normal, reach = face(opening, plan, opening.into)
    ends = np.asarray(opening.segment, float)
    shut = along(opening) * (1 if opening.hinge == 0 else -1)
    return Hinge(ends[opening.hinge] + reach * normal, shut, normal, width(opening))


def swing(opening: Opening, plan: Plan) -> Polygon:
    """Floor swept by the leaf from shut to 90° open, its thickness included; empty without a leaf."""
    turn = hinge(opening, plan)
    if turn is None:
        return Polygon()
    radius = hypot(turn.width, LEAF)
    angles = np.linspace(0, np.pi / 2, ARC + 1)[:, None]
    arc = turn.pivot + radius / np.cos(np.pi / 4 / ARC) * (np.cos(angles) * turn.shut + np.sin(angles) * turn.opened)
    return Polygon([turn.pivot, *arc])


def leaf(opening: Opening, plan: Plan, turned: float = np.pi / 2) -> Polygon:
    """The leaf's footprint, turned by `turned` radians from shut; empty without a leaf."""
    turn = hinge(opening, plan)
    if turn is None:
        return Polygon()
    out = np.cos(turned) * turn.shut + np.sin(turned) * turn.opened
    back = np.sin(turned) * turn.shut - np.cos(turned) * turn.opened
    a, b = turn.pivot, turn.pivot + turn.width * out
    return Polygon([a, b, b + LEAF * back, a + LEAF * back])


def clearance(opening: Opening, plan: Plan, depth: float = 0.6) -> Geometry:
    """Floor that must stay free to pass: `depth` deep on both sides, and what the leaf sweeps."""
    if opening.kind == "window":
        return Polygon()
    inside = unary_union([floor(room) for room in plan.rooms if room.id in opening.rooms])
    zones = [before(opening, plan, room, depth) for room in opening.rooms]
    return unary_union([*zones, swing(opening, plan)]).intersection(inside)


def shell(plan: Plan) -> Geometry:
    """Everything within the outer face of the outer walls: floors and walls together, balconies with their railings."""
    outdoors = [floor(room) for room in plan.rooms if room.base == "balcony"]
    inside = unary_union([floor(room) for room in plan.rooms if room.base != "balcony"] or outdoors)
    railed = [balcony.buffer(RAIL, join_style="mitre") for balcony in outdoors]
    return unary_union([_grown(inside, plan.walls, plan.walls.outer), *railed])


def _grown(area: Geometry, walls: Walls, by: float) -> Geometry:
    # Joins floors across inner walls first, so that corners between rooms do not notch the outside.
    joined = area.buffer(walls.inner, join_style="mitre").buffer(-walls.inner, join_style="mitre")
    return joined.buffer(by, join_style="mitre")


def walls(plan: Plan) -> Geometry:
    """Wall bodies seen from above, cut by doors, openings and entrances; windows are left whole."""
    cut = [threshold(opening, plan) for opening in plan.openings if opening.kind in PASSAGES]
    return shell(plan).difference(unary_union([*floors(plan).values(), *cut]))


def free_floor(plan: Plan) -> Geometry:
    """Where one can walk in the empty plan: floors joined by thresholds; the entrance's own threshold is left out."""
    inner = [threshold(o, plan) for o in plan.openings if o.kind in ("door", "opening")]
    return unary_union([*floors(plan).values(), *inner])

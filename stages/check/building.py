"""The plan: rooms, walls, openings, and whether one gets from the entrance into every room."""

from collections.abc import Iterator
from typing import NamedTuple

import shapely
from shapely import Geometry
from shapely.geometry import Polygon

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.check.fault import Fault
from apartgen.stages.check.shapes import TOUCH, Gate, gate, meeting

PASSAGES = ("door", "opening", "entrance")
AREA, CEILING, PASSAGE = (0.5, 500.0), (1.9, 10.0), 1.9
"""Of rooms, m²; of storeys, and least of what one walks through, m."""
WALL = 1.0
"""No wall is thicker, m."""
WIDTH = {"door": (0.6, 2.5), "entrance": (0.7, 3.0), "opening": (0.6, 15.0), "window": (0.15, 15.0)}


class Site(NamedTuple):
    """What can be made out of a plan: floors by room, gates by opening, those of them with a leaf; and all that is no
    wall, contact included.
    """

    rooms: dict[str, Polygon]
    gates: list[tuple[Opening, Gate]]
    doors: list[tuple[Opening, Gate]]
    open: Geometry


def thickest(home: Plan) -> float:
    """How far floors may be from the middle of a wall, m."""
    return min(max(home.walls.inner, home.walls.outer), WALL)


def site(home: Plan) -> Site:
    """The shapes of a plan whose rooms have proper outlines."""
    rooms = {room.id: Polygon(room.polygon) for room in home.rooms}
    gates = [(o, gate(o, rooms, thickest(home))) for o in home.openings]
    cuts = [it.cut() for o, it in gates if o.kind in PASSAGES]
    wide = shapely.union_all([*rooms.values(), *cuts]).buffer(TOUCH, join_style="mitre")
    shapely.prepare(wide)
    doors = [(o, it) for o, it in gates if o.kind in ("door", "entrance") and o.into in it.sides]
    return Site(rooms, gates, doors, wide)


def faults(home: Plan, site: Site) -> Iterator[Fault]:
    """Everything wrong with a plan."""
    yield from _rooms(home, site)
    for o, it in site.gates:
        yield from _opening(o, it, home, site)
    for i, j in meeting([it.line().buffer(TOUCH, cap_style="flat") for _, it in site.gates]):
        (o, one), (p, two) = site.gates[i], site.gates[j]
        cut = one.line().buffer(TOUCH, cap_style="flat").intersection(two.line())
        if cut.length > TOUCH and min(o.head, p.head) > max(o.sill, p.sill):
            yield Fault("openings-cross", (o.id, p.id), (cut.centroid.x, cut.centroid.y), cut.length)
    yield from _ways(home)


def _rooms(home: Plan, site: Site) -> Iterator[Fault]:
    if not CEILING[0] <= home.height <= CEILING[1]:
        yield Fault("ceiling", (), (), home.height)
    for room in home.rooms:
        if not AREA[0] <= (area := site.rooms[room.id].area) <= AREA[1]:
            yield Fault("area", (room.id,), room.polygon[0], area)
    built = {room.id for room in home.rooms}
    yield from (Fault("not-built", (room.id,)) for room in home.program.rooms if room.id not in built)
    names, floors = list(site.rooms), list(site.rooms.values())
    for i, j in meeting(floors):
        if not (both := floors[i].intersection(floors[j])).buffer(-TOUCH / 2).is_empty:
            at = both.representative_point()
            yield Fault("rooms-overlap", (names[i], names[j]), (at.x, at.y), both.area)


def _opening(o: Opening, it: Gate, home: Plan, site: Site) -> Iterator[Fault]:
    at, wide, walked = it.middle, it.line().length, o.kind in PASSAGES
    if not WIDTH[o.kind][0] <= wide <= WIDTH[o.kind][1]:
        yield Fault("opening-width", (o.id,), at, wide)
    beyond = o.sill < -TOUCH or o.head > home.height + TOUCH or (walked and o.sill > TOUCH)
    if beyond or o.head - o.sill < (PASSAGE if walked else TOUCH):
        yield Fault("opening-height", (o.id,), at, o.head - o.sill)
    for name in sorted(set(o.rooms) - it.sides.keys()):
        yield Fault("not-in-wall", (o.id, name), at, it.line().distance(site.rooms[name]))
    sides = {side for side, _ in it.sides.values()}
    if len(it.sides) > len(sides):
        yield Fault("not-between", (o.id, *o.rooms), at)
    for side in sides if len(o.rooms) == 1 else ():
        outside = it.strip(*sorted((0.0, -side * thickest(home))))
        seen = {room.id for room in home.rooms if room.base == "balcony" and o.kind == "window"}
        areas = {name: room.intersection(outside).area for name, room in site.rooms.items() if name not in seen}
        yield from (Fault("not-outside", (o.id, name), at, area) for name, area in areas.items() if area > TOUCH)


def _ways(home: Plan) -> Iterator[Fault]:
    pairs = {frozenset(o.rooms) for o in home.openings if o.kind in PASSAGES and len(o.rooms) == 2}
    entered = {o.rooms[0] for o in home.openings if o.kind == "entrance"}
    if not entered:
        yield Fault("no-entrance", ())
    reached = entered or {home.rooms[0].id}
    while more := [pair for pair in pairs if len(pair & reached) == 1]:
        reached = reached.union(*more)
    yield from (Fault("cut-off", (room.id,), room.polygon[0]) for room in home.rooms if room.id not in reached)
    asked = dict.fromkeys(map(frozenset, (*home.program.links, *home.program.open_links)))
    yield from (Fault("no-link", tuple(sorted(link)), refuses=not home.relaxed) for link in asked if link not in pairs)

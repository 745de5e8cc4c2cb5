"""The building itself as bodies: walls with openings cut, room linings, floors, ceilings, skirting, doors, windows.

Colliders are on floors, walls, ceilings, doors and panes; linings and trim only show. Ceilings are bodies of their
own, so that a user can leave them out.
"""

from functools import partial

import numpy as np
import shapely
from shapely import Geometry
from shapely.geometry import Polygon
from shapely.ops import unary_union

from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.stages.scene.joinery import Span, door, lining_of_passage, window
from apartgen.stages.space import polygons
from apartgen.stages.things import finishes, solids
from apartgen.stages.things.asset import Array, Collider, Link, Mesh
from apartgen.stages.things.body import Body, Kind

SLAB = 0.12
"""Thickness of floors, m."""
CEILING = 0.02
LINING = 0.012
"""Thickness of plaster and tiles on a room's walls, m; part of the wall."""
SKIRTING = (0.005, 0.07)
"""Thickness and height of skirting boards, m; so thin that they need no collider."""
PARAPET = 1.1
"""Height of a balcony's outer wall, m."""
GRAIN = 1e-6
"""Plans of walls are kept to this, m."""
CONCRETE = 2400.0  # kg/m³, for engines that want a mass of what never moves

Storey = tuple[Geometry, float, float]
"""A prism: its area, from which height to which."""
_ORIGIN = np.zeros(3)


def bodies(plan: Plan, shown: bool = True) -> list[Body]:
    """Every body of the shell, floors first; names are unique among them. Not `shown`, what only shows is left out."""
    storeys = _storeys(plan)
    leaves = [_opening(plan, opening, shown) for opening in plan.openings if not in_parapet(opening, plan)]
    ceilings = [_ceiling(plan, room, shown) for room in plan.rooms if room.base != "balcony"]
    solid = [_ground(plan, shown), _walls(plan, storeys, shown)]
    if not shown:
        return [*solid, *ceilings, *leaves]
    floors = [_floor(plan, room) for room in plan.rooms]
    linings = [lined for room in plan.rooms for lined in _linings(plan, room, storeys)]
    return [solid[0], *floors, solid[1], *linings, *ceilings, *leaves]


def _still(name: str, kind: Kind, room: str, visuals: list[Mesh], colliders: list[Collider] | None = None) -> Body:
    volume = sum(float(np.prod(c.size)) for c in colliders or [])
    link = Link("base", visuals, colliders or [], max(1.0, CONCRETE * volume))
    return Body(name, kind, kind, room, _ORIGIN, 0.0, [link], id=room)


def _ground(plan: Plan, shown: bool) -> Body:
    """One slab under everything, so that nothing rolls over seams; it shows in thresholds and under walls."""
    shell = polygons.shell(plan)
    x0, y0, x1, y1 = shell.bounds
    solid = [solids.slab((x0, y0, -SLAB), (x1, y1, 0.0))]
    if not shown:
        return _still("ground", "floor", "", [], solid)
    below = solids.extruded(shell, -SLAB, -0.004, finishes.CONCRETE)
    sills = [polygons.threshold(o, plan) for o in plan.openings if o.kind in polygons.PASSAGES]
    flush = unary_union(sills).difference(unary_union(list(polygons.floors(plan).values())))
    faces = [below] if flush.is_empty else [below, solids.extruded(flush, -0.004, 0.0, finishes.threshold(plan))]
    return _still("ground", "floor", "", faces, solid)


def _floor(plan: Plan, room: Room) -> Body:
    covering = solids.extruded(polygons.floor(room), -0.004, 0.0, finishes.floor(room, plan))
    return _still(f"floor_{room.id}", "floor", room.id, [covering])


def _ceiling(plan: Plan, room: Room, shown: bool) -> Body:
    area = polygons.floor(room)
    top = plan.height + CEILING
    visuals = [solids.extruded(area, plan.height, top, finishes.CEILING)] if shown else []
    return _still(f"ceiling_{room.id}", "ceiling", room.id, visuals, solids.convex(area, plan.height, top))


def _cut(opening: Opening, plan: Plan) -> Polygon:
    """What an opening takes out of its wall, seen from above, and no more."""
    own = [polygons.floor(room) for room in plan.rooms if room.id in opening.rooms]
    return polygons.threshold(opening, plan).difference(unary_union(own))


def in_parapet(opening: Opening, plan: Plan) -> bool:
    """Whether a window is where the wall is only a balcony's parapet, so that there is nothing to glaze."""
    return opening.kind == "window" and low(plan).contains(_cut(opening, plan).centroid)


def low(plan: Plan) -> Geometry:
    """Where walls are only parapets: about balconies and nothing else."""
    indoors = [room for room in plan.rooms if room.base != "balcony"]
    if not indoors or len(indoors) == len(plan.rooms):
        return Polygon()
    return polygons.shell(plan).difference(polygons.shell(plan.model_copy(update={"rooms": indoors})))


def _storeys(plan: Plan) -> list[Storey]:
    """Wall bodies as prisms: the wall proper, what is above openings, what is below windows."""
    cuts = {o.id: _cut(o, plan) for o in plan.openings if not in_parapet(o, plan)}
    solid = polygons.shell(plan).difference(unary_union([*polygons.floors(plan).values(), *cuts.values()]))
    about = low(plan)
    pieces = [(solid.difference(about), 0.0, plan.height), (solid.intersection(about), 0.0, PARAPET)]
    for opening in (o for o in plan.openings if o.id in cuts):
        area = cuts[opening.id]
        top = PARAPET if about.contains(area.centroid) else plan.height
        pieces += [(area, 0.0, min(opening.sill, top)), (area, opening.head, top)]
    clean = [(_clean(area), z0, z1) for area, z0, z1 in pieces]
    return [(area, z0, z1) for area, z0, z1 in clean if area.area > 1e-6 and z1 - z0 > 1e-3]


def _clean(area: Geometry) -> Geometry:
    """Without the spikes that rounding leaves along a cut, which would stand as sheets across the opening."""
    return shapely.set_precision(area, GRAIN)


def _walls(plan: Plan, storeys: list[Storey], shown: bool) -> Body:
    solid = [c for area, z0, z1 in storeys for c in solids.convex(area, z0, z1)]
    if not shown:
        return _still("walls", "wall", "", [], solid)
    lined = unary_union([_skin(polygons.floor(room)) for room in plan.rooms])
    cores = [(_clean(area.difference(lined)), z0, z1) for area, z0, z1 in storeys]
    visuals = [solids.extruded(area, z0, z1, finishes.WALL) for area, z0, z1 in cores if area.area > 1e-6]
    return _still("walls", "wall", "", visuals, solid)


def _skin(floor: Polygon) -> Geometry:
    """The outermost layer of the walls about a floor."""
    return floor.buffer(LINING, join_style="mitre").difference(floor)


def _linings(plan: Plan, room: Room, storeys: list[Storey]) -> list[Body]:
    """The room's own finish of the walls about it, and its skirting."""
    floor = polygons.floor(room)
    skin = _skin(floor)
    finish = finishes.wall(room, plan)
    layers = [(_clean(skin.intersection(area)), z0, z1) for area, z0, z1 in storeys]
    faces = [solids.extruded(area, z0, z1, finish) for area, z0, z1 in layers if area.area > 1e-6]
    found = [_still(f"lining_{room.id}", "lining", room.id, faces)]
    board = _skirting(plan, room, floor)
    if not board.is_empty:
        shown = solids.extruded(board, 0.0, SKIRTING[1], finishes.skirting(room, plan))
        found.append(_still(f"skirting_{room.id}", "trim", room.id, [shown]))
    return found


def _skirting(plan: Plan, room: Room, floor: Polygon) -> Geometry:
    if not finishes.has_skirting(room.base):
        return Polygon()
    open_ = [_cut(o, plan).buffer(0.07, join_style="mitre") for o in plan.openings if o.kind in polygons.PASSAGES]
    return floor.difference(floor.buffer(-SKIRTING[0], join_style="mitre")).difference(unary_union(open_))


def _opening(plan: Plan, opening: Opening, shown: bool) -> Body:
    """Door, window or lined passage in its own frame: origin on the floor in the middle of the wall's opening."""
    span, position, yaw = frame(plan, opening)
    hung = partial(door, hinge=hinge(opening, plan))
    make = {"window": window, "opening": lining_of_passage}.get(opening.kind, hung)
    links = make(polygons.width(opening), span, opening, finishes.joinery(opening, plan), shown=shown)
    kind: Kind = {"window": "window", "opening": "trim"}.get(opening.kind, "door")  # type: ignore[assignment]
    name = opening.id if opening.id.startswith(kind) else f"{kind}_{opening.id}"
    towards = opening.into or opening.rooms[0]
    return Body(name, kind, opening.kind, towards, position, yaw, links, id=opening.id)


def frame(plan: Plan, opening: Opening) -> tuple[Span, Array, float]:
    """Where the wall's faces lie in an opening's own frame, and that frame's origin (3,) and yaw."""
    towards = opening.into or opening.rooms[0]
    normal, reach = polygons.face(opening, plan, towards)
    others = [room for room in opening.rooms if room != towards]
    beyond = polygons.face(opening, plan, others[0])[1] if others else reach
    middle = np.mean(np.asarray(opening.segment, float), axis=0)
    return (-beyond, reach), np.array([*middle, 0.0]), float(np.arctan2(normal[1], normal[0]))


def hinge(opening: Opening, plan: Plan) -> int:
    """Which side the leaf hangs on seen from the room it opens to: +1 to the left (+y), -1 to the right, 0 no leaf."""
    turn = polygons.hinge(opening, plan)
    if turn is None:
        return 0
    left = np.array([-turn.opened[1], turn.opened[0]])
    return -1 if float(turn.shut @ left) > 0 else 1

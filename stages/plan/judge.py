"""An independent judge of plans: every hard requirement, from the finished geometry alone.

Shares the housing standards and `apartgen.stages.space.polygons` with the rest, and nothing with the solver.
"""

from collections import Counter
from collections.abc import Iterator
from itertools import compress

import networkx as nx
import numpy as np
import shapely
from shapely.geometry import LineString, Polygon
from shapely.ops import unary_union

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.robot.reach import LEVER
from apartgen.stages.space import polygons

LENGTHS_OFF = 0.005
"""Tolerance of lengths, m."""
AREAS_OFF = 0.001
"""Tolerance of areas, as a share: corners of plans are rounded when these are turned into place."""
DEEP = 3.0
"""Depth of open air required before a window or an entrance, m."""
WAY = 0.58
"""Width of the way to every door past leaves that stand open, m: that of the common robot, with room for a raster."""
THICKEST = 0.4
"""Floors further apart than this have more than a wall between them, m."""
GREATEST_ASPECT = 2.2


def faults(plan: Plan) -> list[str]:
    """What is wrong, in words; empty for a plan that meets every hard requirement."""
    shapes = polygons.floors(plan)
    broken = list(_polygons(plan, shapes))
    if broken:
        return broken
    checks = (_apart, _sizes, _graph, _ways, _seats, _daylight, _leaves, _connected)
    return [fault for check in checks for fault in check(plan, shapes)]


Shapes = dict[str, Polygon]


def _polygons(plan: Plan, shapes: Shapes) -> Iterator[str]:
    if sorted(r.id for r in plan.rooms) != sorted(r.id for r in plan.program.rooms):
        yield "the rooms built are not the rooms asked for"
    asked = {r.id: r.type for r in plan.program.rooms}
    for room in plan.rooms:
        shape = shapes[room.id]
        if asked.get(room.id, room.type) != room.type:
            yield f"{room.id} is a {room.type}, not a {asked[room.id]}"
        if not shape.is_valid or not shape.exterior.is_ccw:
            yield f"{room.id}: the polygon is not simple and counter-clockwise"


def _apart(plan: Plan, shapes: Shapes) -> Iterator[str]:
    names, floors = list(shapes), np.array(list(shapes.values()), dtype=object)
    for i, a in enumerate(names):
        near = shapely.distance(floors[i], floors[i + 1 :]) < plan.walls.inner - LENGTHS_OFF
        yield from (f"{a} and {b} are closer than a wall" for b in compress(names[i + 1 :], near))
    joined = shapely.union_all(list(shapes.values())).buffer(THICKEST / 2, join_style="mitre")
    if len(shapely.get_parts(joined)) > 1:
        yield "the rooms do not form one building"
    elif joined.interiors:
        yield "there is a hole between the rooms"


def _sizes(plan: Plan, shapes: Shapes) -> Iterator[str]:
    asked = {r.id: r.area for r in plan.program.rooms}
    for room in plan.rooms:
        norm, shape = STANDARDS[room.base], shapes[room.id]
        want = asked[room.id] or shape.area
        least = min(norm.area, want)
        if shape.area < 0.8 * least:
            yield f"{room.id} has {shape.area:.1f} m², less than the least of {norm.area:g}"
        off = abs(shape.area / max(want, norm.area) - 1) - AREAS_OFF
        if not plan.relaxed and off > (0.5 if room.base == "hallway" else 0.2):
            yield f"{room.id} has {shape.area:.1f} m² instead of {want:.1f}"
        width = min(norm.width, 0.9 * np.sqrt(max(want, norm.area)))
        if shape.buffer(-width / 2 + LENGTHS_OFF, join_style="mitre").is_empty:
            yield f"{room.id} is narrower than {width:.2f} m"
        if shape.buffer(-min(width, 1.1) / 2 + LENGTHS_OFF, join_style="mitre").geom_type != "Polygon":
            yield f"{room.id} has a neck narrower than {min(width, 1.1):.2f} m"
        x0, y0, x1, y1 = shape.bounds
        long, short = max(x1 - x0, y1 - y0), min(x1 - x0, y1 - y0)
        if norm.functional and not plan.relaxed and long > (GREATEST_ASPECT + 0.05) * short:
            yield f"{room.id} is long and thin"


def _graph(plan: Plan, shapes: Shapes) -> Iterator[str]:
    want = dict.fromkeys(frozenset(p) for p in [*plan.program.links, *plan.program.open_links])
    built = Counter(frozenset(o.rooms) for o in plan.openings if o.kind in ("door", "opening"))
    for pair in want:
        if built[pair] != 1:
            yield f"{' and '.join(sorted(pair))} are joined by {built[pair]} openings instead of one"
    for pair in built:
        if pair not in want:
            yield f"{' and '.join(sorted(pair))} are joined though nobody asked"
    wide = {frozenset(o.rooms) for o in plan.openings if o.kind == "opening"}
    if wide != {frozenset(p) for p in plan.program.open_links}:
        yield "the wall-less openings are not those asked for"
    if sum(o.kind == "entrance" for o in plan.openings) != 1:
        yield "there is not exactly one entrance"


def _ways(plan: Plan, shapes: Shapes) -> Iterator[str]:
    types = {r.id: r.base for r in plan.rooms}
    graph = nx.Graph([tuple(o.rooms) for o in plan.openings if o.kind in ("door", "opening")])
    graph.add_nodes_from(types)
    start = next((o.rooms[0] for o in plan.openings if o.kind == "entrance"), plan.rooms[0].id)
    private = {r.id for r in plan.program.rooms if r.private_to}
    for room, kind in types.items():
        if not nx.has_path(graph, start, room):
            yield f"{room} cannot be reached"
        elif kind in ("living_room", "kitchen", "dining_room", "bedroom", "hallway") and room not in private:
            barred = [r for r, t in types.items() if t in ("bedroom", "bathroom") and r not in (room, start)]
            if not nx.has_path(graph.subgraph(set(types) - set(barred)), start, room):
                yield f"{room} can only be reached through a bedroom or bathroom"


def _strip(opening: Opening, normal: np.ndarray, lo: float, hi: float) -> Polygon:
    a, b = np.asarray(opening.segment)
    corners = np.array([p + d * normal for p in (a, b) for d in (lo, hi)])
    return shapely.convex_hull(shapely.multipoints(corners))


def _seats(plan: Plan, shapes: Shapes) -> Iterator[str]:
    """Openings cut the wall they say they cut, over their whole width, and nothing else."""
    hung = {r.id: r.base == "balcony" and _stands_off(r.id, plan, shapes) for r in plan.rooms}
    floors = np.array(list(shapes.values()), dtype=object)
    walled = np.array([not hung[room] for room in shapes])
    wider = {room: shape.buffer(LENGTHS_OFF) for room, shape in shapes.items()}
    for opening in plan.openings:
        line = LineString(opening.segment)
        for room in opening.rooms:
            normal, reach = polygons.face(opening, plan, room)
            if not wider[room].covers(_strip(opening, normal, reach, reach + 0.05)):
                yield f"{opening.id} does not open onto {room} over its whole width"
        if len(opening.rooms) == 1:
            normal, reach = polygons.face(opening, plan, opening.rooms[0])
            ahead = _strip(opening, normal, -DEEP, -reach)
            inside = floors[walled] if opening.kind == "window" else floors
            if (_common(ahead, inside) > LENGTHS_OFF).any():
                yield f"{opening.id} does not lead into the open air"
        reaches = [polygons.face(opening, plan, room)[1] for room in opening.rooms]
        deep = reaches[1] if len(reaches) > 1 else plan.walls.outer / 2
        if abs(reaches[0] - deep) > LENGTHS_OFF or deep > THICKEST:
            yield f"{opening.id} is not on the centre line of its wall"
        if shapely.intersects(line, floors).any():
            yield f"{opening.id} lies on a floor"
        least = {"door": 0.75, "entrance": 0.85, "opening": 0.9, "window": 0.45}[opening.kind]
        if line.length < least:
            yield f"{opening.id} is only {line.length:.2f} m wide"
    cuts = np.array([polygons.threshold(o, plan) for o in plan.openings], dtype=object)
    for i, opening in enumerate(plan.openings):
        same = _common(cuts[i], cuts[i + 1 :]) > 1e-4
        yield from (f"{opening.id} and {o.id} cut the same wall" for o in compress(plan.openings[i + 1 :], same))


def _common(shape: Polygon, others: np.ndarray) -> np.ndarray:
    """Area that a shape has in common with each of others, m² (n,)."""
    area: np.ndarray = shapely.area(shapely.intersection(shape, others))
    return area


def _stands_off(balcony: str, plan: Plan, shapes: Shapes) -> bool:
    """Whether a balcony hangs outside: an outer wall between it and every room."""
    least = plan.walls.outer - LENGTHS_OFF
    return all(shapes[r.id].distance(shapes[balcony]) > least for r in plan.rooms if r.id != balcony)


def _daylight(plan: Plan, shapes: Shapes) -> Iterator[str]:
    types = {r.id: r.base for r in plan.rooms}
    lit = {o.rooms[0] for o in plan.openings if o.kind == "window"}
    lit |= {r for o in plan.openings if o.kind == "door" and "balcony" in (types[r] for r in o.rooms) for r in o.rooms}
    joined = {r for pair in plan.program.open_links for r in pair}
    for room, kind in types.items():
        if STANDARDS[kind].lit and room not in lit and not (kind == "kitchen" and room in joined):
            yield f"{room} has no window"
        if kind in ("closet", "storage") and room in lit:
            yield f"{room} has a window"
    names = {(0, 1): "north", (0, -1): "south", (1, 0): "east", (-1, 0): "west"}
    for opening in plan.openings:
        if len(opening.rooms) == 1:
            out = -polygons.face(opening, plan, opening.rooms[0])[0]
            side = max(names, key=lambda d: float(np.dot(d, out)))
            if opening.kind == "window" and names[side] in plan.program.envelope.party_walls:
                yield f"{opening.id} is in a party wall"
            asked = plan.program.envelope.entrance
            if opening.kind == "entrance" and asked and names[side] != asked:
                yield f"the entrance is on the {names[side]}, not the {asked}"


def _leaves(plan: Plan, shapes: Shapes) -> Iterator[str]:
    hung = [o for o in plan.openings if o.kind in ("door", "entrance")]
    for door in hung:
        if door.into not in door.rooms:
            yield f"{door.id} opens into no room of its own"
    swept = np.array([polygons.swing(o, plan) for o in hung], dtype=object)
    passages = [o for o in plan.openings if o.kind in polygons.PASSAGES]
    ways = np.array([polygons.threshold(o, plan).buffer(0.1) for o in passages], dtype=object)
    for door, sweep in zip(hung, swept, strict=True):
        if door.into and sweep.difference(shapes[door.into].buffer(0.02, join_style="mitre")).area > 1e-3:
            yield f"the leaf of {door.id} meets a wall"
        for other in compress(passages, _common(sweep, ways) > 1e-3):
            if other.id != door.id:
                yield f"the leaf of {door.id} stands in {other.id}"
    for i, door in enumerate(hung):
        met = _common(swept[i], swept[i + 1 :]) > 1e-4
        yield from (f"the leaves of {door.id} and {other.id} meet" for other in compress(hung[i + 1 :], met))


def _connected(plan: Plan, shapes: Shapes) -> Iterator[str]:
    floor = polygons.free_floor(plan)
    free = floor.buffer(-0.25, join_style="mitre").buffer(0.01)
    if len(shapely.get_parts(free)) > 1:
        yield "the floor falls into parts for someone 0.5 m wide"
        return
    leaves = [polygons.leaf(o, plan).buffer(LEVER) for o in plan.openings if o.kind == "door"]
    ways = shapely.get_parts(floor.difference(unary_union(leaves)).buffer(-WAY / 2))
    main = max(ways, key=lambda part: part.area, default=Polygon())
    for o in plan.openings:
        if o.kind not in polygons.PASSAGES:
            continue
        door, outer = polygons.threshold(o, plan), len(o.rooms) == 1
        far = main.distance(door)
        # Through a wall the main part may be nearer to the entrance than one thinks: then another one is nearer still.
        if far > WAY * outer or (outer and float(shapely.distance(ways, door).min()) < far):
            yield f"nobody {WAY} m wide gets to {o.id} while the doors stand open"

"""Plans drawn by hand: polygons only, made into floors with walls between, then given doors and windows."""

import heapq
from itertools import combinations

from shapely.geometry import Polygon

from apartgen.schemas.base import RoomType
from apartgen.schemas.consistency import too_wide
from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import AskedRoom, Link, Plan, Program, Room
from apartgen.stages.plan import doors, faces, windows
from apartgen.stages.plan.check import check
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.plan.outline import ring
from apartgen.stages.plan.standards import LINK_WALL
from apartgen.stages.plan.turn import askew, turned, turned_plan

Floors = dict[str, Polygon]
LEADS: dict[RoomType, int] = {"hallway": 0, "living_room": 1, "dining_room": 2, "kitchen": 3, "study": 6}
"""How unwillingly a room leads on to others; those not named do so only where nothing else can."""
LAST = 9


def built(rooms: list[Room], config: PlanConfig, program: Program | None) -> Plan:
    """See `apartgen.stages.plan.from_polygons`."""
    angle = askew([Polygon(room.polygon) for room in rooms])
    rooms = [room.model_copy(update={"polygon": turned(room.polygon, -angle)}) for room in rooms]
    floors = inset(rooms, config.walls.inner)
    if program is None:
        program = programme(rooms, floors)
    if {r.id: r.type for r in rooms} != {r.id: r.type for r in program.rooms}:
        raise BadInput("rooms: their ids and types differ from program.rooms")
    check(program)
    try:
        passages = doors.place(program, floors, config.walls)
    except Unmet as e:
        raise Unmet(f"{e}: move the walls, or change program.links") from e
    glass = windows.place(program, floors, passages, config.walls)
    dark = [f"{room} has no outside wall for a window" for room in windows.dark(program, glass)]
    drawn = [Room(id=r.id, type=r.type, polygon=ring(floors[r.id])) for r in rooms]
    plan = Plan(program=program, rooms=drawn, openings=[*passages, *glass], height=config.height, walls=config.walls)
    return turned_plan(plan.model_copy(update={"relaxed": dark}), angle)


def inset(rooms: list[Room], inner: float) -> Floors:
    """Clear floors: a room closer to another than a wall gives way all around by half of what lacks."""
    if wrong := too_wide([point for room in rooms for point in room.polygon]):
        raise BadInput(f"rooms: what they cover {wrong}")
    shapes = {room.id: Polygon(room.polygon) for room in rooms}
    for name, shape in shapes.items():
        if not shape.is_valid or shape.area < 0.5:
            raise BadInput(f"rooms: the polygon of {name} crosses itself or is smaller than 0.5 m²")
    lack = dict.fromkeys(shapes, 0.0)
    for a, b in combinations(shapes, 2):
        if shapes[a].intersection(shapes[b]).area > 0.02:
            raise BadInput(f"rooms: {a} and {b} overlap by {shapes[a].intersection(shapes[b]).area:.2f} m²")
        short = inner - shapes[a].distance(shapes[b])
        if short > 1e-4 and _side_by_side(shapes[a], shapes[b], inner):
            lack[a], lack[b] = max(lack[a], short), max(lack[b], short)
    out = {name: shape.buffer(-lack[name] / 2, join_style="mitre").simplify(1e-6) for name, shape in shapes.items()}
    for name, floor in out.items():
        if not isinstance(floor, Polygon) or floor.is_empty:
            raise BadInput(f"rooms: {name} is too narrow to keep a floor between its walls")
    return out


def _side_by_side(a: Polygon, b: Polygon, inner: float) -> bool:
    shared = a.buffer(inner / 2 + 0.01).intersection(b.buffer(inner / 2 + 0.01))
    return bool(shared.length > 4 * inner + 0.2)


def programme(rooms: list[Room], floors: Floors) -> Program:
    """What a drawn plan asks for: its rooms and areas, linked by a tree of doors that spares private rooms."""
    if not rooms:
        raise BadInput("rooms: there is none")
    types = {room.id: room.base for room in rooms}
    near = [(a, b) for a, b in combinations(types, 2) if _doorway(floors[a], floors[b])]
    asked = [AskedRoom(id=r.id, type=r.type, area=round(float(floors[r.id].area), 2), private_to=None) for r in rooms]
    found = _tree(types, near)
    lost = sorted(set(types) - {r for pair in found for r in pair})
    if lost and len(rooms) > 1:
        raise Unmet(f"{lost[0]} shares no {LINK_WALL} m of straight wall with a room one can enter it from")
    owners = {b: a for a, b in found if types[a] in ("bedroom", "bathroom")}
    asked = [room.model_copy(update={"private_to": owners.get(room.id)}) for room in asked]
    return Program(rooms=asked, links=found, complete=True, regularity=0.7)


def _doorway(a: Polygon, b: Polygon) -> bool:
    found = faces.between(a, b)
    return bool(found) and found[0].length >= LINK_WALL - 1e-6


def _tree(types: dict[str, RoomType], near: list[tuple[str, str]]) -> list[Link]:
    """Prim's spanning tree from the hallway; entering a room from a corridor costs least, from a bedroom most."""
    start = min(types, key=lambda r: (LEADS.get(types[r], LAST), r))
    inside, out = {start}, list[Link]()
    heap = [(cost(types, start, b), start, b) for b in _beside(start, near)]
    heapq.heapify(heap)
    while heap:
        _, a, b = heapq.heappop(heap)
        if b in inside:
            continue
        inside.add(b)
        out.append((a, b))
        for c in _beside(b, near):
            heapq.heappush(heap, (cost(types, b, c), b, c))
    return out


def _beside(room: str, near: list[tuple[str, str]]) -> list[str]:
    return [b if a == room else a for a, b in near if room in (a, b)]


def cost(types: dict[str, RoomType], a: str, b: str) -> int:
    own = types[a] == "bedroom" and types[b] in ("bathroom", "closet", "balcony")
    return 5 if own else LEADS.get(types[a], LAST)

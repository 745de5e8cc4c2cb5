"""Doors, wall-less openings and the entrance: where they cut their walls and how their leaves turn.

Every link has many possible doors (place, hinge side, room it opens into). A search takes the cheapest combination in
which no leaf meets another leaf or stands in another doorway.
"""

from itertools import compress

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.base import RoomType
from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Opening, Program, Walls
from apartgen.stages.plan import faces, leading, unwalled
from apartgen.stages.plan.blocks import entrance_sides, facing
from apartgen.stages.plan.check import entrance_room, links, neighbours
from apartgen.stages.plan.faces import Face
from apartgen.stages.plan.standards import LINK_WALL, STANDARDS
from apartgen.stages.plan.swings import NOWHERE, Box, Choice, Column, Depths, together
from apartgen.stages.plan.unwalled import FRAME

Floors = dict[str, Polygon]
HEAD, OPEN_HEAD, GLAZED_HEAD = 2.1, 2.3, 2.2
ENTRANCE = 0.95
APPROACHES = ((0.7, 0.7), (0.35, 0.55), (0.12, 0.55), (0.12, 0.12))
"""Depths of floor before a door, m, over which no other leaf turns, and in which none stands open; the next where the
one before cannot be had."""
BARS, PASSED = 8.0, 0.32
"""Cost of a leaf that, standing open, cuts the hallway it opens into; half the width one passes by it and its lever
in, m."""
LEAF = 0.05
"""Thickness of a leaf that stands open, m."""
ASIDE, HALVED = 1.1, 0.7
"""So far from a corner, m, a door begins to halve the wall for furniture; cost of a metre more, up to one."""
WITHIN, AS_FAR = 0.05, 20.0
"""A wall is followed so deep in its room, m, and no farther than that."""


def place(program: Program, floors: Floors, walls: Walls) -> list[Opening]:
    """Openings for all links and the entrance; raises Unmet naming the door that finds no place."""
    *wider, least = APPROACHES
    for deep in wider:
        try:
            return _placed_all(program, floors, walls, deep)
        except Unmet:
            continue
    return _placed_all(program, floors, walls, least)


def _placed_all(program: Program, floors: Floors, walls: Walls, deep: Depths) -> list[Opening]:
    columns = _columns(program, floors, walls, deep)
    chosen = together(columns)
    return [_built(column, choice, i + 1) for i, (column, choice) in enumerate(zip(columns, chosen, strict=True))]


def _columns(program: Program, floors: Floors, walls: Walls, deep: Depths) -> list[Column]:
    """What is to be placed; raises Unmet naming what no wall has room for."""
    types = {room.id: room.base for room in program.rooms}
    open_links = {frozenset(pair) for pair in program.open_links}
    first = entrance_room(program).id
    far = _doors_from(program, first)
    entrances = _entrances(program, first, floors, walls, deep)
    columns = []
    for a, b in links(program):
        found = faces.between(floors[a], floors[b])
        if frozenset((a, b)) in open_links:
            wide = [face for face in found[:1] if face.length >= LINK_WALL]
            ends = [unwalled.span(face, *_cooked_in(program, floors, (a, b))) for face in wide]
            choices = [_unwalled(face, *span, deep) for face, span in zip(wide, ends, strict=True)]
            columns.append(Column("opening", [a, b], choices, OPEN_HEAD))
        else:
            head = GLAZED_HEAD if "balcony" in (types[a], types[b]) else HEAD
            choices = _doors(a, b, found, floors, types, deep)
            if entrances and {types[a], types[b]} == {types[first], "living_room"} and first in (a, b):
                choices = leading.nearest(choices, entrances[0])
            elif entrances:
                behind = floors[max((a, b), key=lambda room: far.get(room, 0))]
                choices = leading.on_the_way(choices, leading.middle(entrances[0]), behind, program)
            columns.append(Column("door", [a, b], choices, head))
    private = program.weights.get("privacy", 1.0)
    columns = leading.served(columns, types, leading.SERVED / max(private, 1.0))
    if entrances:
        columns = leading.retired(columns, types, leading.middle(entrances[0]), leading.RETIRED * private)
    columns.append(Column("entrance", [first], leading.about(entrances), HEAD))
    for column in columns:
        if not column.choices:
            raise Unmet(f"no wall has room for the {column.kind} of {' and '.join(column.rooms)}")
    return columns


def _built(column: Column, choice: Choice, number: int) -> Opening:
    return Opening(
        id=f"{column.kind}_{number if column.kind != 'entrance' else 1}",
        kind=column.kind,
        rooms=column.rooms,
        segment=choice.face.segment(choice.lo, choice.hi, (choice.face.gap or 0.0) / 2),
        sill=0.0,
        head=column.head,
        hinge=choice.hinge,
        into=choice.into,
    )


def _cooked_in(program: Program, floors: Floors, pair: tuple[str, str]) -> tuple[Polygon | None, shapely.Geometry]:
    """The kitchen of two rooms, and the floors that doors lead to from it."""
    kitchen = next((room.id for room in program.rooms if room.id in pair and room.base == "kitchen"), None)
    behind = [floors[one] for link in links(program) if kitchen in link for one in link if one not in pair]
    return None if kitchen is None else floors[kitchen], shapely.union_all(behind)


def _unwalled(face: Face, lo: float, hi: float, deep: Depths) -> Choice:
    front, way = (_fronts(face, lo, hi, depth) for depth in deep)
    return Choice(face, lo, hi, 0, None, 0.0, NOWHERE, NOWHERE, front, way)


def _box(face: Face, lo: float, hi: float, near: float, far: float) -> Box:
    (x, y), (u, v) = face.start.tolist(), face.along.tolist()
    a, b, c, d = x + lo * u, x + hi * u, near * v, far * v
    e, f, g, h = y + lo * v, y + hi * v, near * u, far * u
    return min(a, b) - max(c, d), min(e, f) + min(g, h), max(a, b) - min(c, d), max(e, f) + max(g, h)


def _fronts(face: Face, lo: float, hi: float, deep: float) -> tuple[Box, Box]:
    gap = face.gap or 0.0
    return _box(face, lo, hi, 0.0, deep), _box(face, lo, hi, -gap - deep, -gap)


def _doors(a: str, b: str, found: list[Face], floors: Floors, types: dict[str, RoomType], deep: Depths) -> list[Choice]:
    width = min(STANDARDS[types[r]].door for r in (a, b))
    better = _opens_into(a, b, types)
    out = []
    for face in (face for face in found if face.length >= width + 2 * FRAME - 1e-6):
        for into in (a, b):
            away = 0.0 if into == better else 5.0 if types[into] in ("closet", "storage") else 3.0
            out += _placed(face, width, into, floors[into], away, into == a, deep)
    halls = [room for room in (a, b) if types[room] == "hallway"]
    return _passing(_fitting(out, floors), {hall: floors[hall] for hall in halls})


def _opens_into(a: str, b: str, types: dict[str, RoomType]) -> str:
    """Leaves turn into the room at the end of the way; those of closets and balconies out of them."""
    rank = ["hallway", "living_room", "dining_room", "kitchen", "bedroom", "study", "utility", "bathroom"]
    shallow = [r for r in (a, b) if types[r] not in rank]
    if shallow:
        return b if shallow[0] == a else a
    return max((a, b), key=lambda r: (rank.index(types[r]), r))


def _entrances(program: Program, room: str, floors: Floors, walls: Walls, deep: Depths) -> list[Choice]:
    sides = entrance_sides(program.envelope)
    out = []
    for face in faces.outside(floors[room], [f for r, f in floors.items() if r != room]):
        if facing(*face.along) in sides and face.length >= ENTRANCE + 2 * FRAME - 1e-6:
            out += _placed(face._replace(gap=walls.outer), ENTRANCE, room, floors[room], 0.0, True, deep)
    return _fitting([leading.towards(choice, _first_seen(program, room, floors)) for choice in out], floors)


def _first_seen(program: Program, first: str, floors: Floors) -> shapely.Geometry | None:
    """What is near the entrance: the living room; of one that is entered itself, bath and kitchen."""
    living = [r.id for r in program.rooms if r.type == "living_room"]
    if living and first not in living:
        return floors[living[0]]
    apart = {one.of for one in program.requirements if one.kind == "apart" and one.to == "entrance"}
    wet = [r.id for r in program.rooms if r.base in ("bathroom", "kitchen") and r.id not in apart]
    return shapely.union_all([floors[room] for room in wet]) if living and wet else None


def _doors_from(program: Program, first: str) -> dict[str, int]:
    """How many doors lie between the room one enters and each room."""
    near, far, queue = neighbours(program), {first: 0}, [first]
    for here in queue:
        for there in near[here]:
            if there not in far:
                far[there] = far[here] + 1
                queue.append(there)
    return far


def _placed(face: Face, width: float, into: str, room: Polygon, extra: float, mine: bool, deep: Depths) -> list[Choice]:
    """Doors along a face; a leaf that opens flat against a side wall of its room costs least, one in mid-wall most."""
    slack = face.length - 2 * FRAME - width
    steps = [0.3 * i for i in range(int(slack / 0.3) + 1)]
    gap = face.gap or 0.0
    before, after = _beyond(face, room, mine)
    out = []
    for lo in sorted({FRAME + round(step, 4) for step in [*steps, slack / 2, slack]}):
        hi = lo + width
        sweep = _box(face, lo, hi, 0.0, width) if mine else _box(face, lo, hi, -gap - width, -gap)
        front, way = (_fronts(face, lo, hi, depth) for depth in deep)
        left, right = before + lo, face.length - hi + after
        middle = 0.6 * min(left, right, 1.5) + HALVED * min(max(min(left, right) - ASIDE, 0.0), 1.0)
        for hinge, beside in ((0, left), (1, right)):
            cost = extra + min(beside, 0.8) + middle
            edge = hi - LEAF if hinge else lo
            stands = _box(face, edge, edge + LEAF, *((0.0, width) if mine else (-gap - width, -gap)))
            out.append(Choice(face, lo, hi, hinge, into, cost, sweep, stands, front, way))  # type: ignore[arg-type]
    return out


def _beyond(face: Face, room: Polygon, mine: bool) -> tuple[float, float]:
    """How far the wall of a room goes on beyond either end of a face that is part of it, m."""
    deep = WITHIN if mine else -(face.gap or 0.0) - WITHIN
    at = face.start + deep * np.array([-face.along[1], face.along[0]])
    ends = np.stack([at - AS_FAR * face.along, at + (face.length + AS_FAR) * face.along])
    pieces = shapely.get_parts(shapely.intersection(shapely.linestrings(ends), room))
    middle = shapely.points(at + 0.5 * face.length * face.along)
    piece = pieces[int(np.argmin(shapely.distance(pieces, middle)))] if len(pieces) > 1 else pieces[0]
    along = (shapely.get_coordinates(piece) - at) @ face.along
    return max(0.0, -float(along.min())), max(0.0, float(along.max()) - face.length)


def _fitting(choices: list[Choice], floors: Floors) -> list[Choice]:
    """Those whose leaf finds room to turn, cheapest first."""
    out: list[Choice] = []
    for room in sorted({c.into for c in choices if c.into}):
        mine = [c for c in choices if c.into == room]
        whole = floors[room].buffer(0.005, join_style="mitre")
        inside = shapely.contains(whole, shapely.box(*np.array([c.sweep for c in mine]).T))
        out += [c for c, ok in zip(mine, inside, strict=True) if ok]
    return sorted(out, key=lambda c: c.cost)


def _passing(choices: list[Choice], halls: Floors) -> list[Choice]:
    """Choices, cheapest first; a leaf that nobody gets by where it stands open in a hallway costs more."""
    barring = {(hall, sweep) for hall, floor in halls.items() for sweep in _barring(choices, hall, floor)}
    dearer = [c._replace(cost=c.cost + BARS) if (c.into, c.sweep) in barring else c for c in choices]
    return sorted(dearer, key=lambda c: c.cost)


def _barring(choices: list[Choice], hall: str, floor: Polygon) -> list[Box]:
    """What leaves sweep in a hallway that leave no way along it."""
    swept = list(dict.fromkeys(choice.sweep for choice in choices if choice.into == hall))
    if not swept:
        return []
    left = shapely.buffer(shapely.difference(floor, shapely.box(*np.array(swept).T)), -PASSED)
    cut = shapely.get_num_geometries(left) > shapely.get_num_geometries(shapely.buffer(floor, -PASSED))
    return list(compress(swept, cut))

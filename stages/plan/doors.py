"""Doors, wall-less openings and the entrance: where they cut their walls and how their leaves turn.

Every link has many possible doors (place, hinge side, room it opens into). A search takes the cheapest combination in
which no leaf meets another leaf or stands in another doorway.
"""

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from schemas.plan import Opening, Program, Walls
from stages.plan import faces
from stages.plan.check import entrance_room, links
from stages.plan.faces import Face
from stages.plan.outline import entrance_sides, facing
from stages.plan.standards import STANDARDS

Array = NDArray[np.float64]
FRAME = 0.1
"""Least wall between a door and a corner, m."""
HEAD = 2.1
ENTRANCE = 0.95
APPROACH = 0.7
"""Depth of floor kept free of other leaves in front of a door, m."""
WIDEST = 3.2
"""Widest opening between open-plan rooms, m."""
TRIES = 4000


class Choice(NamedTuple):
    """One way to build a door: the opening, its cost, the box its leaf sweeps, and the boxes in front of it."""

    opening: Opening
    cost: float
    sweep: Array
    front: Array


def place(program: Program, floors: dict[str, Polygon], walls: Walls) -> list[Opening] | None:
    """Openings for all links and the entrance, or None where some door finds no place."""
    types = {room.id: room.type for room in program.rooms}
    open_links = {frozenset(pair) for pair in program.open_links}
    columns: list[list[Choice]] = []
    for i, (a, b) in enumerate(links(program)):
        found = faces.between(floors[a], floors[b])
        if frozenset((a, b)) in open_links:
            columns.append([_wide(f"opening_{i + 1}", a, b, face) for face in found[:1] if face.length >= 1.1])
        else:
            columns.append(_doors(f"door_{i + 1}", a, b, found, floors, types))
    columns.append(_entrances(program, floors, walls))
    return _search(columns)


def _wide(name: str, a: str, b: str, face: Face) -> Choice:
    clear = min(face.length - 2 * FRAME, WIDEST)
    lo = 0.5 * (face.length - clear)
    gap = face.gap or 0.0
    opening = Opening(
        id=name, kind="opening", rooms=[a, b], segment=face.segment(lo, lo + clear, gap / 2), sill=0.0, head=2.3
    )
    front = [_box(face, lo, lo + clear, 0.0, APPROACH), _box(face, lo, lo + clear, -gap - APPROACH, -gap)]
    return Choice(opening, 0.0, np.zeros(4), np.array(front))


def _box(face: Face, lo: float, hi: float, near: float, far: float) -> Array:
    corners = np.array([face.start + u * face.along + v * face.inward for u in (lo, hi) for v in (near, far)])
    return np.concatenate([corners.min(axis=0), corners.max(axis=0)])


def _doors(
    name: str, a: str, b: str, found: list[Face], floors: dict[str, Polygon], types: dict[str, str]
) -> list[Choice]:
    width = min(STANDARDS[types[r]].door for r in (a, b))  # type: ignore[index]
    out = []
    for face in found:
        if face.length < width + 2 * FRAME - 1e-6:
            continue
        for into in (a, b):
            away = 0.0 if into == _opens_into(a, b, types) else 3.0
            if types[into] in ("closet", "storage"):
                away += 2.0
            out += _placed(name, [a, b], face, width, into, floors[into], away, into == a)
    return _fitting(out, floors)


def _opens_into(a: str, b: str, types: dict[str, str]) -> str:
    """Leaves turn into the room at the end of the way, away from the corridor."""
    rank = ["hallway", "living_room", "dining_room", "kitchen", "bedroom", "study", "utility", "bathroom", "balcony"]
    if {"closet", "storage"} & {types[a], types[b]}:
        return a if types[b] in ("closet", "storage") else b
    if "balcony" in (types[a], types[b]):
        return a if types[b] == "balcony" else b
    return max((a, b), key=lambda r: (rank.index(types[r]), r))


def _entrances(program: Program, floors: dict[str, Polygon], walls: Walls) -> list[Choice]:
    room = entrance_room(program).id
    others = [f for r, f in floors.items() if r != room]
    out = []
    for face in faces.outside(floors[room], others):
        sides = entrance_sides(program.envelope)
        if facing(*face.along) not in sides or face.length < ENTRANCE + 2 * FRAME - 1e-6:
            continue
        outer = face._replace(gap=walls.outer)
        extra = 2.0 if facing(*face.along) in program.envelope.party_walls else 0.0
        out += _placed("entrance_1", [room], outer, ENTRANCE, room, floors[room], extra, True)
    return _fitting(out, floors)


def _placed(
    name: str, rooms: list[str], face: Face, width: float, into: str, floor: Polygon, extra: float, mine: bool
) -> list[Choice]:
    """Doors along a face; a leaf that opens flat against a side wall costs least, one in mid-wall most."""
    slack = face.length - 2 * FRAME - width
    places = FRAME + np.unique(np.concatenate([np.arange(0, slack, 0.3), [slack / 2, slack]]))
    gap = face.gap or 0.0
    out = []
    for lo in places:
        hi = lo + width
        middle = min(lo, face.length - hi)
        for hinge in (0, 1):
            opening = Opening(
                id=name, kind="entrance" if len(rooms) == 1 else "door", rooms=rooms,
                segment=face.segment(lo, hi, gap / 2), sill=0.0, head=HEAD, hinge=hinge, into=into,
            )  # fmt: skip
            beside = lo if hinge == 0 else face.length - hi
            cost = extra + min(beside, 0.8) + 0.6 * min(middle, 1.5)
            sweep = _box(face, lo, hi, 0.0, width) if mine else _box(face, lo, hi, -gap - width, -gap)
            front = [_box(face, lo, hi, 0.0, APPROACH), _box(face, lo, hi, -gap - APPROACH, -gap)]
            out.append(Choice(opening, float(cost), sweep, np.array(front[: len(rooms)])))
    return out


def _fitting(choices: list[Choice], floors: dict[str, Polygon]) -> list[Choice]:
    """Those whose leaf finds room to turn, cheapest first."""
    out: list[Choice] = []
    for room in sorted({c.opening.into for c in choices if c.opening.into}):
        mine = [c for c in choices if c.opening.into == room]
        whole = floors[room].buffer(0.005, join_style="mitre")
        inside = shapely.contains(whole, shapely.box(*np.array([c.sweep for c in mine]).T))
        out += [c for c, ok in zip(mine, inside, strict=True) if ok]
    return sorted(out, key=lambda c: c.cost)


def _meet(a: Array, b: Array) -> bool:
    return bool(min(a[2], b[2]) - max(a[0], b[0]) > 1e-3 and min(a[3], b[3]) - max(a[1], b[1]) > 1e-3)


def clash(a: Choice, b: Choice) -> bool:
    """Whether two doors get in each other's way."""
    if _meet(a.sweep, b.sweep):
        return True
    return any(_meet(a.sweep, front) for front in b.front) or any(_meet(b.sweep, front) for front in a.front)


def _search(columns: list[list[Choice]]) -> list[Opening] | None:
    """Depth-first over the columns, fewest choices first, bounded by the best cost found."""
    if not all(columns):
        return None
    ranked = sorted(range(len(columns)), key=lambda i: (len(columns[i]), i))
    rest = np.cumsum([columns[i][0].cost for i in reversed(ranked)])[::-1].tolist() + [0.0]
    best: tuple[float, list[Choice]] = (np.inf, [])
    left = TRIES

    def descend(depth: int, cost: float, taken: list[Choice]) -> None:
        nonlocal best, left
        if depth == len(ranked):
            best = (cost, list(taken))
            return
        for choice in columns[ranked[depth]]:
            left -= 1
            if left < 0 or cost + choice.cost + rest[depth + 1] >= best[0] - 1e-9:
                return
            if not any(clash(choice, other) for other in taken):
                descend(depth + 1, cost + choice.cost, [*taken, choice])

    descend(0, 0.0, [])
    if not best[1]:
        return None
    placed = {c.opening.id: c.opening for c in best[1]}
    return [placed[columns[i][0].opening.id] for i in range(len(columns))]

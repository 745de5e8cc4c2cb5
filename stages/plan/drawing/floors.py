"""Clear floors out of what a file draws: rooms without their walls, rooms that only walls enclose, and what is open."""

from itertools import combinations
from statistics import median
from typing import NamedTuple

import numpy as np
import shapely
from shapely import Geometry
from shapely.geometry import LineString, MultiLineString, Point, Polygon
from shapely.validation import explain_validity

from apartgen.schemas.errors import BadInput
from apartgen.stages.plan import faces
from apartgen.stages.plan.drawing import Drawing, Hole, Label, Space, names

SMALLEST = 0.6
"""Floor of the smallest room, m²."""
TOUCH = 0.05
"""Floors nearer each other have no wall between them, m."""
FARTHEST = 0.7
"""Floors further apart stand in different buildings, m."""
SLIVER = 0.06
"""Half the width of what is no part of a room, m."""
NOTCH = 0.02
"""What walls that end too late take of a room, m²."""
CRACK = 0.08
"""Half the width of gaps between walls that are closed, m."""
TOLD = 1.5
"""Least floor of what walls enclose, where the file has rooms of its own, m²."""


class Room(NamedTuple):
    """A room's name, as drawn, and its clear floor."""

    name: str
    floor: Polygon


class Storey(NamedTuple):
    """Rooms, pairs of them (by place in the list) that nothing parts, and the usual thickness of walls."""

    rooms: list[Room]
    open: list[tuple[int, int]]
    inner: float | None
    outer: float | None


def storey(drawing: Drawing, inner: float, said: list[str]) -> Storey:
    """The rooms of a drawing; `inner` is how far apart those are put that touch. What is left out is `said`.

    BadInput for rooms that cross themselves or lie over each other.
    """
    walls = shapely.union_all([shapely.make_valid(wall) for wall in drawing.walls])
    spaces = [Space(space.name, _proper(space)) for space in drawing.spaces if not names.is_outside(space.name)]
    if len(spaces) < len(drawing.spaces):
        left = ", ".join(repr(space.name) for space in drawing.spaces if names.is_outside(space.name))
        said.append(f"left out, out of doors: {left}")
    spaces += _enclosed(walls, spaces, drawing.holes)
    rooms = [Room(space.name, floor) for space in spaces if (floor := _clear(space, walls, said)) is not None]
    rooms = [room._replace(name=room.name or _label(room.floor, drawing.labels)) for room in rooms]
    if not rooms:
        raise BadInput("no room: neither outlines of rooms nor walls that enclose one; draw rooms, or close the walls")
    _check_overlaps(rooms)
    rooms = _together(rooms, said)
    touching = [
        (i, j) for i, j in combinations(range(len(rooms)), 2) if rooms[i].floor.distance(rooms[j].floor) < TOUCH
    ]
    parted = _parted(rooms, touching, inner)
    kept = [
        (i, j)
        for i, j in touching
        if drawing.walls
        and _is_open(rooms[i].floor, rooms[j].floor, walls)
        and faces.between(parted[i].floor, parted[j].floor)
    ]
    return Storey(parted, kept, _usual(rooms), _outside(rooms, walls))


def at(shape: Geometry) -> str:
    """The place of a shape, for messages."""
    point = shape.representative_point()
    return f"({point.x:.2f}, {point.y:.2f})"


def _proper(space: Space) -> Polygon:
    if not space.floor.is_valid:
        where = explain_validity(space.floor)
        raise BadInput(f"room {space.name or 'without a name'}: its outline is no polygon ({where}); mend it there")
    return space.floor


def _label(floor: Polygon, labels: list[Label]) -> str:
    """The text in a room that speaks of a type of room, else any with letters in it."""
    inside = [label.text for label in labels if floor.intersects(Point(label.at))]
    worded = [text for text in inside if any(letter.isalpha() for letter in text)]
    speaking = [text for text in worded if names.read(text) and not names.is_outside(text)]
    return next(iter([*speaking, *worded]), "")


def _outside(rooms: list[Room], walls: Geometry) -> float | None:
    """The usual thickness of the walls that have the open air behind them; None where walls have next to none."""
    found = []
    for room in rooms:
        for face in faces.outside(room.floor, [other.floor for other in rooms if other is not room]):
            start = face.start + 0.5 * face.length * face.along
            ray = LineString([start + 0.01 * face.inward, start - face.inward])
            first = [
                part.length
                for part in shapely.get_parts(ray.intersection(walls))
                if part.distance(Point(start)) < TOUCH
            ]
            found += [(first[0], face.length)] if first and first[0] > TOUCH else []
    found.sort()
    total = np.cumsum([length for _, length in found])
    return round(float(found[int(np.searchsorted(total, total[-1] / 2))][0]), 3) if found else None


def _enclosed(walls: Geometry, spaces: list[Space], holes: list[Hole]) -> list[Space]:
    """What walls enclose and no room covers; where the file has rooms, only what a door leads into."""
    closed = walls.buffer(CRACK, join_style="mitre").buffer(-CRACK, join_style="mitre")
    found = [Polygon(ring) for part in shapely.get_parts(closed) for ring in getattr(part, "interiors", [])]
    covered = shapely.union_all([space.floor for space in spaces])
    doors = [LineString(hole.ends) for hole in holes if hole.kind != "window"]
    out = []
    for face in found:
        free = face.difference(closed)
        if face.buffer(-0.3).is_empty or free.intersection(covered).area > 0.3 * free.area:
            continue
        if not spaces or (free.area > TOLD and any(door.distance(free) < FARTHEST for door in doors)):
            out += [Space("", part) for part in shapely.get_parts(free) if isinstance(part, Polygon)]
    return out


def _clear(space: Space, walls: Geometry, said: list[str]) -> Polygon | None:
    """The largest part of a room between its walls, without slivers and without what stands free in it."""
    parts = shapely.get_parts(space.floor.difference(walls))
    opened = [part.buffer(-SLIVER, join_style="mitre").buffer(SLIVER, join_style="mitre") for part in parts]
    pieces = [piece for part in opened for piece in shapely.get_parts(part) if isinstance(piece, Polygon)]
    floor = max(pieces, key=lambda piece: piece.area, default=Polygon())
    if floor.area < SMALLEST:
        said.append(
            f"{space.name or 'a room'} at {at(space.floor)} has {floor.area:.2f} m² between its walls: left out"
        )
        return None
    for ring in floor.interiors:
        if Polygon(ring).area > 0.04:
            said.append(f"what stands free in {space.name or 'a room'} at {at(Polygon(ring))} is left out")
    whole = _mended(Polygon(floor.exterior)).simplify(1e-3)
    return _rounded(whole)


def _mended(floor: Polygon) -> Polygon:
    """The floor without the notches that ends of walls make which were drawn a little too far."""
    closed = floor.buffer(SLIVER, join_style="mitre").buffer(-SLIVER, join_style="mitre").difference(floor)
    notches = [part for part in shapely.get_parts(closed) if 1e-6 < part.area < NOTCH]
    whole = shapely.union_all([floor, *(notch.buffer(1e-5, join_style="mitre") for notch in notches)])
    return whole if isinstance(whole, Polygon) else floor


def _check_overlaps(rooms: list[Room]) -> None:
    for a, b in combinations(rooms, 2):
        both = a.floor.intersection(b.floor)
        if not both.buffer(-SLIVER).is_empty:
            names = " and ".join(room.name or "one without a name" for room in (a, b))
            raise BadInput(f"rooms {names} lie over each other by {both.area:.2f} m² at {at(both)}: part them")


def _together(rooms: list[Room], said: list[str]) -> list[Room]:
    """The rooms of the largest building; others are left out."""
    grown = shapely.union_all([room.floor.buffer(FARTHEST / 2, join_style="mitre") for room in rooms])
    main = max(shapely.get_parts(grown), key=lambda part: sum(r.floor.area for r in rooms if part.intersects(r.floor)))
    for room in rooms:
        if not main.intersects(room.floor):
            said.append(f"{room.name or 'a room'} at {at(room.floor)} stands apart from the other rooms: left out")
    return [room for room in rooms if main.intersects(room.floor)]


def _parted(rooms: list[Room], touching: list[tuple[int, int]], inner: float) -> list[Room]:
    """Rooms that touch give way by half a wall along what they share."""
    floors = [room.floor for room in rooms]
    for pair in touching:
        a, b = (rooms[i].floor for i in pair)
        lack = inner - a.distance(b) + (a.intersection(b).area and SLIVER)
        for i, mine, other in ((pair[0], a, b), (pair[1], b, a)):
            line = _lines(mine.exterior.intersection(other.buffer(TOUCH, join_style="mitre")))
            strip = line.buffer(lack / 2, cap_style="flat", join_style="mitre")
            floors[i] = _largest(floors[i].difference(strip), 0.6 * inner)
    return [Room(room.name, floor) for room, floor in zip(rooms, floors, strict=True)]


def _is_open(a: Polygon, b: Polygon, walls: Geometry) -> bool:
    """Whether most of what two rooms share has no wall on it."""
    shared = a.exterior.intersection(b.buffer(TOUCH, join_style="mitre"))
    return bool(shared.difference(walls.buffer(TOUCH)).length > max(0.6, 0.5 * shared.length))


def _lines(shared: Geometry) -> Geometry:
    lines = [part for part in shapely.get_parts(shared) if isinstance(part, LineString)]
    return shapely.line_merge(MultiLineString(lines))


def _largest(shape: Geometry, tooth: float) -> Polygon:
    smooth = shape.buffer(-tooth, join_style="mitre").buffer(tooth, join_style="mitre").simplify(1e-3)
    whole = max(shapely.get_parts(smooth), key=lambda part: part.area)
    return _rounded(Polygon(whole.exterior))


def _rounded(floor: Polygon) -> Polygon:
    """Counter-clockwise, its corners to 10 µm."""
    return shapely.geometry.polygon.orient(shapely.set_precision(floor, 1e-5))


def _usual(rooms: list[Room]) -> float | None:
    """The middle one of the distances between neighbours; None where all touch."""
    near = [
        faces.between(a.floor, b.floor)[:1] for a, b in combinations(rooms, 2) if a.floor.distance(b.floor) < FARTHEST
    ]
    gaps = [face.gap for found in near for face in found if face.gap is not None and face.gap >= TOUCH]
    return round(median(gaps), 3) if gaps else None

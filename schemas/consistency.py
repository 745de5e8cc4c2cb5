"""What the types of single fields cannot say: that ids are unique, references exist, outlines are proper.

The rules of building (doors wide enough, rooms reachable) are the plan stage's; here is only what every reader of an
artifact relies on.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import hypot
from typing import NamedTuple

from apartgen.schemas.base import Point, Polygon, Record
from apartgen.schemas.carrying import BUILDING
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Opening, Plan, Program
from apartgen.schemas.retrieve import Retrieve

FARTHEST = 1000.0
"""Coordinates beyond this are hardly metres."""
WIDEST, HIGHEST = 250.0, 20.0
"""No home is wider, and no room higher, m."""
_LEAST = 1e-3  # m, the least length of a side


class Fault(NamedTuple):
    """One inconsistency: the path below `body`, and what is wrong there."""

    where: str
    what: str


def faults(body: Record) -> Iterator[Fault]:
    """Everything inconsistent in a body, or in a programme by itself, in the order of its fields."""
    if isinstance(body, Program):
        yield from _program(body)
    if isinstance(body, Plan):
        yield from _program(body.program)
        yield from _rooms(body)
        if body.height > HIGHEST:
            yield Fault("height", f"{body.height:g} m; rooms are at most {HIGHEST:g} m high")
        for name in body.finishes:
            yield from _known(name, {room.id for room in body.rooms}, "finishes")
        yield from _openings(body)
    if isinstance(body, Layout):
        yield from _objects(body)
    if isinstance(body, Retrieve):
        yield from _joints(body)


def _repeated(ids: Iterable[str], where: str) -> Iterator[Fault]:
    seen: set[str] = set()
    for i, id in enumerate(ids):
        if id in seen:
            yield Fault(f"{where}[{i}].id", f"{id!r} is there twice; every id must be unique")
        seen.add(id)


def _known(room: str | None, rooms: set[str], where: str) -> Iterator[Fault]:
    if room is not None and room not in rooms:
        yield Fault(where, f"there is no room {room!r}; there are: {', '.join(sorted(rooms))}")


def _program(program: Program) -> Iterator[Fault]:
    rooms = {room.id for room in program.rooms}
    yield from _repeated((room.id for room in program.rooms), "program.rooms")
    for i, asked in enumerate(program.rooms):
        yield from _known(asked.private_to, rooms, f"program.rooms[{i}].private_to")
    for name, links in (("links", program.links), ("open_links", program.open_links)):
        for i, (a, b) in enumerate(links):
            yield from _known(a, rooms, f"program.{name}[{i}][0]")
            yield from _known(b, rooms, f"program.{name}[{i}][1]")
            if a == b:
                yield Fault(f"program.{name}[{i}]", f"links {a!r} with itself")
    for i, wish in enumerate(program.objects):
        yield from _known(wish.room, rooms, f"program.objects[{i}].room")
    for room in program.counts:
        yield from _known(room, rooms, "program.counts")
    yield from _repeated((asked.id for asked in program.requirements), "program.requirements")
    if program.envelope.outline is not None:
        yield from _outline(program.envelope.outline, "program.envelope.outline")


def _rooms(plan: Plan) -> Iterator[Fault]:
    asked = {room.id: room.type for room in plan.program.rooms}
    yield from _repeated((room.id for room in plan.rooms), "rooms")
    for i, room in enumerate(plan.rooms):
        if room.id not in asked:
            yield Fault(f"rooms[{i}].id", f"{room.id!r} is not among program.rooms; list it there too")
        elif asked[room.id] != room.type:
            yield Fault(f"rooms[{i}].type", f"{room.type!r}, but program.rooms has {asked[room.id]!r} for {room.id!r}")
        yield from _outline(room.polygon, f"rooms[{i}].polygon")
    if plan.rooms and (wrong := too_wide([point for room in plan.rooms for point in room.polygon])):
        yield Fault("rooms", wrong)


def _outline(polygon: Polygon, where: str) -> Iterator[Fault]:
    if wrong := too_wide(polygon):
        yield Fault(where, wrong)
        return
    ends = [*polygon, polygon[0]]
    short = min(hypot(bx - ax, by - ay) for (ax, ay), (bx, by) in pairwise(ends))
    if short < _LEAST:
        yield Fault(where, "two corners in a row coincide; give each corner once, the first not repeated")
        return
    import shapely

    if not shapely.Polygon(polygon).is_valid:
        yield Fault(where, "crosses or touches itself; give the corners in their order around the outline")
    elif not shapely.is_ccw(shapely.LinearRing(polygon)):
        yield Fault(where, "runs clockwise; list the corners counter-clockwise")


def too_wide(points: Sequence[Point]) -> str:
    """What is wrong with points that lie further apart, or further away, than those of a home; or nothing."""
    far = max(max(abs(x), abs(y)) for x, y in points)
    if far > FARTHEST:
        return f"reaches {far:g} m from the origin, over {FARTHEST:g}; coordinates are metres"
    span = max(max(values) - min(values) for values in zip(*points))
    return f"is {span:g} m wide, over {WIDEST:g}; coordinates are metres" if span > WIDEST else ""


def _openings(plan: Plan) -> Iterator[Fault]:
    rooms = {room.id for room in plan.rooms}
    yield from _repeated((opening.id for opening in plan.openings), "openings")
    for i, opening in enumerate(plan.openings):
        for k, room in enumerate(opening.rooms):
            yield from _known(room, rooms, f"openings[{i}].rooms[{k}]")
        for what in _opening(opening):
            yield Fault(f"openings[{i}].{what.where}", what.what)


def _opening(opening: Opening) -> Iterator[Fault]:
    (ax, ay), (bx, by) = opening.segment
    wanted = 2 if opening.kind in ("door", "opening") else 1
    if len(opening.rooms) != wanted or len(set(opening.rooms)) != wanted:
        yield Fault("rooms", f"{opening.kind} {opening.id!r} needs {wanted} different room{'s' * (wanted > 1)}")
    if opening.into is not None and opening.into not in opening.rooms:
        yield Fault("into", f"{opening.into!r} is not one of its rooms")
    if hypot(bx - ax, by - ay) < _LEAST:
        yield Fault("segment", "has no length")
    if max(abs(ax), abs(ay), abs(bx), abs(by)) > FARTHEST:
        yield Fault("segment", f"lies over {FARTHEST:g} m from the origin; coordinates are metres")
    if not opening.sill < opening.head:
        yield Fault("head", f"{opening.head:g} is not above the sill at {opening.sill:g}")


def _objects(layout: Layout) -> Iterator[Fault]:
    rooms = {room.id for room in layout.rooms}
    yield from _repeated((box.id for box in layout.objects), "objects")
    for i, box in enumerate(layout.objects):
        yield from _known(box.room, rooms, f"objects[{i}].room")
        if max(map(abs, (*box.center, *box.size))) > FARTHEST:
            yield Fault(f"objects[{i}]", f"placed or sized over {FARTHEST:g} m; coordinates are metres")
    yield from _carriers(layout)


def _carriers(layout: Layout) -> Iterator[Fault]:
    on = {box.id: box.on for box in layout.objects}
    for i, box in enumerate(layout.objects):
        if box.on is None or box.on in BUILDING:
            continue
        if box.on not in on:
            known = ", ".join(BUILDING)
            yield Fault(f"objects[{i}].on", f"there is no object {box.on!r}; name one by its id, or {known}")
            continue
        below, passed = box.on, {box.id}
        while below not in passed and (further := on.get(below)) is not None:
            passed.add(below)
            below = further
        if below == box.id:
            yield Fault(f"objects[{i}].on", f"{box.id!r} would stand on itself by way of {box.on!r}")


def _joints(home: Retrieve) -> Iterator[Fault]:
    for i, piece in enumerate(home.objects):
        names = [joint.name for joint in piece.joints]
        for k, joint in enumerate(piece.joints):
            where = f"objects[{i}].joints[{k}]"
            if joint.name in names[:k]:
                yield Fault(f"{where}.name", f"{joint.name!r} is there twice")
            if joint.range[0] > joint.range[1]:
                yield Fault(f"{where}.range", f"runs from {joint.range[0]:g} down to {joint.range[1]:g}")
            if hypot(*joint.axis) < 1e-6:
                yield Fault(f"{where}.axis", "has no direction")

"""Balconies, hung in front of the façade of the room they belong to once the rooms stand."""

from collections.abc import Mapping

import numpy as np
from shapely.geometry import Polygon

from apartgen.schemas.plan import Envelope, Program, Requirement, Side, Walls
from apartgen.stages.plan import faces
from apartgen.stages.plan.blocks import facing
from apartgen.stages.plan.check import entrance_room, links
from apartgen.stages.plan.faces import Face
from apartgen.stages.plan.slicing import Floats
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.plan.wishes import DIRECTIONS

USUAL = 1.5
"""Depth of a balcony where the façade allows it, m."""
DEEPEST = 2.4
"""Depth up to which a balcony may be deeper than it is wide, m."""
GLAZED = 2.7
"""Façade that a glazed door and a window beside it take, m."""
SUNNY: dict[Side, float] = {"south": 1.5, "west": 0.8, "east": 0.4, "north": 0.0}
"""Façade that a side is worth, m."""

PLACED = ("position", "orientation")
"""Requirements that say at which side it hangs."""

Floors = dict[str, Polygon]


def hung(program: Program) -> dict[str, str]:
    """Balconies of one door by id, with the room it is in; those of several doors, or open, stay among the rooms."""
    if all(room.type != "balcony" for room in program.rooms):
        return {}
    types = {room.id: room.base for room in program.rooms}
    indoors = [room for room, kind in types.items() if kind != "balcony"]
    joined = {room for pair in program.open_links for room in pair}
    first = entrance_room(program).id
    out = {}
    for room in program.rooms:
        near = [b if a == room.id else a for a, b in links(program) if room.id in (a, b)]
        if room.type == "balcony" and len(near) == 1 and near[0] in indoors and room.id not in (first, *joined):
            out[room.id] = near[0]
    return out


def indoors(program: Program) -> Program:
    """The programme without the balconies that are hung."""
    outside = hung(program)
    rooms = [room for room in program.rooms if room.id not in outside]
    kept = [pair for pair in program.links if not set(pair) & set(outside)]
    asked = [_of_owner(r, outside) for r in program.requirements]
    return program.model_copy(update={"rooms": rooms, "links": kept, "requirements": asked}) if outside else program


def fronts(program: Program) -> dict[str, float]:
    """Façade that the rooms behind hung balconies need, m."""
    wanted = {room.id: _area(program, room.id) for room in program.rooms if room.type == "balcony"}
    least = {name: wanted[name] / max(DEEPEST, wanted[name] ** 0.5) for name in wanted}
    return {owner: max(GLAZED, least[name]) for name, owner in hung(program).items()}


def hang(program: Program, floors: Floors, walls: Walls) -> Floors | None:
    """The floors with those of hung balconies, an outer wall away from their rooms; None where one finds no place."""
    out = dict(floors)
    for name, owner in hung(program).items():
        towards = _towards(program, name, owner)
        facades = _facades(owner, out, program.envelope, towards)
        places = (_placed(face, _area(program, name), walls, towards) for face in facades)
        free = (place for place in places if place is not None and _clear(place, out, walls))
        found = next(free, None)
        if found is None:
            return None
        out[name] = found
    return out


def overlooked(program: Program) -> list[tuple[Side, ...]]:
    """Sides at which hung balconies are asked to be, of those in a corner either: there must be a façade."""
    asked = [r for r in program.requirements if r.kind in PLACED and r.value in DIRECTIONS]
    out = hung(program)
    wanted = [DIRECTIONS[str(r.value)] for r in asked if r.of in out and r.to in (None, out[r.of])]
    return [tuple(side for side in SUNNY if np.dot(DIRECTIONS[side], way) > 0) for way in wanted]


def outside(floors: Mapping[str, Polygon], program: Program, room: str) -> list[Polygon]:
    """Floors that stand before a room's windows: all others but for hung balconies."""
    open_air = hung(program)
    return [floor for other, floor in floors.items() if other != room and other not in open_air]


def _of_owner(asked: Requirement, owners: Mapping[str, str]) -> Requirement:
    """A place asked of a hung balcony, or beside it, as one of the room that it hangs before."""
    ends = {end: owners.get(room, room) for end, room in (("of", asked.of), ("to", asked.to or ""))}
    if asked.kind not in PLACED or asked.value not in DIRECTIONS or ends["of"] == ends["to"]:
        return asked
    return asked.model_copy(update={"of": ends["of"], "to": ends["to"] or None})


def _towards(program: Program, name: str, owner: str) -> Floats:
    """Direction (2,) in which a balcony is asked to be in the home, or before its room; 0 where none is."""
    asked = [r for r in program.requirements if r.of == name and r.kind in PLACED and r.to in (None, owner)]
    return sum((np.array(DIRECTIONS.get(str(r.value), (0, 0)), float) for r in asked), np.zeros(2))


def _area(program: Program, name: str) -> float:
    least = STANDARDS["balcony"].area
    return max(next(room.area for room in program.rooms if room.id == name) or 2 * least, least)


def _facades(owner: str, floors: Floors, envelope: Envelope, towards: Floats) -> list[Face]:
    """Free façades of a room, those that look where the balcony should be first, then long and sunny ones."""
    found = faces.outside(floors[owner], [floor for room, floor in floors.items() if room != owner])
    free = [face for face in found if facing(*face.along) not in envelope.party_walls]
    return sorted(
        free,
        key=lambda face: (face.inward @ towards > -0.5, -face.length - SUNNY[facing(*face.along)], *face.start),
    )


def _placed(face: Face, area: float, walls: Walls, towards: Floats) -> Polygon | None:
    """In the middle of a façade or at the end `towards` a side, `USUAL` deep or deeper where it is short."""
    width = min(face.length, max(area / USUAL, min(GLAZED, area / STANDARDS["balcony"].width)))
    deep = area / width
    if deep > max(DEEPEST, width) or width < STANDARDS["balcony"].width:
        return None
    along = float(face.along @ towards)
    before = 0.5 if abs(along) < 0.5 else float(along > 0)
    lo = before * (face.length - width)
    near, far = (np.array(face.segment(lo, lo + width, walls.outer + d)) for d in (0.0, deep))
    return Polygon([near[0], far[0], far[1], near[1]])


def _clear(place: Polygon, floors: Floors, walls: Walls) -> bool:
    return all(floor.distance(place) > walls.outer - 1e-3 for floor in floors.values())

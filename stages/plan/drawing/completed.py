"""A plan out of what a drawing shows: what it lacks is completed and said, what is wrong is an error with its place."""

from dataclasses import replace

import numpy as np
from shapely.affinity import translate
from shapely.geometry import Polygon

from apartgen.schemas.base import Point
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import AskedRoom, Plan, Program, Room, Walls
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.plan.drawing import Drawing, furniture, types, ways
from apartgen.stages.plan.drawing.floors import Storey, storey

EARTH, LARGEST = 1e8, 30.0
"""No coordinate is larger, and no piece of furniture, m."""
FAR = 500.0
"""Drawings that lie further from their origin are brought there, m."""
MOST = 40
"""Rooms of a programme."""
THIN, THICK = 0.04, 0.6
"""Of walls between rooms, m."""
LOW, HIGH = 1.9, 10.0
"""Of ceilings, m."""


def plan_of(drawing: Drawing, config: PlanConfig) -> tuple[Plan, list[str]]:
    """The plan, a layout where the drawing has furniture; and what was completed or left out, in words.

    BadInput for a drawing that is no floor plan, Unmet where a room can have no door.
    """
    said = list(drawing.said)
    drawing = _brought_near(_measured(drawing, said), said)
    drawn = storey(drawing, config.walls.inner, said)
    if len(drawn.rooms) > MOST:
        raise BadInput(f"{len(drawn.rooms)} rooms; a plan has at most {MOST}: give a part of the building")
    plan = _rooms(drawing, drawn, config, said)
    objects = furniture.boxes(drawing.things, plan.rooms, said)
    plan = ways.opened(plan, drawing.holes, _pairs(plan, drawn), furniture.standing(objects), said)
    plan = _asked(ways.lit(plan, said))
    return (Layout(**dict(plan), objects=objects), said) if objects else (plan, said)


def _rooms(drawing: Drawing, drawn: Storey, config: PlanConfig, said: list[str]) -> Plan:
    """The plan without openings."""
    kinds = types.told(drawn.rooms, drawing.things, said)
    rooms = [Room(id=id, type=type, polygon=_ring(room.floor)) for (id, type), room in zip(kinds, drawn.rooms)]
    asked = [AskedRoom(id=room.id, type=room.type) for room in rooms]
    inner = min(max(drawn.inner or config.walls.inner, THIN), THICK)
    walls = Walls(inner=inner, outer=min(max(drawing.outer or drawn.outer or config.walls.outer, THIN), THICK))
    height = drawing.height
    if height is None or not LOW <= height <= HIGH:
        told = "no height of the ceiling" if height is None else f"a ceiling at {height:.2f} m"
        said.append(f"{told}: {config.height:g} m taken")
        height = config.height
    return Plan(program=Program(rooms=asked), rooms=rooms, openings=[], height=round(height, 4), walls=walls)


def _pairs(plan: Plan, drawn: Storey) -> list[tuple[str, str]]:
    return [(plan.rooms[i].id, plan.rooms[j].id) for i, j in drawn.open]


def _asked(plan: Plan) -> Plan:
    """The plan with a programme that asks for what is there."""
    links = [(o.rooms[0], o.rooms[1]) for o in plan.openings if o.kind == "door"]
    wide = [(o.rooms[0], o.rooms[1]) for o in plan.openings if o.kind == "opening"]
    once = {frozenset(link): link for link in links if frozenset(link) not in {frozenset(pair) for pair in wide}}
    areas = {room.id: round(float(Polygon(room.polygon).area), 2) for room in plan.rooms}
    rooms = [room.model_copy(update={"area": areas[room.id]}) for room in plan.program.rooms]
    program = Program(
        rooms=rooms,
        links=list(once.values()),
        complete=True,
        open_links=list({frozenset(pair): pair for pair in wide}.values()),
    )
    return plan.model_copy(update={"program": program})


def _ring(floor: Polygon) -> list[Point]:
    return [(round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in floor.exterior.coords[:-1]]


def _measured(drawing: Drawing, said: list[str]) -> Drawing:
    """The drawing without furniture and holes that have no size or no place. BadInput for rooms and walls so."""
    spaces = [space for space in drawing.spaces if not space.floor.is_empty]
    walls = [wall for wall in drawing.walls if not wall.is_empty]
    for shape in (*(space.floor for space in spaces), *walls):
        if not np.isfinite(shape.bounds).all() or np.abs(shape.bounds).max() > EARTH:
            raise BadInput(f"a room or wall at {shape.bounds[:2]} has no place on earth; mend its coordinates")
    things = [
        thing
        for thing in drawing.things
        if _sound(*thing.middle, *thing.size, thing.yaw) and min(thing.size) > 0 and max(thing.size) < LARGEST
    ]
    holes = [hole for hole in drawing.holes if _sound(*hole.ends[0], *hole.ends[1], hole.sill or 0.0, hole.head or 0.0)]
    lost = len(drawing.things) - len(things) + len(drawing.holes) - len(holes)
    if lost:
        said.append(f"{lost} openings or pieces of furniture have no size or no place: left out")
    return replace(drawing, spaces=spaces, walls=walls, things=things, holes=holes)


def _sound(*numbers: float) -> bool:
    return bool(np.isfinite(numbers).all() and np.abs(numbers).max() < EARTH)


def _brought_near(drawing: Drawing, said: list[str]) -> Drawing:
    """The drawing moved to the origin where it lies far from it, as surveyed ones do."""
    shapes = [space.floor for space in drawing.spaces] or drawing.walls
    if not shapes:
        return drawing
    bounds = np.array([shape.bounds for shape in shapes])
    x, y = (float(v) for v in np.floor(bounds[:, :2].min(0)))
    if np.abs(bounds).max() <= FAR:
        return drawing
    said.append(f"the drawing lies at ({x:g}, {y:g}) m: moved to the origin")

    def moved(p: Point | None) -> Point | None:
        return p and (p[0] - x, p[1] - y)

    holes = [
        replace(
            hole,
            ends=((hole.ends[0][0] - x, hole.ends[0][1] - y), (hole.ends[1][0] - x, hole.ends[1][1] - y)),
            hinge=moved(hole.hinge),
            swung=moved(hole.swung),
        )
        for hole in drawing.holes
    ]
    labels = [replace(label, at=(label.at[0] - x, label.at[1] - y)) for label in drawing.labels]
    things = [replace(t, middle=(t.middle[0] - x, t.middle[1] - y, t.middle[2])) for t in drawing.things]
    return replace(
        drawing,
        labels=labels,
        holes=holes,
        things=things,
        walls=[translate(wall, -x, -y) for wall in drawing.walls],
        spaces=[replace(space, floor=translate(space.floor, -x, -y)) for space in drawing.spaces],
    )

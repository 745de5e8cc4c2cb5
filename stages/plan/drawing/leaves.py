"""Which way doors turn, and where those go that a drawing lacks."""

from collections.abc import Iterator
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import LineString, Polygon

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.plan import faces
from apartgen.stages.plan.faces import Face
from apartgen.stages.space import polygons

Array = NDArray[np.float64]
FRAME = 0.1
"""Least wall between a door and a corner, m."""
STEP = 0.3
WIDTHS = (0.9, 0.8, 0.7)
"""Of doors that are put in, the first that finds room, m."""
GIVE = 0.02
WIDEST = 1.35
"""Doors wider than this have two leaves or slide, m; they stand open without one."""
Hinge = Literal[0, 1]


class Way(NamedTuple):
    """How a leaf turns: at which end of its segment, and into which room."""

    hinge: Hinge
    into: str


def hung(door: Opening, plan: Plan, drawn: Way | None, standing: list[Polygon]) -> Opening:
    """The door with a leaf: as drawn where that has room, else the first way that meets neither walls nor other leaves,
    nor if it can be what is `standing` there; without a leaf where none has room.
    """
    if drawn is None and polygons.width(door) > WIDEST:
        return door.model_copy(update={"into": None})
    ways = [Way(hinge, room) for room in door.rooms for hinge in (0, 1)]
    turned = [_as(door, way) for way in ([drawn, *ways] if drawn else ways)]
    fits = [leaf for leaf in turned if _inside(leaf, plan) and not _meets(leaf, plan)]
    if drawn and fits and fits[0] is turned[0]:
        return fits[0]
    clear = [leaf for leaf in fits if not any(_over(polygons.swing(leaf, plan), body) for body in standing)]
    return next(iter([*clear, *fits]), door.model_copy(update={"into": None}))


def _as(door: Opening, way: Way) -> Opening:
    return door.model_copy(update={"hinge": way.hinge, "into": way.into})


def _inside(leaf: Opening, plan: Plan) -> bool:
    room = next(room for room in plan.rooms if room.id == leaf.into)
    whole = polygons.floor(room).buffer(GIVE, join_style="mitre")
    return bool(polygons.swing(leaf, plan).difference(whole).area < 1e-3)


def _meets(leaf: Opening, plan: Plan) -> bool:
    swept = polygons.swing(leaf, plan)
    others = [other for other in plan.openings if other.id != leaf.id and other.kind in polygons.PASSAGES]
    return any(
        _over(swept, polygons.swing(other, plan)) or _over(swept, polygons.threshold(other, plan).buffer(GIVE))
        for other in others
    )


def _over(one: Polygon, other: Polygon) -> bool:
    return bool(one.intersection(other).area > 1e-3)


def between(plan: Plan, rooms: tuple[str, str], standing: list[Polygon]) -> Opening | None:
    """A new door from the first room to the second; None where they share no wall for one."""
    floors = polygons.floors(plan)
    thickest = 2 * max(plan.walls.inner, plan.walls.outer)
    found = sorted(faces.between(floors[rooms[0]], floors[rooms[1]]), key=lambda face: (face.gap or 0.0) > thickest)
    return _first(plan, "door", rooms, [(face, 0.5 * (face.gap or 0.0)) for face in found], standing)


def entrance(plan: Plan, room: str, standing: list[Polygon]) -> Opening | None:
    """A new way into a room from outside; None where it has no outside wall for one."""
    floors = polygons.floors(plan)
    found = faces.outside(floors[room], [floor for name, floor in floors.items() if name != room])
    return _first(plan, "entrance", (room,), [(face, 0.5 * plan.walls.outer) for face in found], standing)


def _first(
    plan: Plan,
    kind: Literal["door", "entrance"],
    rooms: tuple[str, ...],
    walls: list[tuple[Face, float]],
    standing: list[Polygon],
) -> Opening | None:
    """The first place along the walls where nothing is in the way of a leaf, else of the door alone."""
    taken = [LineString(o.segment).buffer(FRAME, cap_style="flat") for o in plan.openings]
    bare = None
    for segment in _places(walls):
        if any(LineString(segment).intersects(other) for other in taken):
            continue
        door = Opening(
            id="new", kind=kind, rooms=list(rooms[::-1]), segment=segment, sill=0.0, head=min(2.1, plan.height)
        )
        leaf = hung(door, plan, None, standing)
        if leaf.into and not any(_over(polygons.swing(leaf, plan), body) for body in standing):
            return leaf
        bare = bare or leaf
    return bare


def _places(walls: list[tuple[Face, float]]) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    for width in WIDTHS:
        for face, depth in walls:
            slack = face.length - 2 * FRAME - width
            for k in range(int(slack / STEP + 1e-6) + 1 if slack >= 0 else 0):
                yield face.segment(FRAME + k * STEP, FRAME + k * STEP + width, depth)

"""R_walkable, SR: share of the floor that stays free, and whether it meets each threshold (Eq. 12, 13)."""

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._free import largest_share
from apartgen.stages.metrics._shares import objects
from apartgen.stages.robot import reach
from apartgen.stages.space import footprints, polygons

NEEDS = Layout
THRESHOLDS = tuple(round(0.60 + 0.05 * i, 2) for i in range(8))


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions of R_walkable, by room and over all floors:

    ours = footprints as a union · published = Eq. 12 as printed, footprints summed · physcene = the largest connected
    part of the free floor over all of it, apartment: mean of rooms · connected = what a robot gets to from the
    entrance over all places it could stand. SR_τ is 1 where R_walkable >= τ, of the union and as published.
    """
    things = objects(home)
    floors = polygons.floors(home)
    inside = {room: [o for o in things if o.room == room] for room in floors}
    total = sum(floor.area for floor in floors.values())
    values = []
    for version, ratio in (("ours", footprints.walkable_ratio), ("published", footprints.plain_ratio)):
        by_room = {room: ratio(floor, inside[room]) for room, floor in floors.items()}
        whole = sum(by_room[room] * floor.area for room, floor in floors.items()) / total
        values += [Value(name="R_walkable", value=v, unit="share", version=version, of=of)
                   for of, v in {"apartment": whole, **by_room}.items()]
        values += [Value(name=f"SR_{tau:.2f}", value=float(v >= tau - 1e-9), unit="met", version=version, of=of)
                   for tau in THRESHOLDS for of, v in {"apartment": whole, **by_room}.items()]
    physcene = {room: largest_share(floor, inside[room]) for room, floor in floors.items()}
    values += [Value(name="R_walkable", value=v, unit="share", version="physcene", of=of)
               for of, v in {"apartment": float(np.mean(list(physcene.values()))), **physcene}.items()]
    return [*values, *_connected(home)]


def _connected(home: Plan) -> list[Value]:
    world = reach.space(home)
    cells = reach.free(world, objects(home))
    got = reach.survey(world, [], cells=cells).cells
    values = []
    for i, room in [(None, "apartment"), *enumerate(room.id for room in home.rooms)]:
        here = cells if i is None else cells & (world.rooms == i)
        value = float((got & here).sum() / here.sum()) if here.any() else 0.0
        values.append(Value(name="R_walkable", value=value, unit="share", version="connected", of=room))
    return values

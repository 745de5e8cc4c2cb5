"""R_reach, R_reach_front: objects a robot gets to, and fronts of those that open."""

import numpy as np

from schemas.layout import Layout
from schemas.metrics import Value
from schemas.plan import Plan, Program
from stages import boxes, footprints, grid, polygons, reach, sweeps
from stages.metrics._free import low, reached_share
from stages.metrics._shares import objects, shares

NEEDS = Layout


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions of R_reach: published = PhyScene's, by room, apartment: mean of rooms · ours = the same without what
    hangs above 1.5 m · from_entrance = share of objects beside which a robot of 0.25 m radius gets from the entrance.
    R_reach_front: share of articulated objects it can use from in front, closed and open (ours), closed only (closed).
    """
    values = [*_by_room(home, "published", low_only=False), *_by_room(home, "ours", low_only=True)]
    world = reach.space(home)
    things = low(objects(home))
    got = reach.survey(world, objects(home))
    beside = np.array([(grid.near(boxes.of([o]), world.grid, reach.RADIUS + 0.1) > 0)[got.cells].any() for o in things])
    values += shares(home, "R_reach", "from_entrance", beside.astype(bool), things)
    every = objects(home)
    moving = [o for o, moves in zip(every, sweeps.articulated(every), strict=True)
              if moves and footprints.is_obstacle(o)]
    closed = np.array([o.id not in got.closed for o in moving], bool)
    opened = closed & np.array([o.id not in got.opened for o in moving], bool)
    values += shares(home, "R_reach_front", "closed", closed, moving)
    return [*values, *shares(home, "R_reach_front", "ours", opened, moving)]


def _by_room(home: Plan, version: str, low_only: bool) -> list[Value]:
    every = objects(home)
    found = {
        room: reached_share(floor, [o for o in every if o.room == room], low_only)
        for room, floor in polygons.floors(home).items()
    }
    known = {room: value for room, value in found.items() if value is not None}
    whole = float(np.mean(list(known.values()))) if known else None
    return [Value(name="R_reach", value=value, unit="share", version=version, of=of)
            for of, value in {"apartment": whole, **known}.items()]

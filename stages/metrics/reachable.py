"""R_reach, R_reach_front: objects a robot gets to, and fronts of those that open."""

from collections.abc import Callable, Sequence

import numpy as np
from shapely import Geometry

from apartgen.schemas.carrying import FLOOR
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._free import low, reached_share
from apartgen.stages.metrics._shares import objects, shares
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, footprints, grid, polygons, sweeps

NEEDS = Layout
Share = Callable[[Geometry, Sequence[Box]], float | None]


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions of R_reach: published = PhyScene's, by room, apartment: mean of rooms · ours = the same without what
    hangs above 1.5 m · standing = ours of what stands on the floor alone: a mirror over a basin or a lamp on a
    nightstand is never beside free floor · from_entrance = share of objects beside which a robot of 0.25 m radius
    gets from the entrance.
    R_reach_front: share of articulated objects it can use from in front, closed and open (ours), closed only (closed).
    """
    versions = {"published": reached_share, "ours": _low, "standing": _standing}
    values = [value for version, share in versions.items() for value in _by_room(home, version, share)]
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


def _low(floor: Geometry, things: Sequence[Box]) -> float | None:
    return reached_share(floor, low(things))


def _standing(floor: Geometry, things: Sequence[Box]) -> float | None:
    """Only low things are in the way, and only those on the floor are to be reached."""
    return reached_share(floor, low(things), [o for o in low(things) if o.on == FLOOR])


def _by_room(home: Plan, version: str, share: Share) -> list[Value]:
    every = objects(home)
    found = {room: share(floor, [o for o in every if o.room == room]) for room, floor in polygons.floors(home).items()}
    known = {room: value for room, value in found.items() if value is not None}
    whole = float(np.mean(list(known.values()))) if known else None
    return [Value(name="R_reach", value=value, unit="share", version=version, of=of)
            for of, value in {"apartment": whole, **known}.items()]

"""Where a round robot gets to from the entrance, exactly: into every room, and before all that opens."""

from collections.abc import Iterator

import numpy as np
import shapely
from shapely import Geometry
from shapely.geometry import Point, Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.check.building import Site
from apartgen.stages.check.fault import Fault
from apartgen.stages.check.furniture import FLAT
from apartgen.stages.check.opening import HEADROOM, OPEN
from apartgen.stages.check.shapes import TOUCH, boxes
from apartgen.stages.things.categories import TABLE

RADIUS, REACH, HEIGHT = 0.25, 0.8, 1.5
"""Of the robot; of its arm, from its middle; and it passes under what hangs higher, m."""


def faults(home: Layout, site: Site) -> Iterator[Fault]:
    """Rooms, and things that open, that the robot does not get to; doors stand open, the entrance is shut."""
    got = _reached(home, site)
    goals = [(name, room.buffer(-TOUCH), room.representative_point()) for name, room in site.rooms.items()]
    used = [o for o in home.objects if o.center[2] - o.size[2] / 2 < HEADROOM and _opens(o)]
    goals += [(o.id, _before(o).intersection(site.rooms[o.room]), Point(o.center)) for o in used]
    for name, goal, at in goals:
        if not goal.intersects(got):
            yield Fault("unreached", (name,), (at.x, at.y), None if got.is_empty else float(at.distance(got)))


def _opens(o: Box) -> bool:
    return bool(o.joints) if isinstance(o, Furnishing) else o.category in TABLE and TABLE[o.category].opens != ""


def _before(o: Box) -> Polygon:
    """Where one stands to use a thing."""
    far, wide = 0.5 + (REACH + TOUCH) / o.size[0], 0.5 + RADIUS / o.size[1]
    return boxes([o], (0.5, -wide, 0), (far, wide, 0)).marks()[0]


def _reached(home: Layout, site: Site) -> Geometry:
    """Where the robot's middle can be."""
    leaves = [it.leaf(o, OPEN[-1:]).marks()[0] for o, it in site.doors if o.kind == "door"]
    ways = [it.cut() for o, it in site.gates if o.kind in ("door", "opening")]
    floor = shapely.union_all([*site.rooms.values(), *ways]).difference(shapely.union_all(leaves))
    things = boxes(home.objects)
    lamps = np.array([o.category in TABLE and TABLE[o.category].place == "ceiling" for o in home.objects], bool)
    walls = things.marks()[(things.high > FLAT) & (things.low < HEIGHT) & ~lamps]
    free = floor.buffer(TOUCH - RADIUS).difference(shapely.union_all(shapely.buffer(walls, RADIUS - TOUCH)))
    starts = [it.strip(-3 * RADIUS, 3 * RADIUS) for o, it in site.gates if o.kind == "entrance"] or [floor]
    return shapely.union_all([part for part in shapely.get_parts(free) if any(part.intersects(s) for s in starts)])

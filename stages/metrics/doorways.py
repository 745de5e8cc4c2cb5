"""R_blocked: doors that furniture stands in or in the way of, and windows it covers."""

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Opening, Plan, Program
from apartgen.stages.metrics._shares import objects, share
from apartgen.stages.space import boxes, footprints, polygons
from apartgen.stages.space.boxes import TOLERANCE
from apartgen.stages.things.categories import those

NEEDS = Layout
DEPTH = 0.5
"""Floor to stay free on both sides of a door, m."""
BEHIND = 0.3
"""What stands closer to a window, m, and higher than its sill, covers it."""
COVERED = 0.2
"""Share of a window's width that may be covered."""
SHADES = those(lambda kind: kind.soft and kind.place == "wall")
"""What hangs before windows."""


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions: doors = share of doors, openings and entrances with an obstacle in the opening, before a door or in
    its swing · swings = in a door's swing · windows = share of windows covered over a fifth of their width.
    """
    things = [o for o in objects(home) if footprints.is_obstacle(o)]
    areas = shapely.STRtree(boxes.footprints(boxes.of(things)))
    passages = [o for o in home.openings if o.kind in polygons.PASSAGES]
    swings = [o for o in passages if polygons.hinge(o, home) is not None]
    windows = [o for o in home.openings if o.kind == "window"]
    return [
        share("R_blocked", "doors", "apartment", np.array([_stands_in(areas, _zone(o, home)) for o in passages], bool)),
        share("R_blocked", "swings", "apartment",
              np.array([_stands_in(areas, polygons.swing(o, home)) for o in swings], bool)),
        share("R_blocked", "windows", "apartment", np.array([_covered(o, home, things) for o in windows], bool)),
    ]


def _zone(opening: Opening, home: Plan) -> Polygon:
    if opening.kind == "opening":
        return polygons.threshold(opening, home)
    return polygons.clearance(opening, home, DEPTH)


def _stands_in(areas: shapely.STRtree, zone: Polygon) -> bool:
    return len(areas.query(zone.buffer(-TOLERANCE), predicate="intersects")) > 0


def _covered(window: Opening, home: Plan, things: list[Box]) -> bool:
    before = polygons.before(window, home, window.rooms[0], BEHIND)
    tall = [o for o in things if o.center[2] + o.size[2] / 2 > window.sill + 0.05 and o.category not in SHADES]
    hidden = 0.0
    for area in boxes.footprints(boxes.of(tall)):
        along = shapely.get_coordinates(shapely.intersection(before, area)) @ polygons.along(window)
        hidden += float(np.ptp(along)) if along.size else 0.0
    return hidden > COVERED * polygons.width(window)

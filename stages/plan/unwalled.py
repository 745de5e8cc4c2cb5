"""Openings without a door between open-plan rooms: as wide as leaves a kitchen the end of a wall for its run."""

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.stages.plan import faces
from apartgen.stages.plan.faces import Face

FRAME = 0.1
"""Least wall between a door or an opening and a corner, m."""
WIDEST, LEAST = 3.2, 1.5
"""Widest opening, and the least that is left of one for the sake of a run, m."""
RUN, LONG = 0.66, 1.5
"""Wall that the depth of kitchen units takes beside an opening, and the least length of a run along the next one, m."""
AT, ASIDE = 0.25, 0.3
"""So near a corner of the floor a wall ends there; so near a floor another one lies behind a wall, m."""


def span(face: Face, kitchen: Polygon | None, reached: shapely.Geometry) -> tuple[float, float]:
    """From where to where along a wall an opening goes, m: all of it, but for the depth of units at that corner of the
    kitchen from which the longest run would begin, rather along what is not `reached` from it by a door."""
    clear = min(face.length - 2 * FRAME, WIDEST)
    lo = 0.5 * (face.length - clear)
    if kitchen is None or face.length - FRAME - RUN < LEAST:
        return lo, lo + clear
    ends = [(_run(face, kitchen, reached, at), at) for at in (0.0, face.length)]
    best, at = max(ends, key=lambda found: found[0])
    if best < LONG:
        return lo, lo + clear
    low, high = (RUN, FRAME) if at == 0.0 else (FRAME, RUN)
    clear = min(face.length - low - high, WIDEST)
    lo = min(max(0.5 * (face.length - clear), low), face.length - high - clear)
    return lo, lo + clear


def _run(face: Face, kitchen: Polygon, reached: shapely.Geometry, at: float) -> float:
    """Length of the kitchen's wall that meets a face's end, less what lies before rooms reached by doors, m."""
    corner = shapely.Point(face.start + at * face.along)
    for wall in faces.edges(kitchen):
        near = min(corner.distance(shapely.Point(wall.start + end * wall.along)) for end in (0.0, wall.length))
        if abs(float(np.dot(wall.along, face.along))) < 0.1 and near < AT:
            line = shapely.LineString([wall.start, wall.start + wall.length * wall.along])
            return wall.length - float(line.intersection(reached.buffer(ASIDE)).length)
    return 0.0

"""Plans that stand askew: turned to the axes to be worked on, and back."""

from math import cos, pi, radians, sin

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.base import Point
from apartgen.schemas.plan import Plan


def askew(shapes: list[Polygon]) -> float:
    """Angle in (-45°, 45°], radians, by which the greatest length of edges is turned from the axes."""
    edges = np.concatenate([np.diff(shapely.get_coordinates(shape.exterior), axis=0) for shape in shapes])
    lengths = np.hypot(*edges.T)
    angles = np.arctan2(edges[:, 1], edges[:, 0])
    apart = np.abs((angles[:, None] - angles + pi / 4) % (pi / 2) - pi / 4)
    angle = float(angles[np.argmax(np.round((apart < radians(0.2)) @ lengths, 6))])
    angle -= round(angle / (pi / 2)) * pi / 2
    return 0.0 if abs(angle) < 1e-6 else angle


def turned(points: list[Point], angle: float) -> list[Point]:
    """Points turned about the origin, to 0.1 mm."""
    if angle == 0.0:
        return points
    c, s = cos(angle), sin(angle)
    return [(round(c * x - s * y, 4) + 0.0, round(s * x + c * y, 4) + 0.0) for x, y in points]


def turned_plan(plan: Plan, angle: float) -> Plan:
    """A plan turned about the origin; its programme stays as it was."""
    if angle == 0.0:
        return plan
    rooms = [r.model_copy(update={"polygon": turned(r.polygon, angle)}) for r in plan.rooms]
    openings = [o.model_copy(update={"segment": tuple(turned(list(o.segment), angle))}) for o in plan.openings]
    return plan.model_copy(update={"rooms": rooms, "openings": openings})

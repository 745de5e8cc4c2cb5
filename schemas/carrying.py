"""What carries an object: another object's id, the floor, a wall or the ceiling.

The one place where that is told from geometry; artifacts record it (`on`), and whoever asks reads it there.
"""

from collections.abc import Sequence
from math import cos, sin
from typing import NamedTuple

from apartgen.schemas.base import Vector

FLOOR, WALL, CEILING = "floor", "wall", "ceiling"
BUILDING = (FLOOR, WALL, CEILING)
"""What carries an object and is none itself."""
CLOSE = 0.05
"""What is no further above the floor, over a top or below the ceiling stands or hangs there, m."""


class Body(NamedTuple):
    """A box, and where its kind belongs: floor, flat, wall, ceiling, top (of another), or empty where nobody knows."""

    id: str
    room: str
    place: str
    center: Vector
    size: Vector
    yaw: float

    @property
    def low(self) -> float:
        """Height of its underside, m."""
        return self.center[2] - self.size[2] / 2

    @property
    def high(self) -> float:
        """Height of its top, m."""
        return self.center[2] + self.size[2] / 2


def carrier(body: Body, others: Sequence[Body], height: float) -> str:
    """What carries a body among others, under a ceiling of that height, m.

    What belongs on a wall or the ceiling hangs there; what lies low is on the floor, unless it belongs on a top and is
    on one. Of several tops under its centre the highest carries it.
    """
    if body.place in (WALL, CEILING):
        return body.place
    if body.place != "top" and body.low <= CLOSE:
        return FLOOR
    under = [other for other in others if other is not body and other.room == body.room
             and other.place not in ("top", "flat", CEILING) and over(body, other)]
    if under:
        return max(under, key=lambda other: other.high).id
    if body.low <= CLOSE or body.place in (FLOOR, "flat"):
        return FLOOR
    return CEILING if not body.place and body.high >= height - CLOSE else WALL


def over(body: Body, other: Body) -> bool:
    """Whether a body's centre is over another and its underside about or below that one's top: tops may be sunk."""
    if not other.low < body.low <= other.high + CLOSE:
        return False
    x, y, c, s = body.center[0] - other.center[0], body.center[1] - other.center[1], cos(other.yaw), sin(other.yaw)
    return abs(c * x + s * y) <= other.size[0] / 2 and abs(c * y - s * x) <= other.size[1] / 2


def carriers(bodies: Sequence[Body], height: float) -> list[str]:
    """What carries each of an apartment's bodies."""
    return [carrier(body, bodies, height) for body in bodies]

"""Local controller: regulated pure pursuit with the parameters of Nav2's.

The robot heads for a point of the path a lookahead away, turns on the spot to it when that lies far to the side, and
slows in curves, near obstacles and before the goal. The lookahead grows with speed; it is cut short where the arc to
that point would touch something within the next second. In narrow places, where Nav2's defaults graze, it keeps to
the path closely and slowly.
"""

from dataclasses import dataclass
from functools import cached_property
from math import atan2, copysign, cos, hypot, pi, sin, sqrt

import numpy as np

from apartgen.stages.compiling import compiled
from apartgen.stages.embodied import base, planner
from apartgen.stages.embodied.floor import Field, Floor, clearance_at
from apartgen.stages.space.boxes import Array

Point = tuple[float, float]

PERIOD = 0.05
"""controller_frequency 20 Hz, s."""
LOOKAHEAD, LOOKAHEAD_TIME = (0.3, 0.9), 1.5
"""min_ and max_lookahead_dist, m; lookahead_time, s."""
ROTATE_ANGLE = 0.785
"""rotate_to_heading_min_angle."""
MIN_RADIUS, MIN_SPEED = 0.9, 0.25
"""regulated_linear_scaling_min_radius, m, and _min_speed, m/s."""
COST_DISTANCE = 0.6
"""cost_scaling_dist, m."""
APPROACH, APPROACH_SPEED = 0.6, 0.05
"""approach_velocity_scaling_dist, m, and min_approach_linear_velocity, m/s."""
TIME_TO_COLLISION = 1.0
"""max_allowed_time_to_collision_up_to_carrot, s."""
XY_TOLERANCE, YAW_TOLERANCE = 0.25, 0.25
"""Of Nav2's goal checker, m and rad."""
WITHIN = XY_TOLERANCE - 0.06
"""It drives on until it is so near, so that it still is within tolerance once it has stopped and turned, m."""
NARROW, NARROW_AHEAD = 0.10, 0.5
"""Where the path leaves less than this beside the robot, within so far ahead, it is narrow, m."""
NARROW_LOOKAHEAD, NARROW_SPEED, NARROW_ANGLE = 0.2, 0.2, 0.25
MARGIN = 0.04
"""Arcs keep this far from everything, or as far as the path itself does, m."""
TIGHT = 0.03
"""Where there is less than this, it goes from point to point, m."""
_SHORTEST = 0.05  # m, lookahead where everything longer would touch
_CREEP, _ALIGNED = 0.1, 0.06  # speed then, m/s, once it heads for the next point so closely, rad
_INCHING = 20  # periods
_PATIENCE = 60  # periods without getting any further along the path, after which it goes from point to point
LOOKS = 11
"""Points of the next second's way that are looked at."""


@dataclass
class Pursuit:
    """The controller on its way along a path (n, 2) to a final heading; `speed`, `turn` are the last commands.

    It has arrived `within` so many metres of the goal, `facing` within so many radians.
    """

    floor: Floor
    path: Array
    heading: float
    within: float = WITHIN
    facing: float = YAW_TOLERANCE
    at: int = 0
    speed: float = 0.0
    turn: float = 0.0
    arrived: bool = False
    """Within tolerance of the goal; only the heading is left."""
    turning: bool = False
    inching: int = 0
    """Periods for which it still goes from point to point."""
    waited: int = 0
    """Periods since it last got further along the path."""

    def command(self, x: float, y: float, yaw: float) -> tuple[float, float, bool]:
        """Speed (m/s) and turn (rad/s) for the next period, and whether the goal is reached."""
        here = x, y
        self._advance(here)
        left = _distance(here, self.points[-1])
        self.arrived = self.arrived or left < self.within
        if self.arrived:
            off = _wrapped(self.heading - yaw)
            done = abs(off) < self.facing and abs(self.speed) < 0.01
            self._limited(0.0, 0.0 if done else self._turn_to(off))
            return self.speed, self.turn, done and abs(self.turn) < 0.1
        self._limited(*self._wanted(here, yaw, left))
        return self.speed, self.turn, False

    @cached_property
    def points(self) -> list[Point]:
        """The path's points; numbers by themselves are faster than arrays of two."""
        return [(x, y) for x, y in self.path.tolist()]

    def _advance(self, here: Point) -> None:
        """The nearest point of the path, not looking back, nor further ahead than a metre."""
        further = _nearest(self.path[self.at : self.at + int(1.0 / planner.SPACING)], *here)
        self.at += further
        self.waited = 0 if further else self.waited + 1
        if self.waited > _PATIENCE:
            # Arcs to nearer and further points of the path may call for turns to either side, one after the other.
            self.inching, self.waited = _INCHING, 0

    def _wanted(self, here: Point, yaw: float, left: float) -> tuple[float, float]:
        tightest = self.tightest[self.at]
        narrow = tightest < base.RADIUS + NARROW
        room = max(min(base.RADIUS + MARGIN, tightest), base.RADIUS)
        if self.inching > 0 or tightest < base.RADIUS + TIGHT:
            return self._inched(here, yaw)
        reach = NARROW_LOOKAHEAD if narrow else _held(self.speed * LOOKAHEAD_TIME, *LOOKAHEAD)
        most = NARROW_ANGLE if narrow else ROTATE_ANGLE
        while True:
            carrot = self._carrot(here, reach)
            off = _off(here, yaw, carrot)
            if abs(off) > (most if not self.turning else most / 4):
                self.turning = True
                return 0.0, self._turn_to(off)
            self.turning = False
            distance = max(_distance(here, carrot), 1e-3)
            curvature = 2 * sin(off) / distance
            speed = min(self._regulated(here, curvature, left), NARROW_SPEED if narrow else base.SPEED)
            if self._clear(here, yaw, speed, curvature, distance, room):
                return speed, speed * curvature
            reach *= 0.75
            if reach < _SHORTEST:
                self.inching = _INCHING
                return self._inched(here, yaw)

    def _inched(self, here: Point, yaw: float) -> tuple[float, float]:
        """From point to point of the path, turning on the spot between them."""
        self.inching -= 1
        carrot = self._carrot(here, _SHORTEST)
        off = _off(here, yaw, carrot)
        self.turning = abs(off) > (_ALIGNED if self.turning else 3 * _ALIGNED)
        if self.turning:
            return 0.0, self._turn_to(off)
        return _CREEP, _CREEP * 2 * sin(off) / max(_distance(here, carrot), 1e-3)

    @cached_property
    def tightest(self) -> list[float]:
        """The least clearance of the path from each of its points to a little ahead, m."""
        beside = self.floor.beside(self.path)
        ahead = int(NARROW_AHEAD / planner.SPACING)
        return [float(beside[k : k + ahead].min()) for k in range(len(beside))]

    def _carrot(self, here: Point, reach: float) -> Point:
        """The first point of the path at least the lookahead away, or its end."""
        return self.points[_beyond(self.path, self.at, *here, reach)]

    def _regulated(self, here: Point, curvature: float, left: float) -> float:
        near = self.floor.near(*here)
        speed = base.SPEED * min(1.0, near / COST_DISTANCE, 1 / max(MIN_RADIUS * abs(curvature), 1e-9))
        speed = max(speed, MIN_SPEED)
        return speed if left > APPROACH else max(APPROACH_SPEED, speed * left / APPROACH)

    def _clear(
        self, here: Point, yaw: float, speed: float, curvature: float, distance: float, room: float
    ) -> bool:
        """Whether the next second on this arc, or as much of it as leads to the carrot, keeps clear of everything."""
        run = min(speed * TIME_TO_COLLISION, distance)
        bend = curvature if abs(curvature) > 1e-6 else 1e-6
        return _arc_clear(self.floor.field, *here, yaw, bend, run, room)

    def _turn_to(self, off: float) -> float:
        """As fast as still can be stopped in time."""
        return copysign(min(base.TURN, sqrt(2 * base.TURN_ACCELERATION * 0.6 * abs(off))), off)

    def _limited(self, speed: float, turn: float) -> None:
        """What the motors give of that within a period."""
        most, turn_most = base.ACCELERATION * PERIOD, base.TURN_ACCELERATION * PERIOD
        self.speed += _held(speed - self.speed, -most, most)
        self.turn += _held(turn - self.turn, -turn_most, turn_most)


@compiled()
def _nearest(points: Array, x: float, y: float) -> int:
    """Index of the first of the points (n, 2) that are nearest."""
    best, least = 0, np.inf
    for k in range(len(points)):
        away = (points[k, 0] - x) ** 2 + (points[k, 1] - y) ** 2
        if away < least:
            best, least = k, away
    return best


@compiled()
def _beyond(points: Array, first: int, x: float, y: float, reach: float) -> int:
    """Index of the first point (n, 2) on from one that is so far away, or of the last."""
    for k in range(first, len(points)):
        if sqrt((points[k, 0] - x) ** 2 + (points[k, 1] - y) ** 2) >= reach:
            return k
    return len(points) - 1


@compiled()
def _arc_clear(field: Field, x: float, y: float, yaw: float, bend: float, run: float, room: float) -> bool:
    """Whether an arc of a length and a curvature keeps so far from everything, at `LOOKS` points of it."""
    c, s = cos(yaw) / bend, sin(yaw) / bend
    for k in range(1, LOOKS + 1):
        share = k / LOOKS
        ahead, aside = sin(bend * run * share), 1 - cos(bend * run * share)
        if clearance_at(field, x + c * ahead - s * aside, y + s * ahead + c * aside) < room:
            return False
    return True


def _wrapped(angle: float) -> float:
    return (angle + pi) % (2 * pi) - pi


def _held(value: float, least: float, most: float) -> float:
    return min(max(value, least), most)


def _distance(a: Point, b: Point) -> float:
    return hypot(b[0] - a[0], b[1] - a[1])


def _off(here: Point, yaw: float, there: Point) -> float:
    """How far to the left of a heading a point lies, rad."""
    return _wrapped(atan2(there[1] - here[1], there[0] - here[0]) - yaw)

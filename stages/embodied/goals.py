"""Where to send the robot: from inside the entrance to a pose in front of one object of every room.

What opens is used from its front. Anything else is met from its front where one can stand there, or else from beside
(a chair at its table); what no robot gets to and does not open, as a plant behind a sofa, is no goal, unless the room
has no other. A room without furniture is met in its middle.
"""

from dataclasses import dataclass

import numpy as np

from apartgen.schemas.plan import Room
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.embodied.floor import Floor
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, footprints, grid, polygons, sweeps
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.things.carrying import by_another

Cell = tuple[int, int]
_ROOMY = 0.55  # m of clearance beyond which more is no better: the inflation radius


@dataclass(frozen=True)
class Goal:
    """A pose, or without one why there is none."""

    room: str
    object: str
    category: str
    cell: Cell | None = None
    yaw: float = 0.0
    missing: str = ""


def start(floor: Floor) -> tuple[Cell, float] | None:
    """The cell inside the entrance with most room about it, and the heading into the apartment; None if blocked."""
    open_ = floor.free & floor.space.entry
    if not open_.any():
        return None
    return _best(np.where(open_, floor.clearance, -1.0)), polygons.inward(floor.space.plan) or 0.0


def goals(floor: Floor, objects: list[Furnishing], reached: Mask, rng: np.random.Generator) -> list[Goal]:
    """One for each room, its object drawn from those that stand there; each room draws for itself."""
    lanes = rng.spawn(len(floor.space.plan.rooms))
    return [_goal(floor, k, room, objects, reached, lane) for k, (room, lane) in
            enumerate(zip(floor.space.plan.rooms, lanes, strict=True))]


def worth_meeting(o: Furnishing) -> bool:
    """Whether it stands on the floor, or hangs low, and not on other furniture."""
    return reach.in_the_way(o) and not footprints.gives_way(o) and not by_another(o)


def _goal(
    floor: Floor, index: int, room: Room, objects: list[Furnishing], reached: Mask, rng: np.random.Generator
) -> Goal:
    here = floor.space.rooms == index
    standing = [o for o in objects if o.room == room.id and worth_meeting(o)]
    if not standing:
        return _chosen(Goal(room.id, room.id, room.type), floor, [here & floor.free], reached, None)
    opens = sweeps.articulated(standing)
    meant = [o for o, must in zip(standing, opens, strict=True)
             if must or any((place & here & reached).any() for place in _places(floor, o))]
    o = (meant or standing)[int(rng.integers(len(meant or standing)))]
    places = [place & here & floor.free for place in _places(floor, o)]
    return _chosen(Goal(room.id, o.id, o.category), floor, places, reached, np.array(o.center[:2]))


def _places(floor: Floor, o: Furnishing) -> list[Mask]:
    """Cells from which an object is met, the better ones first."""
    front = np.zeros(floor.grid.shape, bool)
    window, zone = reach.standing(o, floor.grid, reach.REACH, floor.radius)
    front[window] = zone
    if sweeps.articulated([o])[0]:
        return [front]
    return [front, grid.near(boxes.of([o]), floor.grid, reach.REACH) > 0]


def _chosen(goal: Goal, floor: Floor, places: list[Mask], reached: Mask, towards: Array | None) -> Goal:
    """The goal's pose: the roomiest of the cells that are reached, nearer ones first among equals."""
    for place in places:
        if (place & reached).any():
            x, y = np.meshgrid(floor.grid.x, floor.grid.y)
            far = 0.0 if towards is None else np.hypot(x - towards[0], y - towards[1])
            row, column = _best(np.where(place & reached, floor.clearance.clip(max=_ROOMY) - 0.1 * far, -np.inf))
            away = np.zeros(2) if towards is None else towards - [x[row, column], y[row, column]]
            yaw = float(np.arctan2(away[1], away[0]))
            return Goal(goal.room, goal.object, goal.category, (row, column), yaw)
    missing = "planner" if any(place.any() for place in places) else "no standing room"
    return Goal(goal.room, goal.object, goal.category, missing=missing)


def _best(score: Array) -> Cell:
    row, column = np.unravel_index(int(score.argmax()), score.shape)
    return int(row), int(column)

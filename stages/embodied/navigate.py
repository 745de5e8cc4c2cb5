"""Navigation: from the entrance to a pose in front of a random object of every room (SR_nav, SPL, contacts).

An episode succeeds when the robot comes to rest within 0.25 m of the pose, facing the object, having touched nothing
harder than a graze, within the time limit.
"""

import numpy as np
import shapely

from stages.boxes import Array, Mask
from stages.embodied import base, floor, goals, planner, world
from stages.embodied.drive import Drive, drive
from stages.embodied.floor import Floor
from stages.embodied.goals import Goal
from stages.embodied.outcome import Outcome
from stages.embodied.planner import Roadmap
from stages.embodied.pursuit import XY_TOLERANCE, Pursuit
from stages.embodied.world import World

PATIENCE, SLOWEST = 30.0, 0.1
"""Time limit: so many seconds, and the way at so many metres a second."""
_TOUCHABLE = 0.15  # m about the places where the robot can be; colliders further off are left out
_BLOCK = 4  # cells in a row that are looked at as one for this


def run(apartment: World, rng: np.random.Generator, only: str | None = None) -> list[Outcome]:
    """An episode for every room of a world without a robot; `only` one object's, and then with its trace."""
    name, objects = apartment.name, apartment.home.objects
    ground = floor.survey(apartment, base.RADIUS, base.HEIGHT)
    began = goals.start(ground)
    if began is None:
        there = goals.goals(ground, objects, np.zeros(ground.grid.shape, bool), rng)
        return [_failed(name, goal, "planner", "the entrance is blocked") for goal in there]
    cell, yaw = began
    ways = planner.roadmap(ground, cell)
    there = [g for g in goals.goals(ground, objects, ways.reached, rng) if only in (None, g.object)]
    driven = world.build(apartment.scene, apartment.mjcf, base.mjcf(), moving=(), fused=True, name=name,
                         without=_out_of_reach(apartment, ground, ways.reached), source=apartment.source)
    return [_episode(driven, ways, goal, yaw, only is not None) for goal in there]


def _out_of_reach(apartment: World, ground: Floor, reached: Mask) -> list[str]:
    """Colliders that the robot can't touch wherever it drives; the ground stays."""
    blocks = np.unique(np.argwhere(reached) // _BLOCK, axis=0)
    size = ground.grid.resolution
    points = shapely.points(ground.grid.origin + (blocks[:, ::-1] + 0.5) * _BLOCK * size)
    names = list(ground.parts)
    far = base.RADIUS + _TOUCHABLE + _BLOCK * size * np.sqrt(0.5)
    near = shapely.STRtree(list(ground.parts.values())).query(points, predicate="dwithin", distance=far)[1]
    model = apartment.model
    keep = {names[k] for k in set(near.tolist())}
    keep |= {model.geom(k).name for k in range(model.ngeom) if _is_ground(apartment, k)}
    return [name for k in range(model.ngeom) if (name := model.geom(k).name) not in keep]


def _is_ground(still: World, geom: int) -> bool:
    return bool(still.model.body(still.model.geom_bodyid[geom]).name == "ground")


def _episode(driven: World, ways: Roadmap, goal: Goal, yaw: float, trace: bool) -> Outcome:
    if goal.cell is None:
        blocked = goal.missing == "planner"
        reason = "no way from the entrance" if blocked else "the robot fits nowhere in front of it"
        return _failed(driven.name, goal, "planner" if blocked else "no standing room", reason)
    path, shortest = ways.path(goal.cell), ways.shortest(goal.cell)
    limit = PATIENCE + float(np.hypot(*np.diff(path, axis=0).T).sum()) / SLOWEST
    went = drive(driven, Pursuit(ways.floor, path, goal.yaw), yaw, limit)
    return _judged(driven.name, goal, went, path, shortest, trace)


def _judged(name: str, goal: Goal, went: Drive, path: Array, shortest: float, trace: bool) -> Outcome:
    missed = float(np.hypot(went.pose[0] - path[-1, 0], went.pose[1] - path[-1, 1]))
    reason = went.reason or ("" if missed <= XY_TOLERANCE else "did not stop at the goal")
    success = not reason
    numbers = {
        "spl": float(success) * (shortest / max(went.metres, shortest) if shortest else 1.0), "shortest": shortest,
        "metres": went.metres, "seconds": went.seconds, "missed": missed, "push": went.push,
        "touches": float(went.touches), "goal_x": path[-1, 0], "goal_y": path[-1, 1], "goal_yaw": goal.yaw,
    }
    return Outcome(
        apartment=name, episode="navigation", room=goal.room, object=goal.object, category=goal.category,
        success=success, failure=None if success else "controller", reason=reason,
        numbers={key: round(float(value), 4) for key, value in numbers.items()}, trace=went.trace if trace else None,
    )


def _failed(name: str, goal: Goal, failure: str, reason: str) -> Outcome:
    return Outcome.model_validate({
        "apartment": name, "episode": "navigation", "room": goal.room, "object": goal.object,
        "category": goal.category, "success": False, "failure": failure, "reason": reason, "numbers": {"spl": 0.0},
    })

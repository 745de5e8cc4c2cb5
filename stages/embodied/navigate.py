"""Navigation: from the entrance to a pose in front of a random object of every room (SR_nav, SPL, contacts).

An episode succeeds when the robot comes to rest within 0.25 m of the pose, facing the object, having touched nothing
harder than a graze, within the time limit.
"""

import numpy as np

from apartgen.stages.embodied import base, floor, goals, planner, world
from apartgen.stages.embodied.drive import Drive, drive
from apartgen.stages.embodied.goals import Goal
from apartgen.stages.embodied.outcome import Outcome
from apartgen.stages.embodied.planner import Roadmap
from apartgen.stages.embodied.pursuit import XY_TOLERANCE, Pursuit
from apartgen.stages.embodied.world import World
from apartgen.stages.space.boxes import Array

PATIENCE, SLOWEST = 30.0, 0.1
"""Time limit: so many seconds, and the way at so many metres a second."""
WHY = {"planner": "no way from the entrance", "no standing room": "the robot fits nowhere in front of it"}
"""Of a goal without a place."""


def run(apartment: World, rng: np.random.Generator, only: str | None = None) -> list[Outcome]:
    """An episode for every room of a world with the base in it; `only` one object's, and then with its trace."""
    name = apartment.name
    ways, yaw, there = asked(apartment, rng)
    if ways is None:
        return [_failed(name, goal, "planner", "the entrance is blocked") for goal in there]
    there = [g for g in there if only in (None, g.object)]
    alone = world.build(apartment.scene, apartment.mjcf, base.mjcf(), moving=(), fused=True,
                        without=floor.above_ground(apartment), source=apartment.source)
    return [_episode(apartment, alone, ways, goal, yaw, only is not None) for goal in there]


def asked(apartment: World, rng: np.random.Generator) -> tuple[Roadmap | None, float, list[Goal]]:
    """The ways from the start (None where the entrance is blocked), the heading there, and the goal of every room."""
    objects = apartment.home.objects
    ground = floor.survey(apartment, base.RADIUS, base.HEIGHT)
    began = goals.start(ground)
    if began is None:
        return None, 0.0, goals.goals(ground, objects, np.zeros(ground.grid.shape, bool), rng)
    cell, yaw = began
    ways = planner.roadmap(ground, cell)
    return ways, yaw, goals.goals(ground, objects, ways.reached, rng)


def limit(path: Array) -> float:
    """The time that a path (n, 2) may take, s."""
    return PATIENCE + float(np.hypot(*np.diff(path, axis=0).T).sum()) / SLOWEST


def _episode(apartment: World, alone: World, ways: Roadmap, goal: Goal, yaw: float, trace: bool) -> Outcome:
    if goal.cell is None:
        return _failed(apartment.name, goal, goal.missing, WHY[goal.missing])
    path, shortest = ways.path(goal.cell), ways.shortest(goal.cell)
    went = drive(apartment, alone, Pursuit(ways.floor, path, goal.yaw), yaw, limit(path))
    return _judged(apartment.name, goal, went, path, shortest, trace)


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
        course=went.course,
    )


def _failed(name: str, goal: Goal, failure: str, reason: str) -> Outcome:
    return Outcome.model_validate({
        "apartment": name, "episode": "navigation", "room": goal.room, "object": goal.object,
        "category": goal.category, "success": False, "failure": failure, "reason": reason, "numbers": {"spl": 0.0},
    })

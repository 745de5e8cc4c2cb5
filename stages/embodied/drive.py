"""Drives the base along a path in physics, and feels what it touches."""

from dataclasses import dataclass, field
from math import atan2, hypot
from typing import Any

import mujoco
import numpy as np

from apartgen.stages.embodied import base
from apartgen.stages.embodied.outcome import Course, Trace
from apartgen.stages.embodied.pursuit import PERIOD, Pursuit
from apartgen.stages.embodied.world import ROBOT, World
from apartgen.stages.space.boxes import Array

GRAZE = 15.0
"""Greatest push that is only a graze, N, mean over a controller period, as a bumper would report it.

It is what starts to move the lightest loose furniture (3 kg, friction 0.5): a graze leaves everything where it was.
"""
LOST = 2.0
"""A robot that stands still this long though it should drive is stuck, s."""
FRAME = 0.2
"""Between frames of the trace, s."""
STEP, STRIDE = 0.01, 0.025
"""Of the simulation where something may be touched, and where nothing can be, s; a period is some of either."""
_CLEAR = 0.05  # m of clearance above which no contact can come within a period: the way driven, and half a cell


@dataclass
class Drive:
    """How it went: seconds, metres, greatest push (N), touches, what was touched first, and how it ended."""

    seconds: float = 0.0
    metres: float = 0.0
    push: float = 0.0
    touches: int = 0
    touched: str = ""
    done: bool = False
    reason: str = ""
    pose: tuple[float, float, float] = (0.0, 0.0, 0.0)
    course: Course = field(default_factory=Course)
    trace: Trace = field(default_factory=lambda: Trace(joints=list(base.JOINTS)))


def drive(world: World, alone: World, pursuit: Pursuit, yaw: float, limit: float) -> Drive:
    """From the path's start, facing `yaw`, until arrival, a push harder than a graze, or `limit` seconds.

    `alone` is the world with nothing in it but robot and ground, simulated where nothing else is near.
    """
    out, near, column = Drive(), True, world.model.geom(f"{ROBOT}_column").id
    data = _standing(world.model, pursuit.path[0], yaw)
    away = mujoco.MjData(alone.model)
    world.model.opt.timestep, alone.model.opt.timestep = STEP, STRIDE
    still, touching = 0.0, False
    out.pose = _pose(data.qpos)
    while not out.reason and not out.done:
        x, y, yaw = out.pose
        _record(out, data.qpos)
        speed, turn, out.done = _commanded(pursuit, out)
        if near != (pursuit.floor.near(x, y) <= base.RADIUS + _CLEAR):
            near = not near
            _hand_over(data, away)
            data, away = away, data
        data.ctrl[:] = (speed - turn * base.TRACK / 2) / base.WHEEL, (speed + turn * base.TRACK / 2) / base.WHEEL
        if near:
            push, what = felt(world.model, data, round(PERIOD / STEP), column)
        else:
            mujoco.mj_step(alone.model, data, round(PERIOD / STRIDE))
            push, what = 0.0, -1
        out.touches += push > 0 and not touching
        touching = push > 0
        if push > out.push:
            out.push, out.touched = push, world.owner.get(what, "the building")
        out.pose = _pose(data.qpos)
        moved = hypot(out.pose[0] - x, out.pose[1] - y)
        out.metres += moved
        still = still + PERIOD if moved < 1e-3 and abs(out.pose[2] - yaw) < 1e-3 else 0.0
        out.seconds += PERIOD
        out.reason = _ended(out, still, limit)
    return out


def _commanded(pursuit: Pursuit, out: Drive) -> tuple[float, float, bool]:
    """Speed and turn for the next period, and whether the goal is reached; the course knows of it."""
    went, goal = np.array([*out.pose, pursuit.speed, pursuit.turn]), np.array([*pursuit.path[-1], pursuit.heading])
    speed, turn, done = pursuit.command(*out.pose)
    out.course.add(went, goal, np.array([speed, turn]))
    return speed, turn, done


def _ended(out: Drive, still: float, limit: float) -> str:
    if out.push > GRAZE:
        return f"ran against {out.touched}"
    if out.done:
        return ""
    return "stuck" if still > LOST else "too slow" if out.seconds > limit else ""


def _standing(model: Any, at: Array, yaw: float) -> Any:
    data = mujoco.MjData(model)
    joint = model.joint(base.JOINTS[0]).qposadr[0]
    data.qpos[joint : joint + 7] = *at, 0.0, np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)
    mujoco.mj_forward(model, data)
    return data


def _hand_over(here: Any, there: Any) -> None:
    """Go on in another model of the same robot."""
    there.qpos[:], there.qvel[:], there.qacc_warmstart[:] = here.qpos, here.qvel, here.qacc_warmstart


def _pose(qpos: Array) -> tuple[float, float, float]:
    x, y, _, w, _, _, z = qpos[:7].tolist()
    return x, y, 2 * atan2(z, w)


def felt(model: Any, data: Any, steps: int, column: int) -> tuple[float, int]:
    """Mean push on the column over some steps, N, and the geom pushed last (-1 for none)."""
    total, what, force = 0.0, -1, np.zeros(6)
    for _ in range(steps):
        mujoco.mj_step(model, data)
        pairs = data.contact.geom
        for k in np.flatnonzero((pairs == column).any(1)) if len(pairs) else ():
            mujoco.mj_contactForce(model, data, int(k), force)
            total += abs(force[0])
            what = int(pairs[k][0] if pairs[k][1] == column else pairs[k][1])
    return total / steps, what


def _record(out: Drive, qpos: Array) -> None:
    if len(out.trace.times) * FRAME <= out.seconds + 1e-9:
        out.trace.times.append(round(out.seconds, 3))
        out.trace.qpos.append([round(float(v), 4) for v in qpos[:7]])

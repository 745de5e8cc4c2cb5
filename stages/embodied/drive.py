"""Drives the base along a path in physics, and feels what it touches."""

from dataclasses import dataclass, field
from typing import Any

import mujoco
import numpy as np

from stages.boxes import Array
from stages.embodied import base, planner
from stages.embodied.outcome import Trace
from stages.embodied.pursuit import PERIOD, Pursuit
from stages.embodied.world import ROBOT, World

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
_NEAR = 0.05  # m of clearance above which no contact can come within a period: the way driven, and half a cell


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
    trace: Trace = field(default_factory=lambda: Trace(joints=list(base.JOINTS)))


def drive(world: World, pursuit: Pursuit, yaw: float, limit: float) -> Drive:
    """From the path's start, facing `yaw`, until arrival, a push harder than a graze, or `limit` seconds."""
    model, out = world.model, Drive()
    data = _standing(model, pursuit.path[0], yaw)
    column = model.geom(f"{ROBOT}_column").id
    drives = [model.actuator(name).id for name in base.DRIVES]
    still, touching = 0.0, False
    while not out.reason and not out.done:
        x, y, yaw = out.pose = _pose(data)
        _record(out, data)
        speed, turn, out.done = pursuit.command(x, y, yaw)
        data.ctrl[drives] = (speed - turn * base.TRACK / 2) / base.WHEEL, (speed + turn * base.TRACK / 2) / base.WHEEL
        if planner.clearance(pursuit.floor, x, y) > base.RADIUS + _NEAR:
            model.opt.timestep = STRIDE
            mujoco.mj_step(model, data, round(PERIOD / STRIDE))
            push, what = 0.0, -1
        else:
            model.opt.timestep = STEP
            push, what = felt(model, data, round(PERIOD / STEP), column)
        out.touches += push > 0 and not touching
        touching = push > 0
        if push > out.push:
            out.push, out.touched = push, world.owner.get(what, "the building")
        moved = float(np.hypot(data.qpos[0] - x, data.qpos[1] - y))
        out.metres += moved
        still = still + PERIOD if moved < 1e-3 and abs(_pose(data)[2] - yaw) < 1e-3 else 0.0
        out.seconds += PERIOD
        out.reason = _ended(out, still, limit)
    out.pose = _pose(data)
    return out


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


def _pose(data: Any) -> tuple[float, float, float]:
    x, y, _, w, _, _, z = data.qpos[:7]
    return float(x), float(y), float(2 * np.arctan2(z, w))


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


def _record(out: Drive, data: Any) -> None:
    if len(out.trace.times) * FRAME <= out.seconds + 1e-9:
        out.trace.times.append(round(out.seconds, 3))
        out.trace.qpos.append([round(float(v), 4) for v in data.qpos[:7]])

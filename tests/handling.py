"""What a hand does in a populated home in MuJoCo: opens and shuts parts with things in them, takes things away."""

import re
from pathlib import Path
from typing import NamedTuple

import mujoco
import numpy as np

from apartgen.stages.export import mjcf
from apartgen.stages.scene.scene import Scene

TAKES, REST, SETTLES = 1.2, 0.6, 1.0
"""Seconds that a part takes each way, that it is left alone after, and that a home has to come to rest before."""
PUSH, TWIST = 60.0, 25.0
"""Force on what slides, N, and torque on what turns, N·m, at most."""
FALLEN = 0.05


class Moved(NamedTuple):
    """A part with so many things in it: what share of its range it opened, how far open it stayed, and what left it."""

    joint: str
    things: int
    opened: float
    left: float
    fallen: tuple[str, ...]

    @property
    def jams(self) -> bool:
        """Whether it did not open or did not shut."""
        return self.opened < 0.9 or self.left > 0.05


def model(home, load, folder: Path):
    """The home as MuJoCo has it, without what only shows."""
    files = mjcf.write(Scene(home, load, shown=False), folder)
    return mujoco.MjModel.from_xml_path(str(files[0]))


def contents(home):
    """Names of joints by which things are got at, and ids of the things."""
    parts = {(id, place.name): place.part for id, places in home.receptacles.items() for place in places}
    held = {}
    for o in home.objects:
        inside = getattr(o, "in_", None)
        if inside and (part := parts.get((inside.object, inside.receptacle))):
            held.setdefault((f"{inside.object}__{part}__joint", inside.object), []).append(o.id)
    return held


def opened(home, made):
    """Every part that has things behind it or in it, opened and shut again, one at a time; what rests sleeps."""
    made.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    rested = mujoco.MjData(made)
    while rested.time < SETTLES:
        mujoco.mj_step(made, rested)
    for (joint, owner), ids in contents(home).items():
        yield _one(made, rested, joint, owner, ids)


def _one(made, rested, joint, owner, ids):
    data = mujoco.MjData(made)
    mujoco.mj_copyData(data, made, rested)
    known = made.joint(joint)
    dof, at, (low, high) = known.dofadr[0], known.qposadr[0], known.range
    wide = high if abs(high) > abs(low) else low
    slides = made.jnt_type[known.id] == mujoco.mjtJoint.mjJNT_SLIDE
    most, stiff, damped = (PUSH, 1800.0, 120.0) if slides else (TWIST, 60.0, 5.0)
    before = np.array([data.body(id).xpos for id in ids]).copy()
    base, reached = data.body(owner).xpos[:2].copy(), 0.0
    while data.time < rested.time + 2 * TAKES + REST:
        t = (data.time - rested.time) / TAKES
        goal = wide * np.clip(min(1.15 * t, 2.1 - t), 0, 1)
        data.qfrc_applied[dof] = np.clip(stiff * (goal - data.qpos[at]) - damped * data.qvel[dof], -most, most)
        mujoco.mj_step(made, data)
        reached = max(reached, data.qpos[at] / wide)
    after = np.array([data.body(id).xpos for id in ids])
    low_, far = after[:, 2] < before[:, 2] - FALLEN, np.linalg.norm(after[:, :2] - base, axis=1)
    out = far > np.linalg.norm(before[:, :2] - base, axis=1) + 0.3
    return Moved(joint, len(ids), float(reached), float(abs(data.qpos[at] / wide)),
                 tuple(id for id, gone in zip(ids, low_ | out) if gone))


HAND = """<body name="hand" gravcomp="1" sleep="never"><freejoint name="hand"/>
<inertial pos="0 0 0" mass="1" diaginertia=".01 .01 .01"/>
<body name="f0" gravcomp="1"><joint name="f0" type="slide" axis="-1 0 0" damping="10"/>
<geom name="f0" type="box" size=".004 .01 .02" mass=".05" friction="1" condim="4" solref="0.008 1"/></body>
<body name="f1" gravcomp="1"><joint name="f1" type="slide" axis="1 0 0" damping="10"/>
<geom name="f1" type="box" size=".004 .01 .02" mass=".05" friction="1" condim="4" solref="0.008 1"/></body></body>
<body name="led" mocap="true"/></worldbody><equality><weld body1="led" body2="hand" solref="0.008 1"/>
<joint joint1="f0" joint2="f1"/></equality>"""
"""Fingers 8 mm thick, 20 mm wide and 40 mm long, 10 mm of them beyond where they hold, without palm and arm."""
BEYOND = 0.01
FORCE, LIFT, BACK, AWAY = 30.0, 0.1, 0.12, 9.0
"""N; how far a thing is lifted, from how far the hand comes, and where it is when nobody needs it, m."""
COMES, CLOSES, LIFTS, HOLDS = 0.5, 0.3, 1.0, 2.0
"""Seconds."""


def model_with_hand(home, load, folder: Path):
    """The home and a hand that goes where it is led."""
    (path, *_) = mjcf.write(Scene(home, load, shown=False), folder)
    text = path.read_text(encoding="utf-8")
    head, tail = text.split("</worldbody>")
    path.write_text(head + HAND + re.sub(r"<keyframe>.*?</keyframe>", "", tail, flags=re.DOTALL), encoding="utf-8")
    made = mujoco.MjModel.from_xml_path(str(path))
    made.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    rested = mujoco.MjData(made)
    _put(made, rested, np.array([0.0, 0.0, AWAY]), np.eye(3))
    while rested.time < SETTLES:
        mujoco.mj_step(made, rested)
    return made, rested


def _put(made, data, at, turn):
    """The hand at a place, turned so, and led there."""
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(turn).ravel())
    start = made.joint("hand").qposadr[0]
    data.qpos[start:start + 9] = [*at, *quat, 0, 0]
    data.qvel[made.joint("hand").dofadr[0]:][:8] = 0
    data.mocap_pos[0], data.mocap_quat[0] = at, quat


def under_boards(home):
    """Ids of things that lie below a board: on shelves and in cupboards."""
    kinds = {(id, place.name): place.kind for id, places in home.receptacles.items() for place in places}
    return {o.id for o in home.objects if (inside := getattr(o, "in_", None))
            and kinds[inside.object, inside.receptacle] in ("shelf", "inside")}


def taken(made, rested, o, part=None, along=(), under=False):
    """Empty where one of the grasps that are told of a thing takes it, else what came of the last. The part before it
    is wide open, with what is `along` in it; what is `under` a board leaves by the side that it is taken from.
    """
    why = "no grasp"
    for grasp in o.grasps:
        data = mujoco.MjData(made)
        mujoco.mj_copyData(data, made, rested)
        if part:
            _open(made, data, part, along)
        why = _grasped(made, data, o.id, grasp, under)
        if not why:
            return ""
    return why


def _open(made, data, part, along):
    joint = made.joint(part)
    low, high = joint.range
    wide = high if abs(high) > abs(low) else low
    data.qpos[joint.qposadr[0]] = wide
    if made.jnt_type[joint.id] == mujoco.mjtJoint.mjJNT_SLIDE:
        for id in along:
            start = made.joint(f"{id}__free").qposadr[0]
            data.qpos[start:start + 3] += wide * data.xaxis[joint.id]
    mujoco.mj_forward(made, data)


def _grasped(made, data, id, grasp, under):
    turn, start = data.body(id).xmat.reshape(3, 3), data.body(id).xpos.copy()
    approach, close = turn @ grasp.approach, turn @ grasp.close
    at = start + turn @ grasp.at
    hand = np.stack([close, np.cross(approach, close), approach], 1)
    fingers = [made.geom(name).id for name in ("f0", "f1")]
    made.geom_sameframe[fingers] = 0
    for k, finger in enumerate(fingers):
        made.geom_pos[finger] = [(1 - 2 * k) * (grasp.width / 2 + 0.004), 0, BEYOND - 0.02]
    _put(made, data, at - BACK * approach, hand)
    mujoco.mj_forward(made, data)
    if any(c.dist < -1e-3 and {c.geom1, c.geom2} & {*fingers} for c in data.contact[:data.ncon]):
        return "no room"
    # From under a board by the side that it is taken from, else straight up.
    away = np.array([0, 0, 0.01]) - LIFT * approach if under and approach[2] > -0.9 else np.array([0, 0, LIFT])
    dofs, begin = [made.joint(name).dofadr[0] for name in ("f0", "f1")], data.time
    while 0 <= (t := data.time - begin) < COMES + CLOSES + LIFTS + HOLDS:  # time begins anew where a simulation bursts
        data.mocap_pos[0] = (at - BACK * approach * np.clip(1 - t / COMES, 0, 1)
                             + away * np.clip((t - COMES - CLOSES) / LIFTS, 0, 1))
        data.qfrc_applied[dofs] = FORCE * np.clip((t - COMES) / 0.1, 0, 1)
        mujoco.mj_step(made, data)
    went = data.body(id).xpos - start
    return "burst" if t < 0 else "" if went @ away > 0.85 * away @ away else "slipped"

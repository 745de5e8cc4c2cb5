"""What a flat does in MuJoCo when left alone, and when each of its joints is driven by hand force."""

from typing import NamedTuple

import mujoco
import numpy as np

DEEP = 0.001
"""What touches no deeper slides along it, m."""
STEPS = 600
"""Each way, at most."""


class Rest(NamedTuple):
    """How far any geom went and whose it was, energy gained, the greatest speed at the end."""

    drift: float
    worst: str
    energy: float
    speed: float


def rest(model, seconds):
    """Leaves the flat alone."""
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start, energy = data.geom_xpos.copy(), float(data.energy.sum())
    gained = 0.0
    while data.time < seconds:
        mujoco.mj_step(model, data)
        gained = max(gained, float(data.energy.sum()) - energy)
    drift = np.linalg.norm(data.geom_xpos - start, axis=1)
    worst = model.body(model.geom_bodyid[int(drift.argmax())]).name
    return Rest(float(drift.max()), worst, gained, float(np.abs(data.qvel).max(initial=0.0)))


def rubbing(path):
    """Parts that enter their own object somewhere between their ends, found with no pair of bodies excluded."""
    spec = mujoco.MjSpec.from_file(str(path))
    for exclude in list(spec.excludes):
        spec.delete(exclude)
    spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_FILTERPARENT
    model = spec.compile()
    data = mujoco.MjData(model)
    found = set()
    for joint in _joints(model):
        part, at = model.jnt_bodyid[joint], model.jnt_qposadr[joint]
        for value in np.linspace(*model.jnt_range[joint], 13):
            mujoco.mj_resetData(model, data)
            data.qpos[at] = value
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_collision(model, data)
            for contact in data.contact:
                bodies = [int(model.geom_bodyid[geom]) for geom in contact.geom]
                own = model.body_rootid[bodies[0]] == model.body_rootid[bodies[1]]
                if contact.dist < -DEEP and part in bodies and own:
                    met = model.body(next(b for b in bodies if b != part)).name
                    found.add(f"{model.joint(joint).name} at {value:.2f} is {-contact.dist:.4f} m in {met}")
    return sorted(found)


def stuck(model):
    """Joints that hand force does not bring to both ends of their range, one at a time, and what they stop against."""
    return [fault for joint in _joints(model) for fault in _driven(model, joint)]


def held(model, joint):
    """What a hand must overcome before a joint moves: dry friction, and what holds it at its ends."""
    own = model.actuator_trnid[:, 0] == joint if model.nu else np.zeros(0, bool)
    held_at = np.abs(model.actuator_forcerange[own]).max(initial=0.0)
    return float(model.dof_frictionloss[model.jnt_dofadr[joint]] + held_at)


def _joints(model):
    return [int(k) for k in np.flatnonzero(model.jnt_type != mujoco.mjtJoint.mjJNT_FREE)]


def _driven(model, joint):
    at, dof, part = model.jnt_qposadr[joint], model.jnt_dofadr[joint], model.jnt_bodyid[joint]
    lo, hi = model.jnt_range[joint]
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    holding = held(model, joint)
    most = holding + min(15.0, 0.5 + 3 * float(model.body_mass[part]))
    # A brake that is too strong for a light lid makes it chatter.
    brake = min(8.0, 0.4 * float(model.dof_M0[dof]) / model.opt.timestep)
    for target in (hi, lo):
        for _ in range(STEPS):
            push = 40 * (target - data.qpos[at]) + holding * np.sign(target - data.qpos[at]) - brake * data.qvel[dof]
            data.qfrc_applied[dof] = np.clip(push, -most, most)
            mujoco.mj_step(model, data)
            if abs(data.qpos[at] - target) <= 0.05 * (hi - lo):
                break
        else:
            touching = (model.geom_bodyid[contact.geom] for contact in data.contact)
            met = sorted({model.body(int(b)).name for pair in touching if part in pair for b in pair if b != part})
            yield f"{model.joint(joint).name} stops at {data.qpos[at]:.2f} of {lo:.2f}..{hi:.2f} against {met}"
            return

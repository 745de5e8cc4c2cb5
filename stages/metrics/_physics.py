"""What an exported apartment does in a physics engine: how far things drift, how far joints can be driven."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

SETTLE = 2.0
"""Time things are left alone, s."""
DRIVE = 2.4
"""Time a joint is driven for, s."""
DRIFT = 0.05
"""What moves further than this has not stood, m."""
APART = 4.0
"""Joints so far from each other do not disturb one another, m."""
REACHED = 0.95
"""Share of its range by which a joint counts as opened."""
FORCE = 15.0
"""Most that a hand pushes or turns with, N or N m."""


class Travel(NamedTuple):
    """A joint and the share of its range that it can be driven over from where it rests."""

    joint: str
    share: float


def mjcf_model(path: Path) -> Any:
    """An MJCF file as a MuJoCo model."""
    import mujoco

    return mujoco.MjModel.from_xml_path(str(path))


def drift(model: Any) -> dict[str, float]:
    """How far the centre of mass of every loose body is from its start after `SETTLE` seconds, m."""
    import mujoco

    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    loose = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    start = data.xipos[loose].copy()
    while data.time < SETTLE:
        mujoco.mj_step(model, data)
    moved = np.linalg.norm(data.xipos[loose] - start, axis=1)
    return {model.body(body).name: float(d) for body, d in zip(loose, moved, strict=True)}


def travels(model: Any) -> list[Travel]:
    """Every hinge and slide, driven from where it rests to the far end of its range while nothing near it is."""
    import mujoco

    joints = [j for j in range(model.njnt) if model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE]
    found: dict[int, float] = {}
    for batch in _batches(model, joints):
        found |= zip(batch, _driven(model, batch), strict=True)
    return [Travel(model.joint(j).name, found[j]) for j in joints]


def _batches(model: Any, joints: list[int]) -> list[list[int]]:
    """Joints that are driven together, any two of them `APART`."""
    import mujoco

    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    batches: list[list[int]] = []
    for j in joints:
        far = [b for b in batches if np.linalg.norm(data.xanchor[b] - data.xanchor[j], axis=1).min() >= APART]
        if far:
            far[0].append(j)
        else:
            batches.append([j])
    return batches


def _driven(model: Any, joints: list[int]) -> list[float]:
    """Each by a spring and a damper of limited force, as a hand would; the greatest share reached, 1 from `REACHED`."""
    import mujoco

    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    address, dof, body = model.jnt_qposadr[joints], model.jnt_dofadr[joints], model.jnt_bodyid[joints]
    lo, hi = model.jnt_range[joints].T
    rest = data.qpos[address].copy()
    target = np.where(np.abs(hi - rest) >= np.abs(lo - rest), hi, lo)
    most = np.minimum(FORCE, 0.5 + 3 * model.body_mass[body])
    # A brake that is too strong for a light lid makes it chatter.
    brake = np.minimum(8.0, 0.4 * model.dof_M0[dof] / model.opt.timestep)
    best = np.zeros(len(joints))
    for _ in range(int(DRIVE / model.opt.timestep)):
        push = 40 * (target - data.qpos[address]) - brake * data.qvel[dof]
        data.qfrc_applied[dof] = np.clip(push, -most, most)
        mujoco.mj_step(model, data)
        best = np.maximum(best, (data.qpos[address] - rest) / (target - rest))
        if (best >= REACHED).all():
            break
    return [float(share) for share in np.where(best >= REACHED, 1.0, best)]

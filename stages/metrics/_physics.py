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
REACHED = 0.95
"""Share of its range by which a joint counts as opened."""
FORCE = 15.0
"""Most that a hand pushes or turns with, N or N m."""


class Travel(NamedTuple):
    """A joint and the share of its range that it can be driven over from where it rests."""

    joint: str
    share: float


def load(path: Path) -> Any:
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
    """Every hinge and slide, driven alone from where it rests to the far end of its range."""
    import mujoco

    joints = [j for j in range(model.njnt) if model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE]
    return [Travel(model.joint(j).name, _driven(model, j)) for j in joints]


def _driven(model: Any, j: int) -> float:
    """By a spring and a damper of limited force, as a hand would; the greatest share reached, 1 from `REACHED` on."""
    import mujoco

    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    address, dof = int(model.jnt_qposadr[j]), int(model.jnt_dofadr[j])
    lo, hi = (float(v) for v in model.jnt_range[j])
    rest = float(data.qpos[address])
    target = hi if abs(hi - rest) >= abs(lo - rest) else lo
    most = min(FORCE, 0.5 + 3 * float(model.body_mass[model.jnt_bodyid[j]]))
    # A brake that is too strong for a light lid makes it chatter.
    brake = min(8.0, 0.4 * float(model.dof_M0[dof]) / model.opt.timestep)
    best = 0.0
    for _ in range(int(DRIVE / model.opt.timestep)):
        push = 40 * (target - data.qpos[address]) - brake * data.qvel[dof]
        data.qfrc_applied[dof] = np.clip(push, -most, most)
        mujoco.mj_step(model, data)
        best = max(best, float((data.qpos[address] - rest) / (target - rest)))
        if best >= REACHED:
            return 1.0
    return best

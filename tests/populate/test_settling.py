"""A populated home in MuJoCo: nothing is pressed into anything at the start, nothing moves when it is left alone, and
what is in a drawer stays there when the drawer is pulled out and pushed in again."""

import mujoco
import numpy as np
import pytest
from inhabited import library, lived_in, things

from apartgen.stages import export

DEEP, MOVED, TURNED, ALONE = 0.001, 0.01, np.radians(5), 10.0
OUT, REST = 1.0, 0.6
"""Seconds that a drawer takes each way, and that it is left alone after."""


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    folder = tmp_path_factory.mktemp("mjcf") / "home"
    export.run(lived_in(1), ["mjcf"], folder, library().load_asset)
    return mujoco.MjModel.from_xml_path(str(folder / "mjcf" / "apartment.xml"))


def started(model):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data


def test_nothing_is_pressed_into_anything(model):
    data = started(model)
    assert not [contact.dist for contact in data.contact[: data.ncon] if contact.dist < -DEEP]


def test_what_is_left_alone_stays_where_it_is(model):
    # Sleeping spares what has come to rest; whatever moves is awake.
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    data = started(model)
    loose = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE]
    assert len(loose) > 80
    at, turn = data.xpos[loose].copy(), data.xquat[loose].copy()
    while data.time < ALONE:
        mujoco.mj_step(model, data)
    far = np.linalg.norm(data.xpos[loose] - at, axis=1) > MOVED
    turned = 2 * np.arccos(np.clip(np.abs((data.xquat[loose] * turn).sum(1)), 0, 1)) > TURNED
    assert (far | turned).sum() <= 0.005 * len(loose), [model.body(loose[i]).name for i in np.flatnonzero(far | turned)]


def test_drawers_are_pulled_out_and_pushed_in_with_all_that_is_in_them(model):
    home = lived_in(1)
    parts = {(id, place.name): place.part for id, places in home.receptacles.items() for place in places
             if place.kind == "drawer"}
    held = {}
    for o in things(home):
        if o.in_ and (part := parts.get((o.in_.object, o.in_.receptacle))):
            held.setdefault(f"{o.in_.object}__{part}__joint", []).append(o.id)
    assert held
    for joint, ids in held.items():
        data = started(model)
        dof, at = model.joint(joint).dofadr[0], model.joint(joint).qposadr[0]
        far = model.joint(joint).range[1]
        before = np.array([data.body(id).xpos for id in ids]).copy()
        reached = 0.0
        while data.time < 2 * OUT + REST:
            goal = far * np.clip(min(data.time / OUT, 2 - data.time / OUT), 0, 1)
            data.qfrc_applied[dof] = np.clip(600 * (goal - data.qpos[at]) - 40 * data.qvel[dof], -60, 60)
            mujoco.mj_step(model, data)
            reached = max(reached, data.qpos[at])
        assert reached > 0.9 * far, joint
        after = np.array([data.body(id).xpos for id in ids])
        assert np.abs(after[:, 2] - before[:, 2]).max() < 0.05 and abs(data.qpos[at]) < 0.02, joint

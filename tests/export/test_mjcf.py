"""The MJCF in MuJoCo itself: it compiles, rests, and every joint turns through its range."""

import re

import handmade
import mujoco
import numpy as np
import pytest
from export import physics, sample

from apartgen.stages import export
from apartgen.stages.export import mjcf
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Asset, Link
from apartgen.stages.things.materials import PALETTE


@pytest.fixture(scope="module")
def flat(exported):
    out = exported("mjcf")
    return mujoco.MjModel.from_xml_path(str(out / "mjcf" / "apartment.xml")), Scene(sample.home(), sample.load)


def _jointed(scene):
    return [(body, link) for body in scene.bodies for link in body.links if link.joint is not None]


def test_bodies_stand_where_the_artifact_says(flat):
    model, scene = flat
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for body in scene.bodies:
        at = data.body(body.name)
        assert at.xpos == pytest.approx(body.position, abs=1e-6)
        assert at.xmat.reshape(3, 3) == pytest.approx(body.pose()[:3, :3], abs=1e-6)
        assert (model.body(body.name).dofnum[0] == 6) == body.free


def test_joints_have_their_limits_in_radians_and_metres(flat):
    model, scene = flat
    for body, link in _jointed(scene):
        joint = model.joint(body.joint_name(link.joint))
        assert joint.range == pytest.approx(link.joint.range, abs=1e-6)
        assert joint.axis == pytest.approx(link.joint.axis, abs=1e-6) and joint.pos == pytest.approx(link.joint.origin)
        assert model.body(body.link_name(link)).mass == pytest.approx(link.mass, rel=1e-6)


def test_nothing_moves_and_no_energy_appears(flat):
    model, _ = flat
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start, energy = data.geom_xpos.copy(), float(data.energy.sum())
    for _ in range(int(5 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert np.linalg.norm(data.geom_xpos - start, axis=1).max() < 0.02
    assert np.abs(data.qvel).max() < 0.01
    assert float(data.energy.sum()) < energy + 0.1


def test_nothing_stands_in_anything(flat):
    model, _ = flat
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert min((contact.dist for contact in data.contact), default=0) > -0.002


def test_every_joint_can_be_driven_to_both_ends(flat):
    model, scene = flat
    for body, link in _jointed(scene):
        joint = model.joint(body.joint_name(link.joint))
        data = mujoco.MjData(model)
        lo, hi = joint.range
        holding = physics.held(model, joint.id)
        most = holding + min(15.0, 0.5 + 3 * link.mass)  # what a hand gives without lifting a bin by its lid
        for target in (hi, lo):
            for _ in range(600):
                off = target - data.qpos[joint.qposadr[0]]
                push = 40 * off + holding * np.sign(off) - 8 * data.qvel[joint.dofadr[0]]
                data.qfrc_applied[joint.dofadr[0]] = np.clip(push, -most, most)
                mujoco.mj_step(model, data)
            assert data.qpos[joint.qposadr[0]] == pytest.approx(target, abs=0.05 * (hi - lo)), body.name


def test_no_part_enters_its_own_object_and_a_hinge_broken_by_hand_is_seen(exported):
    """The files leave out contacts of a part with its base, so that these are looked for with nothing left out."""
    path = exported("mjcf") / "mjcf" / "apartment.xml"
    assert physics.rubbing(path) == []
    joint = r'(name="display_cabinet_11__door__joint"[^>]* range=")0 '
    text, times = re.subn(joint, r"\g<1>-0.4 ", path.read_text())
    assert times == 1
    broken = path.with_name("broken.xml")
    broken.write_text(text)
    found = physics.rubbing(broken)
    assert found and all(fault.startswith("display_cabinet_11__door__joint at -0.") for fault in found)


def test_ceilings_are_in_a_group_of_their_own(flat):
    model, scene = flat
    ceilings = {body.name for body in scene.bodies if body.kind == "ceiling"}
    for k in range(model.ngeom):
        name = model.body(model.geom_bodyid[k]).name
        shown = model.geom_contype[k] == 0
        assert model.geom_group[k] == ((4 if name in ceilings else 2) if shown else 3)


def test_a_chair_that_stands_in_a_table_is_not_thrown(tmp_path):
    home = sample.home()
    table, chair = (next(o for o in home.objects if o.id == id) for id in ("coffee_table_3", "chair_7"))
    chair.center = (table.center[0] + table.size[0] / 2, table.center[1], chair.center[2])
    export.run(home, ["mjcf"], tmp_path / "x", sample.load)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "x" / "mjcf" / "apartment.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.geom_xpos.copy()
    for _ in range(int(2 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert np.linalg.norm(data.geom_xpos - start, axis=1).max() < 0.005


@pytest.mark.parametrize("depth", [0.0005, 0.0023, 0.0039])
def test_a_chair_that_stands_a_little_in_the_wall_gains_no_energy(depth, tmp_path):
    home = sample.home()
    chair = next(o for o in home.objects if o.id == "chair_7")
    chair.center = (chair.size[0] / 2 - depth, 0.5, chair.center[2])
    export.run(home, ["mjcf"], tmp_path / "x", sample.load)
    found = physics.rest(mujoco.MjModel.from_xml_path(str(tmp_path / "x" / "mjcf" / "apartment.xml")), 0.3)
    assert found.energy < 0.1 and found.drift < 0.005, found


def test_viewers_begin_at_the_middle_of_the_flat(flat):
    """The sample's rooms reach from 0 to 9 m and from 0 to 6.4 m."""
    model, _ = flat
    assert model.stat.center == pytest.approx([4.5, 3.2, 1.0])


@pytest.mark.skipif(not hasattr(mujoco, "mj_getCache"), reason="this MuJoCo's memory can't be looked at")
def test_reading_back_leaves_nothing_in_memory_and_the_readers_settings_as_they_were(exported):
    kept = mujoco.mj_getCache()
    capacity = mujoco.mj_getCacheCapacity(kept)
    mjcf.read_back([exported("mjcf") / "mjcf" / "apartment.xml"])
    assert mujoco.mj_getCacheSize(kept) == 0
    assert mujoco.mj_getCacheCapacity(kept) == capacity


def test_only_what_is_as_smooth_as_a_mirror_throws_back_the_room(tmp_path):
    looks = ("mirror", "chrome", "glass", "oak")
    bars = [((-0.2, 0.2 * k, -0.2), (0.2, 0.2 * k + 0.1, 0.2)) for k in range(len(looks))]
    shown = [solids.box(*bar, PALETTE[name]) for bar, name in zip(bars, looks)]
    rack = Asset("test", "rack", "shelving", "plain", (0.4, 0.7, 0.4),
                 [Link("base", shown, [solids.slab(*bar) for bar in bars], 5.0)])
    home = handmade.home(handmade.thing("shelving", 2, 1, size=rack.size))
    mjcf.write(Scene(home, lambda library, id: rack), tmp_path)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "mjcf" / "apartment.xml"))
    told = {model.material(k).name: float(model.mat_reflectance[k]) for k in range(model.nmat)}
    assert set(looks) <= set(told) and {name for name, back in told.items() if back > 0} == {"mirror"}, told

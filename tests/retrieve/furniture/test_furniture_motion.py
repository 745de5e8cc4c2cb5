"""No part meets another of the same object anywhere along its range, as the simulator's own collision test sees it."""

import mujoco
import numpy as np
import pytest

from apartgen.stages.retrieve import furniture
from apartgen.stages.things import categories
from apartgen.stages.things.solids import corners

TOUCH = 2e-4
"""Pieces may press this deep into each other, m: rounding and what lies on what."""


def model(asset):
    """Each link a body of the world, so that the simulator leaves no pair out."""
    spec = mujoco.MjSpec()
    spec.option.gravity = [0, 0, 0]
    for i, link in enumerate(asset.links):
        body = spec.worldbody.add_body() if i else spec.worldbody
        if link.joint is not None:
            hinge = link.joint.type == "hinge"
            body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE if hinge else mujoco.mjtJoint.mjJNT_SLIDE,
                           axis=link.joint.axis, pos=link.joint.origin)  # fmt: skip
        for k, collider in enumerate(link.colliders):
            add_geom(spec, body, collider, f"{i}:{k}")
    return spec.compile()


def add_geom(spec, body, c, name):
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(c.rotation).ravel())
    place = {"pos": c.center, "quat": quat, "name": name}
    if c.kind == "box":
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=c.size / 2, **place)
    elif c.kind == "cylinder":
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, size=[c.size[0], c.size[2] / 2, 0], **place)
    else:
        mesh = spec.add_mesh(name=name)
        mesh.uservert = c.vertices.ravel().tolist()
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, **place)


def positions(asset, steps, rng):
    """Each joint alone through its range, all together, and at random."""
    top = np.array([joint.range[1] for joint in asset.joints])
    yield 0 * top
    for t in np.linspace(0, 1, steps + 1)[1:]:
        yield from (top * t * (np.arange(len(top)) == i) for i in range(len(top)))
        yield top * t
    yield from (top * rng.random(len(top)) for _ in range(steps))


def deepest(asset, places):
    """How deep any two links of an asset are in each other, m, and which."""
    compiled = model(asset)
    data = mujoco.MjData(compiled)
    worst = (0.0, "")
    for place in places:
        data.qpos[:] = place
        mujoco.mj_kinematics(compiled, data)
        mujoco.mj_comPos(compiled, data)
        mujoco.mj_collision(compiled, data)
        for contact in data.contact[: data.ncon]:
            pair = f"{compiled.geom(contact.geom1).name} {compiled.geom(contact.geom2).name}"
            worst = min(worst, (float(contact.dist), f"{asset.id} {pair} at {np.round(place, 3).tolist()}"))
    return worst


MOVING = [name for name in (*categories.TABLE, *furniture.BUILDING)
          if name in furniture.BUILDING or categories.TABLE[name].articulated]  # fmt: skip

HANDED = categories.those(lambda kind: kind.handed)


@pytest.mark.parametrize("category", MOVING)
def test_no_part_meets_another(category):
    rng = np.random.default_rng(len(category))
    for style in furniture.styles(category):
        for seed, size in enumerate(sizes(category, rng)):
            for right in (False, True) if category in HANDED else (False,):
                asset = furniture.build(category, style, size, seed, right)
                if asset.joints:
                    depth, where = deepest(asset, positions(asset, 5, rng))
                    assert depth > -TOUCH, f"{where}: {-depth * 1000:.1f} mm"


def sizes(category, rng):
    if category in furniture.BUILDING:
        return [(0.1, 0.9, 2.1), (0.12, 1.3, 1.2)]
    kind = categories.TABLE[category]
    middle = tuple((np.array(kind.min) + kind.max) / 2)
    return [kind.size, kind.min, kind.max, middle, tuple(rng.uniform(kind.min, kind.max))]


def test_the_probe_sees_a_drawer_pushed_through_the_back_and_doors_turned_inward():
    chest = furniture.build("chest", "modern", categories.TABLE["chest"].size, 0)
    assert deepest(chest, [np.full(len(chest.joints), -0.05)])[0] < -0.005
    wardrobe = furniture.build("wardrobe", "modern", categories.TABLE["wardrobe"].size, 0)
    assert deepest(wardrobe, [np.full(len(wardrobe.joints), -0.2)])[0] < -0.005


@pytest.mark.parametrize("category", ["bin", "laundry_basket"])
def test_an_upright_lid_keeps_off_a_wall_that_its_vessel_is_pushed_against(category):
    for style in furniture.styles(category):
        asset = furniture.build(category, style, (0.4, 0.45, 0.6))
        (lid,) = [link for link in asset.links if link.joint is not None]
        shut = np.concatenate([corners(c) for c in lid.colliders]) - lid.joint.origin
        # Turned by a right angle about -y, what is above the hinge comes to lie behind it.
        back = lid.joint.origin[0] - shut[:, 2].max()
        assert back >= -0.2 + 0.007, style

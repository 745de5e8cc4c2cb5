"""All formats say the same of one scene: where bodies stand, how joints turn and how far, what things weigh."""

import numpy as np
import pytest
from export import readers

FORMATS = ("mjcf", "usd", "urdf", "sdf", "glb", "habitat", "procthor")
CLOSE = 1e-4


@pytest.fixture(scope="module", params=["sample", "flat"])
def scene(request):
    made = request.getfixturevalue(request.param)
    return made.scene, {name: getattr(readers, name)(made.folder) for name in FORMATS}


def _links(scene):
    return {body.link_name(link): (body, link) for body in scene.bodies for link in body.links}


def test_every_body_stands_at_the_same_place(scene):
    made, worlds = scene
    names = {body.name for body in made.bodies}
    things = {body.name for body in made.bodies if body.kind == "object"}
    moving = {body.name for body in made.bodies if body.kind in ("object", "door")}
    held = {"habitat": moving, "procthor": things}
    for name, world in worlds.items():
        assert set(world.poses) == held.get(name, names), name
        for body in (b for b in made.bodies if b.name in world.poses):
            assert world.poses[body.name] == pytest.approx(body.pose(), abs=CLOSE), (name, body.name)


def test_every_joint_has_the_same_axis_and_limits(scene):
    made, worlds = scene
    jointed = {name: found for name, found in _links(made).items() if found[1].joint}
    assert len(jointed) > 10
    for name, world in worlds.items():
        if name == "procthor":
            continue
        assert set(world.joints) == set(jointed), name
        for link, (body, part) in jointed.items():
            type_, axis, point, limits = world.joints[link]
            joint, turn = part.joint, body.pose()[:3, :3]
            wanted = turn @ np.array(joint.axis) / np.linalg.norm(joint.axis)
            assert type_ == joint.type and axis == pytest.approx(wanted, abs=CLOSE), (name, link)
            assert point == pytest.approx(turn @ joint.origin + body.position, abs=CLOSE), (name, link)
            assert limits == pytest.approx(joint.range, abs=CLOSE) and limits[0] < limits[1], (name, link)


def test_every_part_that_moves_weighs_the_same(scene):
    made, worlds = scene
    moving = {name for name, (body, link) in _links(made).items() if body.free or link.joint}
    for name, world in worlds.items():
        if name == "procthor":
            continue
        assert moving <= set(world.masses), name
        for link in world.masses.keys() & worlds["sdf"].masses.keys():
            assert world.masses[link] == pytest.approx(worlds["sdf"].masses[link], rel=CLOSE), (name, link)

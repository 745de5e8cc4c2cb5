"""The files in engines other than those they are written for: each is skipped where the engine is not installed."""

from xml.etree import ElementTree

import numpy as np
import pytest

from apartgen.stages.things.body import inertia


@pytest.fixture(params=["sample", "flat"])
def made(request):
    """Plain boxes, and the example flat."""
    return request.getfixturevalue(request.param)


def _doors(scene):
    return [body for body in scene.bodies if body.kind == "door" and len(body.links) > 1]


def test_newton_reads_the_usd_and_opens_its_doors(made):
    """A steady torque brings every door to its upper limit, from which Newton's soft limits throw it back."""
    warp = pytest.importorskip("warp")
    newton = pytest.importorskip("newton")
    pytest.importorskip("newton_usd_schemas")
    warp.config.quiet = True
    builder = newton.ModelBuilder()
    builder.add_usd(str(made.folder / "usd" / "apartment.usd"))
    moving = [(b, link) for b in made.scene.bodies for link in b.links if b.free or len(b.links) > 1]
    assert builder.body_count == len(moving)
    start = dict(zip(builder.joint_label, builder.joint_qd_start))
    place = dict(zip(builder.joint_label, builder.joint_q_start))
    masses = dict(zip(builder.body_label, builder.body_mass))
    model = builder.finalize(device="cpu")
    solver = newton.solvers.SolverFeatherstone(model)
    states, control = [model.state(), model.state()], model.control()
    names = [f"/Apartment/Shell/{door.name}/Joints/leaf" for door in _doors(made.scene)]
    force = np.zeros(model.joint_dof_count, np.float32)
    force[[start[name] for name in names]] = 6.0
    control.joint_f.assign(force)
    newton.eval_fk(model, model.joint_q, model.joint_qd, states[0])
    widest = np.zeros(len(names))
    for _ in range(1250):
        states[0].clear_forces()
        solver.step(states[0], states[1], control, None, 1 / 500)
        states.reverse()
        widest = np.maximum(widest, states[0].joint_q.numpy()[[place[name] for name in names]])
    for door, angle in zip(_doors(made.scene), widest):
        leaf = door.links[1]
        assert angle == pytest.approx(leaf.joint.range[1], abs=0.1), door.name
        assert masses[f"/Apartment/Shell/{door.name}/leaf"] == pytest.approx(leaf.mass, rel=1e-4)


def test_sapien_loads_the_urdf_and_opens_a_door(made, tmp_path):
    sapien = pytest.importorskip("sapien")
    file = made.folder / "urdf" / "apartment.urdf"
    robot = ElementTree.parse(file)
    for link in robot.getroot().iter("link"):
        for visual in link.findall("visual"):  # drawing needs a graphics driver
            link.remove(visual)
    for mesh in robot.getroot().iter("mesh"):
        mesh.set("filename", str(file.parent / mesh.get("filename")))
    robot.write(tmp_path / "apartment.urdf")
    world = sapien.Scene([sapien.physx.PhysxCpuSystem()])
    loader = world.create_urdf_loader()
    loader.fix_root_link = True
    loaded = loader.load(str(tmp_path / "apartment.urdf"))
    assert len(loaded.links) == 1 + sum(len(body.links) for body in made.scene.bodies)
    known = {joint.name: joint for joint in loaded.active_joints}
    for body in made.scene.bodies:
        for link in body.links[1:]:
            lower, upper = known[body.joint_name(link.joint)].limits[0]
            assert (lower, upper) == pytest.approx(link.joint.range, abs=1e-4)
    for joint in loaded.active_joints:
        joint.set_friction(0.0)  # the loader gives every joint some, whatever the file says
    index = {joint.name: k for k, joint in enumerate(loaded.active_joints)}
    doors = [index[door.joint_name(door.links[1].joint)] for door in _doors(made.scene)]
    world.set_timestep(1 / 240)
    force = np.zeros(len(index))
    force[doors] = 6.0
    for _ in range(720):  # 3 s
        loaded.set_qf(force + loaded.compute_passive_force(True, True))
        world.step()
    assert loaded.get_qpos()[doors] == pytest.approx(np.pi / 2, abs=0.05)


def test_drake_reads_the_urdf(made):
    parsing = pytest.importorskip("pydrake.multibody.parsing")
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.004)
    model = parsing.Parser(plant).AddModels(str(made.folder / "urdf" / "apartment.urdf"))[0]
    plant.Finalize()
    links = [(body, link) for body in made.scene.bodies for link in body.links]
    assert plant.num_bodies() == 1 + len(links)
    for body, link in links:
        if link.joint is None:
            continue
        joint = plant.GetJointByName(body.joint_name(link.joint), model)
        limits = [joint.position_lower_limits()[0], joint.position_upper_limits()[0]]
        assert limits == pytest.approx(link.joint.range, abs=1e-4)
        assert joint.child_body().default_mass() == pytest.approx(inertia(link).mass, rel=1e-4)

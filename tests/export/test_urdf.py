"""URDF as PyBullet and an independent parser read it: poses, limits, masses, meshes that are there."""

from xml.etree import ElementTree

import numpy as np
import pytest
import trimesh
from export import sample

from apartgen.stages import export
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things.body import inertia


@pytest.fixture(scope="module")
def made(exported):
    out = exported("urdf")
    return out / "urdf", Scene(sample.home(), sample.load)


@pytest.fixture
def pybullet():
    return pytest.importorskip("pybullet")


@pytest.fixture
def world(pybullet):
    client = pybullet.connect(pybullet.DIRECT)
    yield client
    pybullet.disconnect(client)


def _links(pybullet, robot, world):
    infos = [pybullet.getJointInfo(robot, k, physicsClientId=world) for k in range(pybullet.getNumJoints(robot, world))]
    return {info[12].decode(): (k, info) for k, info in enumerate(infos)}


def test_pybullet_reads_the_whole_apartment(made, pybullet, world):
    folder, scene = made
    robot = pybullet.loadURDF(str(folder / "apartment.urdf"), useFixedBase=True, physicsClientId=world,
                              flags=pybullet.URDF_USE_INERTIA_FROM_FILE)
    links = _links(pybullet, robot, world)
    assert len(links) == sum(len(body.links) for body in scene.bodies)
    for body in scene.bodies:
        for link in body.links:
            k, info = links[body.link_name(link)]
            state = pybullet.getLinkState(robot, k, physicsClientId=world)
            expected = body.pose() @ trimesh.transformations.translation_matrix(
                (0, 0, 0) if link.joint is None else link.joint.origin)
            assert np.array(state[4]) == pytest.approx(expected[:3, 3], abs=1e-4)
            turn = np.array(pybullet.getMatrixFromQuaternion(state[5])).reshape(3, 3)
            assert turn == pytest.approx(expected[:3, :3], abs=1e-4)
            mass, friction, *_ = pybullet.getDynamicsInfo(robot, k, physicsClientId=world)
            assert mass == pytest.approx(inertia(link).mass, rel=1e-5)
            assert friction == pytest.approx(link.friction)
            if link.joint is not None:
                assert (info[8], info[9]) == pytest.approx(link.joint.range, abs=1e-6)
                assert info[2] == (pybullet.JOINT_REVOLUTE if link.joint.type == "hinge" else pybullet.JOINT_PRISMATIC)
                # PyBullet turns it into the principal axes of inertia, from which a handle takes it a hair off.
                assert info[13] == pytest.approx(link.joint.axis, abs=1e-4)


def test_pybullet_turns_a_part_as_the_artifact_says(made, pybullet, world):
    """The room door's outer edge moves from shut to open."""
    folder, scene = made
    robot = pybullet.loadURDF(str(folder / "apartment.urdf"), useFixedBase=True, physicsClientId=world)
    body = next(b for b in scene.bodies if b.id == "door_1")
    k, _ = _links(pybullet, robot, world)[body.link_name(body.links[1])]
    before = pybullet.getLinkState(robot, k, physicsClientId=world)[0]
    pybullet.resetJointState(robot, k, np.pi / 2, physicsClientId=world)
    after = pybullet.getLinkState(robot, k, computeForwardKinematics=True, physicsClientId=world)[0]
    assert before[1] - after[1] == pytest.approx(0.45, abs=0.05)  # the leaf is 0.9 wide and opens to -y


def test_every_asset_loads_by_itself_and_its_joints_reach_both_ends(made, pybullet, world):
    folder, scene = made
    files = sorted((folder / "objects").glob("*.urdf"))
    assert len(files) == len({body.model for body in scene.bodies if body.model})
    for file in files:
        robot = pybullet.loadURDF(str(file), useFixedBase=True, physicsClientId=world)
        for k in range(pybullet.getNumJoints(robot, world)):
            info = pybullet.getJointInfo(robot, k, physicsClientId=world)
            pybullet.setJointMotorControl2(robot, k, pybullet.VELOCITY_CONTROL, force=0, physicsClientId=world)
            for target in (info[9], info[8]):
                drive = {"targetPosition": target, "force": 60, "physicsClientId": world}
                pybullet.setJointMotorControl2(robot, k, pybullet.POSITION_CONTROL, **drive)
                for _ in range(240):
                    pybullet.stepSimulation(physicsClientId=world)
                got = pybullet.getJointState(robot, k, physicsClientId=world)[0]
                assert got == pytest.approx(target, abs=0.03 * max(1.0, info[9] - info[8])), file.name
        pybullet.removeBody(robot, physicsClientId=world)


@pytest.mark.parametrize("format_", ["urdf", "sdf"])
def test_files_named_are_there_and_relative(tmp_path, format_):
    export.run(sample.home(), [format_], tmp_path / "x", sample.load)
    folder = tmp_path / "x" / format_
    named = set()
    for file in [*folder.glob("**/*.urdf"), *folder.glob("**/*.sdf")]:
        for element in ElementTree.parse(file).iter():
            text = element.get("filename") or (element.text if element.tag in ("uri", "albedo_map") else None)
            if text:
                assert (file.parent / text).is_file()
                named.add((file.parent / text).resolve())
    for mesh in folder.glob("meshes/*.obj"):
        assert mesh.resolve() in named
        material = mesh.with_suffix(".mtl")
        if material.exists():
            maps = [line.split()[1] for line in material.read_text().splitlines() if line.startswith("map_Kd")]
            assert all((mesh.parent / name).is_file() for name in maps)

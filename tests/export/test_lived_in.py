"""A home with all its small things, in the programs that it is exported for, together in `make consumers`: what each
finds there, and that it has nothing to say against it.
"""

import warnings
from xml.etree import ElementTree

import pytest
from inhabited import library, lived_in

pytest.importorskip("pydrake", reason="for all of this module: `make consumers` installs it")


@pytest.fixture(scope="module")
def made(make):
    found = make(lived_in(0), library().load_asset, ("mjcf", "usd", "urdf", "sdf", "glb"))
    assert sum(body.free for body in found.scene.bodies) > 80
    return found


def _pieces(scene):
    return sum(len(link.colliders) for body in scene.bodies for link in body.links)


def test_drake_has_every_collider_of_the_urdf(made):
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
    from pydrake.systems.framework import DiagramBuilder

    plant, _ = AddMultibodyPlantSceneGraph(DiagramBuilder(), 0.004)
    Parser(plant).AddModels(str(made.folder / "urdf" / "apartment.urdf"))
    plant.Finalize()
    assert plant.num_collision_geometries() == _pieces(made.scene)


def test_mujoco_warp_takes_the_mjcf(made):
    mjw, warp = pytest.importorskip("mujoco_warp"), pytest.importorskip("warp")
    import mujoco

    warp.config.quiet = True
    model = mujoco.MjModel.from_xml_path(str(made.folder / "mjcf" / "apartment.xml"))
    with warnings.catch_warnings(), warp.ScopedDevice("cpu"):
        warnings.simplefilter("error")
        assert mjw.put_model(model).ngeom == model.ngeom


@pytest.mark.parametrize("kind, file", [("usd", "usd/apartment.usd"), ("mjcf", "mjcf/apartment.xml"),
                                        ("urdf", "urdf/apartment.urdf")])
def test_newton_reads_it(made, kind, file):
    warp, newton = pytest.importorskip("warp"), pytest.importorskip("newton")
    warp.config.quiet = True
    builder = newton.ModelBuilder()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        getattr(builder, f"add_{kind}")(str(made.folder / file))
    moving = [link for body in made.scene.bodies for link in body.links if body.free or link.joint is not None]
    assert builder.body_count >= len(moving) and builder.shape_count >= _pieces(made.scene)


def test_sapien_and_bullet_load_the_urdf(made, tmp_path):
    sapien, bullet = pytest.importorskip("sapien"), pytest.importorskip("pybullet")
    file = made.folder / "urdf" / "apartment.urdf"
    links = sum(len(body.links) for body in made.scene.bodies)
    client = bullet.connect(bullet.DIRECT)
    assert bullet.getNumJoints(bullet.loadURDF(str(file), useFixedBase=True, physicsClientId=client), client) == links
    bullet.disconnect(client)
    robot = ElementTree.parse(file)
    for link in robot.getroot().iter("link"):
        for visual in link.findall("visual"):  # drawing needs a graphics driver
            link.remove(visual)
    for mesh in robot.getroot().iter("mesh"):
        mesh.set("filename", str(file.parent / mesh.get("filename")))
    robot.write(tmp_path / "apartment.urdf")
    loader = sapien.Scene([sapien.physx.PhysxCpuSystem()]).create_urdf_loader()
    loader.fix_root_link = True
    assert len(loader.load(str(tmp_path / "apartment.urdf")).links) == 1 + links


def test_validators_find_nothing(made):
    validator = pytest.importorskip("omni.asset_validator")
    from pxr import Usd, UsdValidation

    file = str(made.folder / "usd" / "apartment.usd")
    every = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert not UsdValidation.ValidationContext(every).Validate(Usd.Stage.Open(file))
    assert not list(validator.ValidationEngine().validate(file).issues())

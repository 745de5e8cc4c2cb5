"""What each format says of a scene, read by other means than it was written: one reader a format.

A reader takes the export's folder and gives a `World`; what a format does not hold is left out of it.
"""

import json
import struct
from dataclasses import dataclass, field
from xml.etree import ElementTree

import numpy as np
from scipy.spatial.transform import Rotation

Z_UP = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]])
"""A world with y up as one with z up."""


@dataclass
class World:
    """Poses (4, 4) by body; joints by link: type, world axis, a point on it, range; masses by link, kg."""

    poses: dict = field(default_factory=dict)
    joints: dict = field(default_factory=dict)
    masses: dict = field(default_factory=dict)

    def joint(self, name, type_, frame, axis, origin, limits):
        """Notes a joint whose axis and origin are given in a frame of the world."""
        axis = frame[:3, :3] @ np.asarray(axis, float)
        point = (frame @ [*origin, 1.0])[:3]
        self.joints[name] = (type_, axis / np.linalg.norm(axis), point, np.asarray(limits, float))


def placed(position, rotation=None):
    found = np.eye(4)
    found[:3, 3] = position
    if rotation is not None:
        found[:3, :3] = rotation.as_matrix()
    return found


def floats(text):
    return [float(v) for v in text.split()]


def mjcf(out):
    """By MuJoCo; what never moves has no mass of its own there."""
    import mujoco

    model = mujoco.MjModel.from_xml_path(str(out / "mjcf" / "apartment.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    world = World()
    for k in range(1, model.nbody):
        body = model.body(k)
        if body.parentid[0] == 0:
            world.poses[body.name] = placed(data.xpos[k], Rotation.from_matrix(data.xmat[k].reshape(3, 3)))
        if body.dofnum[0]:
            world.masses[body.name] = body.mass[0]
    for k in range(model.njnt):
        if model.jnt_type[k] != mujoco.mjtJoint.mjJNT_FREE:
            kind = "hinge" if model.jnt_type[k] == mujoco.mjtJoint.mjJNT_HINGE else "slide"
            name = model.body(model.jnt_bodyid[k]).name
            world.joint(name, kind, np.eye(4), data.xaxis[k], data.xanchor[k], model.jnt_range[k])
    return world


def usd(out):
    """By OpenUSD: joints from the frames on their bodies."""
    from pxr import Gf, Usd, UsdGeom, UsdPhysics

    stage = Usd.Stage.Open(str(out / "usd" / "apartment.usd"))
    at = {p: np.array(UsdGeom.Xformable(p).ComputeLocalToWorldTransform(0)).T for p in stage.Traverse()
          if p.IsA(UsdGeom.Xformable)}
    world = World()
    for prim in stage.Traverse():
        if str(prim.GetPath().GetParentPath()) in ("/Apartment/Shell", "/Apartment/Ceilings", "/Apartment/Furniture"):
            world.poses[prim.GetName()] = at[prim]
        if prim.HasAPI(UsdPhysics.MassAPI):
            world.masses[_usd_link(prim)] = UsdPhysics.MassAPI(prim).GetMassAttr().Get()
        if prim.IsA(UsdPhysics.RevoluteJoint) or prim.IsA(UsdPhysics.PrismaticJoint):
            joint = UsdPhysics.Joint(prim)
            link = stage.GetPrimAtPath(joint.GetBody1Rel().GetTargets()[0])
            axis = Gf.Rotation(Gf.Quatd(joint.GetLocalRot1Attr().Get())).TransformDir(Gf.Vec3d(1, 0, 0))
            hinge = prim.IsA(UsdPhysics.RevoluteJoint)
            limits = [prim.GetAttribute(f"physics:{end}Limit").Get() for end in ("lower", "upper")]
            limits = np.radians(limits) if hinge else limits
            kind = "hinge" if hinge else "slide"
            world.joint(_usd_link(link), kind, at[link], axis, joint.GetLocalPos1Attr().Get(), limits)
    return world


def _usd_link(prim):
    """The name of a link in the other formats: a base is called as its body."""
    from pxr import UsdPhysics

    body = prim.GetParent()
    if not body.HasAPI(UsdPhysics.ArticulationRootAPI):
        return prim.GetName()
    base = next(child for child in body.GetChildren() if child.HasAPI(UsdPhysics.RigidBodyAPI))
    return body.GetName() if prim == base else f"{body.GetName()}__{prim.GetName()}"


def urdf(out):
    """As elements of XML."""
    return _urdf(ElementTree.parse(out / "urdf" / "apartment.urdf").getroot(), World(), np.eye(4))


def _urdf(robot, world, root, rename=lambda name: name):
    frames = {}
    children = {joint.find("child").get("link"): joint for joint in robot.iter("joint")}
    for link in robot.iter("link"):
        name = link.get("name")
        frames[name] = root @ _urdf_frame(name, children)
        if link.find("inertial") is not None:
            world.masses[rename(name)] = float(link.find("inertial/mass").get("value"))
    for name, joint in children.items():
        if joint.get("type") == "fixed":
            world.poses[rename(name)] = frames[name]
            continue
        kind = {"revolute": "hinge", "prismatic": "slide"}[joint.get("type")]
        limit = joint.find("limit")
        limits = [float(limit.get(end)) for end in ("lower", "upper")]
        world.joint(rename(name), kind, frames[name], floats(joint.find("axis").get("xyz")), (0, 0, 0), limits)
    return world


def _urdf_frame(name, children):
    if name not in children:
        return np.eye(4)
    joint = children[name]
    origin = joint.find("origin")
    own = placed(floats(origin.get("xyz")), Rotation.from_euler("xyz", floats(origin.get("rpy"))))
    return _urdf_frame(joint.find("parent").get("link"), children) @ own


def sdf(out):
    """As elements of XML."""
    world = World()
    for model in ElementTree.parse(out / "sdf" / "apartment.sdf").getroot().iter("model"):
        pose = floats(model.find("pose").text)
        frame = placed(pose[:3], Rotation.from_euler("xyz", pose[3:]))
        world.poses[model.get("name")] = frame
        for link in model.iter("link"):
            assert link.find("pose") is None
            world.masses[link.get("name")] = float(link.find("inertial/mass").text)
        for joint in model.iter("joint"):
            if joint.get("type") == "fixed":
                continue
            kind = {"revolute": "hinge", "prismatic": "slide"}[joint.get("type")]
            limits = [float(joint.find(f"axis/limit/{end}").text) for end in ("lower", "upper")]
            origin, axis = floats(joint.find("pose").text)[:3], floats(joint.find("axis/xyz").text)
            world.joint(joint.find("child").text, kind, frame, axis, origin, limits)
    return world


def glb(out):
    """As the document's nodes; what they hold beyond glTF is in their extras."""
    return _glb(document(out / "apartment.glb"))


def document(path):
    """The JSON of a GLB."""
    data = path.read_bytes()
    size = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20 : 20 + size])


def _glb(made):
    world = World()

    def visit(k, above):
        node = made["nodes"][k]
        turn = Rotation.from_quat(node.get("rotation", [0, 0, 0, 1]))
        here = above @ placed(node.get("translation", [0, 0, 0]), turn)
        extras = node.get("extras", {})
        if "kind" in extras:
            world.poses[node["name"]] = here
        if "mass" in extras:
            world.masses[node["name"]] = extras["mass"]
        if "joint" in extras:
            joint = extras["joint"]
            world.joint(node["name"], joint["type"], here, joint["axis"], (0, 0, 0), joint["range"])
        for child in node.get("children", []):
            visit(child, here)

    for root in made["scenes"][made["scene"]]["nodes"]:
        visit(root, Z_UP)
    return world


def habitat(out):
    """As its JSON, and each articulated template's URDF where the instance puts it."""
    folder, world = out / "habitat", World()
    instance = json.loads((folder / "scenes" / "apartment.scene_instance.json").read_text())
    for entry in instance["object_instances"]:
        name = entry["user_defined"]["name"]
        world.poses[name] = Z_UP @ _turned(entry) @ np.linalg.inv(Z_UP)  # the model's own file is y up too
        config = json.loads((folder / "objects" / f"{entry['template_name']}.object_config.json").read_text())
        world.masses[name] = config["mass"]
    for entry in instance["articulated_object_instances"]:
        name = entry["user_defined"]["name"]
        robot = ElementTree.parse(folder / "urdf" / f"{entry['template_name']}.urdf").getroot()
        base = next(robot.iter("link")).get("name")
        world.poses[name] = Z_UP @ _turned(entry)
        _urdf(robot, world, world.poses[name], lambda link, base=base, name=name: name + link.removeprefix(base))
    return world


def _turned(entry):
    return placed(entry["translation"], Rotation.from_quat(entry["rotation"], scalar_first=True))


def procthor(out):
    """Objects' poses, from THOR's left-handed world."""
    world = World()
    for entry in json.loads((out / "house.json").read_text())["objects"]:
        x, z, y = (entry["position"][k] for k in "xyz")
        turn = Rotation.from_euler("z", np.pi / 2 - np.radians(entry["rotation"]["y"]))
        world.poses[entry["id"]] = placed([x, y, z], turn)
    return world

"""URDF of the whole apartment, fixed to one world link, and of each object by itself to be placed at will.

A link's frame is on its joint. URDF has no loose bodies: in the whole apartment everything stands where it is; a
simulator that wants chairs to move loads them from urdf/objects, named after their asset.
"""

from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from stages.asset import Array, Collider, Link, Material, Mesh
from stages.body import Body, inertia
from stages.export._hull import hull
from stages.export._obj import Files
from stages.export._pieces import pieces
from stages.export._rotation import roll_pitch_yaw
from stages.export._xml import Element, add, number, save
from stages.scene import Scene, identifier, untaken

FOLDER = "urdf"
DAMPING = {"hinge": 0.4, "slide": 8.0}
"""N·m·s/rad and N·s/m, as in the other formats."""
EFFORT, SPEED = 100.0, 3.0
"""Limits that URDF demands, N or N·m and m/s or rad/s; no design is that stiff or fast."""
ORIGIN = np.zeros(3)


def write(scene: Scene, out: Path) -> list[Path]:
    """urdf/apartment.urdf, urdf/objects/*.urdf, and their meshes in urdf/meshes."""
    files = Files(out / FOLDER / "meshes")
    whole = ElementTree.Element("robot", name="apartment")
    add(whole, "link", name="world")
    written: list[Path] = []
    models: dict[str, str] = {}
    for body in scene.bodies:
        _body(whole, body, files, "meshes")
        _joint(whole, f"{body.name}__world", "fixed", "world", body.name, body.position, body.yaw)
        if body.kind == "object" and body.model not in models:
            name = models[body.model] = untaken(identifier(body.model), models.values())
            alone = ElementTree.Element("robot", name=name)
            _body(alone, body, files, "../meshes")
            written.append(save(alone, out / FOLDER / "objects" / f"{name}.urdf"))
    return [save(whole, out / FOLDER / "apartment.urdf"), *written, *files.written]


def _body(robot: Element, body: Body, files: Files, meshes: str) -> None:
    base, *moving = body.links
    _link(robot, body, base, ORIGIN, files, meshes)
    for link in moving:
        joint = link.joint
        assert joint is not None
        origin = np.array(joint.origin)
        _link(robot, body, link, origin, files, meshes)
        kind = "revolute" if joint.type == "hinge" else "prismatic"
        element = _joint(robot, body.joint_name(joint), kind, body.name, body.link_name(link), origin)
        add(element, "axis", xyz=np.array(joint.axis) / np.linalg.norm(joint.axis))
        add(element, "limit", lower=joint.range[0], upper=joint.range[1], effort=EFFORT, velocity=SPEED)
        add(element, "dynamics", damping=DAMPING[joint.type])


def _joint(robot: Element, name: str, kind: str, parent: str, child: str, xyz: Array, yaw: float = 0.0) -> Element:
    element = add(robot, "joint", name=name, type=kind)
    add(element, "origin", xyz=xyz, rpy=[0, 0, yaw])
    add(element, "parent", link=parent)
    add(element, "child", link=child)
    return element


def _link(robot: Element, body: Body, link: Link, origin: Array, files: Files, meshes: str) -> None:
    """A link whose frame is at `origin` of the body's frame."""
    name = body.link_name(link)
    element = add(robot, "link", name=name)
    mass, center, tensor = inertia(link)
    inertial = add(element, "inertial")
    add(inertial, "origin", xyz=center - origin)
    add(inertial, "mass", value=mass)
    keys = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
    moments = add(inertial, "inertia")
    for key, at in keys.items():
        moments.set(key, number(tensor[at]))
    for k, piece in enumerate(pieces(link)):
        file = files.mesh(f"{name}_{k}", piece, origin, files.surface(piece.material))
        geometry = add(add(element, "visual"), "geometry")
        add(geometry, "mesh", filename=f"{meshes}/{file}")
    for k, collider in enumerate(link.colliders):
        _collider(element, f"{name}__c{k}", collider, origin, files, meshes)


def _collider(element: Element, name: str, c: Collider, origin: Array, files: Files, meshes: str) -> None:
    collision = add(element, "collision")
    if c.kind == "hull":
        file = files.mesh(name, Mesh(*hull(c), Material("hull")), origin)
        add(add(collision, "geometry"), "mesh", filename=f"{meshes}/{file}")
        return
    add(collision, "origin", xyz=c.center - origin, rpy=roll_pitch_yaw(c.rotation))
    geometry = add(collision, "geometry")
    if c.kind == "box":
        add(geometry, "box", size=c.size)
    elif c.kind == "cylinder":
        add(geometry, "cylinder", radius=c.size[0], length=c.size[2])
    else:
        add(geometry, "sphere", radius=c.size[0])

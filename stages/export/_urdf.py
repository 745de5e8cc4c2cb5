"""Bodies as URDF links and joints; a link's frame is on its joint."""

import numpy as np

from apartgen.stages.export._hull import hull
from apartgen.stages.export._obj import Files
from apartgen.stages.export._rotation import roll_pitch_yaw
from apartgen.stages.export._xml import Element, add, number
from apartgen.stages.scene.pieces import pieces
from apartgen.stages.things.asset import Array, Collider, Link, Material, Mesh
from apartgen.stages.things.body import Body, inertia

EFFORT, SPEED = 100.0, 3.0
"""Limits that URDF demands, N or N·m and m/s or rad/s; no design is that stiff or fast."""
ORIGIN = np.zeros(3)


def body_links(robot: Element, body: Body, files: Files, meshes: str) -> None:
    """A body's links and joints; `meshes` is the mesh folder seen from the file."""
    base, *moving = body.links
    _link(robot, body, base, ORIGIN, files, meshes)
    for link in moving:
        moves = link.joint
        assert moves is not None
        origin = np.array(moves.origin)
        _link(robot, body, link, origin, files, meshes)
        kind = "revolute" if moves.type == "hinge" else "prismatic"
        element = joint(robot, body.joint_name(moves), kind, body.name, body.link_name(link), origin)
        add(element, "axis", xyz=np.array(moves.axis) / np.linalg.norm(moves.axis))
        add(element, "limit", lower=moves.range[0], upper=moves.range[1], effort=EFFORT, velocity=SPEED)
        add(element, "dynamics", damping=body.motion(link).damping)


def joint(robot: Element, name: str, kind: str, parent: str, child: str, xyz: Array, yaw: float = 0.0) -> Element:
    """A joint between two links."""
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
    # URDF itself has no word for friction; Bullet reads it here, and others pass over it.
    add(add(element, "contact"), "lateral_friction", value=link.friction)
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

"""An exported apartment with a robot in it, ready for MuJoCo.

Nothing is built anew: the exported MJCF is read, what an episode needs of it is kept, and a robot is added. Room
doors stand open at the end of their range and stay there, as with a doorstop; the entrance is shut.
"""

from collections.abc import Collection
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, cast
from xml.etree import ElementTree

import mujoco
import numpy as np

from schemas.errors import BadInput
from schemas.retrieve import Joint, Retrieve
from stages.body import Body
from stages.boxes import Array
from stages.scene import Scene

Element = ElementTree.Element
ROBOT = "robot"
"""Names of the robot's bodies, joints, geoms, actuators and sensors begin so."""


@dataclass(frozen=True)
class World:
    """The compiled model, what it was built from, and which of its bodies and joints are what in the artifact.

    `bodies` by id of object or opening (`Body.link_name`, `Body.joint_name` give names in the model); `doors` are the
    angles at which room doors stand open, by opening.
    """

    scene: Scene
    mjcf: Path
    bodies: dict[str, Body]
    model: Any
    doors: dict[str, float] = field(default_factory=dict)
    name: str = ""

    @property
    def home(self) -> Retrieve:
        """The apartment's artifact."""
        return cast(Retrieve, self.scene.home)

    @cached_property
    def robot_bodies(self) -> frozenset[int]:
        """Ids of the robot's bodies."""
        return frozenset(k for k in range(self.model.nbody) if self.model.body(k).name.startswith(ROBOT))

    @cached_property
    def object_of(self) -> dict[int, str]:
        """Artifact id of every body's object or opening, by body id; what belongs to none is left out."""
        names = {body.link_name(link): id for id, body in self.bodies.items() for link in body.links}
        found = ((k, names.get(self.model.body(k).name)) for k in range(self.model.nbody))
        return {k: id for k, id in found if id is not None}

    @cached_property
    def owner(self) -> dict[int, str]:
        """The same of every collider, by geom id, which holds in fused worlds, too."""
        names = {body.link_name(link): id for id, body in self.bodies.items() for link in body.links}
        found = ((k, names.get(self.model.geom(k).name.rpartition("__c")[0])) for k in range(self.model.ngeom))
        return {k: id for k, id in found if id is not None}


def build(
    scene: Scene, mjcf: Path, robot: str = "", *, moving: Collection[str] | None = None,
    without: Collection[str] = (), visuals: bool = False, fused: bool = False, timestep: float | None = None,
    name: str = "",
) -> World:
    """The apartment exported to `mjcf` (an apartment.xml), with a robot given as MJCF text.

    `moving` are ids of the objects that may move, joints and all (None: every one); any other is welded as it stands,
    shut. Colliders named in `without` are left out. `visuals` keeps what only shows. `fused` joins all that is welded
    into the world's own body, which is faster; only geoms then tell things apart. BadInput when the file is not that
    apartment's.
    """
    if not isinstance(scene.home, Retrieve):
        raise BadInput("robots need real furniture; run `apartgen retrieve` on this first")
    bodies = {body.id: body for body in scene.bodies if body.id and body.kind in ("object", "door")}
    root = _read(mjcf)
    named = {element.get("name"): element for element in root.iter("body")}
    missing = [body.name for body in bodies.values() if body.name not in named]
    if missing:
        raise BadInput(f"{mjcf}: holds no {missing[0]!r}; export this apartment again")
    doors = _open_doors(bodies, named)
    if moving is not None:
        for id, body in bodies.items():
            if id not in moving:
                _weld(named[body.name])
    _strip(root, visuals, frozenset(without))
    if fused:
        _section(root, "contact").clear()
        _section(root, "compiler").set("fusestatic", "true")
    if robot:
        _attach(root, ElementTree.fromstring(robot))
    if timestep:
        _section(root, "option").set("timestep", str(timestep))
    model = mujoco.MjModel.from_xml_string(ElementTree.tostring(root, "unicode"))
    return World(scene, mjcf, bodies, model, doors, name)


def _read(mjcf: Path) -> Element:
    root = ElementTree.parse(mjcf).getroot()
    compiler = _section(root, "compiler")
    for key in ("meshdir", "texturedir"):
        compiler.set(key, str((mjcf.parent / compiler.get(key, "")).resolve()))
    return root


def _section(root: Element, tag: str) -> Element:
    found = root.find(tag)
    return ElementTree.SubElement(root, tag) if found is None else found


def _open_doors(bodies: dict[str, Body], named: dict[str | None, Element]) -> dict[str, float]:
    """Weld the leaves of room doors where they are open furthest; the entrance's stays shut."""
    doors = {}
    for id, body in bodies.items():
        for link in body.links if body.kind == "door" else []:
            if link.joint is None:
                continue
            angle = link.joint.range[1] if body.category == "door" else 0.0
            _turn(named[body.link_name(link)], link.joint, angle)
            if body.category == "door":
                doors[id] = angle
    return doors


def _turn(part: Element, joint: Joint, angle: float) -> None:
    """Weld a hinged part at an angle; its frame is its parent's when shut."""
    quat, turned = np.zeros(4), np.zeros(3)
    mujoco.mju_axisAngle2Quat(quat, np.asarray(joint.axis, float) / np.linalg.norm(joint.axis), angle)
    origin: Array = np.asarray(joint.origin, float)
    mujoco.mju_rotVecQuat(turned, origin, quat)
    part.set("pos", _text(origin - turned))
    part.set("quat", _text(quat))
    _weld(part)


def _text(values: Array) -> str:
    return " ".join(f"{v:.9g}" for v in values)


def _weld(body: Element) -> None:
    """Take away the joints of a body and of its parts."""
    for part in list(body.iter("body")):
        for tag in ("joint", "freejoint"):
            for joint in part.findall(tag):
                part.remove(joint)


def _strip(root: Element, visuals: bool, without: Collection[str]) -> None:
    """Take away colliders by name; unless `visuals`, all that only shows; then meshes that nothing uses."""
    for body in root.iter("body"):
        for geom in body.findall("geom"):
            if geom.get("name") in without or (geom.get("class") == "visual" and not visuals):
                body.remove(geom)
    if not visuals:
        world = _section(root, "worldbody")
        for light in world.findall("light"):
            world.remove(light)
    assets, used = _section(root, "asset"), {geom.get("mesh") for geom in root.iter("geom")}
    for asset in list(assets):
        if asset.get("name") not in used if asset.tag == "mesh" else not visuals:
            assets.remove(asset)


def _attach(root: Element, robot: Element) -> None:
    """Add every section of the robot's model; `option` and `compiler` overrule the apartment's."""
    for part in robot:
        section = _section(root, part.tag)
        section.extend(list(part))
        if part.tag in ("option", "compiler"):
            section.attrib.update(part.attrib)

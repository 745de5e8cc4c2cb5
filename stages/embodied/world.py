"""An exported apartment with a robot in it, ready for MuJoCo.

Nothing is built anew: the exported MJCF is read, what an episode needs of it is kept, and a robot is added. Room
doors stand open at the end of their range and stay there, as with a doorstop; the entrance is shut.
"""

from collections.abc import Collection
from copy import deepcopy
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import blake2b
from pathlib import Path
from typing import Any, NamedTuple, cast
from xml.etree import ElementTree

import mujoco
import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.schemas.retrieve import Joint, Retrieve
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.body import Body

Element = ElementTree.Element
ROBOT = "robot"
"""Names of the robot's bodies, joints, geoms, actuators and sensors begin so."""


class Source(NamedTuple):
    """What was read of an exported apartment: the document, and its colliders' meshes as files named by content.

    MuJoCo keeps what it makes of such a file, so that each mesh's hull is computed once however many worlds use it.
    """

    root: Element
    meshes: dict[str, bytes]


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
    source: Source | None = field(default=None, repr=False, compare=False)
    """What was read, without what only shows; worlds of the same apartment are built from it faster."""

    @property
    def home(self) -> Retrieve:
        """The apartment's artifact."""
        return cast(Retrieve, self.scene.home)

    @cached_property
    def robot_bodies(self) -> frozenset[int]:
        """Ids of the robot's bodies."""
        return frozenset(k for k in range(self.model.nbody) if self.model.body(k).name.startswith(ROBOT))

    @cached_property
    def owner(self) -> dict[int, str]:
        """Artifact id of every collider's object or opening, by geom id; what belongs to none is left out."""
        names = {body.link_name(link): id for id, body in self.bodies.items() for link in body.links}
        found = ((k, names.get(self.model.geom(k).name.rpartition("__c")[0])) for k in range(self.model.ngeom))
        return {k: id for k, id in found if id is not None}


def build(
    scene: Scene, mjcf: Path, robot: str = "", *, moving: Collection[str] | None = None,
    without: Collection[str] = (), visuals: bool = False, fused: bool = False, timestep: float | None = None,
    name: str = "", source: Source | None = None,
) -> World:
    """The apartment exported to `mjcf` (an apartment.xml), with a robot given as MJCF text.

    `moving` are ids of the objects that may move, joints and all (None: every one); any other is welded as it stands,
    shut. Colliders named in `without` are left out, and with its last collider a body that does not move. `visuals`
    keeps what only shows. `fused` joins all that is fixed, but for the bases of what may move, into the world's own
    body, which is faster; only geoms then tell things apart. `source` is that of a world of this apartment. BadInput
    when the file is not that apartment's.
    """
    if not isinstance(scene.home, Retrieve):
        raise BadInput("robots need real furniture; run `apartgen retrieve` on this first")
    bodies = {body.id: body for body in scene.bodies if body.id and body.kind in ("object", "door")}
    source = _read(mjcf, visuals) if source is None else source
    missing = {body.name for body in bodies.values()} - {element.get("name") for element in source.root.iter("body")}
    if missing:
        raise BadInput(f"{mjcf}: holds no {min(missing)!r}; export this apartment again")
    free = bodies if moving is None else moving
    loose = {body.name for id, body in bodies.items() if id in free}
    root = _copied(source.root, frozenset(without), loose)
    named = {element.get("name"): element for element in root.iter("body")}
    doors = _open_doors(bodies, named)
    for id, body in bodies.items():
        if id not in free and body.name in named:
            _weld(named[body.name])
    _drop_unused(root, named)
    if fused:
        _fuse(root, {element.get("name") for name in loose if name in named for element in named[name].iter("body")})
    if robot:
        _attach(root, ElementTree.fromstring(robot))
    if timestep:
        _section(root, "option").set("timestep", str(timestep))
    used = {mesh.get("file") for mesh in root.iter("mesh")}
    meshes = {name: content for name, content in source.meshes.items() if name in used}
    model = mujoco.MjModel.from_xml_string(ElementTree.tostring(root, "unicode"), meshes)
    return World(scene, mjcf, bodies, model, doors, name, None if visuals else source)


def _read(mjcf: Path, visuals: bool) -> Source:
    root = ElementTree.parse(mjcf).getroot()
    compiler = _section(root, "compiler")
    folders = {key: str((mjcf.parent / compiler.attrib.pop(key, "")).resolve()) for key in ("meshdir", "texturedir")}
    # MuJoCo's threads cost more than they spare for meshes this small.
    compiler.set("usethread", "false")
    # Catches of doors, their sensors and where they stand at first; a robot's are the only ones here.
    for section in [section for section in root if section.tag in ("actuator", "sensor", "keyframe", "custom")]:
        root.remove(section)
    if visuals:
        compiler.attrib.update(folders)
        return Source(root, {})
    for body in root.iter("body"):
        for geom in body.findall("geom"):
            if geom.get("class") == "visual":
                body.remove(geom)
    world, assets = _section(root, "worldbody"), _section(root, "asset")
    for light in world.findall("light"):
        world.remove(light)
    for asset in list(assets):
        if asset.tag != "mesh" or "vertex" not in asset.attrib:
            assets.remove(asset)
    return Source(root, dict(_filed(mesh) for mesh in assets))


def _filed(mesh: Element) -> tuple[str, bytes]:
    """Make a mesh given by its vertices one that is read from a file; that file's name and content (MuJoCo's MSH)."""
    vertices = np.array(mesh.attrib.pop("vertex").split(), np.float32)
    content = np.array([len(vertices) // 3, 0, 0, 0], np.int32).tobytes() + vertices.tobytes()
    name = f"{blake2b(content, digest_size=16).hexdigest()}.msh"
    mesh.set("file", name)
    return name, content


def _copied(source: Element, without: frozenset[str], free: Collection[str]) -> Element:
    """A copy to be changed, some colliders left out; assets are shared."""
    root = Element(source.tag, source.attrib)
    for section in source:
        if section.tag not in ("worldbody", "asset"):
            root.append(deepcopy(section))
            continue
        ours = ElementTree.SubElement(root, section.tag, section.attrib)
        for part in section:
            geoms = [geom.get("name") for geom in part.iter("geom")] if part.tag == "body" else []
            left_out = without.intersection(geoms) if without else set()
            if left_out and len(left_out) == len(geoms) and part.get("name") not in free:
                continue
            ours.append(part if section.tag == "asset" else deepcopy(part))
            if left_out:
                _leave_out(ours[-1], left_out)
    return root


def _leave_out(part: Element, geoms: Collection[str]) -> None:
    for body in part.iter("body"):
        for geom in body.findall("geom"):
            if geom.get("name") in geoms:
                body.remove(geom)


def _drop_unused(root: Element, named: Collection[str | None]) -> None:
    """Take away meshes that nothing uses, and pairs of bodies of which one is not there."""
    assets, used = _section(root, "asset"), {geom.get("mesh") for geom in root.iter("geom")}
    for asset in list(assets):
        if asset.tag == "mesh" and asset.get("name") not in used:
            assets.remove(asset)
    contact = _section(root, "contact")
    for pair in contact.findall("exclude"):
        if pair.get("body1") not in named or pair.get("body2") not in named:
            contact.remove(pair)


def _fuse(root: Element, moving: Collection[str | None]) -> None:
    """Have static bodies joined to the world's; those that pairs name stay, so only moving bodies' pairs are kept."""
    contact = _section(root, "contact")
    for pair in contact.findall("exclude"):
        if pair.get("body1") not in moving and pair.get("body2") not in moving:
            contact.remove(pair)
    _section(root, "compiler").set("fusestatic", "true")


def _section(root: Element, tag: str) -> Element:
    found = root.find(tag)
    return ElementTree.SubElement(root, tag) if found is None else found


def _open_doors(bodies: dict[str, Body], named: dict[str | None, Element]) -> dict[str, float]:
    """Weld the leaves of room doors where they are open furthest; the entrance's stays shut."""
    doors = {}
    for id, body in bodies.items():
        for link in body.links if body.kind == "door" else []:
            if link.joint is None or body.link_name(link) not in named:
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


def _attach(root: Element, robot: Element) -> None:
    """Add every section of the robot's model; `option` and `compiler` overrule the apartment's."""
    for part in robot:
        section = _section(root, part.tag)
        section.extend(list(part))
        if part.tag in ("option", "compiler"):
            section.attrib.update(part.attrib)

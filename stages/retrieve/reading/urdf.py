"""URDF robots, as PartNet-Mobility and GAPartNet write their objects."""

from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from apartgen.stages.retrieve.reading import limits, tree
from apartgen.stages.retrieve.reading.convex import colliders
from apartgen.stages.retrieve.reading.limits import Broken, floats
from apartgen.stages.retrieve.reading.model import Motion
from apartgen.stages.retrieve.reading.pieces import Array, Piece, gathered
from apartgen.stages.retrieve.reading.primitives import shape
from apartgen.stages.retrieve.reading.source import image
from apartgen.stages.retrieve.reading.transforms import at, rpy
from apartgen.stages.retrieve.reading.tree import LINKS, Body
from apartgen.stages.things.asset import Collider, Material

KINDS = {"revolute": "hinge", "continuous": "hinge", "prismatic": "slide"}


@dataclass(frozen=True)
class Robot:
    """Bodies in the root link's frame, parents first; `names` are the joints' by body."""

    bodies: list[Body]
    names: dict[str, str]


def read(file: Path, root: Path, hulls: bool = False) -> Robot:
    """A robot's bodies; with `hulls` its collision meshes become convex pieces, else they are left to the visuals."""
    robot = limits.xml(limits.read(file, limits.TEXT_BYTES), file.name)
    if robot.tag != "robot":
        raise Broken(f"{file.name}: no URDF robot")
    links = {link.get("name", ""): link for link in robot.findall("link")}
    if len(links) > LINKS:
        raise Broken(f"{file.name}: {len(links)} links, more than the {LINKS} accepted")
    joints = {_child(joint, "child"): joint for joint in robot.findall("joint")}
    colors = {m.get("name", ""): m for m in robot.findall("material")}
    bodies: list[Body] = []
    rows: dict[str, int] = {}
    for name in _ordered(list(links), joints, file.name):
        joint = joints.get(name)
        parent = rows[_child(joint, "parent")] if joint is not None else None
        frame = (bodies[parent].frame if parent is not None else np.eye(4)) @ _origin(joint)
        body = Body(name, parent, frame, mass=_mass(links[name]))
        if joint is not None and joint.get("type") in KINDS:
            body.motion = _motion(joint, frame)
        shown = (_visual(v, frame, file, root, colors) for v in links[name].findall("visual"))
        body.pieces = gathered(shown, file.name)
        body.colliders = [c for v in links[name].findall("collision") for c in _collision(v, frame, file, root, hulls)]
        rows[name] = len(bodies)
        bodies.append(body)
        tree.bounded(bodies, file.name)
    return Robot(bodies, {child: joint.get("name", child) for child, joint in joints.items()})


def _ordered(links: list[str], joints: dict[str, Element], name: str) -> list[str]:
    """Links, parents first; Broken for loops and for parents that do not exist."""
    done: list[str] = []
    waiting = list(links)
    while waiting:
        ready = [link for link in waiting if link not in joints or _child(joints[link], "parent") in done]
        if not ready:
            raise Broken(f"{name}: joints form a loop or name links that do not exist: {', '.join(waiting[:3])}")
        done += ready
        waiting = [link for link in waiting if link not in set(ready)]
    return done


def _child(element: Element, tag: str) -> str:
    found = element.find(tag)
    return found.get("link", "") if found is not None else ""


def _origin(element: Element | None) -> Array:
    origin = element.find("origin") if element is not None else None
    if origin is None:
        return np.eye(4)
    return at(floats(origin.get("xyz"), 3, "0 0 0", "origin"), rpy(floats(origin.get("rpy"), 3, "0 0 0", "origin")))


def _mass(link: Element) -> float | None:
    mass = link.find("inertial/mass")
    return float(floats(mass.get("value"), 1, "0", "mass")[0]) if mass is not None else None


def _motion(joint: Element, frame: Array) -> Motion:
    kind, name = KINDS[joint.get("type", "")], joint.get("name", "joint")
    axis, limit = joint.find("axis"), joint.find("limit")
    span = None
    if limit is not None and joint.get("type") != "continuous":
        span = (floats(limit.get("lower"), 1, "0", name)[0], floats(limit.get("upper"), 1, "0", name)[0])
    elif kind == "slide":
        raise Broken(f"slide {name} has no limits")
    direction = floats(axis.get("xyz") if axis is not None else None, 3, "1 0 0", name)
    return tree.motion(kind, np.asarray(direction), frame, span, name)


def _visual(element: Element, frame: Array, file: Path, root: Path, colors: dict[str, Element]) -> list[Piece]:
    material = _material(element, file, root, colors)
    return [p.moved(frame) for p in tree.dyed(_geometry(element, file, root)[0], material)]


def _material(element: Element, file: Path, root: Path, colors: dict[str, Element]) -> Material | None:
    own = element.find("material")
    if own is None:
        return None
    shared = colors.get(own.get("name", ""), own)
    color, picture = (own.find(tag) if own.find(tag) is not None else shared.find(tag) for tag in ("color", "texture"))
    texture = image(file, root)(picture.get("filename", "").removeprefix("file://")) if picture is not None else None
    if color is None and texture is None:
        return None
    r, g, b, a = floats(color.get("rgba") if color is not None else None, 4, "1 1 1 1", "color")
    return Material(own.get("name") or "plain", (r, g, b, a), texture=texture)


def _collision(element: Element, frame: Array, file: Path, root: Path, hulls: bool) -> list[Collider]:
    pieces, found = _geometry(element, file, root)
    if found is None:
        return colliders([p.moved(frame) for p in pieces]) if hulls and pieces else []
    center = frame[:3, :3] @ found.center + frame[:3, 3]
    vertices = None if found.vertices is None else found.vertices @ frame[:3, :3].T
    return [Collider(found.kind, center, found.size, frame[:3, :3] @ found.rotation, vertices)]


def _geometry(element: Element, file: Path, root: Path) -> tuple[list[Piece], Collider | None]:
    """Pieces in the link's frame, and the collider where it is a primitive."""
    pose, plain = _origin(element), Material("plain")
    geometry = element.find("geometry")
    for form in geometry if geometry is not None else []:
        if form.tag == "mesh":
            scale = np.diag([*floats(form.get("scale"), 3, "1 1 1", "mesh scale"), 1.0])
            address = form.get("filename", "").removeprefix("file://")
            address = address.removeprefix("package://")
            return [p.moved(pose @ scale) for p in tree.mesh(_found(file, root, address), root)], None
        if form.tag == "box":
            made = shape("box", np.asarray(floats(form.get("size"), 3, "", "box")), plain, pose)
        elif form.tag in ("cylinder", "sphere"):
            radius = floats(form.get("radius"), 1, "", form.tag)[0]
            length = floats(form.get("length"), 1, "2", form.tag)[0]
            made = shape(form.tag, np.array([radius, length / 2]), plain, pose)
        else:
            continue
        return [made[0]], made[1]
    return [], None


def _found(file: Path, root: Path, address: str) -> Path:
    """Beside the file, as is usual, else below the library's root, as package addresses have it."""
    near = file.parent / address
    return near if near.exists() else root / address

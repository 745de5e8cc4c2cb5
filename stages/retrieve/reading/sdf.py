"""SDFormat models, as Gazebo has them."""

from dataclasses import replace
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


def models(file: Path) -> list[Element]:
    """The models of a file, those of its worlds included."""
    root = limits.xml(limits.read(file, limits.TEXT_BYTES), file.name)
    return [*root.findall("model"), *root.findall("world/model")] if root.tag == "sdf" else []


def bodies(model: Element, file: Path, root: Path) -> list[Body]:
    """The model's links in its own frame, parents first."""
    links = {link.get("name", ""): link for link in model.findall("link")}
    if len(links) > LINKS:
        raise Broken(f"{file.name}: {len(links)} links, more than the {LINKS} accepted")
    joints = {(j.findtext("child") or "").strip(): j for j in model.findall("joint")}
    found: list[Body] = []
    rows: dict[str, int] = {}
    waiting = list(links)
    while waiting:
        ready = [n for n in waiting if n not in joints or _parent(joints[n]) in rows or _parent(joints[n]) == "world"]
        if not ready:
            raise Broken(f"{file.name}: joints form a loop or name links that do not exist: {', '.join(waiting[:3])}")
        for name in ready:
            rows[name] = len(found)
            found.append(_body(name, links, joints.get(name), rows, file, root))
            tree.bounded(found, file.name)
        waiting = [n for n in waiting if n not in rows]
    return found


def _parent(joint: Element) -> str:
    return (joint.findtext("parent") or "").strip()


def _pose(element: Element | None, links: dict[str, Element], depth: int = 0) -> Array:
    """A pose in the model's frame; `relative_to` may name another link."""
    if element is None:
        return np.eye(4)
    if element.get("rotation_format", "euler_rpy") != "euler_rpy" or depth > 32:
        raise Broken("a pose that is no roll, pitch and yaw, or refers to itself")
    values = floats(element.text, 6, "0 0 0 0 0 0", "pose")
    unit = np.pi / 180 if element.get("degrees") == "true" else 1.0
    own = at(values[:3], rpy([v * unit for v in values[3:]]))
    above = links.get(element.get("relative_to", ""))
    return own if above is None else _pose(above.find("pose"), links, depth + 1) @ own


def _body(
    name: str, links: dict[str, Element], joint: Element | None, rows: dict[str, int], file: Path, root: Path
) -> Body:
    link = links[name]
    frame = _pose(link.find("pose"), links)
    parent = rows.get(_parent(joint)) if joint is not None else None
    mass = link.findtext("inertial/mass")
    body = Body(name, parent, frame, mass=floats(mass, 1, "0", "mass")[0] if mass else None)
    if joint is not None and parent is not None and joint.get("type") in KINDS:
        body.motion = _motion(joint, frame)
    body.pieces = gathered((_visual(visual, frame, file, root) for visual in link.findall("visual")), file.name)
    for collision in link.findall("collision"):
        body.colliders += _colliders(collision, frame, file, root)
    return body


def _motion(joint: Element, frame: Array) -> Motion:
    kind, name = KINDS[joint.get("type", "")], joint.get("name", "joint")
    pose = joint.find("pose")
    if pose is not None and pose.get("relative_to"):
        raise Broken(f"joint {name}: a pose relative to {pose.get('relative_to')!r} is not understood")
    place = frame @ _pose(pose, {})
    axis = joint.find("axis")
    if axis is None:
        raise Broken(f"joint {name} has no axis")
    xyz = axis.find("xyz")
    direction = np.asarray(floats(xyz.text if xyz is not None else None, 3, "0 0 1", name))
    if xyz is not None and xyz.get("expressed_in") in ("__model__", "world"):
        direction = place[:3, :3].T @ direction
    span = None
    if axis.find("limit") is not None and joint.get("type") != "continuous":
        span = (
            floats(axis.findtext("limit/lower"), 1, "-1e16", name)[0]
            if axis.findtext("limit/lower")
            else -tree.ENDLESS,
            floats(axis.findtext("limit/upper"), 1, "1e16", name)[0] if axis.findtext("limit/upper") else tree.ENDLESS,
        )
    elif kind == "slide":
        raise Broken(f"slide {name} has no limits")
    return tree.motion(kind, direction, place, span, name)


def _visual(visual: Element, frame: Array, file: Path, root: Path) -> list[Piece]:
    pieces, _ = _geometry(visual, file, root)
    return [p.moved(frame) for p in tree.dyed(pieces, _material(visual, file, root))]


def _material(visual: Element, file: Path, root: Path) -> Material | None:
    rgba, metal = visual.findtext("material/diffuse"), visual.find("material/pbr/metal")
    if not rgba and metal is None:
        return None
    r, g, b, a = floats(" ".join([*(rgba or "1 1 1").split(), "1"][:4]), 4, "1 1 1 1", "diffuse")
    made = Material(f"diffuse {rgba or 'white'}", (r, g, b, a))
    if metal is None:
        return made
    told = {tag: (metal.findtext(tag) or "").strip() for tag in ("albedo_map", "roughness", "metalness")}
    texture = image(file, root)(str(_found(file, root, told["albedo_map"]))) if told["albedo_map"] else None
    rough, shine = (
        min(max(floats(told[tag] or default, 1, "", tag)[0], 0.0), 1.0)
        for tag, default in (("roughness", "0.7"), ("metalness", "0"))
    )
    return replace(made, texture=texture, roughness=rough, metalness=shine)


def _colliders(element: Element, frame: Array, file: Path, root: Path) -> list[Collider]:
    pieces, found = _geometry(element, file, root)
    if found is None:
        return colliders([p.moved(frame) for p in pieces]) if pieces else []
    vertices = None if found.vertices is None else found.vertices @ frame[:3, :3].T
    return [
        Collider(
            found.kind,
            frame[:3, :3] @ found.center + frame[:3, 3],
            found.size,
            frame[:3, :3] @ found.rotation,
            vertices,
        )
    ]


def _geometry(element: Element, file: Path, root: Path) -> tuple[list[Piece], Collider | None]:
    pose, plain = _pose(element.find("pose"), {}), Material("plain")
    geometry = element.find("geometry")
    for form in geometry if geometry is not None else []:
        if form.tag == "mesh":
            scale = np.diag([*floats(form.findtext("scale"), 3, "1 1 1", "scale"), 1.0])
            address = (form.findtext("uri") or "").strip()
            return [p.moved(pose @ scale) for p in tree.mesh(_found(file, root, address), root)], None
        if form.tag == "box":
            piece, found = shape("box", np.asarray(floats(form.findtext("size"), 3, "1 1 1", "box")), plain, pose)
        elif form.tag in ("cylinder", "sphere", "capsule"):
            radius = floats(form.findtext("radius"), 1, "1", form.tag)[0]
            length = floats(form.findtext("length"), 1, "1", form.tag)[0]
            piece, found = shape(form.tag, np.array([radius, length / 2]), plain, pose)
        else:
            continue
        return [piece], found
    return [], None


def _found(file: Path, root: Path, address: str) -> Path:
    """`model://name/…` lies below the library's root; anything else beside the file."""
    if address.startswith("model://"):
        return root / address.removeprefix("model://")
    return file.parent / address.removeprefix("file://")

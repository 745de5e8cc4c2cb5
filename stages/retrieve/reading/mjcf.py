"""MuJoCo models (MJCF): bodies, default classes, includes, meshes and primitive geoms."""

from dataclasses import dataclass, field
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from apartgen.stages.retrieve.reading import limits, tree
from apartgen.stages.retrieve.reading.convex import hull
from apartgen.stages.retrieve.reading.limits import Broken, floats
from apartgen.stages.retrieve.reading.model import Motion
from apartgen.stages.retrieve.reading.pieces import Array, Piece, count
from apartgen.stages.retrieve.reading.primitives import shape
from apartgen.stages.retrieve.reading.source import image
from apartgen.stages.retrieve.reading.transforms import at, quaternion, z_along
from apartgen.stages.retrieve.reading.tree import Body
from apartgen.stages.space.turns import rotation
from apartgen.stages.things.asset import Collider, Material

INCLUDES = 200
NEST = 64
COUNTS = {
    "pos": 3,
    "quat": 4,
    "axis": 3,
    "rgba": 4,
    "scale": 3,
    "axisangle": 4,
    "xyaxes": 6,
    "zaxis": 3,
    "euler": 3,
    "fromto": 6,
    "range": 2,
}


@dataclass
class Document:
    """A model with its includes put in place: its elements by section, default classes, and where meshes lie."""

    file: Path
    root: Path
    sections: dict[str, list[Element]] = field(default_factory=dict)
    defaults: dict[str, dict[str, dict[str, str]]] = field(default_factory=dict)
    options: dict[str, str] = field(default_factory=dict)
    meshes: dict[str, Element] = field(default_factory=dict)
    materials: dict[str, Material] = field(default_factory=dict)
    vertices: int = 0
    faces: int = 0


def is_model(data: bytes) -> bool:
    """Whether an XML file is a whole model, not a fragment for others to include."""
    return b"<mujoco" in data and b"<mujocoinclude" not in data


def document(file: Path, root: Path) -> Document:
    """Reads a model; nothing outside `root` is opened."""
    doc = Document(file, root)
    for section in _spliced(limits.xml(limits.read(file, limits.TEXT_BYTES), file.name), file, root, [file]):
        doc.sections.setdefault(section.tag, []).append(section)
    for compiler in doc.sections.get("compiler", []):
        doc.options |= compiler.attrib
    for section in doc.sections.get("default", []):
        _defaults(doc, section, {}, "main")
    assets = [element for section in doc.sections.get("asset", []) for element in section]
    textures = {element.get("name") or Path(element.get("file", "")).stem: element
                for element in assets if element.tag == "texture"}  # fmt: skip
    for element in assets:
        if element.tag == "mesh":
            doc.meshes[element.get("name") or Path(element.get("file", "")).stem] = element
        elif element.tag == "material":
            doc.materials[element.get("name", "")] = _material(doc, element, textures)
    return doc


def _material(doc: Document, element: Element, textures: dict[str, Element]) -> Material:
    """A material in the mean colour of a drawn texture, or with the image of a flat one; cube maps have no place."""
    name = element.get("name", "")
    told = {key: floats(element.get(key), 1, default, f"material {name}")[0]
            for key, default in (("shininess", "0.5"), ("roughness", "-1"), ("metallic", "0"))}  # fmt: skip
    rough = told["roughness"] if told["roughness"] >= 0 else 1 - 0.8 * told["shininess"]
    color = np.clip(floats(element.get("rgba"), 4, "1 1 1 1", "material"), 0, 1)
    texture, file = textures.get(element.get("texture", "")), None
    if texture is not None and texture.get("builtin", "none") != "none":
        both = [
            floats(texture.get(key), 3, " ".join([grey] * 3), key) for key, grey in (("rgb1", ".8"), ("rgb2", ".5"))
        ]
        color[:3] *= np.mean(both[:1] if texture.get("builtin") == "flat" else both, 0)
    elif texture is not None and texture.get("type", "cube") == "2d":
        folder = doc.options.get("texturedir", doc.options.get("assetdir", ""))
        file = image(doc.file, doc.root)(str(Path(folder) / texture.get("file", "")))
    return Material(name, _four(color.tolist()), min(max(rough, 0.0), 1.0), min(max(told["metallic"], 0.0), 1.0), file)


def _spliced(element: Element, main: Path, root: Path, stack: list[Path]) -> list[Element]:
    """The element's children, each include replaced by the children of the file it names."""
    out = []
    for child in list(element):
        if child.tag == "include":
            # Addresses are relative to the main file, as MuJoCo has it.
            path = limits.inside(root, main.parent / child.get("file", ""))
            if path in stack or len(stack) > INCLUDES:
                raise Broken(f"{main.name}: {path.name} includes itself")
            inner = limits.xml(limits.read(path, limits.TEXT_BYTES), path.name)
            out += _spliced(inner, main, root, [*stack, path])
        else:
            inside = _spliced(child, main, root, stack)
            for old in list(child):
                child.remove(old)
            child.extend(inside)
            out.append(child)
    return out


def _defaults(doc: Document, section: Element, above: dict[str, dict[str, str]], name: str) -> None:
    own = {tag: dict(values) for tag, values in above.items()}
    for element in section:
        if element.tag != "default":
            own[element.tag] = own.get(element.tag, {}) | element.attrib
    doc.defaults[name] = {
        tag: doc.defaults.get(name, {}).get(tag, {}) | own.get(tag, {}) for tag in {*own, *doc.defaults.get(name, {})}
    }
    for element in section:
        if element.tag == "default":
            _defaults(doc, element, own, element.get("class", "main"))


def top_bodies(doc: Document) -> list[Element]:
    """The objects of a model: each body that stands in the world, or all of them together where some slide or turn."""
    worlds = [body for world in doc.sections.get("worldbody", []) for body in world if body.tag == "body"]
    if not any(joint.get("type", "hinge") in ("hinge", "slide") for body in worlds for joint in body.findall("joint")):
        return worlds
    whole = Element("body", name=doc.file.stem)
    whole.extend(worlds)
    return [whole]


def bodies(doc: Document, top: Element) -> list[Body]:
    """The tree of one body, z up, its own frame as root."""
    found: list[Body] = []
    _walk(doc, top, None, np.eye(4), top.get("childclass", "main"), found, 0)
    return found


def _walk(
    doc: Document, element: Element, parent: int | None, frame: Array, inherited: str, found: list[Body], depth: int
) -> None:
    if depth > NEST:
        raise Broken(f"{doc.file.name}: bodies nest too deep")
    name, klass = element.get("name", f"body_{len(found)}"), element.get("childclass", inherited)
    body = Body(name, parent, frame)
    row = len(found)
    found.append(body)
    shown: list[tuple[list[Piece], list[Collider], bool, bool]] = []
    for child in element:
        if child.tag == "geom":
            shown.append(_geom(doc, _full(doc, child, klass), frame))
            _count(doc, shown[-1][0])
        elif child.tag == "joint" and body.motion is None and parent is not None:
            body.motion = _joint(doc, _full(doc, child, klass), frame)
    _share(body, shown)
    for child in element:
        if child.tag == "body":
            _walk(doc, child, row, frame @ _pose(doc, child.attrib), klass, found, depth + 1)


def _count(doc: Document, pieces: list[Piece]) -> None:
    doc.vertices += sum(len(piece.vertices) for piece in pieces)
    doc.faces += sum(len(piece.faces) for piece in pieces)
    count(doc.vertices, doc.faces, doc.file.name)


def _share(body: Body, shown: list[tuple[list[Piece], list[Collider], bool, bool]]) -> None:
    """Geoms that don't collide are seen; those that do are seen too where nothing else is."""
    seen = [pieces for pieces, _, collides, _ in shown if not collides]
    body.pieces = [p for pieces in (seen or [pieces for pieces, _, _, _ in shown]) for p in pieces]
    body.colliders = [c for _, pieces, collides, _ in shown if collides for c in pieces]


def _full(doc: Document, element: Element, klass: str) -> dict[str, str]:
    name = element.get("class", klass)
    return (
        doc.defaults.get("main", {}).get(element.tag, {})
        | doc.defaults.get(name, {}).get(element.tag, {})
        | element.attrib
    )


def _geom(doc: Document, at_: dict[str, str], frame: Array) -> tuple[list[Piece], list[Collider], bool, bool]:
    collides = at_.get("contype", "1") != "0" or at_.get("conaffinity", "1") != "0"
    material = doc.materials.get(at_.get("material", ""), Material("plain"))
    if "rgba" in at_:
        material = Material(f"rgba {at_['rgba']}", _four(floats(at_["rgba"], 4, "", "rgba")))
    kind, pose = at_.get("type", "sphere"), frame @ _pose(doc, at_)
    if "mesh" in at_:
        pieces = [p.moved(pose) for p in tree.dyed(_mesh(doc, at_["mesh"]), material)]
        return pieces, [hull(np.unique(p.vertices, axis=0)) for p in pieces] if collides else [], collides, True
    if kind not in ("box", "sphere", "capsule", "cylinder"):
        return [], [], collides, False
    size = _numbers(at_.get("size", ""))
    if "fromto" in at_:
        ends = np.asarray(floats(at_["fromto"], 6, "", "fromto")).reshape(2, 3)
        pose = frame @ at(ends.mean(0).tolist(), z_along(ends[1] - ends[0]))
        size = np.r_[size[:1], np.linalg.norm(ends[1] - ends[0]) / 2]
    wanted = {"box": 3, "sphere": 1}.get(kind, 2)
    if len(size) < wanted:
        raise Broken(f"{doc.file.name}: a {kind} geom of size {at_.get('size', '')!r}")
    piece, collider = shape(kind, 2 * size[:3] if kind == "box" else np.r_[size, 1e-3][:2], material, pose)
    return [piece], [collider] if collides else [], collides, False


def _numbers(words: str) -> Array:
    return np.asarray(floats(words, len(words.split()), "", "size"), float)


def _mesh(doc: Document, name: str) -> list[Piece]:
    element = doc.meshes.get(name)
    if element is None or "file" not in element.attrib:
        raise Broken(f"{doc.file.name}: mesh {name!r} is not declared with a file")
    folder = doc.options.get("meshdir", doc.options.get("assetdir", ""))
    defaults = doc.defaults.get(element.get("class", "main"), {}).get("mesh", {})
    scale = np.diag([*floats(element.get("scale", defaults.get("scale")), 3, "1 1 1", f"mesh {name}"), 1.0])
    return [p.moved(scale) for p in tree.mesh(doc.file.parent / folder / element.attrib["file"], doc.root)]


def _joint(doc: Document, at_: dict[str, str], frame: Array) -> Motion | None:
    kind, name = at_.get("type", "hinge"), at_.get("name", "joint")
    if kind not in ("hinge", "slide"):
        return None
    limited = at_.get("limited", "auto")
    span = None
    if "range" in at_ and limited in ("true", "auto"):
        low, high = floats(at_["range"], 2, "", f"joint {name}")
        unit = np.pi / 180 if kind == "hinge" and doc.options.get("angle", "degree") == "degree" else 1.0
        span = (low * unit, high * unit)
    elif kind == "slide":
        raise Broken(f"slide {name} has no range")
    axis = np.asarray(floats(at_.get("axis"), 3, "0 0 1", f"joint {name}"))
    return tree.motion(kind, axis, frame @ at(floats(at_.get("pos"), 3, "0 0 0", f"joint {name}")), span, name)


def _pose(doc: Document, at_: dict[str, str]) -> Array:
    position = floats(at_.get("pos"), 3, "0 0 0", "pos")
    degrees = doc.options.get("angle", "degree") == "degree"
    values = {
        key: floats(at_[key], COUNTS[key], "", key)
        for key in ("quat", "euler", "axisangle", "zaxis", "xyaxes")
        if key in at_
    }
    unit = np.pi / 180 if degrees else 1.0
    if "quat" in values:
        return at(position, quaternion(values["quat"]))
    if "axisangle" in values:
        return at(position, rotation(values["axisangle"][:3], values["axisangle"][3] * unit))
    if "zaxis" in values:
        return at(position, z_along(values["zaxis"]))
    if "xyaxes" in values:
        x, y = np.asarray(values["xyaxes"]).reshape(2, 3)
        x = x / np.linalg.norm(x)
        y = y - (x @ y) * x
        y = y / np.linalg.norm(y)
        return at(position, np.stack([x, y, np.cross(x, y)], 1))
    return at(position, _euler(doc, values.get("euler", [0.0, 0, 0]), unit))


def _euler(doc: Document, angles: list[float], unit: float) -> Array:
    turn = np.eye(3)
    for letter, angle in zip(doc.options.get("eulerseq", "xyz"), angles, strict=False):
        step = rotation(np.eye(3)["xyz".index(letter.lower())], angle * unit)
        turn = turn @ step if letter.islower() else step @ turn
    return turn


def _four(values: list[float]) -> tuple[float, float, float, float]:
    r, g, b, a = values
    return r, g, b, a

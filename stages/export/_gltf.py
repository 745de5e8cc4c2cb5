"""A glTF 2.0 document in one binary: nodes, meshes stored once, materials, textures, lights."""

import json
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.pieces import cut_out, digest, image, mesh_digest, names, pieces, relief_image, shaded
from apartgen.stages.things.asset import Array, Link, Material, Mesh
from apartgen.stages.things.body import Body, Light, mass
from apartgen.stages.things.relief import standing
from apartgen.stages.things.shading import tangents

FLOAT, SHORT, INT = 5126, 5123, 5125
VERTICES, INDICES = 34962, 34963
GROUPS = {"ceiling": "ceilings", "object": "furniture"}
"""Nodes that hold the bodies of a kind; the rest are under `shell`."""
LIGHT_COLOR = [1.0, 0.93, 0.82]
RELIEF = "_normal"
"""How the normal map of a pattern is called after it."""

Node = dict[str, Any]


def packed(bodies: list[Body], lights: list[Light], credits: list[str]) -> bytes:
    """The bodies and lights as a GLB, y up; every body in its group of `GROUPS` or the shell."""
    document, binary = _document(bodies, lights, credits)
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def _document(bodies: list[Body], lights: list[Light], credits: list[str]) -> tuple[Node, bytes]:
    store = _Store(bodies)
    groups: dict[str, list[int]] = {"shell": [], "ceilings": [], "furniture": [], "lights": []}
    for body in bodies:
        groups[GROUPS.get(body.kind, "shell")].append(store.body(body))
    groups["lights"] = [store.node(_light(k, light)) for k, light in enumerate(lights)]
    held = [store.node({"name": name, "children": nodes}) for name, nodes in groups.items() if nodes]
    # glTF is y up: the root turns the z-up world by -90° about x.
    root = store.node({"name": "apartment", "rotation": [-(0.5**0.5), 0, 0, 0.5**0.5], "children": held})
    return store.document(root, lights, credits)


def _light(index: int, light: Light) -> Node:
    place = [float(v) for v in light.position]
    return {"name": light.name, "translation": place, "extensions": {"KHR_lights_punctual": {"light": index}}}


def _lights(lights: list[Light]) -> list[Node]:
    return [
        {"type": "point", "name": light.name, "color": LIGHT_COLOR, "intensity": light.lumens / (4 * np.pi)}
        for light in lights
    ]


class _Store:
    """The parts of a glTF document while they are gathered; what is equal is stored once."""

    def __init__(self, bodies: list[Body]) -> None:
        used = (mesh.material for body in bodies for link in body.links for mesh in link.visuals)
        self.materials = names(used)
        textures = sorted({m.texture for m in self.materials if m.texture})
        self.images = {name: image(name) for name in textures}
        self.images |= {f"{name}{RELIEF}": relief_image(name) for name in sorted({*map(standing, textures)} - {""})}
        self.nodes: list[Node] = []
        self.meshes: list[Node] = []
        self.accessors: list[Node] = []
        self.views: list[Node] = []
        self.binary = bytearray()
        self.known: dict[str, Any] = {}

    def node(self, node: Node) -> int:
        self.nodes.append(node)
        return len(self.nodes) - 1

    def body(self, body: Body) -> int:
        """A node for the body and its base, with one below it for each moving link."""
        half = body.yaw / 2
        node: Node = {
            "name": body.name,
            "translation": [float(v) for v in body.position],
            "rotation": [0.0, 0.0, float(np.sin(half)), float(np.cos(half))],
            "extras": {k: v for k, v in _facts(body).items() if v not in ("", None)},
        }
        base, *moving = body.links
        self._show(node, body, base, np.zeros(3))
        children = [self.node(self._link(body, link)) for link in moving]
        return self.node(node | ({"children": children} if children else {}))

    def _link(self, body: Body, link: Link) -> Node:
        assert link.joint is not None
        origin = np.array(link.joint.origin)
        node: Node = {"name": body.link_name(link), "translation": [float(v) for v in origin]}
        joint = link.joint.model_dump(include={"name", "type", "axis", "range", "part"})
        node["extras"] = {"joint": joint, "mass": mass(link)}
        if link.handle is not None:
            node["extras"]["handle"] = [float(v) for v in link.handle - origin]
        self._show(node, body, link, origin)
        return node

    def _show(self, node: Node, body: Body, link: Link, origin: Array) -> None:
        meshes = [_below(mesh) if body.kind == "ceiling" else mesh for mesh in pieces(link)]
        if meshes:
            node["mesh"] = self._mesh(body.link_name(link), meshes, origin)

    def _mesh(self, name: str, meshes: list[Mesh], origin: Array) -> int:
        primitives = [self._primitive(mesh, origin) for mesh in meshes]
        key = json.dumps(primitives)
        if key not in self.known:
            self.known[key] = len(self.meshes)
            self.meshes.append({"name": name, "primitives": primitives})
        return int(self.known[key])

    def _primitive(self, mesh: Mesh, origin: Array) -> Node:
        embossed = mesh.uv is not None and bool(standing(mesh.material.texture or ""))
        key = mesh_digest(mesh) + digest(origin) + "embossed" * embossed
        if key not in self.known:
            vertices, normals, uv, faces = shaded(mesh)
            attributes = {"POSITION": self._floats(vertices - origin, limits=True), "NORMAL": self._floats(normals)}
            if uv is not None:
                attributes["TEXCOORD_0"] = self._floats(uv * [1, -1] + [0, 1])
                attributes |= {"TANGENT": self._floats(tangents(vertices, normals, uv, faces))} if embossed else {}
            kind = (SHORT, "<u2") if len(vertices) < 65535 else (INT, "<u4")
            indices = self._accessor(faces.ravel().astype(kind[1]), kind[0], "SCALAR", INDICES)
            self.known[key] = {"attributes": attributes, "indices": indices}
        return {**self.known[key], "material": list(self.materials).index(mesh.material)}

    def _floats(self, values: Array, limits: bool = False) -> int:
        data = values.astype("<f4")
        index = self._accessor(data, FLOAT, f"VEC{values.shape[1]}", VERTICES)
        if limits:
            self.accessors[index] |= {"min": data.min(0).tolist(), "max": data.max(0).tolist()}
        return index

    def _accessor(self, data: NDArray[Any], component: int, type_: str, target: int) -> int:
        view = self._view(data.tobytes(), target)
        self.accessors.append({"bufferView": view, "componentType": component, "count": len(data), "type": type_})
        return len(self.accessors) - 1

    def _view(self, data: bytes, target: int | None = None) -> int:
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.views.append(view | ({"target": target} if target else {}))
        self.binary += data
        return len(self.views) - 1

    def _extensions(self, lights: list[Light]) -> list[str]:
        clear = any(_clear(m) for m in self.materials)
        return ["KHR_lights_punctual"] * bool(lights) + ["KHR_materials_transmission"] * clear

    def document(self, root: int, lights: list[Light], credits: list[str]) -> tuple[Node, bytes]:
        png = {"mimeType": "image/png"}
        images = [{"name": name, **png, "bufferView": self._view(data)} for name, data in self.images.items()]
        self.binary += b"\0" * (-len(self.binary) % 4)
        document: Node = {
            "asset": {"version": "2.0", "generator": "apartgen", "copyright": "; ".join(credits)},
            "extensionsUsed": self._extensions(lights),
            "extensions": {"KHR_lights_punctual": {"lights": _lights(lights)}} if lights else {},
            "scene": 0, "scenes": [{"name": "apartment", "nodes": [root]}],
            "nodes": self.nodes, "meshes": self.meshes, "accessors": self.accessors, "bufferViews": self.views,
            "materials": [_material(m, name, list(self.images)) for m, name in self.materials.items()],
            "images": images,
            "samplers": [{"wrapS": 10497, "wrapT": 10497, "magFilter": 9729, "minFilter": 9987}] if images else [],
            "textures": [{"sampler": 0, "source": k} for k in range(len(images))],
            "buffers": [{"byteLength": len(self.binary)}],
        }
        return {k: v for k, v in document.items() if v not in ([], {})}, bytes(self.binary)


def _facts(body: Body) -> Node:
    return {
        "id": body.id, "kind": body.kind, "category": body.category, "room": body.room, "asset": body.model,
        "free": body.free, "mass": mass(body.links[0]) if body.kind == "object" else None,
        **body.says,
    }


def _below(mesh: Mesh) -> Mesh:
    """The faces seen from below, so that a viewer that culls back faces looks into the rooms from above."""
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    down = np.cross(b - a, c - a)[:, 2] < -1e-9
    return Mesh(mesh.vertices, mesh.faces[down], mesh.material, mesh.uv)


def _material(m: Material, name: str, textures: list[str]) -> Node:
    r, g, b = ([1.0] * 3 if m.texture else [_linear(c) for c in m.color[:3]])
    surface: Node = {
        "baseColorFactor": [r, g, b, m.color[3]], "metallicFactor": m.metalness, "roughnessFactor": m.roughness
    }
    if m.texture:
        surface["baseColorTexture"] = {"index": textures.index(m.texture)}
    mode = "BLEND" if m.color[3] < 1 else "MASK" if m.texture and cut_out(m.texture) else ""
    made: Node = {"name": name, "pbrMetallicRoughness": surface} | ({"alphaMode": mode} if mode else {})
    if pattern := standing(m.texture or ""):
        made["normalTexture"] = {"index": textures.index(f"{pattern}{RELIEF}")}
    if m.emission:
        made["emissiveFactor"] = [m.emission * _linear(c) for c in m.color[:3]]
    if _clear(m):
        made["extensions"] = {"KHR_materials_transmission": {"transmissionFactor": 1 - m.color[3]}}
    return made


def _clear(m: Material) -> bool:
    """Whether it is glass: light passes through it, smooth as it is."""
    return m.color[3] < 1 and m.roughness < 0.2


def _linear(c: float) -> float:
    """sRGB to linear light."""
    return c / 12.92 if c <= 0.04045 else float(((c + 0.055) / 1.055) ** 2.4)

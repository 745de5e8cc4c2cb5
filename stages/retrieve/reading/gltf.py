"""glTF 2.0: one-file `.glb` and `.gltf` with files beside it."""

import base64
import binascii
import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.retrieve.reading import limits
from apartgen.stages.retrieve.reading.gltf_looks import KNOWN, Looks
from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.pieces import Array, Piece, count

TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
DEPTH = 64
"""Deepest node tree."""
NODES = 10_000
Open = Callable[[str], bytes | None]


@dataclass(frozen=True)
class Node:
    """A node: where its own frame lies in the scene (4 × 4), its meshes in the scene's frame, its children."""

    name: str
    frame: Array
    pieces: list[Piece]
    children: list["Node"] = field(default_factory=list)

    def all(self) -> list[Piece]:
        """Its pieces and those of all nodes below it."""
        return self.pieces + [piece for child in self.children for piece in child.all()]


def parse(data: bytes, name: str, beside: Open) -> list[Node]:
    """The scene's root nodes; `beside` opens files named by relative address."""
    try:
        about, chunk = _split(data)
        return _Reader(about, chunk, name, beside).roots()
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, struct.error, RecursionError) as error:
        raise Broken(f"{name}: not valid glTF ({type(error).__name__}: {error})") from None


def _split(data: bytes) -> tuple[dict[str, Any], bytes]:
    if data[:4] != b"glTF":
        return dict(limits.values(data)), b""
    version, length = struct.unpack_from("<II", data, 4)
    if version != 2 or length > len(data):
        raise ValueError(f"version {version}, {length} bytes announced, {len(data)} there")
    size = struct.unpack_from("<I", data, 12)[0]
    rest = 20 + size
    chunk = data[rest + 8 : rest + 8 + struct.unpack_from("<I", data, rest)[0]] if rest + 8 <= len(data) else b""
    return dict(limits.values(data[20:rest])), chunk


class _Reader:
    def __init__(self, about: dict[str, Any], chunk: bytes, name: str, beside: Open) -> None:
        self.about, self.name, self.beside = about, name, beside
        needed = set(about.get("extensionsRequired", [])) - KNOWN
        if needed:
            raise Broken(f"{name}: needs {', '.join(sorted(needed))}, which is not understood; export it without")
        self.buffers: list[bytes] = []
        for buffer in about.get("buffers", []):
            self.buffers.append(self._buffer(buffer, chunk))
            if sum(map(len, self.buffers)) > limits.FILE_BYTES:
                raise Broken(f"{name}: buffers of more than the {limits.FILE_BYTES / 2**20:.0f} MB accepted")
        self.looks = Looks(about, self._view, self._beside)
        self.seen = self.vertices = self.faces = 0

    def _buffer(self, buffer: dict[str, Any], chunk: bytes) -> bytes:
        uri = buffer.get("uri")
        if uri is None:
            return chunk
        found = self._beside(uri)
        if found is None:
            raise Broken(f"{self.name}: lacks the file {uri!r}")
        return found

    def _beside(self, uri: str) -> bytes | None:
        """What an address holds itself, or the file that it names."""
        if not uri.startswith("data:"):
            return self.beside(uri)
        try:
            return base64.b64decode(uri.partition(",")[2], validate=True)
        except binascii.Error:
            raise Broken(f"{self.name}: an address is not base64") from None

    def _view(self, i: int) -> bytes:
        view = self.about["bufferViews"][i]
        data: bytes = self.buffers[view["buffer"]]
        start = int(view.get("byteOffset", 0))
        if start < 0 or start + int(view["byteLength"]) > len(data):
            raise Broken(f"{self.name}: an image reaches beyond its buffer")
        return data[start : start + int(view["byteLength"])]

    def roots(self) -> list[Node]:
        scenes = self.about.get("scenes") or [{"nodes": list(range(len(self.about.get("nodes", []))))}]
        scene = scenes[self.about.get("scene", 0)]
        return [self._node(i, np.eye(4), 0) for i in scene.get("nodes", [])]

    def _node(self, i: int, parent: Array, depth: int) -> Node:
        self.seen += 1
        if depth > DEPTH or self.seen > NODES:
            raise Broken(f"{self.name}: nodes nest too deep or refer to themselves")
        node = self.about["nodes"][i]
        frame = parent @ _matrix(node)
        mesh = self.about["meshes"][node["mesh"]] if "mesh" in node else {"primitives": []}
        pieces = [p.moved(frame) for p in map(self._piece, mesh["primitives"]) if p is not None]
        children = [self._node(child, frame, depth + 1) for child in node.get("children", [])]
        return Node(str(node.get("name", f"node_{i}")), frame, pieces, children)

    def _piece(self, primitive: dict[str, Any]) -> Piece | None:
        if primitive.get("mode", 4) != 4:
            return None
        attributes = primitive["attributes"]
        vertices = self._array(attributes["POSITION"]).astype(float)
        if "indices" in primitive:
            faces = self._array(primitive["indices"]).reshape(-1, 3).astype(np.int64)
        else:
            faces = np.arange(len(vertices), dtype=np.int64).reshape(-1, 3)
        # Nodes may show one mesh many times.
        self.vertices, self.faces = self.vertices + len(vertices), self.faces + len(faces)
        count(self.vertices, self.faces, self.name)
        material, laid, matrix = self.looks.of(primitive.get("material"), self._tint(attributes))
        uv = self._array(attributes[f"TEXCOORD_{laid}"]).astype(float) if f"TEXCOORD_{laid}" in attributes else None
        if uv is not None:
            # glTF counts v downwards from the image's top.
            uv = (uv @ matrix[:, :2].T + matrix[:, 2]) * [1, -1] + [0, 1]
        return Piece(vertices, faces, material, uv)

    def _tint(self, attributes: dict[str, int]) -> Array:
        """The mean colour (4) of the vertices in linear light; white where they have none."""
        if "COLOR_0" not in attributes:
            return np.ones(4)
        return np.append(self._array(attributes["COLOR_0"]).astype(float).mean(0), 1.0)[:4]

    def _array(self, i: int) -> NDArray[Any]:
        accessor = self.about["accessors"][i]
        width, total = WIDTHS[accessor["type"]], int(accessor["count"])
        count(total, 0, self.name) if width > 1 else count(0, total // 3, self.name)
        if "sparse" in accessor:
            raise Broken(f"{self.name}: sparse accessors are not understood; export it without")
        view = self.about["bufferViews"][accessor["bufferView"]]
        kind = np.dtype(TYPES[accessor["componentType"]])
        stride = int(view.get("byteStride", 0)) or kind.itemsize * width
        start = int(view.get("byteOffset", 0)) + int(accessor.get("byteOffset", 0))
        data = self.buffers[view["buffer"]]
        if (
            total < 1
            or start < 0
            or stride < kind.itemsize * width
            or start + stride * (total - 1) + kind.itemsize * width > len(data)
        ):
            raise Broken(f"{self.name}: an accessor reaches beyond its buffer")
        values: NDArray[Any] = np.ndarray((total, width), kind, data, start, (stride, kind.itemsize))
        if accessor.get("normalized") and kind.kind in "iu":
            values = np.maximum(values / np.iinfo(kind).max, -1.0)
        return values[:, 0] if width == 1 else values


def _matrix(node: dict[str, Any]) -> Array:
    if "matrix" in node:
        return np.asarray(node["matrix"], float).reshape(4, 4).T
    x, y, z, w = (float(v) for v in node.get("rotation", (0, 0, 0, 1)))
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turn * np.asarray(node.get("scale", (1, 1, 1)), float)
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix

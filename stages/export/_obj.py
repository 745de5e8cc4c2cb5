"""Meshes as Wavefront OBJ files and textures as PNG files in one folder; what is equal is written once."""

from pathlib import Path

import numpy as np

from apartgen.stages.export import _digits
from apartgen.stages.export._xml import number, numbers
from apartgen.stages.scene.pieces import image, image_name, mesh_digest, relief_image, shaded
from apartgen.stages.things.asset import Array, Material, Mesh
from apartgen.stages.things.relief import standing


class Files:
    """Writes into `folder`; `written` are the paths so far, in the order of first use."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.folder = folder
        self.written: list[Path] = []
        self._known: dict[str, str] = {}

    def mesh(self, name: str, mesh: Mesh, origin: Array | None = None, mtl: str = "") -> str:
        """File name of the mesh seen from `origin`, `name`.obj unless an equal one has been written.

        `mtl` is the text of its material, for readers that take colours from the mesh file.
        """
        if origin is not None and origin.any():
            mesh = Mesh(mesh.vertices - origin, mesh.faces, mesh.material, mesh.uv)
        key = mesh_digest(mesh) + mtl
        if key not in self._known:
            self._known[key] = f"{name}.obj"
            head = ""
            if mtl:
                self._write(f"{name}.mtl", f"newmtl surface\n{mtl}".encode())
                head = f"mtllib {name}.mtl\nusemtl surface\n"
            self._write(f"{name}.obj", (head + obj(mesh)).encode())
        return self._known[key]

    def texture(self, texture: str) -> str:
        """File name of the texture's image."""
        name = image_name(texture)
        if name not in self._known:
            self._known[name] = name
            self._write(name, image(texture))
        return name

    def relief(self, texture: str) -> str:
        """File name of the normal map of a texture's pattern; empty where its surface is flat."""
        if not (pattern := standing(texture)):
            return ""
        name = f"{pattern}_normal.png"
        if name not in self._known:
            self._known[name] = name
            self._write(name, relief_image(pattern))
        return name

    def surface(self, m: Material) -> str:
        """MTL lines of a material; its texture lies beside the mesh."""
        r, g, b, alpha = (1.0, 1.0, 1.0, m.color[3]) if m.texture else m.color
        lines = f"Kd {numbers([r, g, b])}\nd {number(alpha)}\nNs {number(1000 * (1 - m.roughness) ** 2)}\n"
        return lines + (f"map_Kd {self.texture(m.texture)}\n" if m.texture else "")

    def _write(self, name: str, data: bytes) -> None:
        path = self.folder / name
        with open(path, "wb") as file:
            file.write(data)
        self.written.append(path)


def obj(mesh: Mesh) -> str:
    """OBJ text with normals, and uv where there are."""
    vertices, normals, uv, faces = shaded(mesh)
    parts = [_rows("v", vertices), _rows("vn", normals)]
    if uv is not None:
        parts.append(_rows("vt", uv))
    return "".join(parts) + _text(_digits.triangles(np.ascontiguousarray(faces), uv is not None))


def _rows(tag: str, values: Array) -> str:
    if (np.abs(values) < _digits.LARGEST).all():
        return _text(_digits.rows(np.frombuffer(tag.encode(), np.uint8).copy(), np.ascontiguousarray(values, float)))
    values = np.where(np.abs(values) < _digits.LEAST, 0.0, values)
    pattern = f"{tag} " + " ".join(["%.6g"] * values.shape[1]) + "\n"
    return pattern * len(values) % tuple(values.ravel().tolist())


def _text(letters: _digits.Bytes) -> str:
    return letters.tobytes().decode("ascii")
